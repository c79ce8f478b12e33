/* SPDX-License-Identifier: MIT
 *
 * Blocks of the lattice as a hash draws them, for tests/test_hash.c: the hash of the library, and
 * others that are known to be bad, each in its own way. Every test must reject one of these.
 */
#ifndef SCARP_TESTS_HASH_FIELDS_H
#define SCARP_TESTS_HASH_FIELDS_H

#include "../src/formulas/lattice.h"
#include "../src/plan/plan.h"
#include "check.h"

/* out[i] is the hash of lattice point (x + i, y, z); 2D ignores z. */
typedef void hash_row_fn(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                         uint32_t *out);

struct hash {
    const char *name;
    hash_row_fn *row2, *row3;
};

static inline uvec3 keys_of(const uint32_t key[3])
{
    const uvec3 keys = {key[0], key[1], key[2]};
    return keys;
}

static void scarp_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    (void)z;
    for (int i = 0; i < count; i++) {
        out[i] = hash2(keys_of(key), x + (uint32_t)i, y);
    }
}

static void scarp_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = hash3(keys_of(key), x + (uint32_t)i, y, z);
    }
}

static const struct hash scarp_hash = {"scarp", scarp_row2, scarp_row3};

/* This hash is bad between neighbours, far points and seeds: it joins multiples of primes by
   exclusive or, and multiplies once. Other libraries use it. */
static inline uint32_t prime_point(uint32_t key, uint32_t x, uint32_t y, uint32_t z)
{
    return (key ^ (x * 501125321u) ^ (y * 1136930381u) ^ (z * 1720413743u)) * 0x27d4eb2du;
}

static void prime_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    (void)z;
    for (int i = 0; i < count; i++) {
        out[i] = prime_point(key[0], x + (uint32_t)i, y, 0);
    }
}

static void prime_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = prime_point(key[0], x + (uint32_t)i, y, z);
    }
}

static const struct hash prime_hash = {"known bad in blocks: (x P ^ y Q ^ z R ^ key) M", prime_row2,
                                       prime_row3};

/* This hash is bad along lines: it multiplies the mixed axes. It passes all tests of blocks, but
   one factor is the same along a whole line, and some lines are nearly periodic. */
static inline uint32_t product_axis(uint32_t i, uint32_t multiplier, uint32_t key)
{
    const uint32_t h = i * multiplier + key;
    return h ^ h >> 15;
}

static void product_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                         uint32_t *out)
{
    (void)z;
    const uint32_t hy = product_axis(y, 0xdcf4bb99u, key[1]);
    for (int i = 0; i < count; i++) {
        out[i] = product_axis(x + (uint32_t)i, 0xf4bea973u, key[0]) * hy;
    }
}

static void product_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                         uint32_t *out)
{
    product_row2(key, x, y, 0, count, out);
    for (int i = 0; i < count; i++) {
        out[i] *= product_axis(z, 0xf2a4d27bu, key[2]);
    }
}

static const struct hash product_hash = {"known bad along lines: the product of mixed axes",
                                         product_row2, product_row3};

/* This hash is bad at the corners of cells: it adds the mixed axes, so the alternating sum of four
   corners is 0. */
static void sum_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                     uint32_t *out)
{
    (void)z;
    const uint32_t hy = hash_axis(y, HASH_Y, key[1]);
    for (int i = 0; i < count; i++) {
        out[i] = hash_axis(x + (uint32_t)i, HASH_X, key[0]) + hy;
    }
}

static void sum_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                     uint32_t *out)
{
    sum_row2(key, x, y, 0, count, out);
    for (int i = 0; i < count; i++) {
        out[i] += hash_axis(z, HASH_Z, key[2]);
    }
}

static const struct hash sum_hash = {"known bad at corners: the sum of mixed axes", sum_row2,
                                     sum_row3};

/* This hash is bad far away: it squares sums of mixed axes, and -h has the same square as h. */
static void square_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                        uint32_t *out)
{
    const uint32_t yz = (hash_axis(y, HASH_Y, key[1]) & ~1u) + (hash_axis(z, HASH_Z, key[2]) & ~1u);
    for (int i = 0; i < count; i++) {
        const uint32_t h = (hash_axis(x + (uint32_t)i, HASH_X, key[0]) | 1u) ^ yz;
        out[i] = h * h;
    }
}

