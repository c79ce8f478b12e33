/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 1: where a point lies in the frame of an octave.
 */
#ifndef SCARP_SCALAR_POSITIONS_H
#define SCARP_SCALAR_POSITIONS_H

#include <math.h>
#include <string.h>

#include "../plan/octave.h"
#include "sample.h"

#include "../formulas/positions.h"

/* A point's coordinates: floats; or doubles, with floats that say how far they are displaced, if
   they are. */
struct point {
    int doubles, displaced;
    vec3 f32;
    double f64[3];
};

/* Double positions. The remainder is right below 2^50 cells; half a cell keeps quotients away from
   where rounding would change their floor. The sum with 1.5 * 2^52 has the cell, modulo 2^32, in
   its low bits, which are the remainder where the period is a power of two. */
static inline struct split split_f64(double p, const struct scarp_octave *o, int i,
                                     enum scarp_repeat repeat)
{
    const double lower = floor(p);
    const int any = repeat == SCARP_REPEAT_ANY;
    double remainder = lower;
    if (any) {
        const double period = scarpi_period(o, i);
        remainder -= floor((lower + 0.5) * (1.0 / period)) * period;
    }
    const double shifted = remainder + 0x1.8p52;
    uint64_t bits;
    memcpy(&bits, &shifted, sizeof bits);
    const struct split s = {any ? (uint32_t)bits : (uint32_t)bits & o->last[i], (float)(p - lower)};
    return s;
}

/* The sum of a double and an offset of at most 2, rounded to a multiple of 2^-24, in units of that
   and modulo 2^56. Neither difference is rounded where it matters, but the sum with 1.5 * 2^28 is,
   to such a multiple. The sum with 1.5 * 2^52 has the cell, modulo 2^32, in its low bits. */
static inline uint64_t fixed_of(double a, double offset)
{
    const double cell = floor(a + 0.5);
    const double rest = (a - cell) + (0x1.8p28 + offset), shifted = cell + 0x1.8p52;
    uint64_t bits;
    memcpy(&bits, &shifted, sizeof bits);
    return (bits << 24) + (uint64_t)(int64_t)((rest - 0x1.8p28) * 0x1p24);
}

/* Double positions where axes are turned. p is the sum of what a column of a grid shares and of
   what a row shares, each rounded to a multiple of 2^-24 cells, so that the sum is exact. */
static inline struct split split_turned_f64(const struct scarp_octave *o, const double x[3], int i,
                                            double stretch, int dimensions)
{
    const double *const j = o->jacobian64[i];
    const double column = j[0] * stretch * x[0];
    double row = j[1] * stretch * x[1];
    struct split s = {0, NAN};
    if (dimensions == 3) {
        row += j[2] * stretch * x[2];
    }
    if (isfinite(column) && isfinite(row)) {
        const uint64_t p = fixed_of(column, 0.0) + fixed_of(row, o->offset[i] * stretch);
        s.cell = (uint32_t)(p >> 24);
        s.t = (float)(p & 0xffffff) * 0x1p-24f;
    }
    return s;
}

/* Along axis i of octave k. */
static inline struct split split_along(const struct scarp_call_plan *plan, int k, const double x[3],
                                       int i, int dimensions)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const int counts_rows = i == 1 && dimensions == 2 && basis_has(plan->basis, BASIS_TRIANGLES);
    const double stretch = counts_rows ? o->stretch : 1.0;
    if (is_turned(plan, k)) {
        return split_turned_f64(o, x, i, stretch, dimensions);
    }
    return split_f64((o->frequency64 * x[i] + o->offset[i]) * stretch, o, i, plan->repeat);
}

/* Moves a split position by so many cells: splits these, too, adds the fractions, and carries 1. A
   sum of two cells within a period is less than two periods. */
static inline struct split moved_split(struct split s, float by, uint32_t last)
{
    const struct split more = split(by, last);
    const float sum = s.t + more.t;
    const int carry = sum >= 1.0f;
    const uint32_t cell = s.cell + more.cell + (uint32_t)carry;
    const struct split moved = {cell > last ? cell - (last + 1) : cell, carry ? sum - 1.0f : sum};
    return moved;
}

/* Octave k at doubles, which are split before they are displaced. */
static inline struct location location_at_f64(const struct scarp_call_plan *plan, int k,
                                              const struct point *p, int dimensions)
{
    const struct octave o = octave_of(plan, k, dimensions);
    struct split x = split_along(plan, k, p->f64, 0, dimensions);
    struct split y = split_along(plan, k, p->f64, 1, dimensions);
    struct split z = {0, 0.0f};
    if (dimensions == 3) {
        z = split_along(plan, k, p->f64, 2, dimensions);
    }
    if (p->displaced) {
        const vec3 cells = cells_along(o, is_turned(plan, k), p->f32, dimensions);
        const vec3 by = stretched(o, plan->basis, cells, dimensions);
        x = moved_split(x, by.x, o.last.x);
        y = moved_split(y, by.y, o.last.y);
        z = moved_split(z, by.z, o.last.z);
    }
    return location_in(o.last, x, y, z, dimensions);
}

/* A point in octave k, split into cell and fraction; along y of triangles in units of their rows.
 */
WHOLE struct location location_at(const struct scarp_call_plan *plan, int k, const struct point *x,
                                  int dimensions)
{
    if (x->doubles) {
        return location_at_f64(plan, k, x, dimensions);
    }
    return location_of(octave_of(plan, k, dimensions), plan->basis, is_turned(plan, k), x->f32,
                       dimensions);
}

#endif
