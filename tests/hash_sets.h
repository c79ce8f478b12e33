/* SPDX-License-Identifier: MIT
 *
 * The statistics that tests/test_hash.c takes of one block of the lattice: single indices, pairs at
 * a distance, the corners of cells, and lattice values.
 */
#ifndef SCARP_TESTS_HASH_SETS_H
#define SCARP_TESTS_HASH_SETS_H

#include "hash_fields.h"
#include "hash_stats.h"

#define CORNER_CELLS 65536

/* Room for a block and its shifted copies, and for counts. */
struct workspace {
    uint32_t *base, *moved[8], *counts;
    float *a, *b;
};

static inline void workspace_make(struct workspace *w, int bits)
{
    const size_t points = (size_t)1 << bits;
    w->base = hash_allocate(points, sizeof *w->base);
    for (int i = 0; i < 8; i++) {
        w->moved[i] = hash_allocate(points, sizeof *w->moved[i]);
    }
    w->counts = hash_allocate(CORNER_CELLS, sizeof *w->counts);
    w->a = hash_allocate(points, sizeof *w->a);
    w->b = hash_allocate(points, sizeof *w->b);
}

static inline void workspace_free(struct workspace *w)
{
    free(w->base);
    for (int i = 0; i < 8; i++) {
        free(w->moved[i]);
    }
    free(w->counts);
    free(w->a);
    free(w->b);
}

static inline void clear_counts(uint32_t *counts, int cells)
{
    memset(counts, 0, (size_t)cells * sizeof *counts);
}

static inline void test_uniform(struct report *report, const struct hash *hash,
                                const struct field *f, struct workspace *w)
{
    static const uint32_t here[3] = {0, 0, 0};
    const int n = field_points(f);
    field_fill(hash, f, here, w->base);
    uint32_t counts[16] = {0};
    for (int i = 0; i < n; i++) {
        counts[w->base[i] >> 28]++;
    }
    REPORT(report, TOPIC_UNIFORM, chi_square_z(counts, 16, n), "%dD seed %#llx", f->dimensions,
           (unsigned long long)f->seed);
}

/* Counts base and moved indices jointly; w->base has been filled. */
static inline void count_pairs(const struct hash *hash, const struct field *f, const uint32_t e[3],
                               struct workspace *w)
{
    const int n = field_points(f);
    field_fill(hash, f, e, w->moved[0]);
    clear_counts(w->counts, 256);
    for (int i = 0; i < n; i++) {
        w->counts[(w->base[i] >> 28) << 4 | w->moved[0][i] >> 28]++;
    }
}

static inline void test_pair(struct report *report, enum topic topic, const struct hash *hash,
                             const struct field *f, struct workspace *w, int32_t ex, int32_t ey,
                             int32_t ez)
{
    const uint32_t e[3] = {(uint32_t)ex, (uint32_t)ey, (uint32_t)ez};
    count_pairs(hash, f, e, w);
    REPORT(report, topic, chi_square_z(w->counts, 256, field_points(f)),
           "e = (%ld, %ld, %ld), seed %#llx", (long)ex, (long)ey, (long)ez,
           (unsigned long long)f->seed);
}

/* Tests pairs at e = 2^k d for the directions d of axes and diagonals, and at all small steps e. */
static inline void test_pairs(struct report *report, enum topic topic, const struct hash *hash,
                              const struct field *f, struct workspace *w)
{
    const int deep = f->dimensions == 3;
    for (int k = 0; k <= 23; k++) {
        for (int d = 1; d < (deep ? 27 : 9); d++) {
            /* The digits of d in base 3 are a direction, 2 standing for -1. One of d and -d is
             * enough. */
            const int x = d % 3 == 2 ? -1 : d % 3, y = d / 3 % 3 == 2 ? -1 : d / 3 % 3;
            const int z = d / 9 == 2 ? -1 : d / 9;
            const int first = z != 0 ? z : y != 0 ? y : x;
            const int axes = abs(x) + abs(y) + abs(z);
            /* In 3D, far diagonals are taken along all three axes only. */
            if (first > 0 && !(deep && axes == 2 && k > 4)) {
                test_pair(report, topic, hash, f, w, x * (1 << k), y * (1 << k), z * (1 << k));
            }
        }
    }
    const int reach = deep ? 2 : 5;
    for (int z = 0; z <= (deep ? reach : 0); z++) {
        for (int y = z > 0 ? -reach : 0; y <= reach; y++) {
            for (int x = y > 0 || z > 0 ? -reach : 1; x <= reach; x++) {
                test_pair(report, topic, hash, f, w, x, y, z);
            }
        }
    }
}

