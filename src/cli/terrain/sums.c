/* SPDX-License-Identifier: MIT
 *
 * Adds lines to the file of a share, and reads those of all shares.
 */
#include "terrain/sums.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shared/hash.h"
#include "shared/interrupt.h"
#include "shared/path.h"
#include "shared/posix.h"
#include "shared/text.h"

#define END ".sums"
#define HASH_DIGITS 16

/* The manifest's path without .json */
static char *stem_of(const char *manifest)
{
    return text_join_part(manifest, (size_t)(path_extension(manifest) - manifest), "");
}

bool sums_open(struct sums *sums, const char *manifest, struct option_share share)
{
    struct text path = {0};
    char *const stem = stem_of(manifest);
    if (stem != NULL && share.count != 0) {
        text_add(&path, "%s.%zu-%zu" END, stem, share.index, share.count);
    } else if (stem != NULL) {
        text_add(&path, "%s" END, stem);
    }
    free(stem);
    sums->path = path.bytes;
    sums->manifest = manifest;
    return path.bytes != NULL && !path.failed;
}

/* Adds the line of a file that lies at `now`, and will be called `path`. */
static bool add_line(const struct sums *sums, const char *now, const char *path, struct text *text)
{
    uint64_t hash;
    if (now == NULL) {
        return true; /* a device or a pipe */
    }
    if (!hash_file(now, &hash)) {
        return false;
    }
    char *const relative = path_relative(path, sums->manifest);
    text_add(text, "%016llx  %s\n", (unsigned long long)hash, relative != NULL ? relative : "");
    text->failed |= relative == NULL;
    free(relative);
    return true;
}

static bool add_lines(const struct sums *sums, const struct products *products, struct text *text)
{
    for (size_t i = 0; i < products->count; i++) {
        const struct product *const product = &products->list[i];
        const struct writer *const writer = &product->writer;
        char *const beside =
            product->format->beside != NULL ? product->format->beside(product->tile_path) : NULL;
        const bool added =
            add_line(sums, writer->file.unfinished, product->tile_path, text) &&
            (beside == NULL || add_line(sums, writer->header.unfinished, beside, text));
        free(beside);
        if (!added) {
            return false;
        }
    }
    if (text->failed) {
        errno = ENOMEM;
    }
    return !text->failed;
}

#define TRIES 40

/* Locks a byte far behind the end, so that runs which share one file add one after the other. Where
   there are no locks, appending must do. The lock ends with the descriptor. */
static void lock(int descriptor)
{
    struct flock lock = {
        .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)1 << 30, .l_len = 1};
    for (int i = 0; i < TRIES; i++) {
        if (fcntl(descriptor, F_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES)) {
            return;
        }
        nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL);
    }
}

static bool write_all(int descriptor, const char *bytes, size_t count)
{
    while (count > 0) {
        const ssize_t written = write(descriptor, bytes, count);
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes += written < 0 ? 0 : written;
        count -= written < 0 ? 0 : (size_t)written;
    }
    return true;
}

/* Opens the file to append to it. */
static int open_sums(struct sums *sums)
{
    const int flags = O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC;
    const int made = open(sums->path, flags | O_EXCL, 0666);
    sums->is_new |= made >= 0;
    return made >= 0 ? made : open(sums->path, flags, 0666);
}

static bool append(struct sums *sums, const struct text *text)
{
    const int descriptor = open_sums(sums);
    if (descriptor < 0) {
        return false;
    }
    lock(descriptor);
    const bool is_written =
        write_all(descriptor, text->bytes, text->length) && path_sync(descriptor);
    const int reason = errno;
    const bool is_closed = close(descriptor) == 0;
    if (!is_written) {
        errno = reason;
    }
    return is_written && is_closed;
}

bool sums_keep(struct sums *sums, const struct products *products)
{
    struct text text = {0};
    errno = 0;
    const bool kept =
        add_lines(sums, products, &text) && (text.bytes == NULL || append(sums, &text));
    const int reason = errno;
    free(text.bytes);
    errno = reason;
    return kept;
}

void sums_close(struct sums *sums, bool keep)
{
    if (sums->is_new && !keep) {
        unlink(sums->path);
    }
    free(sums->path);
    *sums = (struct sums){.path = NULL};
}

/* ---- reading ---- */

/* Makes room for one more line. */
static bool grow(struct sums_list *list)
{
    if (list->count < list->room) {
        return true;
    }
    const size_t room = list->room > 0 ? 2 * list->room : 1024;
    struct sums_line *const lines = realloc(list->lines, room * sizeof *lines);
    if (lines == NULL) {
        return false;
    }
    list->lines = lines;
    list->room = room;
    return true;
}

