/* SPDX-License-Identifier: MIT
 *
 * Stage 1 of bases that draw hashes themselves (simplex and cellular noise): the cells of points,
 * and the fractions inside. The reference is scalar/positions.h.
 *
 * A block has the fractions along all axes first, then the bits of the cells, then one free vector.
 * Rows of a grid come as doubles; y and z are the same along a row.
 */
#ifndef SCARP_KERNEL_UNHASHED_H
#define SCARP_KERNEL_UNHASHED_H

#include "lattice.h"

#define UNHASHED_SIZE(dimensions) (2 * (size_t)(dimensions) + 1)

static size_t unhashed_size(int dimensions)
{
    return UNHASHED_SIZE(dimensions);
}

/* A cell and the cells on either side, mixed. After the last cell of a period comes cell 0. */
VEC_INLINE void mixed_beside(vu mixed[3], vu cell, const struct scarp_octave *o, int axis)
{
    const vu multiplier = vu_set(hash_multiplier[axis]);
    const vu a = cell * multiplier + vu_set(o->key[axis]);
    vu before = a - multiplier, next = a + multiplier;
    if (o->last[axis] != UINT32_MAX) {
        const vu last = vu_set(o->last[axis]), period = (last + 1) * multiplier;
        before += (vu)(cell == 0) & period;
        next -= (vu)(cell == last) & period;
    }
    mixed[0] = vu_turn8(before);
    mixed[1] = vu_turn8(a);
    mixed[2] = vu_turn8(next);
}

/* The arrays of coordinates. The next block of an axis is `advance` elements further. */
struct coordinate_arrays {
    const void *array[3];
    size_t advance[3];
    enum axes axes;
};

VEC_INLINE vf load_f32_of(const struct coordinate_arrays *at, int axis, size_t block)
{
    return vf_load((const float *)at->array[axis] + block * at->advance[axis]);
}

VEC_INLINE vd load_f64_of(const struct coordinate_arrays *at, int axis, size_t block, int half)
{
    return vd_load((const double *)at->array[axis] + block * at->advance[axis] +
                   (size_t)half * (VEC_LANES / 2));
}

VEC_INLINE vf unhashed_f32(const struct scarp_octave *o, int axis,
                           const struct coordinate_arrays *at, size_t block, struct frame f)
{
    vf p;
    if (f.axes == AXES_TURNED) {
        vf x[3] = {load_f32_of(at, 0, block), load_f32_of(at, 1, block)};
        if (f.dimensions == 3) {
            x[2] = load_f32_of(at, 2, block);
        }
        p = turned_f32(o, axis, x, f);
    } else {
        p = straight_f32(o, axis, load_f32_of(at, axis, block), f);
    }
    return axis == 1 ? p * vf_set((float)o->stretch) : p;
}

VEC_INLINE vd unhashed_f64(const struct scarp_octave *o, int axis,
                           const struct coordinate_arrays *at, size_t block, int half,
                           struct frame f)
{
    const vd p = straight_f64(o, axis, load_f64_of(at, axis, block, half), f);
    return axis == 1 ? p * vd_set(o->stretch) : p;
}

VEC_INLINE struct split unhashed_turned_f64(const struct scarp_octave *o, int axis,
                                            const struct coordinate_arrays *at, size_t block,
                                            struct frame f)
{
    vd low[3], high[3];
    for (int i = 0; i < f.dimensions; i++) {
        low[i] = load_f64_of(at, i, block, 0);
        high[i] = load_f64_of(at, i, block, 1);
    }
    return split_turned_f64(o, axis, axis == 1 ? o->stretch : 1.0, low, high, f);
}

/* Where a block lies along an axis. `far` collects the bits of cells that within_f32 may have got
   wrong. */
VEC_INLINE struct split unhashed_split(const struct scarp_octave *o, int axis,
                                       const struct coordinate_arrays *at, size_t block,
                                       struct frame f, vu *far)
{
    struct split s;
    if (f.layout == FLOATS) {
        const vf p = unhashed_f32(o, axis, at, block, f);
        s = split_f32(p);
        if (at->axes == AXES_PERIODS) {
            *far |= far_bits(s.cell);
            s.cell = within_f32(s.cell, vf_floor(p), o, axis);
        }
    } else if (f.axes == AXES_TURNED) {
        s = unhashed_turned_f64(o, axis, at, block, f);
    } else {
        const vd p0 = unhashed_f64(o, axis, at, block, 0, f);
        const vd p1 = unhashed_f64(o, axis, at, block, 1, f);
        s = split_f64(p0, p1);
        if (at->axes == AXES_PERIODS) {
            s.cell = vu_low_bits(within_f64(vd_floor(p0), o, axis) + 0x1.8p52,
                                 within_f64(vd_floor(p1), o, axis) + 0x1.8p52);
        }
    }
    if (at->axes == AXES_POWERS) {
        s.cell = within_power(s.cell, o, axis);
    }
    return s;
}

