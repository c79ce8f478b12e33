/* SPDX-License-Identifier: MIT
 *
 * Stage 1, positions: the coordinates of a block of points in the frame of an octave, split into
 * the cell of the lattice and the fraction inside. The reference is scalar/positions.h.
 */
#ifndef SCARP_KERNEL_POSITIONS_H
#define SCARP_KERNEL_POSITIONS_H

#include "../plan/call.h"

/* How an octave takes x to its lattice: p = f x (octave 0 without an offset: to add 0 would cost up
   to 8 % of an octave), p = f x + o, or p = J x + o. On a lattice that repeats it is p = f x + o,
   and cells are numbered within the period: powers of two, or any numbers. */
enum axes { AXES_FIRST, AXES_STRAIGHT, AXES_TURNED, AXES_POWERS, AXES_PERIODS, AXES_KINDS };

/* How coordinates are given: an array for each axis; or, for a row of a grid, an array of doubles
   for x, and for y and z numbers that the whole row shares; or, for each axis, a struct moved_axis
   (moved.h). */
enum layout { FLOATS, DOUBLES, ROW, LAYOUTS, MOVED = LAYOUTS };

struct positions {
    const void *array[3];
    double shared[3];
};

/* How the positions of a pass are given, and how they go to the lattice; a constant wherever it is
 * passed on. */
struct frame {
    enum layout layout;
    enum axes axes;
    int dimensions;
};

static int has_offset(const struct scarp_octave *octave)
{
    return octave->offset[0] != 0.0 || octave->offset[1] != 0.0 || octave->offset[2] != 0.0;
}

static enum axes axes_of(const struct scarp_call_plan *plan, int octave)
{
    const int is_first = octave + plan->first == 0;
    switch (plan->repeat) {
    case SCARP_REPEAT_POWERS: return AXES_POWERS;
    case SCARP_REPEAT_ANY: return AXES_PERIODS;
    case SCARP_REPEAT_NEVER: break;
    }
    return is_first && !has_offset(&plan->octave[octave]) ? AXES_FIRST
           : is_first || !plan->rotate                    ? AXES_STRAIGHT
                                                          : AXES_TURNED;
}

static int axes_repeat(enum axes axes)
{
    return axes == AXES_POWERS || axes == AXES_PERIODS;
}

/* The lower corner of the cell, modulo 2^32 or within the period, and the fraction t inside, along
   one axis. The fraction is in [0, 1]: rounding can reach 1. */
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

/* The sum of two positions that are split: adds the fractions, and carries 1 where the sum is 1 or
   more. */
VEC_INLINE struct split split_sum(struct split a, struct split b)
{
    const vf t = a.t + b.t;
    const vm carry = vm_less(vf_set(0x1.fffffep-1f), t); /* there is no float between this and 1 */
    const struct split s = {vu_add_where(carry, a.cell + b.cell, vu_set(1)),
                            vf_subtract_where(carry, t, vf_set(1.0f))};
    return s;
}

/* A cell within the period, which is a power of two. */
VEC_INLINE vu within_power(vu cell, const struct scarp_octave *o, int axis)
{
    return cell & vu_set(o->last[axis]);
}

/* A cell within any period. The result is right for |cell| < 2^22: there the error of a quotient,
   2^-23 of it, is less than half a cell, and (cell + 1/2) / period is at least that far from the
   next integer.
 */
VEC_INLINE vu within_f32(vu cell, vf lower, const struct scarp_octave *o, int axis)
{
    const vf quotient = (lower + vf_set(0.5f)) * vf_set((float)(1.0 / scarpi_period(o, axis)));
    return cell - vu_from_vf(vf_floor(quotient)) * vu_set(o->last[axis] + 1);
}

/* Bits that are set where |cell| >= 2^22, and in some lanes below. */
#define FAR_BITS 0xff800000u

VEC_INLINE vu far_bits(vu cell)
{
    return cell + vu_set(0x400000);
}

/* A cell within any period, right for every cell, lane by lane. */
VEC_INLINE vu within_far(vu cell, const struct scarp_octave *o, int axis)
{
    uint32_t cells[VEC_LANES];
    vu_store(cells, cell);
    for (size_t i = 0; i < VEC_LANES; i++) {
        const int64_t period = (int64_t)o->last[axis] + 1;
        const int64_t remainder = (int64_t)(int32_t)cells[i] % period;
        cells[i] = (uint32_t)(remainder < 0 ? remainder + period : remainder);
    }
    return vu_load(cells);
}

/* The remainder of cells, right below 2^50. The order of operations is that of the reference, also
   beyond. */
