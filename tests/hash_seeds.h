/* SPDX-License-Identifier: MIT
 *
 * The statistics that tests/test_hash.c takes between seeds and between octaves: whether keys and
 * offsets are drawn well (src/plan/octaves.c).
 */
#ifndef SCARP_TESTS_HASH_SEEDS_H
#define SCARP_TESTS_HASH_SEEDS_H

#include "../src/dispatch/kernels.h"
#include "hash_sets.h"

/* Compares the indices of two lattices at the same points: w->base has those of the one, and those
   of the keys `other` are counted with them. */
static inline double lattices_z(const struct hash *hash, const struct field *f,
                                const uint32_t other[3], struct workspace *w)
{
    static const uint32_t here[3] = {0, 0, 0};
    struct field moved = *f;
    memcpy(moved.key, other, sizeof moved.key);
    count_pairs(hash, &moved, here, w);
    return chi_square_z(w->counts, 256, field_points(f));
}

/* Tests seeds that differ little, and the octaves of one seed. */
static inline void test_seed_pairs(struct report *report, const struct hash *hash,
                                   const struct field *f, struct workspace *w)
{
    static const uint32_t here[3] = {0, 0, 0};
    const uint64_t s = f->seed;
    const uint64_t others[] = {s + 1,
                               s + 2,
                               s + (UINT64_C(1) << 32),
                               ~s,
                               s ^ UINT64_C(1) << 63,
                               s ^ UINT64_C(1) << 31,
                               s + UINT64_C(0x9e3779b97f4a7c15),
                               0 - s};
    field_fill(hash, f, here, w->base);
    uint32_t key[3];
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        if (others[i] != s) {
            seed_keys(others[i], 0, key);
            REPORT(report, TOPIC_SEEDS, lattices_z(hash, f, key, w), "%dD seeds %#llx and %#llx",
                   f->dimensions, (unsigned long long)s, (unsigned long long)others[i]);
        }
    }
    for (int k = 1; k < 6; k++) {
        seed_keys(s, k, key);
        REPORT(report, TOPIC_SEEDS, lattices_z(hash, f, key, w), "%dD octaves 0 and %d of %#llx",
               f->dimensions, k, (unsigned long long)s);
        /* No seed has the octaves of another one, moved up. */
        const uint64_t near[] = {s + 1, s - 1, s - (uint64_t)k};
        for (int i = 0; i < 3; i++) {
            seed_keys(near[i], k, key);
            REPORT(report, TOPIC_SEEDS, lattices_z(hash, f, key, w),
                   "%dD octave 0 of %#llx, %d of %#llx", f->dimensions, (unsigned long long)s, k,
                   (unsigned long long)near[i]);
        }
    }
}

/* Tests seeds i * step at one lattice point: their indices, pairs of neighbours, and values. */
static inline void test_sequence(struct report *report, const struct hash *hash, uint64_t step,
                                 const uint32_t point[3], int dimensions, int bits)
{
    hash_row_fn *const row = dimensions == 2 ? hash->row2 : hash->row3;
    const int n = 1 << bits;
    uint32_t single[16] = {0}, pairs[256] = {0}, value[256] = {0}, before = 0;
    for (int i = 0; i <= n; i++) {
        uint32_t key[3], h;
        seed_keys((uint64_t)i * step, 0, key);
        row(key, point[0], point[1], point[2], 1, &h);
        if (i > 0) {
            single[h >> 28]++;
            pairs[before << 4 | h >> 28]++;
            value[h >> 24]++;
        }
        before = h >> 28;
    }
    const unsigned long long s = step;
    const long x = (int32_t)point[0];
    REPORT(report, TOPIC_SEQUENCE, chi_square_z(single, 16, n),
           "%dD, index, steps of %#llx at x = %ld", dimensions, s, x);
    REPORT(report, TOPIC_SEQUENCE, chi_square_z(pairs, 256, n),
           "%dD, pairs, steps of %#llx at x = %ld", dimensions, s, x);
    REPORT(report, TOPIC_SEQUENCE, chi_square_z(value, 256, n),
           "%dD, value, steps of %#llx at x = %ld", dimensions, s, x);
}

static inline void test_seed_sequence(struct report *report, const struct hash *hash, int bits)
{
    static const uint32_t points[][3] = {{0, 0, 0}, {1, 2, 3}, {0xffffffffu, 1000000, 0x80000000u}};
    static const uint64_t steps[] = {1, 2, UINT64_C(1) << 32, UINT64_C(1) << 40,
                                     UINT64_C(0x9e3779b97f4a7c15)};
    for (size_t p = 0; p < sizeof points / sizeof points[0]; p++) {
        for (size_t s = 0; s < sizeof steps / sizeof steps[0]; s++) {
            test_sequence(report, hash, steps[s], points[p], 2 + (int)(p + s) % 2, bits - 2);
        }
    }
}

