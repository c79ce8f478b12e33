/* SPDX-License-Identifier: MIT
 *
 * Evaluates grids of a noise that neither bends nor has warps.
 *
 * A slice is cut into strips, some blocks wide, and each strip into tiles, some rows high:
 *
 *              one block = VEC_LANES samples
 *              |--|
 *            +--+--+--+--+--+--+--+--+--+--+-     x ->
 *          - |           |           |
 *     tile | |- - row - -|           |
 *          | |           |           |            A strip is all tiles under each other: what
 *          - +-----------+-----------+----        depends on x is prepared once for it, what
 *            |           |           |            depends on y once for each row of a tile.
 *       y    |  strip 0  |  strip 1  |  ...
 *       |    |           |           |
 *       v    +-----------+-----------+----
 *
 * Octaves are added up in the caller's arrays, but for `stores`. Parts of fBm with straight axes
 * are large, since they need nothing between the passes but tables (rows/rows.h). Other tiles are
 * as large as the scratch space permits.
 */
#ifndef SCARP_KERNEL_GRID_H
#define SCARP_KERNEL_GRID_H

#include "driver.h"

/* How many blocks go through the passes at once if their noise goes through the scratch space, and
   how many vectors of noise they may have: few calls, but all stays in the first-level cache. */
#define GROUP_BLOCKS ((size_t)2048 / sizeof(vf))
#define GROUP_VECTORS ((size_t)192)

/* A call streams its outputs if they have this many bytes. On Zen 5 with 32 MiB of third-level
   cache, streaming is faster above 8 MiB, but who reads the outputs next finds nothing in the
   cache; from 20 MiB on, writing and reading together are faster. */
#define STREAM_BYTES ((size_t)24 << 20)

/* Shorter rows whose last block is not full are padded: the strip for the rest of a row would take
   more time than samples that nobody asked for. */
#define PADDED_SAMPLES 64

#define CACHE_LINE 16 /* floats */

/* A call, as all tiles of the grid see it. */
struct grid_call {
    const struct scarp_grid *grid;
    const struct scarp_outputs *out;
    struct passes passes;
    int direct;  /* whether nothing is stored between passes: fBm with straight axes of a basis that
                    blends corners */
    int padded;  /* whether the last block of a row is not full */
    int stores;  /* whether samples are added up in the scratch space, then copied: padded rows, and
                    Hessians in 3D, whose ten arrays compete for lines of the first-level cache */
    int streams; /* whether outputs go past the caches, where they are aligned to a vector */
    size_t lead; /* then: how many samples of a row lie before its first cache line */
    size_t most_rows, most_blocks; /* of a tile */
    size_t group;                  /* how many rows of a tile go through the passes at once */
    size_t vectors;                /* of scratch space */
};

struct grid_scratch {
    struct workspace passes;
    struct row_octave octave;
    double x[STRIP_BLOCKS * VEC_LANES], y[TILE_ROWS];
};

static double coordinate(const struct scarp_grid *grid, int axis, size_t index)
{
    return grid->origin[axis] + (double)(grid->first[axis] + (int64_t)index) * grid->step[axis];
}

/* Fills in the coordinates of a block from sample `first` of an axis on, of which there are `left`,
   at least one: lanes behind them get the last one. The bits are those of coordinate(), since
   numbers of samples are exact. */
VEC_INLINE void block_coordinates(double *to, const struct scarp_grid *grid, int axis, size_t first,
                                  size_t left)
{
    const vd origin = vd_set(grid->origin[axis]), step = vd_set(grid->step[axis]);
    const vd number = vd_set((double)(grid->first[axis] + (int64_t)first));
    const vf lanes = vf_lesser((vf){VEC_NUMBERS}, vf_set((float)least(left - 1, VEC_LANES)));
    const vd x[2] = {origin + (number + vd_from_low(lanes)) * step,
                     origin + (number + vd_from_high(lanes)) * step};
    memcpy(to, x, sizeof x);
}