VEC_INLINE vd within_f64(vd lower, const struct scarp_octave *o, int axis)
{
    const double period = scarpi_period(o, axis);
    const vd quotient = (lower + vd_set(0.5)) * vd_set(1.0 / period);
    return lower - vd_floor(quotient) * vd_set(period);
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

/* p along a straight axis of the octave, in double. */
VEC_INLINE vd straight_f64(const struct scarp_octave *o, int axis, vd x, struct frame f)
{
    const vd p = vd_set(o->frequency64) * x;
    return f.axes == AXES_FIRST ? p : p + vd_set(o->offset[axis]);
}

/*
 * Turned axes at doubles: p = J x + o is the sum of what a column of a grid shares, J_0 x, and of
 * what a row shares, (J_1 y + J_2 z) + o. Each is rounded to a multiple of 2^-24 cells, so that the
 * sum is exact, however many samples share a part. A sum with 1.5 * 2^28 is rounded so, and its
 * bits count the multiples: a difference of such bits is one of parts. That holds below 2^27 cells;
 * far.h has what lies beyond.
 */
#define TURNED_SHIFT 0x1.8p28

/* An axis of an octave: J, and the shift less the offset, where cells are 1 / stretch long. */
struct turned_axis {
    double j[3], shift;
};

VEC_INLINE struct turned_axis turned_axis_of(const struct scarp_octave *o, int axis, double stretch)
{
    const double *const j = o->jacobian64[axis];
    const struct turned_axis a = {{j[0] * stretch, j[1] * stretch, j[2] * stretch},
                                  TURNED_SHIFT - o->offset[axis] * stretch};
    return a;
}

/* What a row shares, but for the offset. */
VEC_INLINE vd turned_row_f64(const struct turned_axis *a, vd y, vd z, int dimensions)
{
    const vd p = vd_set(a->j[1]) * y;
    return dimensions == 3 ? p + vd_set(a->j[2]) * z : p;
}

/* The sum of both parts at half a block, in units of 2^-24 cells. */
VEC_INLINE vec_u64 turned_sum(const struct turned_axis *a, vd column, vd row)
{
    return (vec_u64)(column + vd_set(TURNED_SHIFT)) - (vec_u64)(vd_set(a->shift) - row);
}

/* The fraction that so many multiples of 2^-24 cells are, without whole cells. */
VEC_INLINE vf turned_fraction(vu multiples)
{
    return vf_from_vi((vi)(multiples & 0xffffff)) * vf_set(0x1p-24f);
}

/* The cells and the fractions of both halves of a block, given in units of 2^-24 cells. */
VEC_INLINE struct split split_turned(vec_u64 low, vec_u64 high)
{
    const struct split s = {vu_low_bits((vd)(low >> 24), (vd)(high >> 24)),
                            turned_fraction(vu_low_bits((vd)low, (vd)high))};
    return s;
}

/* p at half a block, in units of 2^-24 cells. In 2D, x[2] is unset. */
VEC_INLINE vec_u64 turned_f64(const struct turned_axis *a, const vd x[3], struct frame f)
{
    const vd column = vd_set(a->j[0]) * x[0];
    return turned_sum(a, column, turned_row_f64(a, x[1], x[f.dimensions - 1], f.dimensions));
}

/* The cell and the fraction of a block along a turned axis, of which both halves are given. */
VEC_INLINE struct split split_turned_f64(const struct scarp_octave *o, int axis, double stretch,
                                         const vd low[3], const vd high[3], struct frame f)
{
    const struct turned_axis a = turned_axis_of(o, axis, stretch);
    return split_turned(turned_f64(&a, low, f), turned_f64(&a, high, f));
}

/* p along one axis of the octave in float: where axes are straight, of the coordinate x along that
   axis, and where they are turned, of the point x. */
VEC_INLINE vf straight_f32(const struct scarp_octave *o, int axis, vf x, struct frame f)
{
    const vf p = vf_set(o->frequency) * x;
    return f.axes == AXES_FIRST ? p : p + vf_set((float)o->offset[axis]);
}

/* J x along one axis. */
VEC_INLINE vf along_turned_f32(const struct scarp_octave *o, int axis, const vf x[3],
                               struct frame f)
{
    const float *const j = o->jacobian[axis];
    vf p = vf_set(j[0]) * x[0] + vf_set(j[1]) * x[1];
    if (f.dimensions == 3) {
        p += vf_set(j[2]) * x[2];
    }
    return p;
}

VEC_INLINE vf turned_f32(const struct scarp_octave *o, int axis, const vf x[3], struct frame f)
{
    return along_turned_f32(o, axis, x, f) + vf_set((float)o->offset[axis]);
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

/* Along a turned axis, of doubles. */
VEC_INLINE struct split position_turned(const struct scarp_octave *o, int axis,
                                        const struct positions *at, size_t block, struct frame f)
{
    vd low[3], high[3];
    for (int i = 0; i < f.dimensions; i++) {
        low[i] = load_f64(at, i, block, 0, f);
        high[i] = load_f64(at, i, block, 1, f);
    }
    return split_turned_f64(o, axis, 1.0, low, high, f);
}

/* Along any other axis. Cells of FLOATS within AXES_PERIODS are left as they are: see within_f32.
 */
VEC_INLINE struct split position(const struct scarp_octave *o, int axis, const struct positions *at,
                                 size_t block, struct frame f)
{
    struct split s;
    if (f.layout == FLOATS) {
        s = split_f32(position_f32(o, axis, at, block, f));
    } else {
        const vd p0 = straight_f64(o, axis, load_f64(at, axis, block, 0, f), f);
        const vd p1 = straight_f64(o, axis, load_f64(at, axis, block, 1, f), f);
        s = split_f64(p0, p1);
        if (f.axes == AXES_PERIODS) {
            s.cell = vu_low_bits(within_f64(vd_floor(p0), o, axis) + 0x1.8p52,
                                 within_f64(vd_floor(p1), o, axis) + 0x1.8p52);
        }
    }
    if (f.axes == AXES_POWERS) {
        s.cell = within_power(s.cell, o, axis);
    }
    return s;
}

#endif
