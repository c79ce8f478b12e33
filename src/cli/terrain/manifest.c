/* SPDX-License-Identifier: MIT
 *
 * Makes the manifest once, without locks, and compares it as text.
 */
#include "terrain/manifest.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shared/error.h"
#include "shared/json.h"
#include "shared/path.h"
#include "shared/posix.h"
#include "shared/text.h"
#include "shared/unfinished.h"

#define VERSION 1 /* of the form of manifests */
#define SIZE_MOST ((size_t)1 << 17)
#define MEMBERS_MOST 100

static int refuse(const struct manifest *manifest, const char *what)
{
    cli_error("%s: %s %s; remove it to begin anew", manifest->option, manifest->path, what);
    return CLI_USAGE;
}

static int tell_failure(const struct manifest *manifest)
{
    cli_error("%s: %s: %s", manifest->option, manifest->path, file_reason(errno));
    return CLI_USAGE;
}

/* The whole file as a text that the caller frees; NULL with errno, which is EFBIG for what cannot
   be a manifest: a long one, or one with NULs, or a pipe, the opening of which would wait. */
static char *read_text(const char *path)
{
    if (file_is_special(path)) {
        errno = EFBIG;
        return NULL;
    }
    FILE *const file = fopen(path, "rb");
    if (file == NULL) {
        return NULL;
    }
    char *const text = malloc(SIZE_MOST + 1);
    const size_t length = text != NULL ? fread(text, 1, SIZE_MOST + 1, file) : 0;
    int reason = text == NULL ? ENOMEM : ferror(file) ? errno : 0;
    fclose(file);
    if (reason == 0 && (length > SIZE_MOST || memchr(text, '\0', length) != NULL)) {
        reason = EFBIG;
    }
    if (reason != 0) {
        free(text);
        errno = reason;
        return NULL;
    }
    text[length] = '\0';
    return text;
}

/* The value of a member, or "nothing" without one */
static int value_length(const struct json_member *member)
{
    return member != NULL ? (int)member->value_length : 7;
}

static const char *value_of(const struct json_member *member)
{
    return member != NULL ? member->value : "nothing";
}

/* Adds "--seed is 1 there and 2 here" if the members of one key, of which one may be NULL, differ.
 */
static void compare_member(const struct json_member *our, const struct json_member *their,
                           struct text *differences)
{
    const struct json_member *const either = our != NULL ? our : their;
    char key[64];
    snprintf(key, sizeof key, "%.*s", (int)either->key_length, either->key);
    if (strcmp(key, "manifest") == 0 || strcmp(key, "derived") == 0 ||
        (value_length(our) == value_length(their) &&
         memcmp(value_of(our), value_of(their), (size_t)value_length(our)) == 0)) {
        return;
    }
    const char *const separator = differences->length > 0 ? "; " : "";
    if (strcmp(key, "recipe") == 0) {
        text_add(differences, "%s--recipe has another text there", separator);
        return;
    }
    text_add(differences, "%s%s%s is %.*s there and %.*s here", separator,
             strcmp(key, "scarp") == 0 ? "" : "--", key, value_length(their), value_of(their),
             value_length(our), value_of(our));
}

/* Adds what differs between two manifests. */
static void compare(const struct json_member *ours, int our_count, const struct json_member *theirs,
                    int their_count, struct text *differences)
{
    for (int i = 0; i < our_count; i++) {
        compare_member(&ours[i], json_find_same(theirs, their_count, &ours[i]), differences);
    }
    /* Keys that this program does not know, and those that come again */
    for (int i = 0; i < their_count; i++) {
        const struct json_member *const their = &theirs[i];
        const struct json_member *const our = json_find_same(ours, our_count, their);
        if (our == NULL || json_find_same(theirs, their_count, their) != their) {
            compare_member(our, their, differences);
        }
    }
}

