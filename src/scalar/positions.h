/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 1: where a point lies in the frame of an octave. Included by columns.h.
 */
#ifndef SCARP_SCALAR_POSITIONS_H
#define SCARP_SCALAR_POSITIONS_H

#include <math.h>
#include <string.h>

#include "../plan.h"

/* A point's coordinates, floats or doubles. */
struct point {
    int doubles;
    float f32[3];
    double f64[3];
};

/* A point of one octave: the cell's lower corner, modulo 2^32, and the position inside, in [0, 1]
   (rounding can reach 1; the noise is continuous there). */
struct place {
    uint32_t cell[3];
    float t[3];
};

/* Float positions. Outside [-2^31, 2^31) the cell is -2^31 and the fraction p - p: 0, or NaN where
   p is not finite. */
static inline void split_f32(float p, uint32_t *cell, float *t)
{
    if (fabsf(p) < 0x1p31f) {
        const int32_t whole = (int32_t)p;
        const int32_t lower = whole - ((float)whole > p);
        *cell = (uint32_t)lower;
        *t = p - (float)lower;
    } else {
        *cell = 0x80000000u;
        *t = p - p;
    }
}

/* Double positions. The sum with 1.5 * 2^52 has the floor, modulo 2^32, in its low bits. */
static inline void split_f64(double p, uint32_t *cell, float *t)
{
    const double lower = floor(p);
    const double shifted = lower + 0x1.8p52;
    uint64_t bits;
    memcpy(&bits, &shifted, sizeof bits);
    *cell = (uint32_t)bits;
    *t = (float)(p - lower);
}

/* Whether an octave's axes are turned: then p = J x + o, else p = f x + o. In octave 0 o is 0;
   adding it turns -0 into 0. */
static inline int is_turned(const struct scarp_call_plan *plan, int octave)
{
    return plan->rotate && octave > 0;
}

static inline float position_f32(const struct scarp_octave *o, int turned, const float x[3], int i,
                                 int dimensions)
{
    const float *const j = o->jacobian[i];
    float p = turned ? j[0] * x[0] + j[1] * x[1] : o->frequency * x[i];
    if (turned && dimensions == 3) {
        p += j[2] * x[2];
    }
    return p + o->offset[i];
}

static inline double position_f64(const struct scarp_octave *o, int turned, const double x[3],
                                  int i, int dimensions)
{
    const double *const j = o->jacobian64[i];
    double p = turned ? j[0] * x[0] + j[1] * x[1] : o->frequency64 * x[i];
    if (turned && dimensions == 3) {
        p += j[2] * x[2];
    }
    return p + o->offset64[i];
}

/* p, split into cell and fraction. */
static inline struct place place_of(const struct scarp_octave *o, int turned, const struct point *x,
                                    int dimensions)
{
    struct place place = {{0}, {0}};
    for (int i = 0; i < dimensions; i++) {
        if (x->doubles) {
            split_f64(position_f64(o, turned, x->f64, i, dimensions), &place.cell[i], &place.t[i]);
        } else {
            split_f32(position_f32(o, turned, x->f32, i, dimensions), &place.cell[i], &place.t[i]);
        }
    }
    return place;
}

#endif
