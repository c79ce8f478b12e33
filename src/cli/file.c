/* SPDX-License-Identifier: MIT
 *
 * The life of an output file: temporary name, final name, removal.
 */
#include "file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>

#include "interrupt.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#define SEEK_SET_64(stream, offset) _fseeki64(stream, (__int64)(offset), SEEK_SET)
#ifndef S_ISREG
#define S_ISREG(mode) (((mode)&_S_IFMT) == _S_IFREG)
#endif
#ifndef S_ISCHR
#define S_ISCHR(mode) (((mode)&_S_IFMT) == _S_IFCHR)
#endif
#else
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#define SEEK_SET_64(stream, offset) fseeko(stream, (off_t)(offset), SEEK_SET)
#endif

char *file_join(const char *const *texts)
{
    size_t length = 1;
    for (size_t i = 0; texts[i] != NULL; i++) {
        length += strlen(texts[i]);
    }
    char *const joined = malloc(length);
    if (joined == NULL) {
        return NULL;
    }
    joined[0] = '\0';
    for (size_t i = 0; texts[i] != NULL; i++) {
        strcat(joined, texts[i]);
    }
    return joined;
}

static bool is_standard_output(const char *path)
{
    return strcmp(path, "-") == 0;
}

const char *file_name(const char *path)
{
    return is_standard_output(path) ? "standard output" : path;
}

bool file_exists(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISREG(status.st_mode);
}

bool file_is_special(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

/* Whether `path` can take the file: nothing is there yet, or a file that may be changed. Renaming
   would tell only at the very end, and would replace a write-protected file. */
static bool is_replaceable(const char *path)
{
    FILE *const old = fopen(path, "r+b");
    if (old == NULL) {
        return errno == ENOENT;
    }
    return fclose(old) == 0;
}

/* Finds out whether writes wait. Then nothing is buffered, which closing the file would wait for.
 */
static bool prepare(struct file *file)
{
    struct stat status;
    file->waits = fstat(fileno(file->stream), &status) == 0 && !S_ISREG(status.st_mode) &&
                  !S_ISCHR(status.st_mode);
    return !file->waits || setvbuf(file->stream, NULL, _IONBF, 0) == 0;
}

#ifdef _WIN32
static char *follow_links(const char *path)
{
    return file_join((const char *const[]){path, NULL});
}

static FILE *open_partial(struct file *file, const char *partial)
{
    (void)file;
    return fopen(partial, "wb");
}

static void unlock(struct file *file)
{
    (void)file;
}
#else
/* What a link leads to is written, not the link. */
static char *follow_links(const char *path)
{
    char *const target = realpath(path, NULL);
    return target != NULL ? target : file_join((const char *const[]){path, NULL});
}

/* Locks the file at `path`, made if need be. -1 if that cannot be; errno is EBUSY if another run
   has locked it, or this one by another name. Where there are no locks, it does without. */
static int open_locked(const char *path)
{
    for (;;) {
        const int descriptor = open(path, O_WRONLY | O_CREAT, 0666);
        if (descriptor < 0) {
            return -1;
        }
        if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            close(descriptor);
            errno = EBUSY;
            return -1;
        }
        /* Until it was locked, another run may have finished with it and renamed it. */
        struct stat locked, named;
        if (fstat(descriptor, &locked) == 0 && stat(path, &named) == 0 &&
            locked.st_ino == named.st_ino && locked.st_dev == named.st_dev) {
            return descriptor;
        }
        close(descriptor);
    }
}

/* The temporary file, empty, for this run alone: it stays locked until it has its own name. What a
   run that was killed left is no longer locked. */
static FILE *open_partial(struct file *file, const char *partial)
{
    const int descriptor = open_locked(partial);
    if (descriptor < 0) {
        return NULL;
    }
    const int copy = dup(descriptor);
    FILE *const stream = copy >= 0 && ftruncate(copy, 0) == 0 ? fdopen(copy, "wb") : NULL;
    if (stream == NULL) {
        close(copy);
        close(descriptor);
        return NULL;
    }
    file->is_locked = true;
    file->lock = descriptor;
    return stream;
}

static void unlock(struct file *file)
{
    if (file->is_locked) {
        close(file->lock);
    }
    file->is_locked = false;
}
#endif

/* A file under a temporary name */
static bool open_ordinary(struct file *file)
{
    if (!is_replaceable(file->path)) {
        return false;
    }
    char *const partial = file_join((const char *const[]){file->path, ".part", NULL});
    if (partial == NULL) {
        return false;
    }
    file->stream = open_partial(file, partial);
    if (file->stream == NULL) {
        free(partial);
        return false;
    }
    file->partial = partial;
    return true;
}

bool file_open(struct file *file, const char *path)
{
    file->path = follow_links(path);
    if (file->path == NULL) {
        return false;
    }
    if (is_standard_output(path)) {
#ifdef _WIN32
        _setmode(_fileno(stdout), _O_BINARY);
#endif
        file->stream = stdout;
        return prepare(file);
    }
    if (file_is_special(path)) {
        file->stream = fopen(path, "wb");
        return file->stream != NULL && prepare(file);
    }
    return open_ordinary(file);
}

/* fwrite would take up again what a signal ended halfway, and wait on. */
bool file_write(struct file *file, const void *bytes, size_t count)
{
    const char *next = bytes;
#ifndef _WIN32
    while (file->waits && count > 0) {
        if (interrupted()) {
            errno = EINTR;
            return false;
        }
        const ssize_t written = write(fileno(file->stream), next, count);
        if (written < 0 && errno != EINTR) {
            return false;
        }
        next += written < 0 ? 0 : written;
        count -= written < 0 ? 0 : (size_t)written;
    }
#endif
    return count == 0 || fwrite(next, 1, count, file->stream) == count;
}

bool file_close(struct file *file)
{
    FILE *const stream = file->stream;
    file->stream = NULL;
    if (stream == NULL) {
        return true;
    }
    const bool written = fflush(stream) == 0 && !ferror(stream);
    const int reason = errno;
    const bool closed = stream == stdout || fclose(stream) == 0;
    if (!written) {
        errno = reason;
    }
    return written && closed;
}

bool file_publish(struct file *file)
{
    if (file->partial == NULL) {
        return true;
    }
#ifdef _WIN32
    remove(file->path); /* where rename does not replace */
#endif
    file->published = rename(file->partial, file->path) == 0;
    unlock(file);
    return file->published;
}

void file_discard(struct file *file)
{
    file_close(file);
    if (file->partial != NULL && !file->published) {
        remove(file->partial);
    }
    unlock(file);
    free(file->path);
    free(file->partial);
    *file = (struct file){0};
}

const char *file_reason(int reason)
{
    return reason == EBUSY ? "is being written by another run, or another option"
           : reason == 0   ? "cannot be written"
                           : strerror(reason);
}

bool file_seek(struct file *file, uint64_t offset)
{
    return SEEK_SET_64(file->stream, offset) == 0;
}
