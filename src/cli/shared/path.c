/* SPDX-License-Identifier: MIT
 *
 * Handles paths by the calls of POSIX. On Windows, a link to a file that is not there is not
 * followed, and directories cannot be synchronised.
 */
#include "shared/path.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "shared/interrupt.h"
#include "shared/posix.h"
#include "shared/text.h"

static bool is_separator(char c)
{
#ifdef _WIN32
    return c == '/' || c == '\\';
#else
    return c == '/';
#endif
}

size_t path_directory_length(const char *path)
{
    size_t length = strlen(path);
    while (length > 0 && !is_separator(path[length - 1])) {
        length--;
    }
    return length;
}

const char *path_extension(const char *path)
{
    const char *const name = path + path_directory_length(path);
    const char *const dot = strrchr(name, '.');
    return dot != NULL && dot != name ? dot : path + strlen(path);
}

#ifdef _WIN32
static char *make_absolute(const char *path)
{
    return windows_absolute(path);
}

static size_t root_length(const char *path)
{
    return windows_root_length(path);
}

bool path_is_same(const char *a, const char *b)
{
    return windows_is_same(a, b);
}
#else
/* `path` from the root on, without "." and ".." and doubled separators. */
static char *make_absolute(const char *path)
{
    char here[4096] = "";
    if (!is_separator(path[0]) && getcwd(here, sizeof here) == NULL) {
        return NULL;
    }
    char *const whole = text_join((const char *const[]){here, "/", path, NULL});
    size_t used = 0;
    for (size_t at = 0; whole != NULL && whole[at] != '\0';) {
        size_t end = at + 1; /* whole[at] is a separator */
        while (whole[end] != '\0' && !is_separator(whole[end])) {
            end++;
        }
        const size_t length = end - at;
        if (length == 3 && whole[at + 1] == '.' && whole[at + 2] == '.') {
            while (used > 0 && whole[--used] != '/') {
            }
        } else if (length > 2 || (length == 2 && whole[at + 1] != '.')) {
            whole[used] = '/';
            memmove(whole + used + 1, whole + at + 1, length - 1);
            used += length;
        }
        at = end;
    }
    if (whole != NULL) {
        whole[used] = '\0';
    }
    return whole;
}

/* How much of `path` names what nobody can make. */
static size_t root_length(const char *path)
{
    (void)path;
    return 0;
}

bool path_is_same(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}
#endif

char *path_relative(const char *path, const char *from)
{
    char *const to = make_absolute(path), *const base = make_absolute(from);
    struct text relative = {0};
    if (to != NULL && base != NULL) {
        size_t common = 0; /* characters of the directories that both share */
        for (size_t i = 0; to[i] == base[i] && to[i] != '\0'; i++) {
            common = to[i] == '/' ? i + 1 : common;
        }
        /* On Windows there is no way from one drive to another. */
        const char *c = common > 0 ? strchr(base + common, '/') : NULL;
        for (; c != NULL; c = strchr(c + 1, '/')) {
            text_add(&relative, "../");
        }
        text_add(&relative, "%s", to + common);
    }
    free(to);
    free(base);
    return relative.bytes;
}

/* Makes the directory that the first `length` characters of `path` name. 1: made; 0: there is
   something of that name; -1: neither. */
static int make_one(char *path, size_t length)
{
    const char after = path[length];
    path[length] = '\0';
    const int made = mkdir(path, 0777) == 0 ? 1 : errno == EEXIST || errno == EISDIR ? 0 : -1;
    path[length] = after;
    return made;
}

int path_make_directories(const char *path)
{
    struct stat status;
    char *const copy = text_copy(path);
    const size_t end = path_directory_length(path);
    int count = 0;
    if (copy == NULL) {
        return -1;
    }
    copy[end] = '\0';
    if (end == 0 || stat(copy, &status) == 0) {
        free(copy);
        return 0;
    }
    copy[end] = path[end];
    for (size_t i = 1 + root_length(path); i < end; i++) {
        if (!is_separator(path[i]) || is_separator(path[i - 1])) {
            continue;
        }
        const int made = make_one(copy, i);
        if (made < 0) {
            const int reason = errno;
            path_remove_directories(copy, count);
            free(copy);
            errno = reason;
            return -1;
        }
        count += made;
    }
    free(copy);
    return count;
}

void path_remove_directories(const char *path, int count)
{
    char *const copy = count > 0 ? text_copy(path) : NULL;
    size_t end = copy != NULL ? path_directory_length(copy) : 0;
    for (; count > 0 && end > 1; count--) {
        copy[end - 1] = '\0';
        if (rmdir(copy) != 0) {
            break;
        }
        end = path_directory_length(copy);
    }
    free(copy);
}

/* What the link `path` says, after the directory of `path` unless it is absolute; NULL if it is no
   link. */
static char *read_link(const char *path)
{
    char target[4096];
    const ssize_t length = readlink(path, target, sizeof target - 1);
    if (length < 0) {
        return NULL;
    }
    target[length] = '\0';
    return target[0] == '/' ? text_copy(target)
                            : text_join_part(path, path_directory_length(path), target);
}

/* The directory's real path and the file's name. */
static char *resolve_parent(const char *path)
{
    const size_t length = path_directory_length(path);
    char *const directory = text_join_part(path, length, length == 0 ? "." : "");
    char *const real = directory != NULL ? realpath(directory, NULL) : NULL;
    char *const resolved =
        real != NULL ? text_join((const char *const[]){real, strcmp(real, "/") == 0 ? "" : "/",
                                                       path + length, NULL})
                     : NULL;
    free(directory);
    free(real);
    return resolved;
}

#define LINKS_MAX 40 /* as the Linux kernel follows */

char *path_resolve(const char *path)
{
    char *const real = realpath(path, NULL);
    if (real != NULL) {
        return real;
    }
    /* Nothing is there, but a link may say where it would be. */
    char *at = text_copy(path);
    for (int links = 0; at != NULL && links < LINKS_MAX; links++) {
        char *const next = read_link(at);
        if (next == NULL) {
            char *const resolved = resolve_parent(at);
            free(at);
            return resolved;
        }
        free(at);
        at = next;
    }
    free(at);
    errno = ELOOP;
    return NULL;
}

bool path_sync(int descriptor)
{
    int result = fsync(descriptor);
    while (result != 0 && errno == EINTR && !interrupted()) {
        result = fsync(descriptor);
    }
    return result == 0 || errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
}

bool path_sync_directory(const char *path)
{
    const size_t length = path_directory_length(path);
    char *const directory = text_join_part(path, length, length == 0 ? "." : "");
    if (directory == NULL) {
        return false;
    }
    const int descriptor = open(directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    free(directory);
    if (descriptor < 0) {
        return errno == EACCES; /* it may be written, but not read */
    }
    const bool synced = path_sync(descriptor);
    const int reason = errno;
    close(descriptor);
    errno = reason;
    return synced;
}
