/* SPDX-License-Identifier: MIT
 *
 * The source of the shaders as C: what the heads of the three languages say in theirs.
 * The other files of this directory keep to the part of C that ../formulas/c.h describes.
 */
#ifndef SCARP_GPU_C_H
#define SCARP_GPU_C_H

#include <math.h>

#include "../formulas/c.h"
#include "plan.h"

/* The plans that shaders find in their uniform buffer. */
static const struct plan *scarp_plan;

/* What a program may fix when it compiles a shader; here nothing is. */
static inline uint only_basis(uint basis)
{
    return basis;
}

static inline uint only_fractal(uint fractal)
{
    return fractal;
}

static inline uint only_depth(uint depth)
{
    return depth;
}

static inline float floor_of(float a)
{
    return floorf(a);
}

/* 1 / a and the root of a in any rounding, up to some units in the last place. Tests say how far
   they are off. */
#ifndef SCARP_GPU_ERROR
#define SCARP_GPU_ERROR 0
#endif
static inline float rough_inverse(float a)
{
    return float_of_bits(bits_of(1.0f / a) + (uint)(SCARP_GPU_ERROR));
}

static inline float rough_root(float a)
{
    return float_of_bits(bits_of(sqrtf(a)) + (uint)(SCARP_GPU_ERROR));
}

#endif