/* The version of the form of a manifest; 0 if it does not say one. */
static long version_of(const struct json_member *members, int count)
{
    const struct json_member *const version = json_find(members, count, "manifest");
    char *end = NULL;
    const long number = version != NULL ? strtol(version->value, &end, 10) : 0;
    return version != NULL && end == version->value + version->value_length ? number : 0;
}

static int check(const struct manifest *manifest, const char *there)
{
    struct json_member ours[MEMBERS_MOST], theirs[MEMBERS_MOST];
    const int our_count = json_read(manifest->text, ours, MEMBERS_MOST);
    const int their_count = json_read(there, theirs, MEMBERS_MOST);
    if (their_count < 0) {
        return refuse(manifest, "is not JSON, so it is no manifest of scarp");
    }
    const long number = version_of(theirs, their_count);
    if (number < VERSION) {
        return refuse(manifest, "is no manifest of scarp: \"manifest\" is missing or no version");
    }
    if (number > VERSION) {
        cli_error("%s: %s is a manifest of version %ld, but this program reads version %d",
                  manifest->option, manifest->path, number, VERSION);
        return CLI_USAGE;
    }
    struct text differences = {0};
    compare(ours, our_count, theirs, their_count, &differences);
    const bool same = differences.length == 0 && !differences.failed;
    if (!same) {
        cli_error("%s: %s is of another world: %.700s; remove it to begin anew", manifest->option,
                  manifest->path, differences.failed ? "no memory" : differences.bytes);
    }
    free(differences.bytes);
    return same ? CLI_SUCCESS : CLI_USAGE;
}

/* Publishes a file with our text, unless there is one of that name that it does not replace. 1:
   done; 0: there is one; -1: failed, with errno. */
static int make(struct manifest *manifest, bool replaces)
{
    struct file file = {0};
    int result = -1;
    errno = 0;
    if ((manifest->makes_directories ? file_open_making_directories(&file, manifest->path)
                                     : file_open(&file, manifest->path)) &&
        file_write(&file, manifest->text, strlen(manifest->text)) && file_close(&file)) {
        const bool published = replaces ? file_publish(&file) : file_publish_new(&file);
        result = published ? 1 : errno == EEXIST ? 0 : -1;
        if (result == 1) {
            manifest->made = file.made;
            manifest->is_first = true;
            result = file_settle(&file) ? 1 : -1;
        }
    }
    file_discard(&file);
    return result;
}

/* Where it may only be read there are no claims, but it can be recognised. */
static int open_claims(const char *path)
{
    const int descriptor = open(path, O_RDWR | O_CLOEXEC);
    return descriptor >= 0 ? descriptor : open(path, O_RDONLY | O_CLOEXEC);
}

/* No other file has its number as long as it is open. */
bool manifest_is_there(const struct manifest *manifest)
{
    struct stat opened, there;
    return !manifest->is_open || manifest->descriptor < 0 ||
           (fstat(manifest->descriptor, &opened) == 0 && stat(manifest->path, &there) == 0 &&
            opened.st_dev == there.st_dev && opened.st_ino == there.st_ino);
}

/* A claim is the lock of one byte, which need not be there. POSIX's locks reach other machines
   where the file system has them. */
static bool set_lock(const struct manifest *manifest, size_t tile, short type)
{
    struct flock lock = {.l_type = type, .l_whence = SEEK_SET, .l_start = (off_t)tile, .l_len = 1};
    return !manifest->is_open || manifest->descriptor < 0 ||
           fcntl(manifest->descriptor, F_SETLK, &lock) == 0;
}

bool manifest_claim(const struct manifest *manifest, size_t tile)
{
    return set_lock(manifest, tile, F_WRLCK) || (errno != EAGAIN && errno != EACCES);
}

void manifest_release(const struct manifest *manifest, size_t tile)
{
    set_lock(manifest, tile, F_UNLCK);
}

#define TRIES 40 /* how often an empty manifest is looked at again: 2 seconds */

static void pause_shortly(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 50000000}, NULL);
}

/* Compares with what is there, or makes it. An empty file is one that a run reserves where there
   are no hard links: it has its contents soon, unless the run was killed. If several then replace
   it, or the run was but slow, the last one counts: the others notice it by manifest_is_there. */
