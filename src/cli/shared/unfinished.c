/* SPDX-License-Identifier: MIT
 *
 * A name contains the machine and the process, so that whoever finds the file knows whose it is,
 * and a number that no other process of that name has, in another container for instance. Nothing
 * depends on locks: they only tell the processes of containers from dead ones.
 */
#include "shared/unfinished.h"

#include <errno.h>
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "shared/interrupt.h"
#include "shared/path.h"
#include "shared/posix.h"
#include "shared/text.h"

#define HOST_MAX 64 /* characters of the machine's name that are used */
#define NAME_MAX_USED                                                                              \
    120                  /* bytes of the file's own name that are used; systems allow 255 in all   \
                          */
#define NUMBER_DIGITS 16 /* own_number, and a count of the files */
#define TRIES 100

/* The machine's name, of only letters, digits and dots */
static void get_host(char host[HOST_MAX + 1])
{
    memset(host, 0, HOST_MAX + 1);
    if (gethostname(host, HOST_MAX) != 0) {
        host[0] = '\0';
    }
    for (char *c = host; *c != '\0'; c++) {
        const bool plain = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') ||
                           (*c >= '0' && *c <= '9') || *c == '.';
        *c = plain ? *c : '_';
    }
    if (host[0] == '\0') {
        strcpy(host, "unknown");
    }
}

/* A number that tells processes of one name apart: they start at different times, or their memory
   lies elsewhere. It need not be secret. */
static uint32_t own_number(void)
{
    static uint32_t number;
    if (number == 0) {
        struct timespec now = {0, 0};
        timespec_get(&now, TIME_UTC);
        uint64_t z = (uint64_t)now.tv_sec * 1000000007 + (uint64_t)now.tv_nsec;
        z ^= (uint64_t)(uintptr_t)&now << 20;
        z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9); /* of splitmix64 (S. Vigna) */
        z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
        number = (uint32_t)(z >> 32) | 1;
    }
    return number;
}

/* The bytes of `path` that go into the name: not more than fit, and no half of a character */
static size_t used_length(const char *path)
{
    const size_t directory = path_directory_length(path);
    const size_t length = strlen(path);
    if (length - directory <= NAME_MAX_USED) {
        return length;
    }
    size_t used = directory + NAME_MAX_USED;
    while (((unsigned char)path[used] & 0xc0) == 0x80 && used > directory + 1) {
        used--;
    }
    return used;
}

static long own_process(void)
{
    return (long)getpid();
}

static char *make_name(const char *path)
{
    static uint32_t files;
    char host[HOST_MAX + 1], end[HOST_MAX + 64];
    get_host(host);
    snprintf(end, sizeof end, ".%s-%ld-%08" PRIx32 "%08" PRIx32 UNFINISHED_END, host, own_process(),
             own_number(), files++);
    return text_join_part(path, used_length(path), end);
}

/* The lock is for unfinished_sweep of a process that cannot see this one. */
static void lock(int descriptor)
{
    while (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EINTR) {
    }
}

char *unfinished_make(const char *path, unsigned mode, FILE **stream)
{
    for (int i = 0; i < TRIES; i++) {
        char *const name = make_name(path);
        const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
        const int descriptor = name != NULL ? open(name, flags, (mode_t)mode) : -1;
        if (descriptor >= 0) {
            lock(descriptor);
            *stream = fdopen(descriptor, "wb");
            if (*stream != NULL) {
                return name;
            }
        }
        const int reason = errno;
        if (descriptor >= 0) {
            close(descriptor);
            remove(name);
        }
        free(name);
        errno = reason;
        if (reason != EEXIST) {
            break;
        }
    }
    return NULL;
}

/* The process of this machine that a file belongs to, and its number; 0 if `name` is none of those
   names. */
