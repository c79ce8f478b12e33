/* SPDX-License-Identifier: MIT
 *
 * Stage 1, positions: the coordinates of a block of points in the frame of an octave, split into
 * the cell of the lattice and the place inside. Included by lattice.h; the reference is
 * scalar/positions.h.
 */
#ifndef SCARP_KERNEL_POSITIONS_H
#define SCARP_KERNEL_POSITIONS_H

#include "../plan.h"

/* How an octave places x: p = f x (octave 0, since adding its offset of 0 would cost 3 to 5 % of a
   single octave), p = f x + o, or p = J x + o. */
enum axes { AXES_FIRST, AXES_STRAIGHT, AXES_TURNED, AXES_KINDS };

/* How coordinates are given: an array for each axis; or, for a row of a grid, an array of doubles
   for x, and for y and z numbers that the whole row shares. */
enum layout { FLOATS, DOUBLES, ROW, LAYOUTS };

struct positions {
    const void *array[3];
    double shared[3];
};

/* How the positions of a pass are given and placed; a constant wherever it is passed on. */
struct frame {
    enum layout layout;
    enum axes axes;
    int dimensions;
};

static enum axes axes_of(const struct scarp_call_plan *plan, int octave)
{
    return octave == 0 ? AXES_FIRST : plan->rotate ? AXES_TURNED : AXES_STRAIGHT;
}

/* The lower corner of the cell modulo 2^32, and the place inside, along one axis. The place is in
   [0, 1]: rounding can reach 1. */
struct split {
    vu cell;
    vf t;
};

VEC_INLINE struct split split_f32(vf p)
{
    const vf lower = vf_floor(p);
    const struct split s = {vu_from_vf(lower), p - lower};
    return s;
}

/* The sum with 1.5 * 2^52 has the floor, modulo 2^32, in its low bits. */
VEC_INLINE struct split split_f64(vd p0, vd p1)
{
    const vd lower0 = vd_floor(p0);
    const vd lower1 = vd_floor(p1);
    const struct split s = {vu_low_bits(lower0 + 0x1.8p52, lower1 + 0x1.8p52),
                            vf_from_vd(p0 - lower0, p1 - lower1)};
    return s;
}

VEC_INLINE vf load_f32(const struct positions *at, int axis, size_t block)
{
    return vf_load((const float *)at->array[axis] + block * VEC_LANES);
}

VEC_INLINE vd load_f64(const struct positions *at, int axis, size_t block, int half, struct frame f)
{
    if (f.layout == ROW && axis > 0) {
        return vd_set(at->shared[axis]);
    }
    return vd_load((const double *)at->array[axis] + block * VEC_LANES +
                   (size_t)half * (VEC_LANES / 2));
}

/* p along one axis of the octave, in double: where axes are straight, of the coordinate x along
   that axis, and where they are turned, of the point x. */
VEC_INLINE vd straight_f64(const struct scarp_octave *o, int axis, vd x, struct frame f)
{
    const vd p = vd_set(o->frequency64) * x;
    return f.axes == AXES_FIRST ? p : p + vd_set(o->offset64[axis]);
}

VEC_INLINE vd turned_f64(const struct scarp_octave *o, int axis, const vd x[3], struct frame f)
{
    const double *const j = o->jacobian64[axis];
    vd p = vd_set(j[0]) * x[0] + vd_set(j[1]) * x[1];
    if (f.dimensions == 3) {
        p += vd_set(j[2]) * x[2];
    }
    return p + vd_set(o->offset64[axis]);
}

/* The same in float. */
VEC_INLINE vf straight_f32(const struct scarp_octave *o, int axis, vf x, struct frame f)
{
    const vf p = vf_set(o->frequency) * x;
    return f.axes == AXES_FIRST ? p : p + vf_set(o->offset[axis]);
}

VEC_INLINE vf turned_f32(const struct scarp_octave *o, int axis, const vf x[3], struct frame f)
{
    const float *const j = o->jacobian[axis];
    vf p = vf_set(j[0]) * x[0] + vf_set(j[1]) * x[1];
    if (f.dimensions == 3) {
        p += vf_set(j[2]) * x[2];
    }
    return p + vf_set(o->offset[axis]);
}

/* The same for one half of a block. */
VEC_INLINE vd position_f64(const struct scarp_octave *o, int axis, const struct positions *at,
                           size_t block, int half, struct frame f)
{
    if (f.axes != AXES_TURNED) {
        return straight_f64(o, axis, load_f64(at, axis, block, half, f), f);
    }
    vd x[3] = {load_f64(at, 0, block, half, f), load_f64(at, 1, block, half, f)};
    if (f.dimensions == 3) {
        x[2] = load_f64(at, 2, block, half, f);
    }
    return turned_f64(o, axis, x, f);
}

VEC_INLINE vf position_f32(const struct scarp_octave *o, int axis, const struct positions *at,
                           size_t block, struct frame f)
{
    if (f.axes != AXES_TURNED) {
        return straight_f32(o, axis, load_f32(at, axis, block), f);
    }
    vf x[3] = {load_f32(at, 0, block), load_f32(at, 1, block)};
    if (f.dimensions == 3) {
        x[2] = load_f32(at, 2, block);
    }
    return turned_f32(o, axis, x, f);
}

VEC_INLINE struct split position(const struct scarp_octave *o, int axis, const struct positions *at,
                                 size_t block, struct frame f)
{
    if (f.layout == FLOATS) {
        return split_f32(position_f32(o, axis, at, block, f));
    }
    return split_f64(position_f64(o, axis, at, block, 0, f),
                     position_f64(o, axis, at, block, 1, f));
}

#endif
