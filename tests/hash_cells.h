/* SPDX-License-Identifier: MIT
 *
 * The statistics that tests/test_hash.c takes of what lattices draw besides one index per point:
 * the centres of 3D simplex noise, and the features of cellular noise.
 */
#ifndef SCARP_TESTS_HASH_CELLS_H
#define SCARP_TESTS_HASH_CELLS_H

#include "../src/scalar/sample.h"

#include "../src/formulas/basis.h"
#include "hash_sets.h"

/*
 * Simplex noise draws from h of a lattice point twice: h (h + HASH_K) for the corner of a cell, and
 * h (h + k) with another k for its centre. A hash that makes centres is a struct hash of its own.
 */
static inline void centre_row(uint32_t k, const uint32_t key[3], const uint32_t point[3], int count,
                              uint32_t *out)
{
    const uint32_t yz = hash_axis(point[1], HASH_Y, key[1]) ^ hash_axis(point[2], HASH_Z, key[2]);
    for (int i = 0; i < count; i++) {
        const uint32_t h = hash_axis(point[0] + (uint32_t)i, HASH_X, key[0]) ^ yz;
        out[i] = h * (h + k);
    }
}

static void centre_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                        uint32_t *out)
{
    centre_row(HASH_CENTRE, key, (const uint32_t[3]){x, y, z}, count, out);
}

static const struct hash centre_hash = {"scarp's centres", NULL, centre_row3};

/* These centres are bad: the sign of their hash is that of the corner or its opposite, by the
   lowest bit of h. */
static void tied_row3(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,
                      uint32_t *out)
{
    centre_row(HASH_K ^ 0x80000000u, key, (const uint32_t[3]){x, y, z}, count, out);
}

static const struct hash tied_hash = {"known bad centres: h (h + k), k as that of corners but for "
                                      "one bit",
                                      NULL, tied_row3};

/* Tests the 12 x 12 directions of corners in w->base and centres e away. */
static inline void test_centre_directions(struct report *report, const struct hash *centre,
                                          const struct field *f, struct workspace *w,
                                          const uint32_t e[3])
{
    const int n = field_points(f);
    field_fill(centre, f, e, w->moved[0]);
    clear_counts(w->counts, 144);
    for (int i = 0; i < n; i++) {
        w->counts[direction_index3(w->base[i]) * 12 + direction_index3(w->moved[0][i])]++;
    }
    REPORT(report, TOPIC_CENTRES, chi_square_z(w->counts, 144, n),
           "12 directions, e = (%d, %d, %d), seed %#llx", (int)e[0], (int)e[1], (int)e[2],
           (unsigned long long)f->seed);
}

/* Counts the four indices of w->moved[0] to [3] jointly. */
static inline void count_four(struct workspace *w, int n)
{
    clear_counts(w->counts, CORNER_CELLS);
    for (int i = 0; i < n; i++) {
        w->counts[(w->moved[0][i] >> 28) << 12 | (w->moved[1][i] >> 28) << 8 |
                  (w->moved[2][i] >> 28) << 4 | w->moved[3][i] >> 28]++;
    }
}

/*
 * Tests the four draws of tetrahedra jointly. The lattice is filled by those that have two centres
 * which are neighbours along an axis, and two corners which are neighbours along another one, on
 * the face between their cells: 12 of them per cell.
 */
static inline void test_tetrahedra(struct report *report, const struct hash *centre,
                                   const struct field *f, struct workspace *w)
{
    const int n = field_points(f);
    for (int kind = 0; kind < 12; kind++) {
        const int centres = kind / 4, corners = (centres + 1 + kind % 2) % 3;
        const int third = 3 - centres - corners;
        uint32_t e[4][3] = {{0}};
        e[1][centres] = e[2][centres] = e[3][centres] = 1;
        e[2][third] = e[3][third] = kind >> 1 & 1;
        e[3][corners] = 1;
        for (int i = 0; i < 4; i++) {
            field_fill(i < 2 ? centre : &scarp_hash, f, e[i], w->moved[i]);
        }
        count_four(w, n);
        REPORT(report, TOPIC_TETRAHEDRA, chi_square_z(w->counts, CORNER_CELLS, n),
               "joint, centres along %d, corners along %d, seed %#llx", centres, corners,
               (unsigned long long)f->seed);
    }
}

/* Tests corner and centre of a cell and of a neighbour along axes and diagonals jointly. */
static inline void test_two_cells(struct report *report, const struct hash *centre,
                                  const struct field *f, struct workspace *w)
{
    const int n = field_points(f);
    for (uint32_t d = 0; d < 8; d++) {
        const uint32_t e[3] = {d & 1, d >> 1 & 1, d >> 2};
        field_fill(&scarp_hash, f, e, w->moved[d == 0 ? 0 : 2]);
        field_fill(centre, f, e, w->moved[d == 0 ? 1 : 3]);
        if (d > 0) {
            count_four(w, n);
            REPORT(report, TOPIC_TETRAHEDRA, chi_square_z(w->counts, CORNER_CELLS, n),
                   "two cells, e = (%d%d%d), seed %#llx", (int)e[0], (int)e[1], (int)e[2],
                   (unsigned long long)f->seed);
        }
    }
}

