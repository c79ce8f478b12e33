/* SPDX-License-Identifier: MIT
 *
 * Output files that appear only when they are whole. A file is written under a temporary name
 * beside its own, PATH.part, and takes its own name when all of it is written: a run that fails
 * leaves no half files, and older ones as they were; two runs do not write one file at a time. "-"
 * is standard output, and it, devices and named pipes are written as they are. Used by everything
 * that writes.
 */
#ifndef SCARP_CLI_FILE_H
#define SCARP_CLI_FILE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* Zero-initialise, then open. */
struct file {
    FILE *stream;
    bool waits; /* a pipe or the like: a write may wait for whoever reads */
    /* Private to file.c: */
    char *path, *partial; /* the final and the temporary name; none: no temporary name */
    bool published;       /* under the final name */
    bool is_locked;
    int lock; /* a descriptor that keeps other runs from the temporary file */
};

/* All return whether they succeeded; on failure errno may tell why. */
bool file_open(struct file *file, const char *path);
bool file_close(struct file *file); /* nothing is left to write; still under its temporary name */
bool file_publish(struct file *file);

/* False also when the user or the system asked the program to stop, before or while the write
   waits. */
bool file_write(struct file *file, const void *bytes, size_t count);

/* Frees the file. Unless it was published, it is removed. May be called at any time after
   zero-initialisation. */
void file_discard(struct file *file);

/* What messages say of an errno after one of these failed */
const char *file_reason(int reason);

/* Moves to a byte counted from the start. False where that is impossible, as in a pipe. */
bool file_seek(struct file *file, uint64_t offset);

/* Whether `path` is there and is no ordinary file: a device, a pipe, a directory. */
bool file_is_special(const char *path);

/* What messages call the file `path` */
const char *file_name(const char *path);

/* Whether there is a file of that name already, and not a directory, device or pipe. */
bool file_exists(const char *path);

/* The texts one after the other, NULL at the end, in memory that the caller frees; NULL without
   memory. */
char *file_join(const char *const *texts);

#endif
