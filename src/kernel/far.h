/* SPDX-License-Identifier: MIT
 *
 * Turned axes at doubles, where positions.h cannot go: parts of p of 2^27 cells and more. They are
 * cut into cells and what is left, which is rounded as parts that are near.
 */
#ifndef SCARP_KERNEL_FAR_H
#define SCARP_KERNEL_FAR_H

#include "unhashed.h"

/* The integer nearest to a part, or one of both. Less that integer, the part is exact, but where no
   bit of it is left after rounding. */
VEC_INLINE vd far_cell(vd part)
{
    return vd_floor(part + vd_set(0.5));
}

/* Cells in units of 2^-24 cells, modulo 2^56. The sum with 1.5 * 2^52 has the cell, modulo 2^32, in
   its low bits. */
VEC_INLINE vec_u64 far_bits_of(vd cell)
{
    return (vec_u64)(cell + 0x1.8p52) << 24;
}

/* turned_sum() of any parts, modulo 2^56; anything of those that are not finite. */
VEC_INLINE vec_u64 far_sum(const struct turned_axis *a, vd column, vd row)
{
    const vd column_cell = far_cell(column), row_cell = far_cell(row);
    return turned_sum(a, column - column_cell, row - row_cell) + far_bits_of(column_cell) +
           far_bits_of(row_cell);
}

/* 0, or NaN where a part is not finite. */
VEC_INLINE vd far_nan(vd column, vd row)
{
    return (column - column) + (row - row);
}

/* The cell and the fraction of a block along a turned axis. */
VEC_INLINE struct split far_split(const struct turned_axis *a, const struct positions *at,
                                  size_t block, int dimensions)
{
    const struct frame f = {DOUBLES, AXES_TURNED, dimensions};
    vd column[2], row[2];
    for (int half = 0; half < 2; half++) {
        column[half] = vd_set(a->j[0]) * load_f64(at, 0, block, half, f);
        row[half] = turned_row_f64(a, load_f64(at, 1, block, half, f),
                                   load_f64(at, dimensions - 1, block, half, f), dimensions);
    }
    struct split s = split_turned(far_sum(a, column[0], row[0]), far_sum(a, column[1], row[1]));
    s.t += vf_from_vd(far_nan(column[0], row[0]), far_nan(column[1], row[1]));
    return s;
}

/* What a pass for turned axes stores of a block: corners of either form (lattice.h), or cells
   (unhashed.h). */
enum turned_form { TURNED_HASHED, TURNED_MIXED, TURNED_CELLS, TURNED_FORMS };

/* Locates the blocks of a row of points. This is one function for all, since few points are so far.
 */
static __attribute__((noinline)) void far_row(vf *to, const struct scarp_octave *o, size_t blocks,
                                              const struct positions *at, int dimensions,
                                              enum turned_form form)
{
    const enum corner_form corners =
        form == TURNED_HASHED && VEC_LANES == 16 ? CORNERS_HASHED : CORNERS_MIXED;
    vf *const begin = to;
    struct turned_axis axis[3];
    struct mixed m;
    memset(&m, 0, sizeof m);
    for (int i = 0; i < dimensions; i++) {
        axis[i] = turned_axis_of(o, i, form == TURNED_CELLS && i == 1 ? o->stretch : 1.0);
    }
    for (size_t b = 0; b < blocks; b++) {
        for (int i = 0; i < dimensions; i++) {
            const struct split s = far_split(&axis[i], at, b, dimensions);
            to[i] = s.t;
            if (form == TURNED_CELLS) {
                to[dimensions + i] = (vf)s.cell;
            } else {
                m.axis[i] = hash_axis(s.cell, o, i, AXES_TURNED);
            }
        }
        if (form != TURNED_CELLS) {
            lattice_put_corners(to, &m, dimensions, corners);
        }
        to += form == TURNED_CELLS ? unhashed_size(dimensions) : lattice_size(dimensions);
    }
#if VEC_LANES != 16
    if (form == TURNED_HASHED) {
        (dimensions == 2 ? hash_blocks2 : hash_blocks3)(begin, blocks);
    }
#else
    (void)begin;
#endif
}

/* The square of the distance of half a block of points from the origin, of which `count` are there.
 */
VEC_INLINE vd far_square_at(const void *const position[3], size_t first, size_t count,
                            int dimensions)
{
    vd square = vd_set(0.0);
    for (int i = 0; i < dimensions; i++) {
        const double *const from = (const double *)position[i] + first;
        const vd x = count < VEC_LANES / 2 ? vd_load_partial(from, count) : vd_load(from);
        square += x * x;
    }
    return square;
}

VEC_INLINE int far_within(double square, size_t count, const void *const position[3],
                          int dimensions)
{
    const size_t half = VEC_LANES / 2;
    vec_u64 near = (vec_u64)(vd_set(0.0) == vd_set(0.0));
    size_t i = 0;
    for (; i + half <= count; i += half) {
        near &= (vec_u64)(far_square_at(position, i, half, dimensions) < vd_set(square));
    }
    if (i < count) {
        near &= (vec_u64)(far_square_at(position, i, count - i, dimensions) < vd_set(square));
    }
    return vu_any(~(vu)near);
}

/* Whether an octave of that frequency needs far_row() at some of the points of doubles: they are
   2^26 cells from the origin, so that a part may have 2^27, where it is stretched and with its
   offset; or they are not finite. */
static __attribute__((noinline)) int is_far(double frequency, size_t count,
                                            const void *const position[3], int dimensions)
{
    const double square = 0x1p52 / (frequency * frequency);
    return dimensions == 2 ? far_within(square, count, position, 2)
                           : far_within(square, count, position, 3);
}

/* The highest frequency of an octave. */
static double highest_frequency(const struct scarp_call_plan *plan)
{
    const double first = plan->octave[0].frequency64;
    const double last = plan->octave[plan->octaves - 1].frequency64;
    return first > last ? first : last;
}

/* Whether the axes of some octave are turned. */
static int turns_axes(const struct scarp_call_plan *plan)
{
    return plan->rotate && plan->first + plan->octaves > 1;
}

#endif
