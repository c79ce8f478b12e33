/* SPDX-License-Identifier: MIT
 *
 * The names of files that are being written: NAME.HOST-PROCESS-NUMBER.part next to NAME, which no
 * two processes share, not even on different machines.
 */
#ifndef SCARP_CLI_UNFINISHED_H
#define SCARP_CLI_UNFINISHED_H

#include <stdbool.h>
#include <stdio.h>

#define UNFINISHED_END ".part" /* what all their names end with */

/* Makes such a file for `path`, empty, for this process only, with the permissions `mode` less the
   umask. Returns its name, which the caller frees, and the file open for writing; NULL, with errno
   and with nothing left, if that cannot be. */
char *unfinished_make(const char *path, unsigned mode, FILE **stream);

/* Removes those that processes of this machine left in the directory of `path` when they were
   killed. Looks into a directory once, however many files there follow one another. */
void unfinished_sweep(const char *path);

#endif
