/* SPDX-License-Identifier: MIT
 *
 * Paths of files: their parts, where they lead, and the directories on the way.
 */
#ifndef SCARP_CLI_PATH_H
#define SCARP_CLI_PATH_H

#include <stdbool.h>
#include <stddef.h>

/* How much of `path` names the directory, its last separator included; 0: the current one */
size_t path_directory_length(const char *path);

/* The dot of the extension; the end of the path if it has none. */
const char *path_extension(const char *path);

/* `path` as seen from the directory of the file `from`, both seen from the current directory. Links
   are not followed, so neither need be there. In memory that the caller frees; NULL without. */
char *path_relative(const char *path, const char *from);

/* The path of the file that `path` leads to, without symbolic links in it: two paths of one file
   become the same text. The file need not be there, its directory must. In memory that the caller
   frees; NULL, with errno, if it cannot be found. */
char *path_resolve(const char *path);

/* Whether two paths without symbolic links are of one file: on Windows, upper and lower case are
   the same. */
bool path_is_same(const char *a, const char *b);

/* Makes the directories that lead to the file `path`. Returns how many were made, the deepest
   ones, or -1 with errno; those that were made by then are removed again. */
int path_make_directories(const char *path);

/* Removes the `count` deepest directories that lead to the file `path`, as far as they are empty.
 */
void path_remove_directories(const char *path, int count);

/* Waits until all that was written to an open file is on the disk. False, with errno, only if the
   system tried and failed; not every file system can. */
bool path_sync(int descriptor);

/* Sees to it that the names in the file's directory survive a power cut. Like path_sync. */
bool path_sync_directory(const char *path);

#endif
