/* SPDX-License-Identifier: MIT
 *
 * The source of the shaders as C: what the heads of the three languages say in theirs. Tests
 * include it; the library does not.
 *
 * The other files of this directory are written in the part of C that shaders.py turns into GLSL,
 * HLSL and WGSL: structures by value, one declaration to a line, no pointers, no operator ?:, no
 * number that is converted without a word. Floats are added, subtracted and multiplied by the
 * functions below alone, which every language guards against compilers that fuse or reorder.
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

static inline float add(float a, float b)
{
    return a + b;
}

static inline float sub(float a, float b)
{
    return a - b;
}

static inline float mul(float a, float b)
{
    return a * b;
}

static inline vec3 vec3_of(float x, float y, float z)
{
    const vec3 v = {x, y, z};
    return v;
}

static inline float pick(bool condition, float yes, float no)
{
    return condition ? yes : no;
}

static inline int pick_int(bool condition, int yes, int no)
{
    return condition ? yes : no;
}

static inline uint pick_uint(bool condition, uint yes, uint no)
{
    return condition ? yes : no;
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

/* The same bits as another type. */
static inline int int_of(uint a)
{
    return (int)a;
}

static inline uint uint_of(int a)
{
    return (uint)a;
}

/* The same number as another type; from floats towards 0. Conversions from integers are exact here:
   they have at most 24 bits. */
static inline float float_of_int(int a)
{
    return (float)a;
}

static inline float float_of_uint(uint a)
{
    return (float)a;
}

static inline int whole_of(float a)
{
    return (int)a;
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
