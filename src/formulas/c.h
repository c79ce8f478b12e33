/* SPDX-License-Identifier: MIT
 *
 * The types of the formulas in C.
 *
 * Every basis is written once, plain, for the reference in C and for shaders. The formulas, and the
 * other source of shaders in src/gpu, keep to a part of C, which shaders.py turns into GLSL, HLSL
 * and WGSL. The script knows the type of every expression, and refuses what is outside:
 *
 * - Functions are static inline, without side effects, and stand before those that call them. They
 *   take and return numbers, vectors and structures; there are no pointers and no arrays, but those
 *   of the plans of shaders.
 * - Statements are declarations, assignments to variables (not to parameters), if, for with one
 *   counter, and return. Spell out short loops: llvmpipe ends all loops of an invocation after
 *   65,535 rounds. Blocks have braces. Braces initialise structures, with names of members
 *   or without; what they leave out is 0.
 * - No type becomes another without a cast, but a whole number where uint is wanted. Integers that
 *   become floats have at most 24 bits, since shaders may round others in another way.
 * - Floats are added, subtracted and multiplied by operators, each of which rounds once; the script
 *   makes them calls of functions that compilers of shaders neither fuse nor reorder. inverse()
 *   stands in for division.
 * - ?: chooses one of two numbers. Shaders compute both.
 * - A macro is the name of a number; so are the enumerators of bases, fades and fractals, as uint.
 *   No name of a variable is a word of a shading language.
 *
 * Some functions are not the same in C and in shaders: magnitude(), floor_of(), either(),
 * inverse(), root() and lattice_value() of numbers.h, direction2(), direction3() and quarter3() of
 * directions.h. These files are in src/scalar and in src/gpu; one of each must be included before
 * the formulas.
 */
#ifndef SCARP_FORMULAS_C_H
#define SCARP_FORMULAS_C_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "scarp.h"

typedef unsigned int uint; /* so systems that have this type declare it */
_Static_assert(sizeof(uint) == sizeof(uint32_t), "uint has 32 bits");

typedef struct {
    float x, y, z;
} vec3;
typedef struct {
    uint x, y, z;
} uvec3;
typedef struct {
    float x, y, z, w;
} vec4;

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

#endif
