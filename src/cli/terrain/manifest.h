/* SPDX-License-Identifier: MIT
 *
 * What all files of a world have in common, as JSON in a file next to them. The run that is first
 * makes it, all others compare: files of one world are never mixed with those of another. Runs
 * that share a world also learn from it which tiles the others are at.
 */
#ifndef SCARP_CLI_MANIFEST_H
#define SCARP_CLI_MANIFEST_H

#include <stdbool.h>
#include <stddef.h>

#include "shared/file.h"

/* Zero-initialise, set the first two members, open. */
struct manifest {
    const char *option;     /* that messages name */
    bool makes_directories; /* those that lead to it */
    struct file_time time;  /* files that are older are not of this world */
    char *file;             /* its path without symbolic links; NULL: there is no manifest */
    char *path;             /* its path as seen from the current directory */
    /* Private to manifest.c: */
    char *text;
    bool is_open, is_first;
    int descriptor; /* for claims; -1: there are none */
    int made;       /* directories */
};

/* Makes the manifest `path`, which then holds `text`, or compares `text` with what is there: the
   members of an object, of which "manifest", the version of this form, and "derived" are not
   compared. Returns an exit status, after a line on stderr if it is not CLI_SUCCESS: CLI_USAGE if
   another world is there. */
int manifest_open(struct manifest *manifest, const char *path, const char *text);

/* Compares `text` with the manifest `path`, which must be there, and is not changed. Returns as
   manifest_open. */
int manifest_compare(struct manifest *manifest, const char *path, const char *text);

/* Whether it is still there. A user may have removed it to begin anew, or the run that had made it,
   because it failed; and others may have made the next one. */
bool manifest_is_there(const struct manifest *manifest);

/* Makes or compares it again. Returns an exit status, after a line on stderr if it is not
   CLI_SUCCESS. */
int manifest_open_again(struct manifest *manifest);

/* Claims tile number `tile` for this run. False if another run has it; claims end with the run, by
   whatever end. They are a courtesy: where they cannot be had, they are granted. */
bool manifest_claim(const struct manifest *manifest, size_t tile);
void manifest_release(const struct manifest *manifest, size_t tile);

/* Frees the manifest, and removes it unless `keep` if this run made it. May be called at any time
   after zero-initialisation. */
void manifest_close(struct manifest *manifest, bool keep);

#endif
