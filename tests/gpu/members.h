/* SPDX-License-Identifier: MIT
 *
 * What tests of shaders compare: the members of a sample, in the order in which shaders write them,
 * and the bits that count.
 */
#ifndef SCARP_TESTS_GPU_MEMBERS_H
#define SCARP_TESTS_GPU_MEMBERS_H

#include "../outputs.h"

enum { MEMBERS = 10 };

/* The order of the derivatives that a member is, and whether it is along z. */
static const unsigned char order_of[MEMBERS] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
static const unsigned char is_along_z[MEMBERS] = {0, 0, 0, 1, 0, 0, 1, 0, 1, 1};

static inline int has_member(int m, int dimensions, int order)
{
    return order_of[m] <= order && (dimensions == 3 || !is_along_z[m]);
}

/* 0 for magnitudes below 2^-120, which shaders may flush to 0, and for either 0. */
static inline uint32_t counted_bits(const float *value)
{
    const uint32_t bits = float_bits(value);
    return (bits & 0x7fffffffu) < (uint32_t)(127 - 120) << 23 ? 0 : bits;
}

#endif
