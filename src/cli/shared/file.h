/* SPDX-License-Identifier: MIT
 *
 * Output files that appear only when they are whole. A file is written under a name of its own
 * next to its final one (see unfinished.h), and takes that when it is complete and has reached
 * the disk: a run that fails leaves no half files, and older ones as they were. "-" is standard
 * output, and it, devices and named pipes are written as they are.
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
    char *path;       /* the final name, without symbolic links in it */
    char *unfinished; /* the name until then; NULL: none, or it has the final one */
    int made;         /* directories that were made for it, and go with it */
    bool replaces;    /* an older file of the final name, since it was published */
    bool is_published;
    int lock; /* a descriptor that keeps the lock of the closed file, if is_locked */
    bool is_locked;
};

/* All return whether they succeeded; on failure errno may tell why. */
bool file_open(struct file *file, const char *path);
bool file_open_making_directories(struct file *file, const char *path);
bool file_close(struct file *file);       /* all is on the disk, still under the unfinished name */
bool file_publish(struct file *file);     /* gives it its final name */
bool file_publish_new(struct file *file); /* unless there is a file of that name: errno is EEXIST */
bool file_settle(const struct file *file); /* the name is on the disk, too */

/* Removes a published file, unless it replaced an older one, which cannot come back. */
void file_retract(struct file *file);

/* False also when the user or the system asked the program to stop, before or while the write
   waits. */
bool file_write(struct file *file, const void *bytes, size_t count);

/* Frees the file. Unless it was published, it is removed, and so are directories that were made for
   it, if they are empty: what was opened last goes first. May be called at any time after
   zero-initialisation. */
void file_discard(struct file *file);

/* Whether both are open files of the same final name, whatever paths they were opened by */
bool file_is_same(const struct file *a, const struct file *b);

/* What messages say of an errno after one of these failed */
const char *file_reason(int reason);

/* Moves to a byte counted from the start. False where that is impossible, as in a pipe. */
bool file_seek(struct file *file, uint64_t offset);

/* Whether `path` is there and is no ordinary file: a device, a pipe, a directory. */
bool file_is_special(const char *path);

/* What messages call the file `path` */
const char *file_name(const char *path);

struct file_time {
    int64_t seconds;
    long nanoseconds;
};

/* Tells the size of an ordinary file and when it was last written, but not later than the system
   says that anything about it changed: programs can set the first to times to come. False if there
   is none of that name. */
bool file_look(const char *path, uint64_t *size, struct file_time *time);

bool file_is_older(struct file_time a, struct file_time b);

#endif
