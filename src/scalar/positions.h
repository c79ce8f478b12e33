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
static inline void split_f64(double p, const struct scarp_octave *o, int i,
                             enum scarp_repeat repeat, uint32_t *cell, float *t)
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
    *cell = any ? (uint32_t)bits : (uint32_t)bits & o->last[i];
    *t = (float)(p - lower);
}

/* Moves a split position by so many cells: splits these, too, adds the fractions, and carries 1. A
   sum of two cells within a period is less than two periods. */
static inline void move_split(float by, uint32_t last, uint32_t *cell, float *t)
{
    const struct split s = split(by, last);
    const float sum = *t + s.t;
    const int carry = sum >= 1.0f;
    const uint32_t moved = *cell + s.cell + (uint32_t)carry;
    *cell = moved > last ? moved - (last + 1) : moved;
    *t = carry ? sum - 1.0f : sum;
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
static inline void split_turned_f64(const struct scarp_octave *o, const double x[3], int i,
                                    double stretch, int dimensions, uint32_t *cell, float *t)
{
    const double *const j = o->jacobian64[i];
    const double column = j[0] * stretch * x[0];
    double row = j[1] * stretch * x[1];
    if (dimensions == 3) {
        row += j[2] * stretch * x[2];
    }
    if (isfinite(column) && isfinite(row)) {
        const uint64_t p = fixed_of(column, 0.0) + fixed_of(row, o->offset[i] * stretch);
        *cell = (uint32_t)(p >> 24);
        *t = (float)(p & 0xffffff) * 0x1p-24f;
    } else {
        *cell = 0;
        *t = NAN;
    }
}

/* p in octave k, split into cell and fraction; along y of triangles in units of their rows. Doubles
   are split before they are displaced. */
WHOLE struct location location_at(const struct scarp_call_plan *plan, int k, const struct point *x,
                                  int dimensions)
{
    const struct octave o = octave_of(plan, k, dimensions);
    const struct scarp_octave *const of = &plan->octave[k];
    const int turned = is_turned(plan, k), counts_rows = plan->basis == SCARP_SIMPLEX;
    uint32_t cell[3] = {0}, next[3] = {0};
    float t[3] = {0.0f};
    if (!x->doubles) {
        return location_of(o, plan->basis, turned, x->f32, dimensions);
    }
    const vec3 cells = cells_along(o, turned, x->f32, dimensions);
    const vec3 by = stretched(o, plan->basis, cells, dimensions);
    const float moves[3] = {by.x, by.y, by.z};
    for (int i = 0; i < dimensions; i++) {
        const double stretch = counts_rows && dimensions == 2 && i == 1 ? of->stretch : 1.0;
        if (turned) {
            split_turned_f64(of, x->f64, i, stretch, dimensions, &cell[i], &t[i]);
        } else {
            const double p = (of->frequency64 * x->f64[i] + of->offset[i]) * stretch;
            split_f64(p, of, i, plan->repeat, &cell[i], &t[i]);
        }
        if (x->displaced) {
            move_split(moves[i], of->last[i], &cell[i], &t[i]);
        }
        next[i] = cell_after(of->last[i], cell[i]);
    }
    const struct location at = {
        {cell[0], cell[1], cell[2]}, {next[0], next[1], next[2]}, {t[0], t[1], t[2]}};
    return at;
}

#endif