/* worst[k - 24] = the greatest V at shift 2^k along an axis, k = 24 to 31; and no shift from 2^8 on
   is a period. */
static inline void far_pairs(const struct hash *hash, const struct field *f, struct workspace *w,
                             double worst[8])
{
    static const uint32_t here[3] = {0, 0, 0};
    const int n = field_points(f);
    field_fill(hash, f, here, w->base);
    for (int axis = 0; axis < f->dimensions; axis++) {
        for (int k = 8; k <= 31; k++) {
            uint32_t e[3] = {0, 0, 0};
            e[axis] = UINT32_C(1) << k;
            count_pairs(hash, f, e, w);
            double equal = 0.0;
            for (uint32_t i = 0; i < 16; i++) {
                equal += w->counts[i << 4 | i];
            }
            CHECK(equal < 0.5 * n, "2^%d is nearly a period along axis %d: %.0f %% equal", k, axis,
                  100.0 * equal / n);
            if (k >= 24) {
                worst[k - 24] = fmax(worst[k - 24], cramers_v(w->counts, n));
            }
        }
    }
}

/* Fills in the corners of all cells of the block: moved[i] has those at the binary digits of i. */
static inline void fill_corners(const struct hash *hash, const struct field *f, struct workspace *w)
{
    for (uint32_t i = 0; i < (f->dimensions == 2 ? 4u : 8u); i++) {
        const uint32_t e[3] = {i & 1, i >> 1 & 1, i >> 2};
        field_fill(hash, f, e, w->moved[i]);
    }
}

/* Tests the corners of the mask `set`: their exclusive or, and their sum with alternating signs. */
static inline void test_combined(struct report *report, enum topic topic, const struct field *f,
                                 struct workspace *w, unsigned set)
{
    const int n = field_points(f);
    uint32_t either[16] = {0}, sums[16] = {0}, wide[256] = {0};
    for (int i = 0; i < n; i++) {
        uint32_t x = 0, sum = 0, full = 0;
        for (unsigned corner = 0; corner < 8; corner++) {
            if ((set >> corner & 1) != 0) {
                const uint32_t h = w->moved[corner][i];
                const int odd = (corner ^ corner >> 1 ^ corner >> 2) & 1;
                x ^= h >> 28;
                sum = odd ? sum - (h >> 28) : sum + (h >> 28);
                full = odd ? full - h : full + h;
            }
        }
        either[x]++;
        sums[sum & 15]++;
        wide[full >> 24]++;
    }
    REPORT(report, topic, chi_square_z(either, 16, n), "xor of corners %#x, seed %#llx", set,
           (unsigned long long)f->seed);
    REPORT(report, topic, chi_square_z(sums, 16, n), "alternating sum of %#x, seed %#llx", set,
           (unsigned long long)f->seed);
    REPORT(report, topic == TOPIC_CORNERS4 ? TOPIC_TWIST : topic, chi_square_z(wide, 256, n),
           "alternating sum (hash) of %#x, seed %#llx", set, (unsigned long long)f->seed);
}

/* Tests all four indices of a cell jointly. */
static inline void test_corners4(struct report *report, const struct hash *hash,
                                 const struct field *f, struct workspace *w)
{
    const int n = field_points(f);
    fill_corners(hash, f, w);
    clear_counts(w->counts, CORNER_CELLS);
    for (int i = 0; i < n; i++) {
        const uint32_t joint = (w->moved[0][i] >> 28) << 12 | (w->moved[1][i] >> 28) << 8 |
                               (w->moved[2][i] >> 28) << 4 | w->moved[3][i] >> 28;
        w->counts[joint]++;
    }
    REPORT(report, TOPIC_CORNERS4, chi_square_z(w->counts, CORNER_CELLS, n), "joint, seed %#llx",
           (unsigned long long)f->seed);
    test_combined(report, TOPIC_CORNERS4, f, w, 0x0f);
}

