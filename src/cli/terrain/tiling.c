/* SPDX-License-Identifier: MIT
 *
 * Counts tiles row by row, from the top left.
 */
#include "terrain/tiling.h"

#include "shared/error.h"

static size_t quotient_up(size_t a, size_t b)
{
    return (a + b - 1) / b;
}

/* What only tiles have. */
static bool check_needs(const struct terrain_options *options)
{
    const char *const needs = options->tiles.x1 != 0      ? "--tiles"
                              : options->share.count != 0 ? "--share"
                              : options->overlap != 0     ? "--overlap"
                                                          : NULL;
    if (needs != NULL && options->tile.width == 0) {
        cli_error("%s: needs --tile", needs);
        return false;
    }
    return true;
}

/* The first tile of share number `index`: shares are contiguous and differ by one tile at most. */
static size_t share_begin(size_t tiles, size_t index, size_t count)
{
    const size_t rest = tiles % count;
    return tiles / count * index + (index < rest ? index : rest);
}

bool tiling_make(const struct terrain_options *options, struct tiling *tiling)
{
    if (!check_needs(options)) {
        return false;
    }
    *tiling = (struct tiling){.raster = options->size,
                              .tile = options->size,
                              .range = options->tiles,
                              .overlap = options->overlap,
                              .numbered = options->tile.width != 0};
    if (tiling->numbered) {
        tiling->tile = options->tile;
    }
    tiling->across = quotient_up(options->size.width, tiling->tile.width);
    tiling->down = quotient_up(options->size.height, tiling->tile.height);
    if (tiling->range.x1 == 0) {
        tiling->range = (struct option_range){0, tiling->across, 0, tiling->down};
    }
    if (tiling->range.x1 > tiling->across || tiling->range.y1 > tiling->down) {
        cli_error("--tiles: there are %zu x %zu tiles, so X1 is at most %zu and Y1 at most %zu",
                  tiling->across, tiling->down, tiling->across, tiling->down);
        return false;
    }
    const size_t tiles =
        (tiling->range.x1 - tiling->range.x0) * (tiling->range.y1 - tiling->range.y0);
    const struct option_share all = {0, 1};
    const struct option_share share = options->share.count != 0 ? options->share : all;
    tiling->begin = share_begin(tiles, share.index, share.count);
    tiling->end = share_begin(tiles, share.index + 1, share.count);
    return true;
}

static size_t extent(size_t first, size_t length, size_t size, size_t overlap)
{
    return (first + length < size ? length : size - first) + overlap;
}

struct tile tiling_at(const struct tiling *tiling, size_t n)
{
    const size_t width = tiling->range.x1 - tiling->range.x0;
    const size_t x = tiling->range.x0 + n % width, y = tiling->range.y0 + n / width;
    const size_t column = x * tiling->tile.width, row = y * tiling->tile.height;
    return (struct tile){
        .column = column,
        .row = row,
        .width = extent(column, tiling->tile.width, tiling->raster.width, tiling->overlap),
        .height = extent(row, tiling->tile.height, tiling->raster.height, tiling->overlap),
        .x = x,
        .y = y,
        .up = tiling->down - 1 - y,
        .number = y * tiling->across + x,
        .numbered = tiling->numbered,
    };
}
