/* SPDX-License-Identifier: MIT
 *
 * Grids. Included by table.h.
 *
 * fBm with straight axes goes through tiles of GRID_ROWS rows of a chunk, octave by octave, each
 * one added to the outputs themselves: what depends on x (columns.h) is prepared once for all rows.
 * All other noise needs the passes of fractal.h, over chunks that are made of several short rows;
 * octaves with turned axes are points there, with coordinates made on the fly.
 */
#ifndef SCARP_KERNEL_GRID_H
#define SCARP_KERNEL_GRID_H

#include "fractal.h"

/* Blocks of a row, where a chunk is made of several. */
#define PATCH_BLOCKS 8

/* Bytes of output from which a call streams them. Measured on Zen 5 with 32 MiB of third-level
   cache: above 8 MiB it is faster in itself, but a reader that comes next finds nothing in the
   cache; from 20 MiB both together are faster. */
#define STREAM_BYTES ((size_t)24 << 20)

#define CACHE_LINE 16 /* floats */

/* A call, as all parts of the grid see it. */
struct grid_call {
    const struct scarp_grid *grid;
    struct passes passes;
    struct scarp_samples out;
    int tiles;   /* whether it goes through tiles */
    int streams; /* whether outputs go past the caches, where they are aligned to a vector */
    size_t lead; /* then: samples of each row in front of a cache line */
};

struct grid_scratch {
    struct scratch chunk;
    struct along_x x;
    struct along_rows rows;
    double position[3][CHUNK_POINTS];
};

/* Part of slice k: `rows` rows from row j, of `blocks` whole blocks from sample i. */
struct part {
    size_t i, j, k, rows, blocks;
};

static double coordinate(const struct scarp_grid *grid, int axis, size_t index)
{
    return grid->origin[axis] + (double)(grid->first[axis] + (int64_t)index) * grid->step[axis];
}

static double coordinate_z(const struct grid_call *call, size_t k)
{
    return call->passes.dimensions == 3 ? coordinate(call->grid, 2, k) : 0.0;
}

/* Of the rows of a part, filled up to whole vectors. */
static void coordinates_of_rows(const struct grid_call *call, const struct part *part,
                                double y[GRID_ROWS])
{
    for (size_t r = 0; r < part->rows || r % VEC_LANES != 0; r++) {
        y[r] = coordinate(call->grid, 1, part->j + (r < part->rows ? r : 0));
    }
}

/* Where the outputs of row r of a part begin; for members that are not there, `spare`. */
static struct scarp_samples part_row(const struct grid_call *call, const struct part *part,
                                     size_t r, const struct scarp_samples *spare)
{
    const struct scarp_grid *const g = call->grid;
    const size_t at = part->k * g->slice_stride + (part->j + r) * g->row_stride + part->i;
    return rows_from(&call->out, at, spare);
}

static int basis_order(const struct scarp_plan *plan)
{
    return plan->order + (plan->fractal == SCARP_EROSION);
}

/* Prepares an octave across the rows of a part, whose coordinates are `y`. */
static void prepare_rows(const struct grid_call *call, struct grid_scratch *scratch,
                         const struct part *part, int k, const double *y)
{
    const struct scarp_plan *const plan = call->passes.plan;
    along_rows(&scratch->rows, &plan->octave[k], part->rows, y, coordinate_z(call, part->k),
               plan->fade, call->passes.dimensions, axes_of(plan, k));
    scratch->chunk.first.columns.x = &scratch->x;
    scratch->chunk.first.columns.rows = &scratch->rows;
}

/* A tile of fBm with straight axes. What is prepared along x is good for the tile below too if
   there is no other octave. */
