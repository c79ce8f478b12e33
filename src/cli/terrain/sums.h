/* SPDX-License-Identifier: MIT
 *
 * Checksums of the files of a world, in files next to its manifest, one for each share: NAME.sums
 * next to NAME.json, or NAME.I-N.sums. A line is "HASH  PATH", with the path as seen from there,
 * which xxhsum -c reads, too. Runs add lines; of those of one path, each is right.
 */
#ifndef SCARP_CLI_SUMS_H
#define SCARP_CLI_SUMS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "shared/options.h"
#include "terrain/products.h"

/* Where a run keeps its checksums. Zero-initialise; close. */
struct sums {
    char *path;
    const char *manifest; /* as seen from the current directory */
    bool is_new;          /* the file was made by this run */
};

/* Sets the path. False without memory. */
bool sums_open(struct sums *sums, const char *manifest, struct option_share share);

/* Reads the files of a tile, which are complete and have not yet their names, and adds their lines.
   Returns false, with errno, if that failed. */
bool sums_keep(struct sums *sums, const struct products *products);

/* Frees the path, and removes the file if this run made it, unless `keep`. */
void sums_close(struct sums *sums, bool keep);

/* All lines of a world, sorted. Zero-initialise; free it. */
struct sums_list {
    struct sums_line {
        const char *path;
        uint64_t hash;
    } * lines;
    size_t count, room;
    char **texts; /* the files, which paths point into */
    size_t text_count;
};

/* Reads the files of all shares. False, with errno, if that failed. */
bool sums_read(struct sums_list *list, const char *manifest);
void sums_free(struct sums_list *list);

/* Whether a file has a line, and one with that hash */
enum sums_found { SUMS_NONE, SUMS_DIFFERENT, SUMS_SAME };
enum sums_found sums_find(const struct sums_list *list, const char *path, uint64_t hash);

#endif
