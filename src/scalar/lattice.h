/* SPDX-License-Identifier: MIT
 *
 * Reference: what the lattice draws at its points. Included by columns.h and by tests.
 */
#ifndef SCARP_SCALAR_LATTICE_H
#define SCARP_SCALAR_LATTICE_H

#include <stdint.h>

/*
 * The lattice hash. Each axis is mixed by itself, because the corners of a cell share the results;
 * exclusive or joins them to h, and the hash is h (h + k). Its top bits matter most.
 * tests/test_hash.c states what is asked of it.
 *
 * A change of bit b of h moves the hash by 2^b times 2 h + k, which differs from point to point:
 * neither lines that differ in few bits nor the corners of a cell are alike. Bit 31 moves it by
 * 2^31 only: the turn puts a low bit of the products there. Because k is odd, each even number is
 * the hash of two h, so that bits 1 to 31 are uniform.
 *
 * Other hashes fail. h M makes lines alike that differ in few bits. A product of the mixed axes is
 * nearly periodic on lines where a factor happens to be special. The square of h is that of ~h + 1,
 * too, so that every line across an axis is found again in its mirror image. Shifts of some 10^5
 * cells along two axes leave sums of mixed axes as they are.
 *
 * A search among random odd numbers found the multipliers. With them, shifts along an axis that
 * move only the top four bits of h, after which indices depend on each other, are longer than 10^8
 * cells. k is 2^32 over the golden ratio. With these all statistics of tests/test_hash.c stay below
 * 4 in 2^20 points, and peaks of spectra below 19 times the mean.
 */
#define HASH_X 0x1a2012f5u
#define HASH_Y 0x14e84743u
#define HASH_Z 0xec1d7da1u
#define HASH_K 0x9e3779b9u

static inline uint32_t hash_axis(uint32_t i, uint32_t multiplier, uint32_t key)
{
    const uint32_t h = i * multiplier + key;
    return h >> 8 | h << 24;
}

static inline uint32_t hash2(const uint32_t key[3], uint32_t x, uint32_t y)
{
    const uint32_t h = hash_axis(x, HASH_X, key[0]) ^ hash_axis(y, HASH_Y, key[1]);
    return h * (h + HASH_K);
}

static inline uint32_t joined3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z)
{
    const uint32_t yz = hash_axis(y, HASH_Y, key[1]) ^ hash_axis(z, HASH_Z, key[2]);
    return hash_axis(x, HASH_X, key[0]) ^ yz;
}

static inline uint32_t hash3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z)
{
    const uint32_t h = joined3(key, x, y, z);
    return h * (h + HASH_K);
}

#endif
