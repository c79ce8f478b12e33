/* SPDX-License-Identifier: MIT
 *
 * Formulas: the self-test of shaders.
 */
#ifndef SCARP_FORMULAS_ANSWERS_H
#define SCARP_FORMULAS_ANSWERS_H

#include "lattice.h"

/* A coordinate of test point i, in steps of a unit. Every operation is exact. */
static inline float test_coordinate(float unit, uint i, uint axis)
{
    const uvec3 key = {0, 0, 0};
    const int cells = (int)(hash2(key, i, axis) >> 12u) - 524288;
    return (float)cells * unit;
}

/* The hash h with an output; what is below 2^-120 counts as 0. */
static inline uint hash_with(uint h, float a)
{
    const uint magnitude_bits = bits_of(a) & 0x7fffffffu;
    const uint bits = magnitude_bits < 0x03800000u ? 0u : bits_of(a);
    return (((h << 5u) | (h >> 27u)) ^ bits) * HASH_K;
}

#endif
