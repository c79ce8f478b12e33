/* SPDX-License-Identifier: MIT
 *
 * The life of an output file: unfinished name, final name, removal.
 */
#include "shared/file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "shared/interrupt.h"
#include "shared/path.h"
#include "shared/posix.h"
#include "shared/unfinished.h"

static bool is_standard_output(const char *path)
{
    return strcmp(path, "-") == 0;
}

const char *file_name(const char *path)
{
    return is_standard_output(path) ? "standard output" : path;
}

bool file_is_older(struct file_time a, struct file_time b)
{
    return a.seconds < b.seconds || (a.seconds == b.seconds && a.nanoseconds < b.nanoseconds);
}

static struct file_time earlier(const struct timespec *a, const struct timespec *b)
{
    const struct file_time first = {a->tv_sec, a->tv_nsec}, second = {b->tv_sec, b->tv_nsec};
    return file_is_older(first, second) ? first : second;
}

bool file_look(const char *path, uint64_t *size, struct file_time *time)
{
    struct stat status;
    if (stat(path, &status) != 0 || !S_ISREG(status.st_mode)) {
        return false;
    }
    *size = (uint64_t)status.st_size;
#if defined(__APPLE__)
    *time = earlier(&status.st_mtimespec, &status.st_ctimespec);
#else
    *time = earlier(&status.st_mtim, &status.st_ctim);
#endif
    return true;
}

bool file_is_special(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

bool file_is_same(const struct file *a, const struct file *b)
{
    return a->unfinished != NULL && b->unfinished != NULL && path_is_same(a->path, b->path);
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

/* Whether `path` can take the file: nothing is there yet, or a file that may be changed. Renaming
   would fail only at the very end, and would replace a write-protected file. */
static bool is_replaceable(const char *path)
{
    FILE *const old = fopen(path, "r+b");
    if (old == NULL) {
        return errno == ENOENT;
    }
    return fclose(old) == 0;
}

/* A file under an unfinished name, with the permissions of the one that it replaces */
static bool open_ordinary(struct file *file)
{
    struct stat old;
    const bool replaces = stat(file->path, &old) == 0;
    if (!is_replaceable(file->path)) {
        return false;
    }
    unfinished_sweep(file->path);
    const unsigned mode = replaces ? (unsigned)old.st_mode & 0777 : 0666;
    file->unfinished = unfinished_make(file->path, mode, &file->stream);
    if (file->unfinished != NULL && replaces) {
        /* What the umask took away. Some file systems have no permissions. */
        (void)!fchmod(fileno(file->stream), old.st_mode & 07777);
    }
    return file->unfinished != NULL;
}

bool file_open(struct file *file, const char *path)
{
    if (is_standard_output(path)) {
        file->stream = stdout;
        return prepare(file);
    }
    if (file_is_special(path)) {
        file->stream = fopen(path, "wb");
        return file->stream != NULL && prepare(file);
    }
    file->path = path_resolve(path);
    return file->path != NULL && open_ordinary(file);
}

#define TRIES 10

/* Just before the file is opened, another run may remove the directory: it made that for a file of
   its own, which failed. */
bool file_open_making_directories(struct file *file, const char *path)
{
    for (int i = 0; i < TRIES; i++) {
        const int made = path_make_directories(path);
        if (made >= 0 && file_open(file, path)) {
            file->made = made;
            return true;
        }
        const int reason = errno;
        path_remove_directories(path, made);
        free(file->path);
        file->path = NULL;
        errno = reason;
        if (reason != ENOENT) {
            break;
        }
    }
    return false;
}

/* fwrite would take up again what a signal ended halfway, and wait on. */
bool file_write(struct file *file, const void *bytes, size_t count)
{
    const char *next = bytes;
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
    return count == 0 || fwrite(next, 1, count, file->stream) == count;
}

/* Waits until all that was written is on the disk: a name must not survive a power cut that its
   contents do not. Not every file system can tell. */
static bool synchronise(FILE *stream)
{
#ifdef F_FULLFSYNC
    if (fcntl(fileno(stream), F_FULLFSYNC) == 0) {
        return true;
    }
#endif
    return path_sync(fileno(stream));
}

/* The lock of an unfinished file lasts until it has its final name: see unfinished.h. */
static void keep_lock(struct file *file, FILE *stream)
{
    if (file->unfinished != NULL) {
        file->lock = dup(fileno(stream));
        file->is_locked = file->lock >= 0;
    }
}

static void end_lock(struct file *file)
{
    if (file->is_locked) {
        close(file->lock);
    }
    file->is_locked = false;
}

bool file_close(struct file *file)
{
    FILE *const stream = file->stream;
    file->stream = NULL;
    if (stream == NULL) {
        return true;
    }
    const bool written =
        fflush(stream) == 0 && !ferror(stream) && (file->unfinished == NULL || synchronise(stream));
    const int reason = errno;
    keep_lock(file, stream);
    const bool closed = stream == stdout || fclose(stream) == 0;
    if (!written) {
        errno = reason;
    }
    return written && closed;
}

/* Forgets a file that has its final name, which stays. */
static void forget_unfinished(struct file *file)
{
    end_lock(file);
    free(file->unfinished);
    file->unfinished = NULL;
    file->is_published = true;
}

bool file_publish(struct file *file)
{
    struct stat old;
    if (file->unfinished == NULL) {
        return true;
    }
    /* Not when it was opened: another run may have written the file since. */
    file->replaces = stat(file->path, &old) == 0;
    if (rename(file->unfinished, file->path) != 0) {
        return false;
    }
    forget_unfinished(file);
    return true;
}

/* Gives the name to the file by a hard link, which is made only where nothing of the name is. Over
   a network the answer may get lost, so the links are counted. Where there are no hard links, the
   name is reserved first. */
static bool publish_by_link(struct file *file)
{
    struct stat status;
    if (link(file->unfinished, file->path) == 0 ||
        (errno == EEXIST && stat(file->unfinished, &status) == 0 && status.st_nlink == 2)) {
        unlink(file->unfinished);
        return true;
    }
    if (errno == EEXIST) {
        return false;
    }
    const int descriptor = open(file->path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return false;
    }
    close(descriptor);
    if (rename(file->unfinished, file->path) != 0) {
        const int reason = errno;
        unlink(file->path);
        errno = reason;
        return false;
    }
    return true;
}

bool file_publish_new(struct file *file)
{
    if (!publish_by_link(file)) {
        return false;
    }
    forget_unfinished(file);
    return true;
}

bool file_settle(const struct file *file)
{
    return file->path == NULL || path_sync_directory(file->path);
}

void file_retract(struct file *file)
{
    if (file->is_published && !file->replaces) {
        const int reason = errno;
        remove(file->path);
        file->is_published = false;
        errno = reason;
    }
}

void file_discard(struct file *file)
{
    const int reason = errno;
    if (file->stream != NULL && file->stream != stdout) {
        fclose(file->stream);
    }
    if (file->unfinished != NULL) {
        remove(file->unfinished);
    }
    end_lock(file);
    if (file->made > 0 && !file->is_published) {
        path_remove_directories(file->path, file->made);
    }
    free(file->path);
    free(file->unfinished);
    *file = (struct file){0};
    errno = reason;
}

const char *file_reason(int reason)
{
    return reason == EBUSY ? "is already written by another option, or is the manifest"
           : reason == 0   ? "cannot be written"
                           : strerror(reason);
}

bool file_seek(struct file *file, uint64_t offset)
{
    return fseeko(file->stream, (off_t)offset, SEEK_SET) == 0;
}
