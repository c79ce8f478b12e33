/* SPDX-License-Identifier: MIT
 *
 * Grids that are computed as points, chunk by chunk: those of noise without passes along rows, and
 * those whose rows are so short that points take less time. Chunks go on across the ends of rows:
 *
 *     row 0    |0 0 0 0 0|0 0 0          chunk 0 ends in the middle of row 1, and chunk 1
 *     row 1    |0 0 0 1 1|1 1 1          begins there
 *
 * Outputs go to the caller's arrays at once where these have no gaps between rows.
 */
#ifndef SCARP_KERNEL_FLAT_H
#define SCARP_KERNEL_FLAT_H

#include "bend.h"

/* A sample of a grid, by its numbers along the axes, in the order of the samples. */
struct walk {
    const struct scarp_grid *grid;
    size_t at[3];
};

/* Moves on by `count` samples, which are in one row. */
static void walk_on(struct walk *w, size_t count)
{
    w->at[0] += count;
    for (int axis = 0; axis < 2 && w->at[axis] == w->grid->count[axis]; axis++) {
        w->at[axis] = 0;
        w->at[axis + 1]++;
    }
}

/* How many of `count` samples are in the row where the walk is. */
static size_t walk_run(const struct walk *w, size_t count)
{
    return least(count, w->grid->count[0] - w->at[0]);
}

/* Fills in the coordinates of the next `count` samples, and moves on. Each axis may get a vector
   more. Whole rows after the first are copies of it along x. */
VEC_INLINE void walk_fill(double *const to[3], struct walk *walk, size_t count, int dimensions)
{
    struct walk w = *walk; /* a copy: nothing that is stored can alias it */
    const struct scarp_grid grid = *walk->grid;
    const double *row = NULL;
    for (size_t first = 0, run; first < count; first += run) {
        run = walk_run(&w, count - first);
        if (row != NULL) {
            copy_doubles(to[0] + first, row, run);
        } else {
            for (size_t i = 0; i < run; i++) {
                to[0][first + i] = coordinate(&grid, 0, w.at[0] + i);
            }
            row = run == grid.count[0] ? to[0] + first : NULL;
        }
        for (int axis = 1; axis < dimensions; axis++) {
            fill_doubles(to[axis] + first, coordinate(&grid, axis, w.at[axis]), run);
        }
        walk_on(&w, run);
    }
    memcpy(walk->at, w.at, sizeof w.at);
}

static void walk_fill2(double *const to[3], struct walk *walk, size_t count)
{
    walk_fill(to, walk, count, 2);
}

static void walk_fill3(double *const to[3], struct walk *walk, size_t count)
{
    walk_fill(to, walk, count, 3);
}

/* Copies the outputs of `count` samples to the rows of the caller's arrays. */
static void walk_copy(const struct scarp_outputs *out, struct walk w, size_t count,
                      const struct scarp_outputs *from)
{
    const struct scarp_grid *const grid = w.grid;
    for (size_t first = 0, run; first < count; first += run) {
        const size_t at = w.at[2] * grid->slice_stride + w.at[1] * grid->row_stride + w.at[0];
        run = walk_run(&w, count - first);
        for (int i = 0; i < OUTPUTS; i++) {
            if (out->array[i] != NULL) {
                memcpy(out->array[i] + at, from->array[i] + first, run * sizeof(float));
            }
        }
        walk_on(&w, run);
    }
}

/* How fast the passes along rows are: samples of long rows for one sample at points, and what each
   strip of a row takes beside its samples, in samples. */
struct rows_speed {
    float gain, overhead;
};

/* The same where axes are turned, measured with SSE4.1, AVX2 and AVX-512 on Zen 4 at four octaves
   and steps of 0.05 cells, for rows of 5 to 257 samples. */
static struct rows_speed turned_speed_of(const struct scarp_call_plan *plan, int dimensions)
{
    static const struct rows_speed blends[2] = {{1.25f, 3.4f}, {1.55f, 5.4f}}; /* [values alone] */
    static const struct rows_speed simplex[2][2] = {/* by [in space][values alone] */
                                                    {{1.05f, 0.8f}, {1.2f, 1.6f}},
                                                    {{1.2f, 5.6f}, {1.35f, 4.0f}}};
    static const struct rows_speed cells = {1.2f, 1.6f};
    const int in_space = dimensions == 3, values = plan->order == 0;
    return plan->basis == SCARP_SIMPLEX  ? simplex[in_space][values]
           : blends_corners(plan->basis) ? blends[values]
                                         : cells;
}

