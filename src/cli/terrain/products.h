/* SPDX-License-Identifier: MIT
 *
 * Which layer goes to which file in which format, and the files of one tile.
 */
#ifndef SCARP_CLI_PRODUCTS_H
#define SCARP_CLI_PRODUCTS_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/writer.h"
#include "raster/layers.h"
#include "terrain/tiling.h"

/* A layer that was asked for as a file, of which there is one per tile */
struct product {
    const struct layer *layer;
    size_t part;         /* of a layer that has several */
    const char *content; /* a word for what it holds; of a part, its name */
    const char *option;  /* that messages name */
    const struct format *format;
    enum sample_type type;
    char *path; /* a pattern, or without the tile's number */

    /* Of the tile at hand: */
    char *tile_path;
    struct writer writer;
    size_t row_bytes;
    int reason; /* errno of what failed */
    bool failed;
};

/* Seven layers may be asked for by themselves, and five by --output; fields and masks have several
   files. */
#define PRODUCTS_MAX (7 + 5 + GROUND_FIELDS_MOST + PALETTE_GROUNDS)

struct products {
    struct product list[PRODUCTS_MAX];
    size_t count;
};

/* Adds the file `text`: PATH, or FORMAT:PATH. False, with a line on stderr, if it cannot be. */
bool products_add(struct products *products, const struct layer *layer, const char *text);

/* Adds the file of field number `field`, which is called `name`. */
bool products_add_field(struct products *products, size_t field, const char *name,
                        const char *text);

/* Adds STEM-rock, STEM-snow and so on, or of STEM.png STEM-1.png and STEM-2.png. */
bool products_add_masks(struct products *products, const char *stem);

/* Adds STEM-height, STEM-normal, STEM-hillshade and STEM-relief, and STEM-compare if `compare`. */
bool products_add_stem(struct products *products, const char *stem, bool compare);

bool products_are_files(const struct products *products); /* no pipe, device or standard output */
unsigned products_needs(const struct products *products);

/* Whether the paths can name the tiles. False, with a line on stderr, if not. */
bool products_check(const struct products *products, const struct tiling *tiling);

/* Decides what the files of a tile are and are called. False without memory, with a line on stderr.
 */
bool products_begin(struct products *products, const struct surface *surface,
                    const struct tile *tile);

/* Whether all of them are there, whole and not older than `since` */
bool products_are_there(const struct products *products, struct file_time since);

/* Removes what killed runs left next to them. */
void products_sweep(const struct products *products);

/* Each of these returns false if a file fails, whose `failed` is then set. */

/* Opens the files. None of them may be the file `manifest`, unless that is NULL. */
bool products_open(struct products *products, const char *manifest);

/* Brings all of them to the disk, before the first one takes its name: it may fill up until then.
 */
bool products_complete(struct products *products);

/* Gives all of them their final names. If one fails, those that replaced no older file are removed.
 */
bool products_publish(struct products *products);

/* How many bytes the files of a tile that are packed take at most, about, and those that are not.
   Both arrays have an element for each product. */
void products_measure(const struct products *products, const struct surface *surface,
                      const struct tile *tile, uint64_t *exact, uint64_t *most);

/* Whether one of the open files is a pipe or the like */
bool products_wait(const struct products *products);

/* Ends a tile: files that were not completed are removed. */
void products_discard(struct products *products);
void products_free(struct products *products);

/* Tells why product->failed. */
void product_error(const struct product *product);

#endif