/* Tests two bits of each of the eight indices of a cell jointly, then faces, diagonal planes, and
   all corners. */
static inline void test_corners8(struct report *report, const struct hash *hash,
                                 const struct field *f, struct workspace *w)
{
    static const unsigned sets[] = {0x0f, 0xf0, 0x33, 0xcc, 0x55, 0xaa, 0xc3, 0xa5, 0x99, 0xff};
    const int n = field_points(f);
    fill_corners(hash, f, w);
    for (int low = 28; low <= 30; low += 2) {
        clear_counts(w->counts, CORNER_CELLS);
        for (int i = 0; i < n; i++) {
            uint32_t joint = 0;
            for (int corner = 0; corner < 8; corner++) {
                joint = joint << 2 | (w->moved[corner][i] >> low & 3);
            }
            w->counts[joint]++;
        }
        REPORT(report, TOPIC_CORNERS8, chi_square_z(w->counts, CORNER_CELLS, n),
               "joint, bits %d and %d, seed %#llx", low, low + 1, (unsigned long long)f->seed);
    }
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++) {
        test_combined(report, TOPIC_CORNERS8, f, w, sets[i]);
    }
}

static inline float value_of(uint32_t hash)
{
    return (float)(int32_t)hash * 0x1p-31f;
}

/* Tests the mean and the variance of lattice values. They are uniform in [-1, 1), so these are 0
   and 1/3, and the variance of their squares is 1/5 - 1/9. */
static inline void test_moments(struct report *report, const struct field *f, const float *values)
{
    const int n = field_points(f);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < n; i++) {
        const double v = (double)values[i];
        sum += v;
        squares += v * v;
    }
    REPORT(report, TOPIC_VALUE, fabs(sum / n) / sqrt(1.0 / (3.0 * n)), "mean, %dD seed %#llx",
           f->dimensions, (unsigned long long)f->seed);
    REPORT(report, TOPIC_VALUE, fabs(squares / n - 1.0 / 3.0) / sqrt((1.0 / 5.0 - 1.0 / 9.0) / n),
           "variance, %dD seed %#llx", f->dimensions, (unsigned long long)f->seed);
}

static inline void test_values(struct report *report, const struct hash *hash,
                               const struct field *f, struct workspace *w)
{
    static const uint32_t here[3] = {0, 0, 0};
    const int n = field_points(f);
    field_fill(hash, f, here, w->base);
    for (int low = 8; low <= 24; low += 8) { /* the three bytes of the 24 bits */
        uint32_t counts[256] = {0};
        for (int i = 0; i < n; i++) {
            counts[w->base[i] >> low & 255]++;
        }
        REPORT(report, TOPIC_VALUE, chi_square_z(counts, 256, n), "bits %d up, %dD seed %#llx", low,
               f->dimensions, (unsigned long long)f->seed);
    }
    for (int i = 0; i < n; i++) {
        w->a[i] = value_of(w->base[i]);
    }
    test_moments(report, f, w->a);
    for (int k = 0; k <= 23; k++) {
        for (int d = 1; d < 1 << f->dimensions; d++) {
            const uint32_t step = UINT32_C(1) << k;
            const uint32_t e[3] = {d & 1 ? step : 0, d & 2 ? step : 0, d & 4 ? step : 0};
            field_fill(hash, f, e, w->moved[0]);
            for (int i = 0; i < n; i++) {
                w->b[i] = value_of(w->moved[0][i]);
            }
            REPORT(report, TOPIC_VALUE, correlation_z(w->a, w->b, n),
                   "correlation along 2^%d (%d%d%d), seed %#llx", k, d & 1, d >> 1 & 1, d >> 2,
                   (unsigned long long)f->seed);
        }
    }
}

#endif
