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
#if !VEC_SMALL
#include "crossing.h"
#endif

/* Coordinates of samples in the order of the grid, an array for each axis. Where rows are short, x
   is the same for every chunk that begins in the same place of its row; where slices are small, so
   is y. */
struct flat_positions {
    const struct scarp_grid *grid;
    int dimensions, repeats[2]; /* whether the array of x, and that of y, serves all chunks */
    double *array[3];
};

/* Longer rows, and larger slices, are not repeated. */
#define REPEATED_ROW 256
#define REPEATED_SLICE 384

/* Fills in x of rows from the first sample on, and up to a vector more. The vectors of a row are
   stored in all rows, the last one first, since it reaches into the next row. */
static void flat_repeat_x(double *to, const struct scarp_grid *grid, size_t count)
{
    const size_t row = grid->count[0];
    double x[VEC_LANES];
    for (size_t i = (row - 1) / VEC_LANES * VEC_LANES;; i -= VEC_LANES) {
        block_coordinates(x, grid, 0, i, row - i);
        const vd low = vd_load(x), high = vd_load(x + VEC_LANES / 2);
        for (size_t at = i + VEC_LANES / 2; i + VEC_LANES / 2 < row && at < count; at += row) {
            memcpy(to + at, &high, sizeof high);
        }
        for (size_t at = i; at < count; at += row) {
            memcpy(to + at, &low, sizeof low);
        }
        if (i == 0) {
            return;
        }
    }
}

/* Fills in x from sample `first` of a row on, and up to a vector more. After the first row, what is
   there is copied, twice as much each time. */
static void flat_fill_x(double *to, const struct scarp_grid *grid, size_t first, size_t count)
{
    const size_t row = grid->count[0];
    for (size_t i = 0; i < least(row, count); i++) {
        to[i] = coordinate(grid, 0, first);
        first = first + 1 < row ? first + 1 : 0;
    }
    for (size_t filled = row; filled < count; filled *= 2) {
        copy_doubles(to + filled, to, least(filled, count - filled));
    }
}

/* Fills in y or z from a sample of the grid on, and up to a vector more. */
static void flat_fill_runs(double *to, const struct scarp_grid *grid, int axis, size_t first,
                           size_t count)
{
    const size_t period = axis == 1 ? grid->count[0] : grid->count[0] * grid->count[1];
    size_t index = first / period % grid->count[axis], run = period - first % period;
    for (size_t at = 0; at < count; at += run, run = period) {
        fill_doubles(to + at, coordinate(grid, axis, index), least(run, count - at));
        index = index + 1 < grid->count[axis] ? index + 1 : 0;
    }
}

/* Vectors that are needed besides those of a chunk. */
static size_t flat_repeated_size(const struct flat_positions *p)
{
    const size_t row = p->repeats[0] ? p->grid->count[0] : 0;
    const size_t slice = p->repeats[1] ? p->grid->count[0] * p->grid->count[1] : 0;
    const size_t doubles = row + slice + (size_t)p->dimensions * VEC_LANES;
    return (doubles * 2 + VEC_LANES - 1) / VEC_LANES;
}

static void flat_positions_begin(struct flat_positions *p, const struct scarp_grid *grid,
                                 int dimensions)
{
    const size_t row = grid->count[0], slice = row * grid->count[1];
    p->grid = grid;
    p->dimensions = dimensions;
    p->repeats[0] = row <= REPEATED_ROW;
    p->repeats[1] = dimensions == 3 && row <= REPEATED_ROW && slice <= REPEATED_SLICE;
}

/* Takes the arrays for chunks of `most` samples, and returns where the rest of the space begins. */
static vf *flat_positions_take(struct flat_positions *p, vf *space, size_t most)
{
    const size_t row = p->grid->count[0], slice = row * p->grid->count[1];
    const size_t count[3] = {most + (p->repeats[0] ? row : 0), most + (p->repeats[1] ? slice : 0),
                             most};
    double *from = (double *)space;
    for (int axis = 0; axis < p->dimensions; axis++) {
        p->array[axis] = from;
        from += count[axis] + VEC_LANES / 2;
    }
    if (p->repeats[0]) {
        flat_repeat_x(p->array[0], p->grid, count[0]);
    }
    if (p->repeats[1]) {
        flat_fill_runs(p->array[1], p->grid, 1, 0, count[1]);
    }
    return space + most * 2 * (size_t)p->dimensions / VEC_LANES + flat_repeated_size(p);
}