/* Whether the caller's arrays have gaps between rows. */
static int has_row_gaps(const struct scarp_grid *grid, int dimensions)
{
    return grid->row_stride != grid->count[0] ||
           (dimensions == 3 && grid->slice_stride != grid->count[0] * grid->count[1]);
}

/* Vectors of scratch space for a tile, by use. `by_turns` holds what the octave at work needs:
   tables of lines, or positions on the lattice. */
struct tile_space {
    size_t along, by_turns, noise, state, turning, moving, sums;
};

/* How many rows of that many blocks go through the passes at once. */
static size_t group_of(const struct grid_call *g, size_t blocks)
{
    const size_t size = g->passes.noise_size;
    const size_t most = size * GROUP_BLOCKS > GROUP_VECTORS ? GROUP_VECTORS / size : GROUP_BLOCKS;
    return g->direct ? TILE_ROWS : blocks < most ? most / blocks : 1;
}

static struct tile_space space_of(const struct grid_call *g, size_t rows, size_t blocks)
{
    const struct passes *const passes = &g->passes;
    const size_t table = !passes->rows_pass ? 0
                         : passes->takes_unhashed
                             ? passes->basis->table_size(passes->dimensions, blocks)
                             : table_size_of(passes->dimensions, passes->basis_order, blocks);
    const size_t rows_at_once = least(rows, g->group);
    const size_t lattice = g->direct ? 0 : rows_at_once * blocks * passes->lattice_size;
    const size_t straight = !passes->rows_pass       ? 0
                            : passes->takes_unhashed ? along_cells_size(blocks)
                                                     : along_size(blocks);
    const size_t turned = passes->plan->rotate ? turned_size(passes->dimensions, rows, blocks) : 0;
    const struct tile_space space = {
        .along = straight > turned ? straight : turned,
        .by_turns = table > lattice ? table : lattice,
        .noise = rows_at_once * blocks * passes->noise_size,
        .state = rows * blocks * passes->state_size,
        .turning = rows_at_once * blocks * passes->turning_size,
        .moving = rows * blocks * passes->moving_size,
        .sums = g->stores ? rows * blocks * passes->sums_size : 0,
    };
    return space;
}

/* Whether the scratch space has room for a tile of that size, with a spare row. */
static int fits(const struct grid_call *g, size_t rows, size_t blocks)
{
    const struct tile_space s = space_of(g, rows, blocks);
    return blocks + s.along + s.by_turns + s.noise + s.state + s.turning + s.moving + s.sums <=
           g->vectors;
}

/* `count` cut into as few pieces as possible, none larger than `most` and all about equal. */
static size_t piece(size_t count, size_t most)
{
    const size_t pieces = (count + most - 1) / most;
    return (count + pieces - 1) / pieces;
}

/* Decides how large tiles are. What depends on x is prepared for each tile, what depends on y for
   each row of a tile: so neither gets much larger than the other, but where the grid ends. */
static void size_tiles(struct grid_call *g)
{
    const size_t rows = g->grid->count[1];
    const size_t blocks = (g->grid->count[0] + (g->padded ? VEC_LANES - 1 : 0)) / VEC_LANES;
    g->most_rows = least(rows, TILE_ROWS);
    g->most_blocks = least(blocks, STRIP_BLOCKS);
    g->group = group_of(g, g->most_blocks);
    while (!fits(g, g->most_rows, g->most_blocks)) {
        if (g->most_blocks == 1 || (g->most_rows > g->most_blocks && (g->stores || !g->direct)) ||
            (g->padded && g->most_rows > 1)) {
            g->most_rows--;
        } else {
            g->most_blocks--;
        }
        g->group = group_of(g, g->most_blocks);
    }
    g->most_blocks = piece(blocks, g->most_blocks);
    g->most_rows = piece(rows, g->most_rows);
}

