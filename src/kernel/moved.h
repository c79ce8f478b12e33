/* SPDX-License-Identifier: MIT
 *
 * Stage 1 at displaced positions of doubles: where samples lie that are so many floats away from
 * coordinates in double. Coordinates are split into cells and fractions in double, as those of
 * other noise are; displacements are turned into cells of the octave in float, split, and added:
 *
 *     coordinate   -- f x + o or J x + o, in double --> cell, fraction --+
 *                                                                        +--> split_sum()
 *     displacement -- f d or J d, in float -----------> cell, fraction --+
 *
 * So nothing that is far from the origin is rounded to float. Along the straight axes of a grid,
 * coordinates are split once for each column and each row. The reference is scalar/positions.h.
 */
#ifndef SCARP_KERNEL_MOVED_H
#define SCARP_KERNEL_MOVED_H

#include "far.h"

/* What is known of samples along an axis. `by` has whole blocks. */
struct moved_axis {
    const double *x;   /* the coordinates: of each sample, if they are points; if they are rows of a
                          grid, of each column, of each row, of the slice, by axis */
    const float *by;   /* how far each sample is displaced */
    size_t row_blocks; /* the blocks of a row, with padding; 0: points */
};

/* The coordinates of some blocks, as they are or split; of these, the next block is `advance`
   vectors further. And how far they are displaced. */
struct moved_arrays {
    struct coordinate_arrays x;
    const vf *t[3], *cell[3];
    size_t advance[3];
    const float *by[3];
};

/* The split coordinate of block b. */
VEC_INLINE struct split split_at(const struct moved_arrays *at, int axis, size_t b)
{
    const struct split s = {(vu)at->cell[axis][b * at->advance[axis]],
                            at->t[axis][b * at->advance[axis]]};
    return s;
}

VEC_INLINE vf displacement(const struct moved_arrays *at, int axis, size_t b)
{
    return vf_load(at->by[axis] + b * VEC_LANES);
}

/* How far block b is displaced along an axis of the octave, in cells. */
VEC_INLINE vf moved_cells(const struct scarp_octave *o, int axis, const struct moved_arrays *at,
                          size_t b, struct frame f)
{
    if (f.axes != AXES_TURNED) {
        return vf_set(o->frequency) * displacement(at, axis, b);
    }
    vf d[3] = {displacement(at, 0, b), displacement(at, 1, b)};
    if (f.dimensions == 3) {
        d[2] = displacement(at, 2, b);
    }
    return along_turned_f32(o, axis, d, f);
}

/* Puts some blocks somewhere. */
typedef void moved_pass(vf *to, const struct scarp_octave *octave, size_t blocks,
                        const struct moved_arrays *at);

/* Where block b is: of a row of a grid with straight axes, `shared` is what the row shares along y
   and z; of points, as of a row with turned axes, coordinates are not split yet. */
VEC_INLINE struct split moved_at(const struct scarp_octave *o, int axis,
                                 const struct moved_arrays *at, const struct split *shared,
                                 size_t b, struct frame f)
{
    struct split s;
    if (shared != NULL) {
        s = axis > 0 ? shared[axis - 1] : split_at(at, 0, b);
    } else if (f.axes == AXES_TURNED) {
        vd low[3], high[3];
        for (int i = 0; i < f.dimensions; i++) {
            low[i] = load_f64_of(&at->x, i, b, 0);
            high[i] = load_f64_of(&at->x, i, b, 1);
        }
        s = split_turned_f64(o, axis, 1.0, low, high, f);
    } else {
        s = split_f64(straight_f64(o, axis, load_f64_of(&at->x, axis, b, 0), f),
                      straight_f64(o, axis, load_f64_of(&at->x, axis, b, 1), f));
    }
    return split_sum(s, split_f32(moved_cells(o, axis, at, b, f)));
}

VEC_INLINE void moved_run(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                          const struct moved_arrays *arrays, struct frame f, enum corner_form form)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    struct moved_arrays at = *arrays;
    struct split shared[2];
    const int is_row = f.layout == ROW;
    for (int i = 0; i < f.dimensions; i++) {
        at.advance[i] = 2; /* these are constants: see split_along() */
        at.x.advance[i] = f.axes == AXES_TURNED ? at.x.advance[i] : VEC_LANES;
        if (is_row && i > 0) {
            shared[i - 1] = split_at(&at, i, 0);
        }
    }
    for (size_t b = 0; b < blocks; b++, lattice += lattice_size(f.dimensions)) {
        struct split s[3];
        for (int i = 0; i < f.dimensions; i++) {
            s[i] = moved_at(&o, i, &at, is_row ? shared : NULL, b, f);
        }
        const struct mixed m = lattice_put_fractions(lattice, &o, s, AXES_STRAIGHT, f.dimensions);
        lattice_put_corners(lattice, &m, f.dimensions, form);
    }
}

