/* SPDX-License-Identifier: MIT
 *
 * Reference: what the formulas leave to C of operations on numbers.
 */
#ifndef SCARP_SCALAR_NUMBERS_H
#define SCARP_SCALAR_NUMBERS_H

#include <math.h>

#include "../formulas/c.h"

static inline float magnitude(float a)
{
    return fabsf(a);
}

static inline float inverse(float a)
{
    return 1.0f / a;
}

static inline float root(float a)
{
    return sqrtf(a);
}

static inline float floor_of(float a)
{
    return floorf(a);
}

/* One of two numbers, without a branch: where a hash decides, half of them are mispredicted. */
static inline float either(bool condition, float yes, float no)
{
    const float of[2] = {no, yes};
    return of[condition];
}

/* A lattice value, in units of 2^-31: the hash as a signed number, rounded to float. */
static inline float lattice_value(uint hash)
{
    return (float)(int32_t)hash;
}

#endif