static void square_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                        uint32_t *out)
{
    const uint32_t key2[3] = {key[0], key[1], 0};
    (void)z;
    square_row3(key2, x, y, 0, count, out);
}

static const struct hash square_hash = {"known bad far away: the square of x ^ (y + z)",
                                        square_row2, square_row3};

/* This hash is bad between seeds: it is the library's with one key, and other seeds only move it
   along x. */
static const uint32_t one_key[3] = {0x8f1bbcdcu, 0x6ed9eba1u, 0x5a827999u};

static void moved_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    scarp_row2(one_key, x + (key[0] & 255), y, z, count, out);
}

static void moved_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    scarp_row3(one_key, x + (key[0] & 255), y, z, count, out);
}

static const struct hash moved_hash = {"known bad between seeds: they move one lattice", moved_row2,
                                       moved_row3};

/* This hash is bad everywhere: it is the library's without its greatest sixteenth. */
static void uneven_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                        uint32_t *out)
{
    scarp_row2(key, x, y, z, count, out);
    for (int i = 0; i < count; i++) {
        out[i] -= out[i] >> 4;
    }
}

static void uneven_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                        uint32_t *out)
{
    scarp_row3(key, x, y, z, count, out);
    for (int i = 0; i < count; i++) {
        out[i] -= out[i] >> 4;
    }
}

static const struct hash uneven_hash = {"known bad everywhere: the greatest 1/16 missing",
                                        uneven_row2, uneven_row3};

/* The block of lattice points origin + [0, size) of one seed. */
struct field {
    int dimensions;
    uint64_t seed;
    uint32_t key[3], origin[3];
    int size[3];
};

/* The keys of octave k. */
static inline void seed_keys(uint64_t seed, int k, uint32_t key[3])
{
    const struct scarp_noise noise = {.seed = seed, .octaves = (float)(k + 1)};
    struct scarp_octave octave[SCARP_MAX_OCTAVES];
    struct scarp_call_plan plan;
    const struct scarp_request kind = {.dimensions = 3};
    CHECK(scarpi_plan_call(&plan, octave, NULL, &noise, kind) == SCARP_OK, "octave %d has no keys",
          k);
    memcpy(key, octave[k].key, sizeof octave[k].key);
}

/*
 * Field `index` of 2^bits points. The first two lie around the origin and have the seeds 0 and 1;
 * the others lie anywhere and have any seed.
 */
static inline struct field field_make(int index, int dimensions, int bits)
{
    struct field f = {.dimensions = dimensions, .seed = (uint64_t)index};
    uint64_t state = (uint64_t)(100 * dimensions + index);
    const int third = dimensions == 3 ? bits / 4 : 0;
    const int share[3] = {(bits - third + 1) / 2, (bits - third) / 2, third};
    for (int i = 0; i < 3; i++) {
        f.size[i] = 1 << share[i];
        f.origin[i] = 0u - (uint32_t)f.size[i] / 2;
        if (index >= 2) {
            f.origin[i] = (uint32_t)check_random(&state);
        }
    }
    if (index >= 2) {
        f.seed = check_random(&state);
    }
    seed_keys(f.seed, 0, f.key);
    return f;
}

static inline int field_points(const struct field *f)
{
    return f->size[0] * f->size[1] * f->size[2];
}

/* Fills in the hashes of the block moved by e, x fastest. */
static inline void field_fill(const struct hash *hash, const struct field *f, const uint32_t e[3],
                              uint32_t *out)
{
    hash_row_fn *const row = f->dimensions == 2 ? hash->row2 : hash->row3;
    for (int z = 0; z < f->size[2]; z++) {
        for (int y = 0; y < f->size[1]; y++) {
            row(f->key, f->origin[0] + e[0], f->origin[1] + e[1] + (uint32_t)y,
                f->origin[2] + e[2] + (uint32_t)z, f->size[0], out);
            out += f->size[0];
        }
    }
}

static inline void *hash_allocate(size_t count, size_t size)
{
    void *const memory = calloc(count, size);
    if (memory == NULL) {
        printf("out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

#endif
