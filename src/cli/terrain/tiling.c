/* SPDX-License-Identifier: MIT
 *
 * Counts tiles row by row, from the top left.
 */
#include "terrain/tiling.h"

#include <stdint.h>

#include "shared/bounds.h"
#include "shared/error.h"

/* That a run can mean to write: each has a file at least. */
#define TILES_MOST 10000000

/* What only tiles have, and what does not go with levels */
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
    if (options->tiles.x1 != 0 && options->levels > 1) {
        cli_error("--tiles: cannot choose tiles of --levels; --share divides those of all levels");
        return false;
    }
    return true;
}

/* Level `n`; the levels before it are set. */
static struct level level_of(const struct tiling *tiling, const struct option_size *raster,
                             unsigned n)
{
    const size_t side = (size_t)1 << n;
    struct level level = {
        .raster = {quotient_up(raster->width, side), quotient_up(raster->height, side)}};
    const struct option_size tile = tiling->numbered ? tiling->tile : level.raster;
    level.across = quotient_up(level.raster.width, tile.width);
    level.down = quotient_up(level.raster.height, tile.height);
    if (n > 0) {
        const struct level *const before = &tiling->levels[n - 1];
        level.first = before->first + before->across * before->down;
    }
    return level;
}

static bool refuse_count(double tiles)
{
    cli_error("--tile: %.0f tiles, and a run writes at most %d; larger tiles, --tiles or --share "
              "make fewer",
              tiles, TILES_MOST);
    return false;
}

static bool set_levels(const struct terrain_options *options, struct tiling *tiling)
{
    tiling->level_count = (unsigned)options->levels;
    for (unsigned n = 0; n < tiling->level_count; n++) {
        tiling->levels[n] = level_of(tiling, &options->size, n);
        const struct option_size *const raster = &tiling->levels[n].raster;
        const double tiles = (double)tiling->levels[n].across * (double)tiling->levels[n].down;
        if (tiles > (double)(SIZE_MAX / 2)) { /* addresses of 32 bits: levels together count more */
            return refuse_count(tiles);
        }
        if (raster->width == 1 && raster->height == 1 && n + 1 < tiling->level_count) {
            cli_error("--levels: %zux%zu samples have %u levels, the last of which is one sample",
                      options->size.width, options->size.height, n + 1);
            return false;
        }
    }
    return true;
}

/* The first tile of share number `index`: shares are contiguous and differ by one tile at most. */
static size_t share_begin(size_t tiles, size_t index, size_t count)
{
    const size_t rest = tiles % count;
    return tiles / count * index + (index < rest ? index : rest);
}

/* Tiles of the range, or of all levels */
static size_t count_tiles(const struct tiling *tiling)
{
    const struct level *const last = &tiling->levels[tiling->level_count - 1];
    const struct option_range *const range = &tiling->range;
    return tiling->level_count > 1 ? last->first + last->across * last->down
                                   : (range->x1 - range->x0) * (range->y1 - range->y0);
}

bool tiling_make(const struct terrain_options *options, struct tiling *tiling)
{
    *tiling = (struct tiling){.tile = options->tile,
                              .range = options->tiles,
                              .overlap = options->overlap,
                              .numbered = options->tile.width != 0};
    if (!check_needs(options) || !set_levels(options, tiling)) {
        return false;
    }
    const struct level *const raster = &tiling->levels[0];
    if (tiling->range.x1 == 0) {
        tiling->range = (struct option_range){0, raster->across, 0, raster->down};
    }
    if (tiling->range.x1 > raster->across || tiling->range.y1 > raster->down) {
        cli_error("--tiles: there are %zu x %zu tiles, so X1 is at most %zu and Y1 at most %zu",
                  raster->across, raster->down, raster->across, raster->down);
        return false;
    }
    const struct option_share all = {0, 1};
    const struct option_share share = options->share.count != 0 ? options->share : all;
    const size_t tiles = count_tiles(tiling);
    tiling->begin = share_begin(tiles, share.index, share.count);
    tiling->end = share_begin(tiles, share.index + 1, share.count);
    return tiling->end - tiling->begin <= TILES_MOST ||
           refuse_count((double)(tiling->end - tiling->begin));
}

void tiling_warn(const struct terrain_options *options)
{
    const struct option_size *const size = &options->size, *const tile = &options->tile;
    if (tile->width == 0) {
        return;
    }
    const size_t across = size->width % tile->width, down = size->height % tile->height;
    const bool is_wide = across > options->overlap || across == size->width || across == 0;
    const bool is_high = down > options->overlap || down == size->height || down == 0;
    if (!is_wide || !is_high) {
        cli_error("--size: %zux%zu leaves slivers at the %s, which are no larger than the "
                  "--overlap; %zux%zu leaves none",
                  size->width, size->height,
                  is_high   ? "right"
                  : is_wide ? "bottom"
                            : "right and at the bottom",
                  is_wide ? size->width : size->width - across,
                  is_high ? size->height : size->height - down);
    }
}

static size_t extent(size_t first, size_t length, size_t size, size_t overlap)
{
    return (first + length < size ? length : size - first) + overlap;
}

struct tile tiling_at(const struct tiling *tiling, size_t n)
{
    unsigned index = tiling->level_count - 1;
    while (index > 0 && tiling->levels[index].first > n) {
        index--;
    }
    const struct level *const level = &tiling->levels[index];
    const struct option_size tile = tiling->numbered ? tiling->tile : level->raster;
    const struct option_range all = {0, level->across, 0, level->down};
    const struct option_range range = tiling->level_count > 1 ? all : tiling->range;
    const size_t width = range.x1 - range.x0, place = n - level->first;
    const size_t x = range.x0 + place % width, y = range.y0 + place / width;
    const size_t column = x * tile.width, row = y * tile.height;
    return (struct tile){
        .level = index,
        .coarser = tiling->level_count - 1 - index,
        .column = column,
        .row = row,
        .width = extent(column, tile.width, level->raster.width, tiling->overlap),
        .height = extent(row, tile.height, level->raster.height, tiling->overlap),
        .x = x,
        .y = y,
        .up = level->down - 1 - y,
        .number = level->first + y * level->across + x,
        .numbered = tiling->numbered,
    };
}