static long owner(const char *name, const char *host, uint32_t *number)
{
    const size_t tail = 1 + NUMBER_DIGITS + strlen(UNFINISHED_END); /* "-0123456789abcdef.part" */
    const size_t length = strlen(name);
    if (length <= tail || strcmp(name + length - strlen(UNFINISHED_END), UNFINISHED_END) != 0 ||
        name[length - tail] != '-' ||
        strspn(name + length - tail + 1, "0123456789abcdef") != NUMBER_DIGITS) {
        return 0;
    }
    const char *digits = name + length - tail;
    while (digits > name && digits[-1] >= '0' && digits[-1] <= '9') {
        digits--;
    }
    const size_t before = strlen(host) + 2; /* ".HOST-" */
    if ((size_t)(digits - name) <= before || digits[-1] != '-' || digits[-(long)before] != '.' ||
        memcmp(digits - before + 1, host, before - 2) != 0) {
        return 0;
    }
    char first[NUMBER_DIGITS / 2 + 1] = "";
    memcpy(first, name + length - tail + 1, NUMBER_DIGITS / 2);
    *number = (uint32_t)strtoul(first, NULL, 16);
    return strtol(digits, NULL, 10);
}

/* Whether all that is left of a process is its number, which nobody has asked for the status of. */
static bool is_zombie(long process)
{
    bool result = false;
#ifdef __linux__
    char path[64], line[256] = "";
    snprintf(path, sizeof path, "/proc/%ld/stat", process);
    FILE *const file = fopen(path, "r");
    if (file != NULL) {
        const char *const end = fgets(line, sizeof line, file) != NULL ? strrchr(line, ')') : NULL;
        result = end != NULL && strncmp(end, ") Z", 3) == 0;
        fclose(file);
    }
#else
    (void)process;
#endif
    return result;
}

static bool has_ended(long process)
{
    return (kill((pid_t)process, 0) != 0 && errno == ESRCH) || is_zombie(process);
}

/* Removes the file unless somebody has locked it; with `must_lock`, also not where nobody could. */
static void remove_unlocked(const char *path, bool must_lock)
{
    struct stat status;
    const int descriptor = open(path, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        return;
    }
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool is_free = locked || (!must_lock && errno != EWOULDBLOCK);
    if (is_free && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
        unlink(path);
    }
    close(descriptor);
}

static void sweep(const char *path, DIR *directory)
{
    char host[HOST_MAX + 1];
    get_host(host);
    struct dirent *entry;
    while (!interrupted() && (entry = readdir(directory)) != NULL) {
        uint32_t number = 0;
        const long process = owner(entry->d_name, host, &number);
        /* In a container that is started again, a process may be called as its predecessor was. */
        const bool is_namesake = process == own_process() && number != own_number();
        if (process > 0 && (is_namesake || has_ended(process))) {
            char *const name = text_join_part(path, path_directory_length(path), entry->d_name);
            if (name != NULL) {
                remove_unlocked(name, is_namesake);
            }
            free(name);
        }
    }
}

#define SEEN_MAX 16 /* a run alternates between few directories */

/* Whether the directory was not seen lately. */
static bool is_new(const struct stat *status)
{
    static struct {
        uint64_t device, file;
    } seen[SEEN_MAX];
    static size_t next;
    for (size_t i = 0; i < SEEN_MAX; i++) {
        if (seen[i].device == (uint64_t)status->st_dev &&
            seen[i].file == (uint64_t)status->st_ino) {
            return false;
        }
    }
    seen[next].device = (uint64_t)status->st_dev;
    seen[next].file = (uint64_t)status->st_ino;
    next = (next + 1) % SEEN_MAX;
    return true;
}

void unfinished_sweep(const char *path)
{
    struct stat status;
    const size_t length = path_directory_length(path);
    char *const name = text_join_part(path, length, length == 0 ? "." : "");
    if (name != NULL && stat(name, &status) == 0 && is_new(&status)) {
        DIR *const directory = opendir(name);
        if (directory != NULL) {
            sweep(path, directory);
            closedir(directory);
        }
    }
    free(name);
}
