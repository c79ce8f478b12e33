/* SPDX-License-Identifier: MIT
 *
 * Stage 2 of bases that find their own way from cell to cell: the cells of points, and the places
 * inside. The reference is scalar/positions.h.
 *
 * At a block, the places along all axes come first, then the bits of the cells, and one vector that
 * is free. Rows of a grid come
 * as doubles, of which those along y and z stand still.
 */
#ifndef SCARP_KERNEL_PLACES_H
#define SCARP_KERNEL_PLACES_H

#include "lattice.h"

#define PLACES_SIZE(dimensions) (2 * (size_t)(dimensions) + 1)

static size_t places_size(int dimensions)
{
    return PLACES_SIZE(dimensions);
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

/* How points are placed, and where their coordinates are; `advance` is how far the next block of an
   axis is, in elements. */
struct places {
    const void *array[3];
    size_t advance[3];
    enum axes axes;
};

VEC_INLINE vf places_load_f32(const struct places *at, int axis, size_t block)
{
    return vf_load((const float *)at->array[axis] + block * at->advance[axis]);
}

VEC_INLINE vd places_load_f64(const struct places *at, int axis, size_t block, int half)
{
    return vd_load((const double *)at->array[axis] + block * at->advance[axis] +
                   (size_t)half * (VEC_LANES / 2));
}

VEC_INLINE vf places_f32(const struct scarp_octave *o, int axis, const struct places *at,
                         size_t block, struct frame f)
{
    vf p;
    if (f.axes == AXES_TURNED) {
        vf x[3] = {places_load_f32(at, 0, block), places_load_f32(at, 1, block)};
        if (f.dimensions == 3) {
            x[2] = places_load_f32(at, 2, block);
        }
        p = turned_f32(o, axis, x, f);
    } else {
        p = straight_f32(o, axis, places_load_f32(at, axis, block), f);
    }
    return axis == 1 ? p * vf_set((float)o->stretch) : p;
}

VEC_INLINE vd places_f64(const struct scarp_octave *o, int axis, const struct places *at,
                         size_t block, int half, struct frame f)
{
    vd p;
    if (f.axes == AXES_TURNED) {
        vd x[3] = {places_load_f64(at, 0, block, half), places_load_f64(at, 1, block, half)};
        if (f.dimensions == 3) {
            x[2] = places_load_f64(at, 2, block, half);
        }
        p = turned_f64(o, axis, x, f);
    } else {
        p = straight_f64(o, axis, places_load_f64(at, axis, block, half), f);
    }
    return axis == 1 ? p * vd_set(o->stretch) : p;
}

/* Where a block lies along an axis. `far` collects the bits of cells that within_f32 may have got
   wrong. */
VEC_INLINE struct split places_split(const struct scarp_octave *o, int axis,
                                     const struct places *at, size_t block, struct frame f, vu *far)
{
    struct split s;
    if (f.layout == FLOATS) {
        const vf p = places_f32(o, axis, at, block, f);
        s = split_f32(p);
        if (at->axes == AXES_PERIODS) {
            *far |= far_bits(s.cell);
            s.cell = within_f32(s.cell, vf_floor(p), o, axis);
        }
    } else {
        const vd p0 = places_f64(o, axis, at, block, 0, f);
        const vd p1 = places_f64(o, axis, at, block, 1, f);
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

static void places_far(vf *to, const struct scarp_octave *octave, size_t blocks,
                       const struct places *places, int dimensions);

VEC_INLINE void places_run(vf *to, const struct scarp_octave *octave, size_t blocks,
                           const struct places *places, struct frame f, int is_far)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    const struct places at = *places;
    vu far = vu_set(0);
    for (size_t b = 0; b < blocks; b++) {
        for (int i = 0; i < f.dimensions; i++) {
            struct split s;
            if (is_far) {
                s = split_f32(places_f32(&o, i, &at, b, f));
                s.cell = within_far(s.cell, &o, i);
            } else {
                s = places_split(&o, i, &at, b, f, &far);
            }
            to[i] = s.t;
            to[f.dimensions + i] = (vf)s.cell;
        }
        to += places_size(f.dimensions);
    }
    if (!is_far && f.layout == FLOATS && vu_any(far & vu_set(FAR_BITS))) {
        to -= blocks * places_size(f.dimensions);
        places_far(to, octave, blocks, places, f.dimensions);
    }
}

/* Does once more what places_run does with periods and floats, of which some are far. */
static __attribute__((noinline, cold)) void places_far(vf *to, const struct scarp_octave *octave,
                                                       size_t blocks, const struct places *places,
                                                       int dimensions)
{
    const struct frame f = {FLOATS, AXES_STRAIGHT, dimensions};
    places_run(to, octave, blocks, places, f, 1);
}

#define PLACES_PASS(name, layout, axes, dimensions)                                                \
    static void name(vf *to, const struct scarp_octave *o, size_t blocks, const struct places *at) \
    {                                                                                              \
        const struct frame f = {layout, axes, dimensions};                                         \
        places_run(to, o, blocks, at, f, 0);                                                       \
    }

PLACES_PASS(places2_floats, FLOATS, AXES_STRAIGHT, 2)
PLACES_PASS(places2_doubles, DOUBLES, AXES_STRAIGHT, 2)
PLACES_PASS(places2_turned_floats, FLOATS, AXES_TURNED, 2)
PLACES_PASS(places2_turned_doubles, DOUBLES, AXES_TURNED, 2)
PLACES_PASS(places3_floats, FLOATS, AXES_STRAIGHT, 3)
PLACES_PASS(places3_doubles, DOUBLES, AXES_STRAIGHT, 3)
PLACES_PASS(places3_turned_floats, FLOATS, AXES_TURNED, 3)
PLACES_PASS(places3_turned_doubles, DOUBLES, AXES_TURNED, 3)

#undef PLACES_PASS

/* By [dimensions - 2][whether axes are turned][whether coordinates are doubles]. */
typedef void places_pass(vf *to, const struct scarp_octave *o, size_t blocks,
                         const struct places *at);
static places_pass *const places_passes[2][2][2] = {
    {{places2_floats, places2_doubles}, {places2_turned_floats, places2_turned_doubles}},
    {{places3_floats, places3_doubles}, {places3_turned_floats, places3_turned_doubles}},
};

/* Places the blocks of a row of points. */
static void place_row(vf *to, const struct scarp_octave *o, size_t blocks,
                      const struct positions *at, struct frame f)
{
    struct places places = {.axes = f.axes};
    double still[3][VEC_LANES];
    for (int i = 0; i < f.dimensions; i++) {
        const int stands = f.layout == ROW && i > 0;
        for (int lane = 0; stands && lane < VEC_LANES; lane++) {
            still[i][lane] = at->shared[i];
        }
        places.array[i] = stands ? still[i] : at->array[i];
        places.advance[i] = stands ? 0 : VEC_LANES;
    }
    places_passes[f.dimensions - 2][f.axes == AXES_TURNED][f.layout != FLOATS](to, o, blocks,
                                                                               &places);
}

#endif