/* Finds the coordinates of the chunk that begins with sample `first`. */
static void flat_positions_of(const struct flat_positions *p, const void *position[3], size_t first,
                              size_t count)
{
    const size_t row = p->grid->count[0], slice = row * p->grid->count[1];
    position[0] = p->array[0] + (p->repeats[0] ? first % row : 0);
    position[1] = p->array[1] + (p->repeats[1] ? first % slice : 0);
    position[2] = p->array[2];
    if (!p->repeats[0]) {
        flat_fill_x(p->array[0], p->grid, first % row, count);
    }
    if (!p->repeats[1]) {
        flat_fill_runs(p->array[1], p->grid, 1, first, count);
    }
    if (p->dimensions == 3) {
        flat_fill_runs(p->array[2], p->grid, 2, first, count);
    }
}

/* Copies the outputs of the chunk that begins with sample `first` to the rows of the caller's
   arrays. */
static void flat_copy(const struct scarp_outputs *out, const struct scarp_grid *grid, size_t first,
                      size_t count, const struct scarp_outputs *from)
{
    const size_t row = grid->count[0];
    size_t run = least(row - first % row, count);
    for (size_t done = 0; done < count; done += run, run = least(row, count - done)) {
        const size_t at = first + done, r = at / row;
        const size_t to = r / grid->count[1] * grid->slice_stride +
                          r % grid->count[1] * grid->row_stride + at % row;
        for (int i = 0; i < OUTPUTS; i++) {
            if (out->array[i] != NULL) {
                memcpy(out->array[i] + to, from->array[i] + done, run * sizeof(float));
            }
        }
    }
}

/* How fast a way is depends on the processor. All measures below are of Zen 4, which takes vectors
   of 16 lanes in two halves. Zen 5 takes them whole: a sample costs half there, but what is
   prepared for a strip, one line of vertices after another, costs the same. So it counts twice with
   such vectors: rows have to win on both. Where a measure says that rows are faster by less than a
   tenth, points are taken: they are never much slower, and rows may be. */
#define WIDE_VECTORS (VEC_LANES == 16 ? 2.0f : 1.0f)
#define CLEARLY 1.1f

/* Samples that passes along rows compute, those beyond the ends of rows and `overhead` for each
   strip with them. */
static float rows_samples(const struct scarp_grid *grid, float overhead)
{
    const size_t count = grid->count[0], rest = count % VEC_LANES;
    const size_t samples = count - rest + (rest > 0 ? VEC_LANES : 0);
    return (float)samples + overhead * (rest == 0 || count < PADDED_SAMPLES ? 1.0f : 2.0f);
}

/* How far samples of a row are apart, in cells of octave k. */
static float step_of(const struct scarp_call_plan *plan, const struct scarp_grid *grid, int k)
{
    const double step = grid->step[0] * plan->octave[k].frequency64;
    const double apart = step < 0.0 ? -step : step;
    return apart < 1e6 ? (float)apart : 1e6f;
}

#if !VEC_SMALL
/* What a sample along rows takes, for one of crossing.h: `sample`, and `cell` for each cell from
   one sample to the next, but `points` where rows are computed as points (COLUMNS_PER_BLOCK); and
   what a strip takes, in samples. */
struct rows_time {
    float sample, cell, points, overhead;
};

/* Measured on Zen 4 with SSE4.1, AVX2 and AVX-512: rows of 5 to 1,024 samples, 0.01 to 0.2 cells
   apart (corners up to 1), of one, four and eight octaves. */
static struct rows_time rows_time_of(const struct scarp_call_plan *plan, int dimensions)
{
    enum { SET = VEC_LANES == 4 ? 0 : VEC_LANES == 8 ? 1 : 2 };
    static const float corners[3][2][2] = {/* by [set][one octave][in space] */
                                           {{0.6f, 0.6f}, {0.82f, 0.82f}},
                                           {{0.5f, 0.66f}, {0.74f, 0.66f}},
                                           {{0.36f, 0.36f}, {0.66f, 0.58f}}};
    static const struct rows_time simplex[2][2] = {
        /* by [in space][only values] */
        {{0.7f, 4.0f, 1.1f, 12.0f}, {0.6f, 2.0f, 1.4f, 8.0f}},
        {{0.5f, 4.0f, 1.4f, 20.0f}, {0.4f, 1.0f, 1.0f, 20.0f}}};
    static const struct rows_time cells[2][2] = {
        /* by [in space][two features] */
        {{0.15f, 8.0f, 1.0f, 0.0f}, {0.3f, 8.0f, 0.9f, 4.0f}},
        {{0.15f, 4.0f, 0.9f, 0.0f}, {0.25f, 4.0f, 1.1f, 2.0f}}};
    static const float gain[3] = {1.3f, 1.0f, 0.82f}; /* of rows, from set to set */
    const int finds_two = plan->basis == SCARP_CELL_F2 || plan->basis == SCARP_CELL_EDGE;
    const int in_space = dimensions == 3;
    if (blends_corners(plan->basis)) {
        const struct rows_time t = {.sample = corners[SET][plan->octaves == 1][in_space],
                                    .cell = 0.05f};
        return t;
    }
    struct rows_time t = plan->basis == SCARP_SIMPLEX ? simplex[in_space][plan->order == 0]
                                                      : cells[in_space][finds_two];
    t.sample /= gain[SET];
    t.cell /= gain[SET];
    t.points /= gain[SET];
    t.sample *= CLEARLY;
    t.cell *= CLEARLY;
    t.overhead *= plan->basis == SCARP_SIMPLEX ? WIDE_VECTORS : 1.0f;
    return t;
}