static inline int compare_u64(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* 2^bits seeds have as many distinct keys: consecutive, evenly spaced and random ones. */
static inline void test_distinct_keys(int bits)
{
    const size_t n = (size_t)1 << bits;
    uint64_t *const keys = hash_allocate(n, sizeof *keys);
    for (int kind = 0; kind < 4; kind++) {
        uint64_t state = 0;
        for (size_t i = 0; i < n; i++) {
            const uint64_t seed = kind == 0   ? i
                                  : kind == 1 ? (uint64_t)i << 32
                                  : kind == 2 ? ~(uint64_t)0 - ((uint64_t)i << 44)
                                              : check_random(&state);
            uint32_t key[3];
            seed_keys(seed, 0, key);
            keys[i] = (uint64_t)key[0] << 32 | key[1];
        }
        qsort(keys, n, sizeof *keys, compare_u64);
        size_t repeated = 0;
        for (size_t i = 1; i < n; i++) {
            repeated += keys[i] == keys[i - 1];
        }
        CHECK(repeated == 0, "kind %d: %zu seeds share the keys of others", kind, repeated);
    }
    free(keys);
}

#define OCTAVES 6
#define PATCH 5 /* points in each direction of the patch around the origin */

enum octaves { OCTAVES_OF_SCARP, OCTAVES_ALIKE };

/* Makes octaves that are known to be bad: all have the keys and the offset of the first. */
static inline void make_alike(struct scarp_octave octave[OCTAVES])
{
    for (int k = 1; k < OCTAVES; k++) {
        memcpy(octave[k].key, octave[0].key, sizeof octave[k].key);
        memcpy(octave[k].offset, octave[0].offset, sizeof octave[k].offset);
    }
}

/* Samples every octave of `seed` by itself at the points of the patch, x = p / f_k, which lie at
   the same place in its cells. There, octaves with a common lattice or offset look alike. */
static inline void sample_patch(uint64_t seed, enum scarp_basis kind, enum octaves octaves,
                                float values[OCTAVES][PATCH * PATCH])
{
    const struct scarp_noise noise = {
        .basis = kind, .seed = seed, .octaves = OCTAVES, .offset_first = 1};
    struct scarp_octave all[SCARP_MAX_OCTAVES], two[2];
    struct scarp_call_plan plan;
    const struct scarp_request asked = {.dimensions = 2};
    CHECK(scarpi_plan_call(&plan, all, NULL, &noise, asked) == SCARP_OK && plan.octaves == OCTAVES,
          "plan");
    if (octaves == OCTAVES_ALIKE) {
        make_alike(all);
    }
    plan.octave = two;
    for (int k = 0; k < OCTAVES; k++) {
        double x[PATCH * PATCH], y[PATCH * PATCH];
        two[0] = all[0];
        if (k > 0) {
            /* The first octave of a plan is never turned: it stays, with the amplitude 0. */
            two[0].amplitude = 0.0f;
            two[1] = all[k];
        }
        plan.octaves = k > 0 ? 2 : 1;
        for (int i = 0; i < PATCH * PATCH; i++) {
            x[i] = (i % PATCH - PATCH / 2) * 0.375 / all[k].frequency64;
            y[i] = (i / PATCH - PATCH / 2) * 0.375 / all[k].frequency64;
        }
        const void *const position[3] = {x, y, NULL};
        const struct scarp_outputs out = {{[VALUE] = values[k]}};
        scarpi_kernels_scalar.points2_f64(&plan, PATCH * PATCH, position, &out);
    }
}

/* Tests the correlation between each two octaves at each point of the patch, over seeds: of values,
   and of their squares. */
static inline void test_octaves_of(struct report *report, enum scarp_basis kind,
                                   enum octaves octaves, int seeds)
{
    const size_t points = PATCH * PATCH;
    float *const values = hash_allocate(points * OCTAVES * (size_t)seeds, sizeof *values);
    float *const squares = hash_allocate(points * OCTAVES * (size_t)seeds, sizeof *squares);
    for (int s = 0; s < seeds; s++) {
        float patch[OCTAVES][PATCH * PATCH];
        sample_patch((uint64_t)s, kind, octaves, patch);
        for (size_t k = 0; k < OCTAVES; k++) {
            for (size_t p = 0; p < points; p++) {
                const float v = patch[k][p];
                values[(k * points + p) * (size_t)seeds + (size_t)s] = v;
                squares[(k * points + p) * (size_t)seeds + (size_t)s] = v * v;
            }
        }
    }
    for (size_t j = 0; j < OCTAVES; j++) {
        for (size_t k = j + 1; k < OCTAVES; k++) {
            for (size_t p = 0; p < points; p++) {
                const size_t a = (j * points + p) * (size_t)seeds;
                const size_t b = (k * points + p) * (size_t)seeds;
                REPORT(report, TOPIC_OCTAVES, correlation_z(values + a, values + b, seeds),
                       "values of octaves %zu and %zu, point %zu, basis %d", j, k, p, (int)kind);
                REPORT(report, TOPIC_OCTAVES, correlation_z(squares + a, squares + b, seeds),
                       "squares of octaves %zu and %zu, point %zu, basis %d", j, k, p, (int)kind);
            }
        }
    }
    free(values);
    free(squares);
}

static inline void test_octaves(struct report *report, enum octaves octaves, int bits)
{
    test_octaves_of(report, SCARP_GRADIENT, octaves, 1 << (bits - 7));
    test_octaves_of(report, SCARP_VALUE, octaves, 1 << (bits - 7));
}

#endif