static void unhashed_far(vf *to, const struct scarp_octave *octave, size_t blocks,
                         const struct coordinate_arrays *arrays, int dimensions);

VEC_INLINE void unhashed_run(vf *to, const struct scarp_octave *octave, size_t blocks,
                             const struct coordinate_arrays *arrays, struct frame f, int is_far)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    const struct coordinate_arrays at = *arrays;
    vu far = vu_set(0);
    for (size_t b = 0; b < blocks; b++) {
        for (int i = 0; i < f.dimensions; i++) {
            struct split s;
            if (is_far) {
                s = split_f32(unhashed_f32(&o, i, &at, b, f));
                s.cell = within_far(s.cell, &o, i);
            } else {
                s = unhashed_split(&o, i, &at, b, f, &far);
            }
            to[i] = s.t;
            to[f.dimensions + i] = (vf)s.cell;
        }
        to += unhashed_size(f.dimensions);
    }
    if (!is_far && f.layout == FLOATS && vu_any(far & vu_set(FAR_BITS))) {
        to -= blocks * unhashed_size(f.dimensions);
        unhashed_far(to, octave, blocks, arrays, f.dimensions);
    }
}

/* Repeats the work of unhashed_run for floats on a lattice with periods: some of them are far. */
static __attribute__((noinline, cold)) void unhashed_far(vf *to, const struct scarp_octave *octave,
                                                         size_t blocks,
                                                         const struct coordinate_arrays *arrays,
                                                         int dimensions)
{
    const struct frame f = {FLOATS, AXES_STRAIGHT, dimensions};
    unhashed_run(to, octave, blocks, arrays, f, 1);
}

#define UNHASHED_PASS(name, layout, axes, dimensions)                                              \
    static void name(vf *to, const struct scarp_octave *o, size_t blocks,                          \
                     const struct coordinate_arrays *at)                                           \
    {                                                                                              \
        const struct frame f = {layout, axes, dimensions};                                         \
        unhashed_run(to, o, blocks, at, f, 0);                                                     \
    }

UNHASHED_PASS(unhashed2_floats, FLOATS, AXES_STRAIGHT, 2)
UNHASHED_PASS(unhashed2_doubles, DOUBLES, AXES_STRAIGHT, 2)
UNHASHED_PASS(unhashed2_turned_floats, FLOATS, AXES_TURNED, 2)
UNHASHED_PASS(unhashed2_turned_doubles, DOUBLES, AXES_TURNED, 2)
UNHASHED_PASS(unhashed3_floats, FLOATS, AXES_STRAIGHT, 3)
UNHASHED_PASS(unhashed3_doubles, DOUBLES, AXES_STRAIGHT, 3)
UNHASHED_PASS(unhashed3_turned_floats, FLOATS, AXES_TURNED, 3)
UNHASHED_PASS(unhashed3_turned_doubles, DOUBLES, AXES_TURNED, 3)

#undef UNHASHED_PASS

/* By [dimensions - 2][whether axes are turned][whether coordinates are doubles]. */
typedef void unhashed_pass(vf *to, const struct scarp_octave *o, size_t blocks,
                           const struct coordinate_arrays *at);
static unhashed_pass *const unhashed_passes[2][2][2] = {
    {{unhashed2_floats, unhashed2_doubles}, {unhashed2_turned_floats, unhashed2_turned_doubles}},
    {{unhashed3_floats, unhashed3_doubles}, {unhashed3_turned_floats, unhashed3_turned_doubles}},
};

/* Locates the blocks of a row of points. */
static void unhashed_row(vf *to, const struct scarp_octave *o, size_t blocks,
                         const struct positions *at, struct frame f)
{
    struct coordinate_arrays arrays = {.axes = f.axes};
    double still[3][VEC_LANES];
    for (int i = 0; i < f.dimensions; i++) {
        const int stands = f.layout == ROW && i > 0;
        for (int lane = 0; stands && lane < VEC_LANES; lane++) {
            still[i][lane] = at->shared[i];
        }
        arrays.array[i] = stands ? still[i] : at->array[i];
        arrays.advance[i] = stands ? 0 : VEC_LANES;
    }
    unhashed_passes[f.dimensions - 2][f.axes == AXES_TURNED][f.layout != FLOATS](to, o, blocks,
                                                                                 &arrays);
}

#endif