static void grid_tile(const struct grid_call *call, struct grid_scratch *scratch,
                      const struct part *tile, const struct scarp_samples *to)
{
    const struct scarp_plan *const plan = call->passes.plan;
    double y[GRID_ROWS];
    coordinates_of_rows(call, tile, y);
    const int aligned = tile->i % VEC_LANES == call->lead % VEC_LANES;
    const int start = call->streams && aligned ? STREAM : 1;
    for (int k = 0; k < plan->octaves; k++) {
        if (plan->octaves > 1 || tile->j == 0) {
            along_x(&scratch->x, &plan->octave[k], tile->blocks, scratch->position[0], plan->fade,
                    axes_of(plan, k), plan->order);
        }
        prepare_rows(call, scratch, tile, k, y);
        const struct scarp_octave *const o = &plan->octave[k];
        const struct weights weights = {o->amplitude, o->slope, o->curvature};
        call->passes.columns(&scratch->chunk.first.columns, tile->rows, tile->blocks, &weights,
                             k == 0 ? start : 0, to);
    }
}

/* The coordinates of a patch, row after row; `x` has those of its first row. */
static void place_patch(const struct grid_call *call, struct grid_scratch *scratch,
                        const struct part *patch, const double *x, const double *y)
{
    const size_t count = patch->blocks * VEC_LANES;
    const double z = coordinate_z(call, patch->k);
    for (size_t r = 0; r < patch->rows; r++) {
        for (size_t n = 0; n < count; n++) {
            scratch->position[0][r * count + n] = x[n];
            scratch->position[1][r * count + n] = y[r];
            scratch->position[2][r * count + n] = z;
        }
    }
}

/* A patch, rows times blocks of one chunk, of any noise: into the rows of sums. */
static void grid_patch(const struct grid_call *call, struct grid_scratch *scratch,
                       const struct part *patch, const double *x)
{
    const struct scarp_plan *const plan = call->passes.plan;
    const void *const position[3] = {scratch->position[0], scratch->position[1],
                                     scratch->position[2]};
    const struct scarp_samples sums = samples_of(&scratch->chunk.sums);
    double y[GRID_ROWS];
    coordinates_of_rows(call, patch, y);
    place_patch(call, scratch, patch, x, y);
    for (int k = 0; k < plan->octaves; k++) {
        const enum axes axes = axes_of(plan, k);
        const struct scarp_octave *const o = &plan->octave[k];
        struct source source = {0};
        if (axes != AXES_TURNED) {
            along_x(&scratch->x, o, patch->blocks, x, plan->fade, axes, basis_order(plan));
            prepare_rows(call, scratch, patch, k, y);
            source.rows = patch->rows;
        } else {
            lattice_passes[call->passes.dimensions - 2][1][axes](
                &scratch->chunk.first.lattice, o, patch->rows * patch->blocks, position);
        }
        add_any(&call->passes, k, axes, &source, patch->rows * patch->blocks, &scratch->chunk,
                k > 0 ? &sums : NULL, &sums);
    }
}

/* The first `count` samples of each row of a patch, to where they belong. */
static void put_patch(const struct grid_call *call, const struct grid_scratch *scratch,
                      const struct part *patch, size_t count)
{
    static const struct scarp_samples none; /* all NULL */
    for (size_t r = 0; r < patch->rows; r++) {
        const struct scarp_samples row = part_row(call, patch, r, &none);
        copy_rows(&row, &scratch->chunk.sums, r * patch->blocks, count);
    }
}

/* All rows of a slice, `blocks` whole blocks from sample i, of which `count` samples are wanted. */
static void grid_strip(const struct grid_call *call, struct grid_scratch *scratch, size_t i,
                       size_t blocks, size_t count, size_t k)
{
    const struct scarp_samples spare = samples_of(&scratch->chunk.sums);
    const int tiles = call->tiles && count == blocks * VEC_LANES;
    const size_t rows_at_once = least(tiles ? GRID_ROWS : CHUNK_BLOCKS / blocks, GRID_ROWS);
    double x[CHUNK_POINTS];
    for (size_t n = 0; n < blocks * VEC_LANES; n++) {
        x[n] = coordinate(call->grid, 0, i + least(n, count - 1));
    }
    memcpy(scratch->position[0], x, blocks * VEC_LANES * sizeof *x);
    for (size_t j = 0; j < call->grid->count[1]; j += rows_at_once) {
        const size_t rows = least(call->grid->count[1] - j, rows_at_once);
        const struct part part = {i, j, k, rows, blocks};
        if (!tiles) {
            grid_patch(call, scratch, &part, x);
            put_patch(call, scratch, &part, count);
            continue;
        }
        struct scarp_samples to[GRID_ROWS];
        for (size_t r = 0; r < rows; r++) {
            to[r] = part_row(call, &part, r, &spare);
        }
        grid_tile(call, scratch, &part, to);
    }
}

