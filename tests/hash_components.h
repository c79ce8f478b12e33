/* SPDX-License-Identifier: MIT
 *
 * The statistics that tests/test_hash.c takes of the components of vector noise, which draw from
 * one hash of each lattice point: each component by itself, as good as noise with one, and pairs of
 * components, at the same point and at a distance.
 */
#ifndef SCARP_TESTS_HASH_COMPONENTS_H
#define SCARP_TESTS_HASH_COMPONENTS_H

#include "hash_sets.h"

/* The draws of a basis in the plane or in space. */
struct draws {
    const char *name;
    int dimensions, components;
    uint32_t (*of)(uint32_t hash, uint32_t component); /* the hash in place of another */
    int numbers; /* how many numbers are drawn: those of gradients, or 16 intervals of values */
};

static uint32_t draws_gradient2(uint32_t hash, uint32_t component)
{
    return component_hash2(hash, component);
}

static uint32_t draws_gradient3(uint32_t hash, uint32_t component)
{
    return component_hash3(hash, component);
}

static uint32_t draws_values(uint32_t hash, uint32_t component)
{
    return component_hash_values(hash, component);
}

static const struct draws scarp_draws[] = {
    {"2D gradients", 2, 2, draws_gradient2, 16},
    {"3D gradients", 3, 3, draws_gradient3, 12},
    {"2D values", 2, 2, draws_values, 16},
    {"3D values", 3, 3, draws_values, 16},
};

/* These components draw from fields of the hash, the lower of which depend on those of neighbours.
 */
static uint32_t draws_fields(uint32_t hash, uint32_t component)
{
    return hash << (11 * component);
}

/* These draw alike: component 1 is component 0 with another sign. */
static uint32_t draws_alike(uint32_t hash, uint32_t component)
{
    return component == 0 ? hash : ~hash;
}

static const struct draws field_draws = {"known bad draws: 11-bit fields", 3, 3, draws_fields, 16};
static const struct draws alike_draws = {"known bad draws: the complement", 2, 2, draws_alike, 16};

/* The number that a component draws. */
static inline uint32_t number_drawn(const struct draws *draws, uint32_t hash, uint32_t component)
{
    const uint32_t h = draws->of(hash, component);
    return draws->numbers == 12 ? (h >> 16) * 12 >> 16 : h >> 28;
}

/* Counts numbers of component a in w->base, and those of b in w->moved[0], jointly. */
static inline double draws_z(const struct draws *draws, const struct field *f, struct workspace *w,
                             uint32_t a, uint32_t b)
{
    const int n = field_points(f), cells = draws->numbers * draws->numbers;
    clear_counts(w->counts, cells);
    for (int i = 0; i < n; i++) {
        const uint32_t first = number_drawn(draws, w->base[i], a);
        const uint32_t second = number_drawn(draws, w->moved[0][i], b);
        w->counts[first * (uint32_t)draws->numbers + second]++;
    }
    return chi_square_z(w->counts, cells, n);
}

/* Tests all pairs of components at points that are e apart; a component with itself, too, unless e
   is 0. Values are correlated besides. */
static inline void test_component_pairs(struct report *report, const struct draws *draws,
                                        const struct field *f, struct workspace *w,
                                        const uint32_t e[3])
{
    static const uint32_t here[3] = {0, 0, 0};
    const int n = field_points(f), apart = (e[0] | e[1] | e[2]) != 0;
    field_fill(&scarp_hash, f, here, w->base);
    field_fill(&scarp_hash, f, e, w->moved[0]);
    for (uint32_t a = 0; a < (uint32_t)draws->components; a++) {
        for (uint32_t b = 0; b < (uint32_t)draws->components; b++) {
            if (!apart && a >= b) {
                continue;
            }
            REPORT(report, TOPIC_COMPONENTS, draws_z(draws, f, w, a, b),
                   "%s, components %u and %u, e = (%ld, %ld, %ld)", draws->name, (unsigned)a,
                   (unsigned)b, (long)(int32_t)e[0], (long)(int32_t)e[1], (long)(int32_t)e[2]);
            if (draws->of == draws_values) {
                for (int i = 0; i < n; i++) {
                    w->a[i] = value_of(draws->of(w->base[i], a));
                    w->b[i] = value_of(draws->of(w->moved[0][i], b));
                }
                REPORT(report, TOPIC_COMPONENTS, correlation_z(w->a, w->b, n),
                       "%s, correlation of %u and %u, e = (%ld, %ld, %ld)", draws->name,
                       (unsigned)a, (unsigned)b, (long)(int32_t)e[0], (long)(int32_t)e[1],
                       (long)(int32_t)e[2]);
            }
        }
    }
}

