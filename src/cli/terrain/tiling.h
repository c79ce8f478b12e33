/* SPDX-License-Identifier: MIT
 *
 * How a raster falls into tiles, and which of them a run writes. A raster without tiles is one.
 */
#ifndef SCARP_CLI_TILING_H
#define SCARP_CLI_TILING_H

#include <stdbool.h>
#include <stddef.h>

#include "shared/options.h"
#include "terrain/terrain_options.h"

/* A level of detail: level 0 is the raster, and each one after it half as wide. */
struct level {
    struct option_size raster; /* in samples */
    size_t across, down;       /* tiles */
    size_t first;              /* the number of its first tile */
};

struct tiling {
    struct option_size tile;
    struct option_range range; /* of tiles, from which the share is taken, if there is one level */
    size_t overlap;
    struct level levels[LEVELS_MOST];
    unsigned level_count;
    size_t begin, end; /* the share: tiles of the range, or of all levels, counted row by row */
    bool numbered;     /* the raster has tiles, and their numbers are part of file names */
};

/* Part of the raster of a level; it may go beyond it to the right and below. */
struct tile {
    unsigned level, coarser; /* and how many levels follow it */
    size_t column, row, width, height;
    size_t x, y, up; /* its place among the tiles: from the left, the top and the bottom */
    size_t number;   /* among all tiles of all levels, row by row */
    bool numbered;
};

/* False, with a line on stderr, if the options do not go together. */
bool tiling_make(const struct terrain_options *options, struct tiling *tiling);

/* Warns of tiles at the right and at the bottom that hold no more than the overlap of their
   neighbours: of a size with the sample that tiles share, which --overlap adds by itself. */
void tiling_warn(const struct terrain_options *options);

/* Tile number `n` of the range: of [tiling->begin, tiling->end) in this run. */
struct tile tiling_at(const struct tiling *tiling, size_t n);

#endif
