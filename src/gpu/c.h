/* SPDX-License-Identifier: MIT
 *
 * The source of the shaders as C: what the heads of the three languages say in theirs.
 *
 * The other files of this directory are written in a part of C, which shaders.py turns into GLSL,
 * HLSL and WGSL. The script knows the type of every expression, and refuses what is outside:
 *
 * - Functions are static inline, without side effects, and stand before those that call them. They
 *   take and return numbers, vectors and structures; there are no pointers and no arrays, but those
 *   of the plans.
 * - Statements are declarations, assignments to variables (not to parameters), if, for with one
 *   counter, and return. Blocks have braces.
 * - No type becomes another without a cast, but a whole number where uint is wanted. Integers that
 *   become floats have at most 24 bits, since shaders may round others in another way.
 * - Floats are added, subtracted and multiplied by operators, each of which rounds once; the script
 *   makes them calls of functions that compilers of shaders neither fuse nor reorder. inverse()
 *   stands in for division.
 * - ?: chooses one of two numbers. Shaders compute both.
 * - A macro is the name of a number. No name of a variable is a word of a shading language.
 */
#ifndef SCARP_GPU_C_H
#define SCARP_GPU_C_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

typedef uint32_t uint;
typedef struct {
    float x, y, z;
} vec3;
typedef struct {
    uint x, y, z;
} uvec3;
typedef struct {
    float x, y, z, w;
} vec4;

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

static inline vec3 vec3_of(float x, float y, float z)
{
    const vec3 v = {x, y, z};
    return v;
}

static inline float float_of_bits(uint bits)
{
    float a;
    memcpy(&a, &bits, sizeof a);
    return a;
}

static inline uint bits_of(float a)
{
    uint bits;
    memcpy(&bits, &a, sizeof bits);
    return bits;
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

#include "noise.h"

#endif