/* Tests all three components of a point jointly. */
static inline void test_component_triple(struct report *report, const struct draws *draws,
                                         const struct field *f, struct workspace *w)
{
    static const uint32_t here[3] = {0, 0, 0};
    const int n = field_points(f), m = draws->numbers;
    field_fill(&scarp_hash, f, here, w->base);
    clear_counts(w->counts, m * m * m);
    for (int i = 0; i < n; i++) {
        uint32_t joint = 0;
        for (uint32_t c = 0; c < 3; c++) {
            joint = joint * (uint32_t)m + number_drawn(draws, w->base[i], c);
        }
        w->counts[joint]++;
    }
    REPORT(report, TOPIC_COMPONENTS, chi_square_z(w->counts, m * m * m, n), "%s, all components",
           draws->name);
}

/* Tests components of a block at small steps and at powers of two along axes and a diagonal. */
static inline void test_components(struct report *report, const struct draws *draws, int bits)
{
    struct workspace w;
    workspace_make(&w, bits);
    for (int index = 0; index <= 2; index += 2) {
        const struct field f = field_make(index, draws->dimensions, bits);
        const int deep = f.dimensions == 3;
        for (int z = 0; z <= deep; z++) {
            for (int y = z > 0 ? -1 : 0; y <= 1; y++) {
                for (int x = y > 0 || z > 0 ? -1 : 0; x <= 1; x++) {
                    const uint32_t e[3] = {(uint32_t)x, (uint32_t)y, (uint32_t)z};
                    test_component_pairs(report, draws, &f, &w, e);
                }
            }
        }
        for (int k = 1; k <= 20; k++) {
            for (int d = 0; d <= f.dimensions; d++) {
                uint32_t e[3] = {0, 0, 0};
                for (int axis = 0; axis < f.dimensions; axis++) {
                    e[axis] = d == axis || d == f.dimensions ? UINT32_C(1) << k : 0;
                }
                test_component_pairs(report, draws, &f, &w, e);
            }
        }
        if (draws->components == 3) {
            test_component_triple(report, draws, &f, &w);
        }
    }
    workspace_free(&w);
}

/* The hashes of components, which each have the statistics of noise with one. */
#define COMPONENT_ROW(name, row, draw, i)                                                          \
    static void name(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z, int count,         \
                     uint32_t *out)                                                                \
    {                                                                                              \
        row(key, x, y, z, count, out);                                                             \
        for (int at = 0; at < count; at++) {                                                       \
            out[at] = draw(out[at], i);                                                            \
        }                                                                                          \
    }
COMPONENT_ROW(gradient2_row1, scarp_row2, component_hash2, 1)
COMPONENT_ROW(gradient3_row1, scarp_row3, component_hash3, 1)
COMPONENT_ROW(gradient3_row2, scarp_row3, component_hash3, 2)
COMPONENT_ROW(value2_row1, scarp_row2, component_hash_values, 1)
COMPONENT_ROW(value3_row1, scarp_row3, component_hash_values, 1)
COMPONENT_ROW(value3_row2, scarp_row3, component_hash_values, 2)
#undef COMPONENT_ROW

static const struct hash component_hashes[] = {
    {"component 1 of gradients", gradient2_row1, gradient3_row1},
    {"component 2 of gradients", gradient2_row1, gradient3_row2},
    {"component 1 of values", value2_row1, value3_row1},
    {"component 2 of values", value2_row1, value3_row2},
};

#endif
