/* SPDX-License-Identifier: MIT
 *
 * Blocks of the lattice as a hash draws them, for tests/test_hash.c: the hash of the library, and
 * one that is known to be bad.
 */
#ifndef SCARP_TESTS_HASH_FIELDS_H
#define SCARP_TESTS_HASH_FIELDS_H

#include "../src/plan.h"
#include "../src/scalar/lattice.h"
#include "check.h"

/* out[i] is the hash of lattice point (x + i, y, z); 2D ignores z. */
typedef void hash_row_fn(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                         uint32_t *out);

struct hash {
    const char *name;
    hash_row_fn *row2, *row3;
};

static void scarp_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    (void)z;
    for (int i = 0; i < count; i++) {
        out[i] = hash2(key, x + (uint32_t)i, y);
    }
}

static void scarp_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                       uint32_t *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = hash3(key, x + (uint32_t)i, y, z);
    }
}

static const struct hash scarp_hash = {"scarp", scarp_row2, scarp_row3};

/* The negative control: primes, exclusive or, one multiplication; in use elsewhere. */
static inline uint32_t bad_hash(uint32_t key, uint32_t x, uint32_t y, uint32_t z)
{
    return (key ^ (x * 501125321u) ^ (y * 1136930381u) ^ (z * 1720413743u)) * 0x27d4eb2du;
}

static void bad_row2(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                     uint32_t *out)
{
    (void)z;
    for (int i = 0; i < count; i++) {
        out[i] = bad_hash(key[0], x + (uint32_t)i, y, 0);
    }
}

static void bad_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                     uint32_t *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = bad_hash(key[0], x + (uint32_t)i, y, z);
    }
}

static const struct hash known_bad_hash = {"known bad: (x P ^ y Q ^ z R ^ key) M", bad_row2,
                                           bad_row3};

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
    struct scarp_plan plan;
    scarp_plan_make(&plan, &noise, 3, 0);
    memcpy(key, plan.octave[k].key, sizeof plan.octave[k].key);
}

/*
 * Field `index` of 2^bits points. The first two lie around the origin, with seeds 0 and 1; the
 * others anywhere, with any seed.
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

/* The hashes of the block moved by e, x fastest. */
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