static int open_or_make(struct manifest *manifest)
{
    for (int i = 0; i <= TRIES; i++) {
        char *const there = read_text(manifest->path);
        if (there != NULL && *there != '\0') {
            const int status = check(manifest, there);
            free(there);
            return status;
        }
        const bool is_empty = there != NULL;
        free(there);
        if (!is_empty && errno == EFBIG) {
            return refuse(manifest, "is not JSON, so it is no manifest of scarp");
        }
        if (!is_empty && errno != ENOENT) {
            return tell_failure(manifest);
        }
        const bool is_left = is_empty && i == TRIES;
        const int made = is_empty && !is_left ? 0 : make(manifest, is_left);
        if (made != 0) {
            return made > 0 ? CLI_SUCCESS : tell_failure(manifest);
        }
        if (is_empty || i > 0) {
            pause_shortly();
        }
    }
    return refuse(manifest, "is made and removed by other runs all the time");
}

static void end_claims(struct manifest *manifest)
{
    if (manifest->is_open && manifest->descriptor >= 0) {
        close(manifest->descriptor);
    }
    manifest->descriptor = -1;
}

static void leave(struct manifest *manifest)
{
    end_claims(manifest);
    manifest->is_open = false;
    manifest->is_first = false;
    free(manifest->file);
    manifest->file = NULL;
}

/* Makes or compares it, and keeps it open. The run that made it may fail, and remove it, while this
   one is about to open it. */
static int join(struct manifest *manifest)
{
    uint64_t size;
    for (int i = 0; i < TRIES; i++) {
        const int status = open_or_make(manifest);
        if (status != CLI_SUCCESS) {
            return status;
        }
        manifest->descriptor = open_claims(manifest->path);
        manifest->is_open = true;
        manifest->file = path_resolve(manifest->path);
        if (manifest->file != NULL && file_look(manifest->path, &size, &manifest->time)) {
            return CLI_SUCCESS;
        }
        if (errno != ENOENT) {
            break;
        }
        leave(manifest);
    }
    return tell_failure(manifest);
}

int manifest_open(struct manifest *manifest, const char *path, const char *text)
{
    manifest->path = text_copy(path);
    manifest->text = text_copy(text);
    if (manifest->path == NULL || manifest->text == NULL) {
        cli_error("%s: no memory", manifest->option);
        return CLI_FAILURE;
    }
    unfinished_sweep(path); /* its directory may have no other file */
    return join(manifest);
}

int manifest_compare(struct manifest *manifest, const char *path, const char *text)
{
    uint64_t size;
    manifest->path = text_copy(path);
    manifest->text = text_copy(text);
    manifest->file = text_copy(path);
    manifest->descriptor = -1;
    if (manifest->path == NULL || manifest->text == NULL || manifest->file == NULL) {
        cli_error("%s: no memory", manifest->option);
        return CLI_FAILURE;
    }
    char *const there = read_text(path);
    if (there == NULL) {
        return tell_failure(manifest);
    }
    const int status = check(manifest, there);
    free(there);
    return status == CLI_SUCCESS && !file_look(path, &size, &manifest->time)
               ? tell_failure(manifest)
               : status;
}

int manifest_open_again(struct manifest *manifest)
{
    leave(manifest);
    manifest->makes_directories = false; /* where they were removed, the tiles were */
    return join(manifest) == CLI_SUCCESS ? CLI_SUCCESS : CLI_FAILURE;
}

void manifest_close(struct manifest *manifest, bool keep)
{
    if (manifest->is_first && !keep && manifest_is_there(manifest)) {
        remove(manifest->file != NULL ? manifest->file : manifest->path);
        end_claims(manifest); /* Windows keeps the name of a file that is open */
        path_remove_directories(manifest->path, manifest->made);
    }
    leave(manifest);
    free(manifest->path);
    free(manifest->text);
    *manifest = (struct manifest){.option = manifest->option};
}