/* Measured with AVX2 and AVX-512 on Zen 4, at steps of 0.05 cells, for rows of 5 to 257 samples.
   `crosses` tells whether a block of the last octave crosses more than two cells. */
static struct rows_speed rows_speed_of(const struct scarp_call_plan *plan, int dimensions,
                                       int crosses)
{
    static const float simplex[2][2][2] = {/* by [one octave][in space][values alone] */
                                           {{0.95f, 1.1f}, {1.05f, 1.2f}},
                                           {{1.0f, 1.5f}, {1.25f, 2.5f}}};
    const int one = plan->octaves == 1, in_space = dimensions == 3, values = plan->order == 0;
    if (plan->rotate) {
        return turned_speed_of(plan, dimensions);
    }
    if (plan->basis == SCARP_SIMPLEX) {
        const struct rows_speed s = {simplex[one][in_space][values],
                                     one && in_space && values ? 20.0f : 8.0f};
        return s;
    }
    if (one) {
        const struct rows_speed cells = {in_space ? 3.0f : 2.0f, 10.0f};
        return cells;
    }
    const struct rows_speed s = {in_space || !crosses ? 1.2f : 0.95f, 3.0f};
    return s;
}

/* Whether points take less time than passes along such short rows. */
static int rows_are_short(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                          int dimensions)
{
    const size_t count = grid->count[0], rest = count % VEC_LANES;
    if (blends_corners(plan->basis) && !plan->rotate) {
        return count < VEC_LANES && 20 * count < (plan->order > 0 ? 16 : 13) * (size_t)VEC_LANES;
    }
    const size_t samples = count - rest + (rest > 0 ? VEC_LANES : 0);
    const float strips = rest == 0 || count < PADDED_SAMPLES ? 1.0f : 2.0f;
    const float filling = 0.25f / (float)plan->octaves; /* coordinates, for one sample at points */
    const double step = grid->step[0] * plan->octave[plan->octaves - 1].frequency64;
    const struct rows_speed speed =
        rows_speed_of(plan, dimensions, (step < 0 ? -step : step) * VEC_LANES > 2);
    return speed.gain * (float)count * (1.0f + filling) < (float)samples + speed.overhead * strips;
}

/* Whether a grid of a noise, without its warps, is computed as points. */
static int is_flat(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                   int dimensions)
{
    return has_no_rows(plan) || rows_are_short(plan, grid, dimensions);
}

/* Computes a grid of a noise without warps as points. */
static __attribute__((noinline)) void flat_grid(const struct scarp_call_plan *plan,
                                                const struct scarp_grid *grid,
                                                const struct scarp_outputs *out, int dimensions)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    struct chunked c = {.f = {.layout = DOUBLES, .dimensions = dimensions}};
    struct walk walk = {grid, {0, 0, 0}};
    const size_t slice = grid->count[0] * grid->count[1];
    const size_t count = slice * (dimensions == 3 ? grid->count[2] : 1);
    const int has_gaps =
        grid->row_stride != grid->count[0] || (dimensions == 3 && grid->slice_stride != slice);
    const size_t size = sample_size(dimensions, plan->order) + (plan->dphase ? 1 : 0);
    struct scarp_outputs to = {.array = {NULL}};
    float *from = chunked_begin(&c, work, has_gaps ? size : 0);
    if (has_gaps) {
        take_arrays(&to, &from, c.most, dimensions, plan->order);
        to.array[DPHASE] = plan->dphase ? from : NULL;
        from += plan->dphase ? c.most : 0;
    }
    chunked_end(&c, work, from);
    const void *const position[3] = {c.position[0], c.position[1], c.position[2]};
    double *const fill[3] = {c.position[0], c.position[1], c.position[2]};
    for (size_t first = 0, here; first < count; first += here) {
        const struct walk begin = walk;
        here = least(count - first, c.most);
        (dimensions == 2 ? walk_fill2 : walk_fill3)(fill, &walk, here);
        for (int i = 0; i < OUTPUTS && !has_gaps; i++) {
            to.array[i] = out->array[i] != NULL ? out->array[i] + first : NULL;
        }
        points_unwarped(plan, here, position, &to, c.f, c.passes);
        if (has_gaps) {
            walk_copy(out, begin, here, &to);
        }
    }
}

#endif