/* How many samples from i on are cut into strips next: the rest of a row; where rows are streamed,
   as much of it as is aligned. */
static size_t part_of_row(const struct grid_call *call, size_t i)
{
    const size_t left = call->grid->count[0] - i;
    if (!call->streams) {
        return left;
    }
    return i < call->lead ? call->lead - i : left < VEC_LANES ? left : left - left % VEC_LANES;
}

/* A slice in strips. A remainder that fills no block is computed once more with what is left of it,
   to the same bits. */
static void grid_slice(const struct grid_call *call, struct grid_scratch *scratch, size_t k)
{
    const size_t count = call->grid->count[0];
    const size_t widest = call->tiles ? CHUNK_BLOCKS : PATCH_BLOCKS;
    size_t i = 0;
    if (count < VEC_LANES) {
        grid_strip(call, scratch, 0, 1, count, k);
        return;
    }
    while (i < count) {
        const size_t left = part_of_row(call, i);
        size_t blocks = least((left + VEC_LANES - 1) / VEC_LANES, widest);
        if (blocks * VEC_LANES > count) {
            blocks--; /* the remainder comes next */
        }
        const size_t from = least(i, count - blocks * VEC_LANES);
        grid_strip(call, scratch, from, blocks, blocks * VEC_LANES, k);
        i = least(from + blocks * VEC_LANES, i + left);
    }
}

/* Decides on `streams` and `lead`. All rows must lie alike. Where they do not begin with a cache
   line and end with a vector, a strip of ordinary stores comes first or last, a block or two wide,
   but as dear as ten: in 3D, rows of 512 samples were slower for it. */
static void place_streams(struct grid_call *call)
{
    const struct scarp_grid *const g = call->grid;
    const struct scarp_samples *const out = &call->out;
    const float *const arrays[ROWS] = {out->value, out->dx,  out->dy,  out->dz,  out->dxx,
                                       out->dxy,   out->dxz, out->dyy, out->dyz, out->dzz};
    const int solid = call->passes.dimensions == 3;
    const size_t samples = g->count[0] * g->count[1] * (solid ? g->count[2] : 1);
    size_t floats = 0, start = 0, apart = g->row_stride | (solid ? g->slice_stride : 0);
    for (int i = 0; i < ROWS; i++) {
        if (arrays[i] != NULL) {
            const size_t at = (uintptr_t)arrays[i] / sizeof(float);
            start = floats == 0 ? at : start;
            apart |= at - start;
            floats += samples;
        }
    }
    call->lead = (0 - start) % CACHE_LINE;
    const int whole = call->lead == 0 && g->count[0] % VEC_LANES == 0;
    call->streams = VEC_STREAMS && call->tiles && call->passes.plan->octaves == 1 &&
                    floats >= STREAM_BYTES / sizeof(float) && apart % VEC_LANES == 0 &&
                    g->count[0] >= (whole ? 64 : 1024);
}

static void grid(const struct scarp_plan *plan, const struct scarp_grid *g,
                 const struct scarp_samples *out, int dimensions)
{
    struct grid_scratch scratch;
    struct grid_call call = {.grid = g, .passes = passes_of(plan, dimensions, 1), .out = *out};
    call.tiles = plan->fractal == SCARP_FBM && !plan->rotate;
    place_streams(&call);
    for (size_t k = 0; k < (dimensions == 3 ? g->count[2] : 1); k++) {
        grid_slice(&call, &scratch, k);
    }
    if (call.streams) {
        vf_stream_end();
    }
}

static void grid2(const struct scarp_plan *plan, const struct scarp_grid *g,
                  const struct scarp_samples *out)
{
    grid(plan, g, out, 2);
}

static void grid3(const struct scarp_plan *plan, const struct scarp_grid *g,
                  const struct scarp_samples *out)
{
    grid(plan, g, out, 3);
}

#endif
