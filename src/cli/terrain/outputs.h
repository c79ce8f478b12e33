/* SPDX-License-Identifier: MIT
 *
 * Which layer goes to which file in which format, and the files of one tile.
 */
#ifndef SCARP_CLI_OUTPUTS_H
#define SCARP_CLI_OUTPUTS_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/writer.h"
#include "raster/layers.h"
#include "terrain/tiling.h"

/* A file that was asked for, of which there is one per tile */
struct output {
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
#define OUTPUTS_MAX (7 + 5 + GROUND_FIELDS_MOST + PALETTE_GROUNDS)

struct outputs {
    struct output list[OUTPUTS_MAX];
    size_t count;
};

/* Adds the file `text`: PATH, or FORMAT:PATH. False, with a line on stderr, if it cannot be. */
bool outputs_add(struct outputs *outputs, const struct layer *layer, const char *text);

/* Adds the file of field number `field`, which is called `name`. */
bool outputs_add_field(struct outputs *outputs, size_t field, const char *name, const char *text);

/* Adds STEM-rock, STEM-snow and so on, or of STEM.png STEM-1.png and STEM-2.png. */
bool outputs_add_masks(struct outputs *outputs, const char *stem);

/* Adds STEM-height, STEM-normal, STEM-hillshade and STEM-relief, and STEM-compare if `compare`. */
bool outputs_add_stem(struct outputs *outputs, const char *stem, bool compare);

bool outputs_to_standard_output(const struct outputs *outputs);
bool outputs_are_files(const struct outputs *outputs); /* no pipe, device or standard output */
unsigned outputs_needs(const struct outputs *outputs);

/* Whether the paths can name the tiles. False, with a line on stderr, if not. */
bool outputs_check(const struct outputs *outputs, const struct tiling *tiling);

/* Decides what the files of a tile are and are called. False without memory, with a line on stderr.
 */
bool outputs_begin(struct outputs *outputs, const struct surface *surface, const struct tile *tile);

/* Whether all of them are there, whole and not older than `since` */
bool outputs_are_there(const struct outputs *outputs, struct file_time since);

/* Removes what killed runs left beside them. */
void outputs_sweep(const struct outputs *outputs);

/* Each of these returns false if a file fails, whose `failed` is then set. */

/* Opens the files. None of them may be the file `manifest`, unless that is NULL. */
bool outputs_open(struct outputs *outputs, const char *manifest);

/* Brings all of them to the disk, before the first one takes its name: it may fill up until then.
 */
bool outputs_complete(struct outputs *outputs);

/* Gives all of them their final names. If one fails, those that replaced no older file are removed.
 */
bool outputs_publish(struct outputs *outputs);

/* How many bytes the files of a tile that are packed take at most, about, and those that are not.
   Both arrays have an element for each output. */
void outputs_measure(const struct outputs *outputs, const struct surface *surface,
                     const struct tile *tile, uint64_t *exact, uint64_t *most);

/* Whether one of the open files is a pipe or the like */
bool outputs_wait(const struct outputs *outputs);

/* Ends a tile: files that were not completed are removed. */
void outputs_discard(struct outputs *outputs);
void outputs_free(struct outputs *outputs);

/* Tells why output->failed. */
void output_error(const struct output *output);

#endif
