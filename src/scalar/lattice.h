/* SPDX-License-Identifier: MIT
 *
 * Reference: where a point lies on the lattice, and what the lattice draws at its corners.
 * Included by the other files of src/scalar only; shares nothing with src/kernel.
 */
#ifndef SCARP_SCALAR_LATTICE_H
#define SCARP_SCALAR_LATTICE_H

#include <math.h>
#include <string.h>

#include "../plan.h"
#include "inline.h"

/* A point of one octave: the cell's lower corner, modulo 2^32, and the position inside, in [0, 1]
   (rounding can reach 1; the noise is continuous there). */
struct place {
    uint32_t cell[3];
    float t[3];
};

/* Float positions. Outside [-2^31, 2^31) the cell is -2^31 and the fraction p - p: 0, or NaN where
   p is not finite. */
SCALAR_INLINE void split_f32(float p, uint32_t *cell, float *t)
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
SCALAR_INLINE void split_f64(double p, uint32_t *cell, float *t)
{
    const double lower = floor(p);
    const double shifted = lower + 0x1.8p52;
    uint64_t bits;
    memcpy(&bits, &shifted, sizeof bits);
    *cell = (uint32_t)bits;
    *t = (float)(p - lower);
}

/*
 * The lattice hash. Each axis is mixed by itself, because the corners of a cell share the results;
 * the hash is their product, of which the top bits are used. Products join better than what is
 * usual, (x ^ y) * M, and cost one operation less per corner: nothing cancels in the exclusive ors,
 * or the sums with alternating signs, of the corners of a cell. Their low bits are poor (a product
 * of three is even in 7 of 8 cases), and count for nothing in a float. The multipliers were found
 * by search; tests/test_hash.c states what is asked of them.
 */
#define HASH_X 0xf4bea973u
#define HASH_Y 0xdcf4bb99u
#define HASH_Z 0xf2a4d27bu
#define HASH_SHIFT 15

SCALAR_INLINE uint32_t hash_axis(uint32_t i, uint32_t multiplier, uint32_t key)
{
    const uint32_t h = i * multiplier + key;
    return h ^ (h >> HASH_SHIFT);
}

SCALAR_INLINE uint32_t hash2(const uint32_t key[3], uint32_t x, uint32_t y)
{
    return hash_axis(x, HASH_X, key[0]) * hash_axis(y, HASH_Y, key[1]);
}

SCALAR_INLINE uint32_t hash3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z)
{
    const uint32_t yz = hash_axis(y, HASH_Y, key[1]) * hash_axis(z, HASH_Z, key[2]);
    return hash_axis(x, HASH_X, key[0]) * yz;
}

#endif
