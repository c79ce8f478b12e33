/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 1: where a point lies in the frame of an octave.
 */
#ifndef SCARP_SCALAR_POSITIONS_H
#define SCARP_SCALAR_POSITIONS_H

#include <math.h>
#include <string.h>

#include "../formulas/lattice.h"
#include "../plan/call.h"

/* A point's coordinates: floats; or doubles, with floats that say how far they are displaced, if
   they are. */
struct point {
    int doubles, displaced;
    float f32[3];
    double f64[3];
};

/* The remainder of a cell by the period along axis i, in [0, period), or the cell itself. */
static inline uint32_t within_period(const struct scarp_octave *o, int i, int32_t cell)
{
    if (o->last[i] == UINT32_MAX) {
        return (uint32_t)cell;
    }
    const int64_t period = (int64_t)o->last[i] + 1;
    const int64_t remainder = cell % period;
    return (uint32_t)(remainder < 0 ? remainder + period : remainder);
}

/* Float positions. Outside [-2^31, 2^31) the cell is -2^31 and the fraction p - p: 0, or NaN where
   p is not finite. */
static inline void split_f32(float p, const struct scarp_octave *o, int i, uint32_t *cell, float *t)
{
    if (fabsf(p) < 0x1p31f) {
        const int32_t whole = (int32_t)p;
        const int32_t lower = whole - ((float)whole > p);
        *cell = within_period(o, i, lower);
        *t = p - (float)lower;
    } else {
        *cell = within_period(o, i, INT32_MIN);
        *t = p - p;
    }
}

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
static inline void move_split(float by, const struct scarp_octave *o, int i, uint32_t *cell,
                              float *t)
{
    uint32_t cells;
    float fraction;
    split_f32(by, o, i, &cells, &fraction);
    const float sum = *t + fraction;
    const int carry = sum >= 1.0f;
    const uint32_t moved = *cell + cells + (uint32_t)carry;
    *cell = moved > o->last[i] ? moved - (o->last[i] + 1) : moved;
    *t = carry ? sum - 1.0f : sum;
}

/* Whether an octave's axes are turned: then p = J x + o, else p = f x + o. In octave 0 o is 0;
   adding it turns -0 into 0. */
static inline int is_turned(const struct scarp_call_plan *plan, int octave)
{
    return plan->rotate && octave + plan->first > 0;
}

/* J x or f x: the cells along axis i of the octave that x is long. */
static inline float along_axis_f32(const struct scarp_octave *o, int turned, const float x[3],
                                   int i, int dimensions)
{
    const float *const j = o->jacobian[i];
    float p = turned ? j[0] * x[0] + j[1] * x[1] : o->frequency * x[i];
    if (turned && dimensions == 3) {
        p += j[2] * x[2];
    }
    return p;
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
static inline struct location location_of(const struct scarp_call_plan *plan, int k,
                                          const struct point *x, int dimensions)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const int turned = is_turned(plan, k);
    const int counts_rows = plan->basis == SCARP_SIMPLEX && dimensions == 2;
    uint32_t cell[3] = {0}, next[3] = {0};
    float t[3] = {0.0f};
    for (int i = 0; i < dimensions; i++) {
        const double stretch = counts_rows && i == 1 ? o->stretch : 1.0;
        const float along = along_axis_f32(o, turned, x->f32, i, dimensions);
        if (x->doubles && turned) {
            split_turned_f64(o, x->f64, i, stretch, dimensions, &cell[i], &t[i]);
        } else if (x->doubles) {
            const double p = (o->frequency64 * x->f64[i] + o->offset[i]) * stretch;
            split_f64(p, o, i, plan->repeat, &cell[i], &t[i]);
        } else {
            const float p = (along + (float)o->offset[i]) * (float)stretch;
            split_f32(p, o, i, &cell[i], &t[i]);
        }
        if (x->doubles && x->displaced) {
            move_split(along * (float)stretch, o, i, &cell[i], &t[i]);
        }
        next[i] = cell_after(o->last[i], cell[i]);
    }
    const struct location at = {
        {cell[0], cell[1], cell[2]}, {next[0], next[1], next[2]}, {t[0], t[1], t[2]}};
    return at;
}

#endif