/* Gives the tiles of a strip, `blocks` wide, their share of the scratch space. */
static void divide_scratch(const struct grid_call *g, struct tile *tile,
                           struct grid_scratch *scratch, size_t blocks)
{
    const struct tile_space s = space_of(g, g->most_rows, blocks);
    struct row_octave *const octave = &scratch->octave;
    vf *const end = scratch->passes.space + scratch->passes.vectors;
    tile->locations.extent.blocks = blocks;
    tile->locations.fade = g->passes.plan->fade;
    tile->row_octave = octave;
    tile->y = scratch->y;
    tile->at.array[0] = scratch->x;
    tile->spare = scratch->passes.space;
    tile->noise = tile->spare + blocks;
    tile->state = tile->noise + s.noise;
    tile->turning = tile->state + s.state;
    tile->moving = tile->turning + s.turning;
    tile->sums_stored = tile->moving + s.moving;
    tile->along = tile->sums_stored + s.sums;
    if (!g->passes.takes_unhashed) {
        octave->x.block = (struct along_block *)tile->along;
        octave->x.hash = (vf *)(octave->x.block + blocks);
    }
    tile->locations.lattice = tile->sums_stored + s.sums + s.along;
    octave->table = tile->locations.lattice;
    octave->table_size = (size_t)(end - octave->table);
}

/* Computes a tile whose coordinates are in the scratch space. It begins with sample at[0] of row
   at[1] of slice at[2]. `count` is the length of a row that is less than a block. */
static void grid_tile(const struct grid_call *g, struct tile *tile, const size_t at[3],
                      size_t count)
{
    const struct scarp_grid *const grid = g->grid;
    const size_t first = at[2] * grid->slice_stride + at[1] * grid->row_stride + at[0];
    const size_t blocks = tile->locations.extent.blocks;
    const struct passes *const passes = &g->passes;
    struct outputs to, stored, turning;
    outputs_stored(&stored, tile->noise, passes->noise_size, passes->dimensions,
                   passes->basis_order, blocks);
    tile->stored = &stored;
    outputs_stored(&turning, tile->turning, passes->turning_size, passes->dimensions,
                   passes->fractal->extra_order, blocks);
    tile->turning_stored = &turning;
    tile->to = &to;
    tile->group = g->group;
    tile->put = PUT_FIRST;
    if (g->stores) {
        outputs_stored(&to, tile->sums_stored, passes->sums_size, passes->dimensions,
                       passes->plan->order, blocks);
    } else {
        const int aligned = at[0] % VEC_LANES == g->lead % VEC_LANES;
        outputs_of(&to, g->out, passes->plan->order, first, grid->row_stride, tile->spare);
        tile->put = g->streams && aligned ? PUT_STREAM : PUT_FIRST;
    }
    sum_octaves(&g->passes, tile, at[1] == 0);
    for (size_t r = 0; g->stores && r < tile->locations.extent.rows; r++) {
        copy_out(g->out, first + r * grid->row_stride, &to, r, count);
    }
}

/* Computes the strip of slice k that begins with sample i and is `blocks` blocks wide, of which the
   last one may reach beyond the row. */
static void grid_strip(const struct grid_call *g, struct grid_scratch *scratch, size_t i,
                       size_t blocks, size_t k)
{
    const struct scarp_grid *const grid = g->grid;
    const size_t count = least(blocks * VEC_LANES, grid->count[0] - i);
    struct tile tile = {0};
    divide_scratch(g, &tile, scratch, blocks);
    tile.at.shared[2] = g->passes.dimensions == 3 ? coordinate(grid, 2, k) : 0.0;
    for (size_t n = 0; n < blocks * VEC_LANES; n += VEC_LANES) {
        block_coordinates(scratch->x + n, grid, 0, i + n, count - n);
    }
    for (size_t j = 0; j < grid->count[1]; j += g->most_rows) {
        tile.locations.extent.rows = least(grid->count[1] - j, g->most_rows);
        for (size_t r = 0; r < tile.locations.extent.rows; r += VEC_LANES) {
            block_coordinates(scratch->y + r, grid, 1, j + r, tile.locations.extent.rows - r);
        }
        const size_t at[3] = {i, j, k};
        grid_tile(g, &tile, at, count);
    }
}

