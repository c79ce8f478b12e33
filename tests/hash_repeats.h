/* SPDX-License-Identifier: MIT
 *
 * Whether parts of the lattice are found again elsewhere, for tests/test_hash.c: a line or plane
 * across an axis anywhere along it, or the whole lattice after a shift along two axes at once.
 */
#ifndef SCARP_TESTS_HASH_REPEATS_H
#define SCARP_TESTS_HASH_REPEATS_H

#include "hash_seeds.h"

#define AGAIN_LINES (1 << 17) /* if each recurred once in 2^32 lines, 2 pairs would meet */
#define AGAIN_CELLS 16
#define EQUAL_BOUND 0.1 /* the share of hashes that a shift may leave as they are */

static inline uint32_t hash_at(const struct hash *hash, const uint32_t key[3], int dimensions,
                               const uint32_t p[3])
{
    uint32_t h;
    (dimensions == 2 ? hash->row2 : hash->row3)(key, p[0], p[1], p[2], 1, &h);
    return h;
}

/* Draws a number for i; no two i have the same one. */
static inline uint32_t scattered(uint32_t i)
{
    i *= 0x9e3779b1u;
    i ^= i >> 15;
    i *= 0x85ebca6bu;
    return i ^ i >> 13;
}

/* How many of the lines, in 3D planes, across an axis equal another one, by the indices of 16
   cells. */
static inline long lines_again(const struct hash *hash, int dimensions, int axis)
{
    uint64_t *const prints = hash_allocate(AGAIN_LINES, sizeof *prints);
    uint32_t key[3];
    seed_keys(0, 0, key);
    for (uint32_t i = 0; i < AGAIN_LINES; i++) {
        uint64_t random = 1;
        for (int cell = 0; cell < AGAIN_CELLS; cell++) {
            uint32_t p[3];
            for (int k = 0; k < 3; k++) {
                p[k] = k == axis ? scattered(i) : (uint32_t)check_random(&random);
            }
            prints[i] = prints[i] << 4 | hash_at(hash, key, dimensions, p) >> 28;
        }
    }
    qsort(prints, AGAIN_LINES, sizeof *prints, compare_u64);
    long again = 0;
    for (size_t i = 1; i < AGAIN_LINES; i++) {
        again += prints[i] == prints[i - 1];
    }
    free(prints);
    return again;
}

/* The share of indices that the shift e leaves as they are, beyond that of random numbers. */
static inline double equal_share(const struct hash *hash, int dimensions, const uint32_t e[3])
{
    uint32_t key[3];
    uint64_t random = 1;
    int equal = 0;
    seed_keys(0, 0, key);
    for (int i = 0; i < 4096; i++) {
        uint32_t p[3], q[3];
        for (int k = 0; k < 3; k++) {
            p[k] = (uint32_t)check_random(&random);
            q[k] = p[k] + e[k];
        }
        equal += hash_at(hash, key, dimensions, p) >> 28 == hash_at(hash, key, dimensions, q) >> 28;
    }
    return (equal / 4096.0 - 1.0 / 16.0) / (15.0 / 16.0);
}

/* 1 / m modulo 2^32, by Newton's method. */
static inline uint32_t modular_inverse(uint32_t m)
{
    uint32_t r = m;
    for (int i = 0; i < 5; i++) {
        r *= 2 - m * r;
    }
    return r;
}

static inline uint32_t distance(uint32_t shift)
{
    return shift < 0x80000000u ? shift : 0 - shift;
}

/*
 * Finds the worst share over shifts along the axes i and j at once: the one changes its mixed axis
 * by d, nearly always, and the other by d or -d, so that the hash, which joins them, may not
 * change. There is such a shift for each d, so some are short; a few of the shortest are tried.
 */
static inline double worst_shift(const struct hash *hash, int dimensions, int i, int j, int bits)
{
    static const uint32_t multiplier[3] = {HASH_X, HASH_Y, HASH_Z};
    const uint32_t step = modular_inverse(multiplier[i]), other = modular_inverse(multiplier[j]);
    const int32_t most = 1 << bits;
    const uint32_t near = (uint32_t)(0x1p31 * sqrt(8.0 / (65.0 * 2.0 * most)));
    double worst = 0.0;
    for (int32_t low = -32; low <= 32; low++) {
        for (int32_t high = -most; high <= most; high++) {
            const uint32_t d = (uint32_t)high * 256 + (uint32_t)low;
            if (d != 0 && distance(d * step) < near && distance(d * other) < near) {
                uint32_t e[3] = {0, 0, 0};
                e[i] = d * step;
                for (int sign = 0; sign < 2; sign++) {
                    e[j] = sign == 0 ? d * other : 0 - d * other;
                    worst = fmax(worst, equal_share(hash, dimensions, e));
                }
            }
        }
    }
    return worst;
}

static inline void test_repeats(const struct hash *hash, int bits)
{
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int axis = 0; axis < dimensions; axis++) {
            const long again = lines_again(hash, dimensions, axis);
            CHECK(again == 0, "%dD: %ld lines across axis %d are found again", dimensions, again,
                  axis);
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        const double share = worst_shift(hash, 3, axis, (axis + 1) % 3, bits);
        CHECK(share <= EQUAL_BOUND, "a shift along %d and %d leaves %.3f of all hashes", axis,
              (axis + 1) % 3, share);
        printf("shifts along axes %d and %d leave at most %.3f of all hashes\n", axis,
               (axis + 1) % 3, share);
    }
}

static inline void test_bad_repeats(int bits)
{
    const long again = lines_again(&square_hash, 2, 1);
    CHECK(again > 0, "no line of \"%s\" is found again", square_hash.name);
    const double share = worst_shift(&square_hash, 3, 1, 2, bits);
    CHECK(share > 2.0 * EQUAL_BOUND, "shifts leave %.3f of \"%s\"", share, square_hash.name);
    printf("%s: %ld lines are found again; a shift leaves %.3f\n", square_hash.name, again, share);
}

#endif
