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

struct tiling {
    struct option_size raster, tile;
    struct option_range range; /* of tiles, from which the share is taken */
    size_t overlap;
    size_t across, down; /* tiles of the whole raster */
    size_t begin, end;   /* the share: tiles of the range, counted row by row */
    bool numbered;       /* the raster has tiles, and their numbers are part of file names */
};

/* Part of the raster; it may go beyond it to the right and below. */
struct tile {
    size_t column, row, width, height;
    size_t x, y, up; /* its place among the tiles: from the left, the top and the bottom */
    size_t number;   /* among all tiles of the raster, row by row */
    bool numbered;
};

/* False, with a line on stderr, if the options do not go together. */
bool tiling_make(const struct terrain_options *options, struct tiling *tiling);

/* Tile number `n` of the range: of [tiling->begin, tiling->end) in this run. */
struct tile tiling_at(const struct tiling *tiling, size_t n);

#endif