/* Whether octaves with straight axes take less time by crossing.h than along rows. */
static int crossing_is_faster(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                              int dimensions)
{
    const struct rows_time t = rows_time_of(plan, dimensions);
    float sum = 0.0f;
    for (int k = 0; k < plan->octaves; k++) {
        const float step = step_of(plan, grid, k);
        const int by_points = !blends_corners(plan->basis) && step * VEC_LANES > COLUMNS_PER_BLOCK;
        sum += by_points ? t.points : t.sample + t.cell * step;
    }
    return (float)(grid->count[0] * (size_t)plan->octaves) < sum * rows_samples(grid, t.overhead);
}
#endif

/* How fast the passes along rows are: samples of long rows for one sample at points, and what each
   strip of a row takes besides its samples, in samples. */
struct rows_speed {
    float gain, overhead;
};

/* The same where axes are turned, measured with SSE4.1, AVX2 and AVX-512 on Zen 4 at four octaves
   and steps of 0.05 cells, for rows of 5 to 257 samples. */
static struct rows_speed turned_speed_of(const struct scarp_call_plan *plan, int dimensions)
{
    static const struct rows_speed blends[2][2] = {/* by [16 lanes][only values] */
                                                   {{1.25f, 3.4f}, {1.55f, 5.4f}},
                                                   {{1.2f, 3.4f}, {1.55f, 5.4f}}};
    static const struct rows_speed simplex[2][2] = {/* by [in space][only values] */
                                                    {{1.05f, 0.8f}, {1.2f, 1.6f}},
                                                    {{1.2f, 5.6f}, {1.35f, 4.0f}}};
    static const struct rows_speed cells = {1.2f, 1.6f};
    const int in_space = dimensions == 3, values = plan->order == 0;
    if (blends_corners(plan->basis)) {
        return blends[VEC_LANES == 16][values];
    }
    const int is_simplex = plan->basis == SCARP_SIMPLEX;
    struct rows_speed s = is_simplex ? simplex[in_space][values] : cells;
    s.gain /= CLEARLY;
    s.overhead *= is_simplex ? WIDE_VECTORS : 1.0f;
    return s;
}

/* Measured with AVX2 and AVX-512 on Zen 4, at steps of 0.05 cells, for rows of 5 to 257 samples. */
static struct rows_speed rows_speed_of(const struct scarp_call_plan *plan,
                                       const struct scarp_grid *grid, int dimensions)
{
    static const float simplex[2][2][2] = {/* by [one octave][in space][only values] */
                                           {{0.95f, 1.1f}, {1.05f, 1.2f}},
                                           {{1.0f, 1.5f}, {1.25f, 2.5f}}};
    const int one = plan->octaves == 1, in_space = dimensions == 3, values = plan->order == 0;
    if (plan->rotate) {
        return turned_speed_of(plan, dimensions);
    }
    if (plan->basis == SCARP_SIMPLEX) {
        const float overhead = one && in_space && values ? 20.0f : 8.0f;
        const struct rows_speed s = {simplex[one][in_space][values] / CLEARLY,
                                     overhead * WIDE_VECTORS};
        return s;
    }
    if (one) {
        const struct rows_speed cells = {in_space ? 3.0f : 2.0f, 10.0f};
        return cells;
    }
    const int few_cells = step_of(plan, grid, plan->octaves - 1) * VEC_LANES <= 2.0f;
    const struct rows_speed s = {in_space || few_cells ? 1.2f : 0.95f, 3.0f};
    return s;
}