/* How many samples from i on are cut into strips next: the rest of a row or, where rows are
   streamed, those before its first cache line, then its whole vectors, then what is left. */
static size_t run_of_row(const struct grid_call *g, size_t i)
{
    const size_t left = g->grid->count[0] - i;
    if (!g->streams) {
        return left;
    }
    return i < g->lead ? g->lead - i : left < VEC_LANES ? left : left - left % VEC_LANES;
}

/* Computes a slice strip by strip. A remainder that fills no block is padded, or computed with the
   samples on its left, which get the same bits once more. */
static void grid_slice(const struct grid_call *g, struct grid_scratch *scratch, size_t k)
{
    const size_t count = g->grid->count[0];
    size_t i = 0;
    while (i < count) {
        const size_t left = run_of_row(g, i);
        size_t blocks = least((left + VEC_LANES - 1) / VEC_LANES, g->most_blocks);
        if (!g->padded && blocks * VEC_LANES > count) {
            blocks--; /* the remainder comes next */
        }
        const size_t from = g->padded ? i : least(i, count - blocks * VEC_LANES);
        grid_strip(g, scratch, from, blocks, k);
        i = least(from + blocks * VEC_LANES, i + left);
    }
}

/* Decides on `streams` and `lead`. All rows must be aligned alike. Where they do not begin with a
   cache line and end with a vector, a strip of ordinary stores comes first or last. It is a block
   or two wide, but takes as long as ten blocks: in 3D it makes rows of 512 samples slower. */
static void decide_streams(struct grid_call *call)
{
    const struct scarp_grid *const g = call->grid;
    const int solid = call->passes.dimensions == 3;
    const size_t samples = g->count[0] * g->count[1] * (solid ? g->count[2] : 1);
    size_t floats = 0, start = 0, apart = g->row_stride | (solid ? g->slice_stride : 0);
    for (int i = 0; i < OUTPUTS; i++) {
        if (call->out->array[i] != NULL) {
            const size_t at = (uintptr_t)call->out->array[i] / sizeof(float);
            start = floats == 0 ? at : start;
            apart |= at - start;
            floats += samples;
        }
    }
    call->lead = (0 - start) % CACHE_LINE;
    const int whole = call->lead == 0 && g->count[0] % VEC_LANES == 0;
    call->streams = VEC_STREAMS && call->passes.rows_pass != NULL && call->passes.straight_fbm &&
                    call->passes.plan->octaves == 1 && floats >= STREAM_BYTES / sizeof(float) &&
                    apart % VEC_LANES == 0 && g->count[0] >= (whole ? 64 : 1024);
}

/* Computes a grid with scratch space that it is given. */
static __attribute__((noinline)) void grid_within(const struct scarp_call_plan *plan,
                                                  const struct scarp_grid *described,
                                                  const struct scarp_outputs *out, int dimensions,
                                                  struct workspace work)
{
    struct grid_scratch scratch;
    struct grid_call g = {.grid = described, .out = out, .vectors = work.vectors};
    scratch.passes = work;
    passes_choose(&g.passes, plan, dimensions, ROW);
    g.direct = g.passes.rows_pass != NULL && g.passes.straight_fbm && !g.passes.takes_unhashed;
    g.padded = described->count[0] % VEC_LANES != 0 && described->count[0] < PADDED_SAMPLES;
    g.stores = g.padded || (dimensions == 3 && plan->order == 2 && plan->octaves > 1);
    decide_streams(&g);
    size_tiles(&g);
    for (size_t k = 0; k < (dimensions == 3 ? described->count[2] : 1); k++) {
        grid_slice(&g, &scratch, k);
    }
    if (g.streams) {
        vf_stream_end();
    }
}

#endif