/* Reads a line, and ends its path with a NUL. What is no line is left out: a run may have been
   killed. */
static bool read_line(struct sums_list *list, char *line)
{
    const size_t digits = strspn(line, "0123456789abcdefABCDEF"); /* strtoull takes signs, too */
    if (digits != HASH_DIGITS || strncmp(line + digits, "  ", 2) != 0) {
        return true;
    }
    const unsigned long long hash = strtoull(line, NULL, 16);
    if (!grow(list)) {
        return false;
    }
    list->lines[list->count++] = (struct sums_line){.path = line + digits + 2, .hash = hash};
    return true;
}

/* A whole file as a text, which the list then owns; NULL with errno */
static char *read_file(struct sums_list *list, const char *path)
{
    char **const texts = realloc(list->texts, (list->text_count + 1) * sizeof *texts);
    if (texts == NULL) {
        return NULL;
    }
    list->texts = texts;
    uint64_t size;
    struct file_time time;
    FILE *const file = file_look(path, &size, &time) ? fopen(path, "rb") : NULL;
    char *const text = file != NULL && size < SIZE_MAX ? malloc((size_t)size + 1) : NULL;
    const size_t length = text != NULL ? fread(text, 1, (size_t)size, file) : 0;
    if (file != NULL) {
        fclose(file);
    }
    if (text != NULL) {
        text[length] = '\0';
        list->texts[list->text_count++] = text;
    }
    return text;
}

static bool read_sums(struct sums_list *list, const char *path)
{
    char *const text = read_file(list, path);
    bool is_read = text != NULL;
    for (char *line = text, *end; is_read && *line != '\0' && !interrupted(); line = end) {
        end = line + strcspn(line, "\n");
        const bool is_whole = *end == '\n';
        if (is_whole) {
            *end++ = '\0';
            is_read = read_line(list, line);
        }
    }
    return is_read;
}

/* Whether `name` is STEM.sums or STEM.I-N.sums */
static bool is_of_world(const char *name, const char *stem)
{
    const size_t length = strlen(stem), all = strlen(name), end = strlen(END);
    if (all < length + end || strncmp(name, stem, length) != 0 ||
        strcmp(name + all - end, END) != 0) {
        return false;
    }
    const char *const share = name + length;
    const size_t middle = all - length - end;
    return middle == 0 || (*share == '.' && strspn(share + 1, "0123456789-") == middle - 1);
}

static int compare_lines(const void *a, const void *b)
{
    return strcmp(((const struct sums_line *)a)->path, ((const struct sums_line *)b)->path);
}

static bool read_all(struct sums_list *list, DIR *directory, const char *stem)
{
    const size_t begin = path_directory_length(stem);
    const struct dirent *entry;
    while ((entry = readdir(directory)) != NULL && !interrupted()) {
        if (!is_of_world(entry->d_name, stem + begin)) {
            continue;
        }
        char *const path = text_join_part(stem, begin, entry->d_name);
        const bool is_read = path != NULL && read_sums(list, path);
        free(path);
        if (!is_read) {
            return false;
        }
    }
    return true;
}

bool sums_read(struct sums_list *list, const char *manifest)
{
    char *const stem = stem_of(manifest);
    char *const name = stem != NULL ? text_join_part(stem, path_directory_length(stem), ".") : NULL;
    DIR *const directory = name != NULL ? opendir(name) : NULL;
    const bool is_read = directory != NULL && read_all(list, directory, stem);
    if (directory != NULL) {
        closedir(directory);
    }
    free(name);
    free(stem);
    if (is_read && list->count > 0 && !interrupted()) {
        qsort(list->lines, list->count, sizeof *list->lines, compare_lines);
    }
    return is_read;
}

void sums_free(struct sums_list *list)
{
    for (size_t i = 0; i < list->text_count; i++) {
        free(list->texts[i]);
    }
    free(list->texts);
    free(list->lines);
    *list = (struct sums_list){.count = 0};
}

enum sums_found sums_find(const struct sums_list *list, const char *path, uint64_t hash)
{
    size_t low = 0, high = list->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (strcmp(list->lines[middle].path, path) < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    enum sums_found found = SUMS_NONE;
    for (; low < list->count && strcmp(list->lines[low].path, path) == 0; low++) {
        if (list->lines[low].hash == hash) {
            return SUMS_SAME;
        }
        found = SUMS_DIFFERENT;
    }
    return found;
}