#define MOVED_PASS(name, dimensions, layout, axes, form)                                           \
    static void name(vf *lattice, const struct scarp_octave *octave, size_t blocks,                \
                     const struct moved_arrays *at)                                                \
    {                                                                                              \
        const struct frame f = {layout, axes, dimensions};                                         \
        moved_run(lattice, octave, blocks, at, f, form);                                           \
    }
#define MOVED_PASSES(name, form)                                                                   \
    MOVED_PASS(name##2_row, 2, ROW, AXES_STRAIGHT, form)                                           \
    MOVED_PASS(name##2_straight, 2, MOVED, AXES_STRAIGHT, form)                                    \
    MOVED_PASS(name##2_turned, 2, MOVED, AXES_TURNED, form)                                        \
    MOVED_PASS(name##3_row, 3, ROW, AXES_STRAIGHT, form)                                           \
    MOVED_PASS(name##3_straight, 3, MOVED, AXES_STRAIGHT, form)                                    \
    MOVED_PASS(name##3_turned, 3, MOVED, AXES_TURNED, form)
#define MOVED_NAMES(name)                                                                          \
    {                                                                                              \
        {name##2_row, name##2_straight, name##2_turned},                                           \
        {                                                                                          \
            name##3_row, name##3_straight, name##3_turned                                          \
        }                                                                                          \
    }

MOVED_PASSES(moved_axes, CORNERS_MIXED)
#if VEC_LANES == 16
MOVED_PASSES(moved_hashes, CORNERS_HASHED)
#endif

/* By [form][dimensions - 2][straight row, straight, turned]: for axes without periods. Sets with
   fewer lanes make hashes of mixed axes in a loop of their own: see lattice.h. */
static moved_pass *const moved_passes[CORNER_FORMS][2][3] = {
    [CORNERS_MIXED] = MOVED_NAMES(moved_axes),
#if VEC_LANES == 16
    [CORNERS_HASHED] = MOVED_NAMES(moved_hashes),
#endif
};

#undef MOVED_PASS
#undef MOVED_PASSES
#undef MOVED_NAMES

/* Gives blocks unhashed locations (unhashed.h), where the split coordinates may be. */
VEC_INLINE void moved_unhashed_run(vf *to, const struct scarp_octave *octave, size_t blocks,
                                   const struct moved_arrays *arrays, struct frame f)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    const struct moved_arrays at = *arrays;
    for (size_t b = 0; b < blocks; b++, to += unhashed_size(f.dimensions)) {
        struct split s[3];
        for (int i = 0; i < f.dimensions; i++) {
            const vf cells = moved_cells(&o, i, &at, b, f);
            s[i] = split_sum(split_at(&at, i, b),
                             split_f32(i == 1 ? cells * vf_set((float)o.stretch) : cells));
        }
        for (int i = 0; i < f.dimensions; i++) {
            to[i] = s[i].t;
            to[f.dimensions + i] = (vf)s[i].cell;
        }
    }
}

/* The same along one axis, on a lattice with periods. A sum of two cells within a period is less
   than two periods. */
static __attribute__((noinline)) void moved_within_axis(vf *to, const struct scarp_octave *o,
                                                        int axis, size_t blocks,
                                                        const struct moved_arrays *at,
                                                        int dimensions)
{
    const struct frame f = {MOVED, AXES_PERIODS, dimensions};
    const vf stretch = vf_set(axis == 1 ? (float)o->stretch : 1.0f);
    const vu last = vu_set(o->last[axis]);
    for (size_t b = 0; b < blocks; b++, to += unhashed_size(dimensions)) {
        const vf cells = moved_cells(o, axis, at, b, f) * stretch;
        struct split by = split_f32(cells);
        by.cell = vu_any(far_bits(by.cell) & vu_set(FAR_BITS))
                      ? within_far(by.cell, o, axis)
                      : within_f32(by.cell, vf_floor(cells), o, axis);
        const struct split s = split_sum(split_at(at, axis, b), by);
        to[axis] = s.t;
        to[dimensions + axis] = (vf)(s.cell - ((vu)(s.cell > last) & (last + 1)));
    }
}

static void moved_within(vf *to, const struct scarp_octave *o, size_t blocks,
                         const struct moved_arrays *at, int dimensions)
{
    for (int axis = 0; axis < dimensions; axis++) {
        moved_within_axis(to, o, axis, blocks, at, dimensions);
    }
}

#define MOVED_UNHASHED(name, dimensions, axes)                                                     \
    static void name(vf *to, const struct scarp_octave *octave, size_t blocks,                     \
                     const struct moved_arrays *at)                                                \
    {                                                                                              \
        const struct frame f = {MOVED, axes, dimensions};                                          \
        moved_unhashed_run(to, octave, blocks, at, f);                                             \
    }
MOVED_UNHASHED(moved_unhashed2_straight, 2, AXES_STRAIGHT)
MOVED_UNHASHED(moved_unhashed2_turned, 2, AXES_TURNED)
MOVED_UNHASHED(moved_unhashed3_straight, 3, AXES_STRAIGHT)
MOVED_UNHASHED(moved_unhashed3_turned, 3, AXES_TURNED)
#undef MOVED_UNHASHED

/* By [dimensions - 2][whether axes are turned]. */
static moved_pass *const moved_unhashed_passes[2][2] = {
    {moved_unhashed2_straight, moved_unhashed2_turned},
    {moved_unhashed3_straight, moved_unhashed3_turned},
};

/* Puts unhashed locations on a lattice with periods, as mixed axes. */
VEC_INLINE void hash_unhashed_run(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                                  const vf *from, int dimensions)
{
    const struct scarp_octave o = *octave; /* a copy: nothing that is stored can alias it */
    for (size_t b = 0; b < blocks; b++) {
        struct split s[3];
        for (int i = 0; i < dimensions; i++) {
            s[i].t = from[i];
            s[i].cell = (vu)from[dimensions + i];
        }
        const struct mixed m = lattice_put_fractions(lattice, &o, s, AXES_PERIODS, dimensions);
        lattice_put_corners(lattice, &m, dimensions, CORNERS_MIXED);
        lattice += lattice_size(dimensions);
        from += unhashed_size(dimensions);
    }
}

static __attribute__((noinline)) void hash_unhashed(vf *lattice, const struct scarp_octave *octave,
                                                    size_t blocks, const vf *from, int dimensions)
{
    if (dimensions == 2) {
        hash_unhashed_run(lattice, octave, blocks, from, 2);
    } else {
        hash_unhashed_run(lattice, octave, blocks, from, 3);
    }
}

#if VEC_LANES == 16
/* Makes hashes of mixed axes, in place. */
static __attribute__((noinline)) void hash_in_place(vf *lattice, size_t blocks, int dimensions)
{
    for (size_t b = 0; b < blocks; b++, lattice += lattice_size(dimensions)) {
        struct mixed m;
        for (int i = 0; i < 3; i++) {
            m.axis[i] = axis_of(lattice, i < dimensions ? i : 0, dimensions);
        }
        lattice_put_corners(lattice, &m, dimensions, CORNERS_HASHED);
    }
}
#endif

/* Splits the coordinates of some blocks along a straight axis: for each block, the fractions, then
   the cells. */
static __attribute__((noinline)) void split_along(vf *to, const struct scarp_octave *o, int axis,
                                                  const double *x, size_t blocks, enum axes axes)
{
    const vd stretch = vd_set(axis == 1 ? o->stretch : 1.0);
    const struct frame f = {DOUBLES, AXES_STRAIGHT, 3};
    for (size_t b = 0; b < blocks; b++, x += VEC_LANES) {
        const vd p0 = straight_f64(o, axis, vd_load(x), f) * stretch;
        const vd p1 = straight_f64(o, axis, vd_load(x + VEC_LANES / 2), f) * stretch;
        struct split s = split_f64(p0, p1);
        if (axes == AXES_PERIODS) {
            s.cell = vu_low_bits(within_f64(vd_floor(p0), o, axis) + 0x1.8p52,
                                 within_f64(vd_floor(p1), o, axis) + 0x1.8p52);
        } else if (axes == AXES_POWERS) {
            s.cell = within_power(s.cell, o, axis);
        }
        to[2 * b] = s.t;
        to[2 * b + 1] = (vf)s.cell;
    }
}

/* An octave at displaced positions. */
struct moved {
    const struct moved_axis *axis[3];
    struct scarp_octave
        octave;  /* whose stretch is 1 but for a basis that takes unhashed locations */
    vf *columns; /* of a grid with straight axes: by split_along() */
    enum axes axes;
    enum corner_form corners;
    int dimensions, takes_unhashed; /* struct basis of driver.h */
};

/* What rows share along y and z, with straight axes: some rows at once, then the slice. */
struct rows_split {
    size_t block; /* the number of the block of rows, if it is split */
    vf rows[2], slice[2];
};

/* The same in all lanes as in lane i. */
VEC_INLINE vf lane_of(vf a, size_t i)
{
    float lanes[VEC_LANES];
    vf_store(lanes, a);
    return vf_set(lanes[i]);
}

/* Splits coordinates of blocks, from `first` on, which are in one row of a grid with straight axes.
   `shared` has room for what the row shares. */
static void split_row(struct moved_arrays *s, const struct moved *m, size_t first,
                      struct rows_split *split, vf shared[2][2])
{
    const size_t row_blocks = m->axis[0]->row_blocks, row = first / row_blocks;
    s->t[0] = m->columns + 2 * (first % row_blocks);
    s->cell[0] = s->t[0] + 1;
    s->advance[0] = 2;
    if (split->block != row / VEC_LANES) {
        split->block = row / VEC_LANES;
        split_along(split->rows, &m->octave, 1, m->axis[1]->x + split->block * VEC_LANES, 1,
                    m->axes);
    }
    for (int i = 1; i < m->dimensions; i++) {
        const vf *const from = i == 1 ? split->rows : split->slice;
        shared[i - 1][0] = lane_of(from[0], i == 1 ? row % VEC_LANES : 0);
        shared[i - 1][1] = lane_of(from[1], i == 1 ? row % VEC_LANES : 0);
        s->t[i] = shared[i - 1];
        s->cell[i] = s->t[i] + 1;
        s->advance[i] = 0;
    }
}

/* Finds coordinates of blocks of points, or of a row with turned axes. `still` has room for what
   the row shares. */
static void find_blocks(struct moved_arrays *s, const struct moved *m, size_t first,
                        double still[2][VEC_LANES])
{
    const size_t row_blocks = m->axis[0]->row_blocks;
    s->x.axes = m->axes;
    for (int i = 0; i < m->dimensions; i++) {
        s->x.advance[i] = VEC_LANES;
        s->x.array[i] = m->axis[i]->x + (row_blocks > 0 ? first % row_blocks : first) * VEC_LANES;
        if (row_blocks > 0 && i > 0) {
            const vd x = vd_set(m->axis[i]->x[i == 1 ? first / row_blocks : 0]);
            memcpy(still[i - 1], &x, sizeof x);
            memcpy(still[i - 1] + VEC_LANES / 2, &x, sizeof x);
            s->x.advance[i] = 0;
            s->x.array[i] = still[i - 1];
        }
    }
}

/* The coordinates of block b that find_blocks() has found. */
static void block_at(const void *array[3], const struct moved_arrays *s, size_t b, int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        array[i] = (const double *)s->x.array[i] + b * s->x.advance[i];
    }
}

/* Whether far.h has what find_blocks() has found, where axes are turned. A row is farthest at one
   of its ends. */
static int blocks_are_far(const struct moved *m, const struct moved_arrays *s, size_t blocks)
{
    const double frequency = m->octave.frequency64;
    const void *begin[3], *end[3];
    if (m->axis[0]->row_blocks == 0) {
        return is_far(frequency, blocks * VEC_LANES, s->x.array, m->dimensions);
    }
    block_at(begin, s, 0, m->dimensions);
    block_at(end, s, blocks - 1, m->dimensions);
    return is_far(frequency, VEC_LANES, begin, m->dimensions) ||
           is_far(frequency, VEC_LANES, end, m->dimensions);
}

/* Splits what find_blocks() has found: each block gets an unhashed location at `to`. */
static void split_blocks(vf *to, const struct moved *m, size_t blocks, struct moved_arrays *s,
                         int far)
{
    const int d = m->dimensions;
    const struct scarp_octave *const o = &m->octave;
    if (far) {
        for (size_t b = 0; b < blocks; b++) {
            struct positions at;
            block_at(at.array, s, b, d);
            far_row(to + b * unhashed_size(d), o, 1, &at, d, TURNED_CELLS);
        }
    } else {
        unhashed_passes[d - 2][m->axes == AXES_TURNED][1](to, o, blocks, &s->x);
    }
    for (int i = 0; i < m->dimensions; i++) {
        s->t[i] = to + i;
        s->cell[i] = to + m->dimensions + i;
        s->advance[i] = unhashed_size(m->dimensions);
    }
}

/* Gives some blocks unhashed locations, those of a lattice with periods behind the blocks to be
   made of them, which never reach what is still to be read. */
static void locate_unhashed_blocks(vf *to, const struct moved *m, size_t blocks,
                                   struct moved_arrays *s, int is_row, int far)
{
    const int d = m->dimensions, repeats = axes_repeat(m->axes);
    const size_t size = m->takes_unhashed ? unhashed_size(d) : lattice_size(d);
    vf *const behind = to + blocks * (size - unhashed_size(d));
    if (!is_row) {
        split_blocks(behind, m, blocks, s, far);
    }
    if (repeats) {
        moved_within(behind, &m->octave, blocks, s, d);
    } else {
        moved_unhashed_passes[d - 2][m->axes == AXES_TURNED](behind, &m->octave, blocks, s);
    }
    if (!m->takes_unhashed) {
        hash_unhashed(to, &m->octave, blocks, behind, d);
    }
}

/* Locates some blocks, from `first` on, of points or of one row. */
static __attribute__((noinline)) void locate_blocks(vf *to, const struct moved *m, size_t first,
                                                    size_t blocks, struct rows_split *split)
{
    const int d = m->dimensions, turned = m->axes == AXES_TURNED;
    const int is_row = m->axis[0]->row_blocks > 0 && !turned;
    double still[2][VEC_LANES];
    vf shared[2][2];
    struct moved_arrays s;
    for (int i = 0; i < d; i++) {
        s.by[i] = m->axis[i]->by + first * VEC_LANES;
    }
    if (is_row) {
        split_row(&s, m, first, split, shared);
    } else {
        find_blocks(&s, m, first, still);
    }
    const int far = turned && blocks_are_far(m, &s, blocks);
    if (m->takes_unhashed || axes_repeat(m->axes) || far) {
        locate_unhashed_blocks(to, m, blocks, &s, is_row, far);
#if VEC_LANES == 16
        if (far && !m->takes_unhashed && m->corners == CORNERS_HASHED) {
            hash_in_place(to, blocks, d);
        }
#endif
    } else {
        const enum corner_form form = VEC_LANES == 16 ? m->corners : CORNERS_MIXED;
        moved_passes[form][d - 2][is_row ? 0 : turned ? 2 : 1](to, &m->octave, blocks, &s);
    }
}

/* Locates the blocks of a tile, row by row. */
static void locate_moved(vf *to, const struct moved *m, size_t first, size_t blocks)
{
    const int d = m->dimensions;
    const size_t size = m->takes_unhashed ? unhashed_size(d) : lattice_size(d);
    const size_t row_blocks = m->axis[0]->row_blocks;
    struct rows_split split = {.block = SIZE_MAX};
    if (d == 3 && row_blocks > 0) {
        split_along(split.slice, &m->octave, 2, m->axis[2]->x, 1, m->axes);
    }
    for (size_t b = 0, here; b < blocks; b += here) {
        const size_t in_row = row_blocks > 0 ? row_blocks - (first + b) % row_blocks : blocks;
        here = in_row < blocks - b ? in_row : blocks - b;
        locate_blocks(to + b * size, m, first + b, here, &split);
    }
#if VEC_LANES < 16
    if (!m->takes_unhashed && m->corners == CORNERS_HASHED) {
        (d == 2 ? hash_blocks2 : hash_blocks3)(to, blocks);
    }
#else
    if (!m->takes_unhashed && m->corners == CORNERS_HASHED && axes_repeat(m->axes)) {
        hash_in_place(to, blocks, d);
    }
#endif
}

/* Locates the blocks of a tile in octave k. What depends on x is kept for the tiles that follow if
   there is no other octave. */
static void locate_octave(vf *to, struct moved *m, const struct scarp_call_plan *plan, int k,
                          size_t first, size_t blocks)
{
    const struct scarp_octave *const o = &plan->octave[k];
    m->octave = *o;
    m->octave.stretch = m->takes_unhashed ? o->stretch : 1.0;
    m->axes = axes_of(plan, k);
    if (m->axes != AXES_TURNED && (plan->octaves > 1 || first == 0)) {
        split_along(m->columns, o, 0, m->axis[0]->x, m->axis[0]->row_blocks, m->axes);
    }
    locate_moved(to, m, first, blocks);
}

/* Vectors that the columns of a grid need: see split_along(). */
static size_t moved_size(const struct moved_axis *axis)
{
    return 2 * axis->row_blocks;
}

#endif