/* Tests corners with centres of the same numbers and of others, and centres with centres. */
static inline void test_centre_pairs(struct report *report, const struct hash *centre,
                                     const struct field *f, struct workspace *w)
{
    static const uint32_t here[3] = {0, 0, 0};
    field_fill(&scarp_hash, f, here, w->base);
    test_pair(report, TOPIC_CENTRES, centre, f, w, 0, 0, 0);
    test_pairs(report, TOPIC_CENTRES, centre, f, w);
    for (uint32_t i = 0; i < 8; i++) { /* the corners of the centre's cell */
        const uint32_t e[3] = {0u - (i & 1), 0u - (i >> 1 & 1), 0u - (i >> 2)};
        test_centre_directions(report, centre, f, w, e);
    }
    field_fill(centre, f, here, w->base);
    test_pairs(report, TOPIC_CENTRES, &scarp_hash, f, w);
    test_pairs(report, TOPIC_CENTRES, centre, f, w);
}

/* Pairs need fewer points than tetrahedra: they have few counts. */
static inline void test_centres(struct report *report, const struct hash *centre, int bits)
{
    struct workspace w;
    workspace_make(&w, bits);
    for (int i = 0; i < 2; i++) {
        const struct field few = field_make(2 * i, 3, bits - 2), f = field_make(2 * i, 3, bits);
        test_centre_pairs(report, centre, &few, &w);
        test_tetrahedra(report, centre, &f, &w);
        test_two_cells(report, centre, &f, &w);
    }
    workspace_free(&w);
}

/*
 * Cellular noise draws four numbers from the hash of a cell: the hash and its products with three
 * odd numbers. Three place the feature along x, y and z, the last is its id and its value.
 */
struct features {
    const char *name;
    uint32_t multiplier[4]; /* x, y, z, id */
};

static const struct features scarp_features = {"scarp's features",
                                               {1, FEATURE_Y, FEATURE_Z, FEATURE_ID}};
static const struct features small_features = {"known bad features: hash times 1, 3, 5, 7",
                                               {1, 3, 5, 7}};

/* In 2D there is no z. */
static inline int is_drawn(const struct field *f, int number)
{
    return f->dimensions == 3 || number != 2;
}

/* Tests the bytes of each number, the pairs of them by eight bits, and all of them jointly. */
static inline void test_feature(struct report *report, const struct features *features,
                                const struct field *f, struct workspace *w)
{
    const uint32_t *const m = features->multiplier;
    const unsigned long long seed = f->seed;
    const int n = field_points(f), low = f->dimensions == 3 ? 28 : 27;
    for (int a = 0; a < 4; a++) {
        for (int byte = 8; byte <= 24 && is_drawn(f, a); byte += 8) {
            clear_counts(w->counts, 256);
            for (int i = 0; i < n; i++) {
                w->counts[w->base[i] * m[a] >> byte & 255]++;
            }
            REPORT(report, TOPIC_FEATURES, chi_square_z(w->counts, 256, n),
                   "number %d, bits %d up, seed %#llx", a, byte, seed);
        }
        for (int b = a + 1; b < 4 && is_drawn(f, a); b++) {
            clear_counts(w->counts, CORNER_CELLS);
            for (int i = 0; i < n; i++) {
                w->counts[(w->base[i] * m[a] >> 24) << 8 | w->base[i] * m[b] >> 24]++;
            }
            REPORT(report, TOPIC_FEATURES, chi_square_z(w->counts, CORNER_CELLS, n),
                   "numbers %d and %d, seed %#llx", a, b, seed);
        }
    }
    clear_counts(w->counts, CORNER_CELLS);
    for (int i = 0; i < n; i++) {
        uint32_t joint = 0;
        for (int a = 0; a < 4; a++) {
            joint = is_drawn(f, a) ? joint << (32 - low) | w->base[i] * m[a] >> low : joint;
        }
        w->counts[joint]++;
    }
    REPORT(report, TOPIC_FEATURES, chi_square_z(w->counts, f->dimensions == 3 ? 65536 : 32768, n),
           "joint %dD, seed %#llx", f->dimensions, seed);
}

/* Tests number a of each cell with number b of the cell e away: their pairs, and the correlation.
 */
static inline void test_feature_pair(struct report *report, const struct hash *hash,
                                     const struct features *features, const struct field *f,
                                     struct workspace *w, const int e[3])
{
    const uint32_t step[3] = {(uint32_t)e[0], (uint32_t)e[1], (uint32_t)e[2]};
    const int n = field_points(f);
    field_fill(hash, f, step, w->moved[0]);
    for (int ab = 0; ab < 16; ab++) {
        const uint32_t ma = features->multiplier[ab / 4], mb = features->multiplier[ab % 4];
        if (!is_drawn(f, ab / 4) || !is_drawn(f, ab % 4)) {
            continue;
        }
        clear_counts(w->counts, 256);
        for (int i = 0; i < n; i++) {
            const uint32_t a = w->base[i] * ma, b = w->moved[0][i] * mb;
            w->a[i] = value_of(a);
            w->b[i] = value_of(b);
            w->counts[(a >> 28) << 4 | b >> 28]++;
        }
        REPORT(report, TOPIC_NEIGHBOURS, chi_square_z(w->counts, 256, n),
               "numbers %d and %d, e = (%d, %d, %d), seed %#llx", ab / 4, ab % 4, e[0], e[1], e[2],
               (unsigned long long)f->seed);
        REPORT(report, TOPIC_NEIGHBOURS, correlation_z(w->a, w->b, n),
               "correlation of %d and %d, e = (%d, %d, %d), seed %#llx", ab / 4, ab % 4, e[0], e[1],
               e[2], (unsigned long long)f->seed);
    }
}