/* Whether points take less time than passes along such short rows. */
static int rows_are_short(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                          int dimensions)
{
    const size_t count = grid->count[0];
#if !VEC_SMALL
    if (crossing_serves(plan, grid, dimensions) > 0) {
        return crossing_is_faster(plan, grid, dimensions);
    }
#endif
    if (blends_corners(plan->basis) && !plan->rotate) {
        return count < VEC_LANES && 20 * count < (plan->order > 0 ? 16 : 13) * (size_t)VEC_LANES;
    }
    const float filling = 0.25f / (float)plan->octaves; /* coordinates, for one sample at points */
    const struct rows_speed speed = rows_speed_of(plan, grid, dimensions);
    return speed.gain * (float)count * (1.0f + filling) < rows_samples(grid, speed.overhead);
}

/* Whether a grid of a noise, without its warps, is computed as points. */
static int is_flat(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                   int dimensions)
{
    return has_no_rows(plan) || rows_are_short(plan, grid, dimensions);
}

/* Samples of a chunk: as many tiles of points as there is room for. Octaves that bend have chunks
   of their own, and leave the rest of the space to these. A chunk that has room for `count` samples
   even with as much scratch space as points may take needs no closer look. */
static size_t flat_chunk(const struct scarp_call_plan *plan, size_t vectors, size_t outputs,
                         size_t count, int dimensions)
{
    const size_t each = 2 * (size_t)dimensions + outputs; /* vectors of a block, of a chunk */
    if (fractal_bends(plan->fractal)) {
        return least(vectors * 9 / 16 / each, CHUNK_SAMPLES / VEC_LANES) * VEC_LANES;
    }
    const size_t any = LATTICE_SIZE3 + 1 + 2 * sample_size(dimensions, plan->order);
    if (plan->fractal == SCARP_FBM && count <= vectors / (each + any) * VEC_LANES) {
        return least(vectors / (each + any), TILE_BLOCKS) * VEC_LANES;
    }
    struct passes passes;
    passes_choose(&passes, plan, dimensions, DOUBLES);
    const size_t block = points_block_size(&passes);
    const size_t vectors_of_block =
        is_value_sum(plan) && block < VALUES_VECTORS ? VALUES_VECTORS : block;
    vectors -= plan->octaves == 1 ? PADDED_BLOCKS * passes.sums_size : 0;
    const size_t tile = least(vectors / (each + vectors_of_block), TILE_BLOCKS);
    return tile * ((vectors - vectors_of_block * tile) / (each * tile)) * VEC_LANES;
}

/* Computes a grid of a noise without warps as points. */
static __attribute__((noinline)) void flat_grid(const struct scarp_call_plan *plan,
                                                const struct scarp_grid *grid,
                                                const struct scarp_outputs *out, int dimensions)
{
    vf space[FLAT_BYTES / sizeof(vf)];
    struct workspace work = {space, sizeof space / sizeof(vf)};
#if !VEC_SMALL
    const size_t part = crossing_serves(plan, grid, dimensions);
    if (part > 0) {
        crossing_parts(plan, grid, out, dimensions, part, work);
        return;
    }
#endif
    const struct frame f = {.layout = DOUBLES, .dimensions = dimensions};
    const size_t slice = grid->count[0] * grid->count[1];
    const size_t count = slice * (dimensions == 3 ? grid->count[2] : 1);
    const int has_gaps = has_row_gaps(grid, dimensions);
    const size_t size =
        has_gaps ? sample_size(dimensions, plan->order) + (plan->dphase ? 1 : 0) : 0;
    struct flat_positions positions;
    struct scarp_outputs to = {.array = {NULL}};
    flat_positions_begin(&positions, grid, dimensions);
    const size_t most =
        flat_chunk(plan, work.vectors - flat_repeated_size(&positions), size, count, dimensions);
    float *from = (float *)flat_positions_take(&positions, space, most);
    if (has_gaps) {
        take_arrays(&to, &from, most, dimensions, plan->order);
        to.array[DPHASE] = plan->dphase ? from : NULL;
        from += plan->dphase ? most : 0;
    }
    work.space = (vf *)from;
    work.vectors -= (size_t)(work.space - space);
    for (size_t first = 0, here; first < count; first += here) {
        const void *position[3];
        here = least(count - first, most);
        flat_positions_of(&positions, position, first, here);
        for (int i = 0; i < OUTPUTS && !has_gaps; i++) {
            to.array[i] = out->array[i] != NULL ? out->array[i] + first : NULL;
        }
        points_unwarped(plan, here, position, &to, f, work);
        if (has_gaps) {
            flat_copy(out, grid, first, here, &to);
        }
    }
}

#endif