/* Tests features by themselves, and with those of neighbours along axes and diagonals, by fewer
   points; and with those 2 to 2^20 cells away along an axis. */
static inline void test_features(struct report *report, const struct hash *hash,
                                 const struct features *features, int bits)
{
    static const uint32_t here[3] = {0, 0, 0};
    struct workspace w;
    workspace_make(&w, bits);
    for (int i = 0; i < 4; i++) {
        const int dimensions = 2 + i / 2, directions = dimensions == 3 ? 27 : 9;
        const struct field f = field_make(i % 2 * 2, dimensions, bits);
        field_fill(hash, &f, here, w.base);
        test_feature(report, features, &f, &w);
        const struct field few = field_make(i % 2 * 2, dimensions, bits - 3);
        field_fill(hash, &few, here, w.base);
        for (int d = 1; d < directions; d++) {
            const int e[3] = {(d + 1) % 3 - 1, (d / 3 + 1) % 3 - 1, (d / 9 + 1) % 3 - 1};
            test_feature_pair(report, hash, features, &few, &w, e);
        }
        for (int k = 1; k <= 20; k += k < 3 ? 1 : 4) {
            for (int axis = 0; axis < dimensions; axis++) {
                int e[3] = {0, 0, 0};
                e[axis] = 1 << k;
                test_feature_pair(report, hash, features, &few, &w, e);
            }
        }
    }
    workspace_free(&w);
}

/*
 * The spectral test (Knuth, "Seminumerical Algorithms", 3.3.4). All even hashes are equally likely,
 * so the numbers of features are the points of a lattice. They lie on parallel hyperplanes, which
 * are as far apart as 1 over the length of the shortest vector s with
 *     sum_i s_i m_i = 0 modulo 2^31.
 * No lattice has one longer than sqrt(gamma) 2^(31/count), with Hermite's constant gamma. Returns
 * whether there is a vector shorter than `fraction` times that for these multipliers: tries all
 * components but the first, which follows from the others.
 */
static inline int is_coarse(const uint32_t *m, int count, double fraction)
{
    static const double hermite[] = {1.0745699318235418, 1.1224620483093730, 1.1892071150027211};
    const double shortest = fraction * hermite[count - 2] * pow(2.0, 31.0 / count);
    const int64_t square = (int64_t)(shortest * shortest);
    const int reach = (int)shortest, y = count > 2 ? reach : 0, z = count > 3 ? reach : 0;
    uint32_t inverse = m[0]; /* right in 3 bits; Newton's method doubles them */
    for (int i = 0; i < 4; i++) {
        inverse *= 2 - m[0] * inverse;
    }
    const uint32_t px = inverse * m[1], py = count > 2 ? inverse * m[2] : 0;
    const uint32_t pz = count > 3 ? inverse * m[3] : 0;
    int found = 0;
    for (int i = 0; i <= reach && !found; i++) {
        for (int j = -y; j <= y; j++) {
            for (int k = -z; k <= z; k++) {
                const uint32_t sum = px * (uint32_t)i + py * (uint32_t)j + pz * (uint32_t)k;
                const int64_t first = (int32_t)(sum << 1) / 2;
                const int64_t length =
                    first * first + (int64_t)i * i + (int64_t)j * j + (int64_t)k * k;
                found |= length > 0 && length < square;
            }
        }
    }
    return found;
}

/* Returns how many pairs, triples and quadruples of the multipliers make coarse lattices. */
static inline int coarse_sets(const struct features *features, double fraction)
{
    int coarse = 0;
    for (unsigned set = 1; set < 16; set++) {
        uint32_t m[4];
        int count = 0;
        for (int i = 0; i < 4; i++) {
            if ((set >> i & 1) != 0) {
                m[count++] = features->multiplier[i];
            }
        }
        coarse += count > 1 && is_coarse(m, count, fraction);
    }
    return coarse;
}

#define FINENESS 0.8

static inline void test_spectral(void)
{
    const int coarse = coarse_sets(&scarp_features, FINENESS);
    CHECK(coarse == 0, "%d sets of %s are coarse", coarse, scarp_features.name);
    CHECK(coarse_sets(&scarp_features, 0.99) > 0, "the spectral test sees nothing");
    CHECK(coarse_sets(&small_features, FINENESS) == 11, "few sets of \"%s\" are coarse",
          small_features.name);
}

#endif
