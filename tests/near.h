/* SPDX-License-Identifier: MIT
 *
 * Outputs of a call as a list of arrays, each between two words where nothing may be written, and
 * the points of calls that exist in two and three dimensions, for floats and doubles. Before this is
 * included, POINTS is how many points there are, and MEMBERS how many arrays.
 */
#ifndef SCARP_TESTS_NEAR_H
#define SCARP_TESTS_NEAR_H

#include "check.h"

/* A call of 2 or 3 dimensions, with coordinates of floats or of doubles. */
struct call {
    int dimensions, doubles;
};

static const struct call calls[4] = {{2, 0}, {2, 1}, {3, 0}, {3, 1}};
#define CALLS 4

static float f32[3][POINTS];
static double f64[3][POINTS];

struct near {
    union {
        float f[POINTS + 2];
        uint32_t u[POINTS + 2];
    } of[MEMBERS];
};

#define POISON 0x7fa5a5a5u

static struct near here, there;

static inline void poison(struct near *n)
{
    for (int i = 0; i < MEMBERS * (POINTS + 2); i++) {
        n->of[i / (POINTS + 2)].u[i % (POINTS + 2)] = POISON;
    }
}

static inline float of(const struct near *n, int member, size_t i)
{
    return n->of[member].f[i + 1];
}

static inline uint32_t word_of(const struct near *n, int member, size_t i)
{
    return n->of[member].u[i + 1];
}

/* The bits, which are the same of all NaNs but the poison. */
static inline uint32_t bits_of(const struct near *n, int member, size_t i)
{
    const uint32_t bits = word_of(n, member, i);
    return isnan(of(n, member, i)) && bits != POISON ? 0x7fc00000u : bits;
}

/* The arrays of the members in `wanted`, from element `first` on; NULL for the others */
static inline void arrays_at(struct near *n, unsigned wanted, size_t first, float *at[MEMBERS])
{
    for (int m = 0; m < MEMBERS; m++) {
        at[m] = (wanted >> m & 1) != 0 ? n->of[m].f + 1 + first : NULL;
    }
}

static inline void draw_points(float span)
{
    uint64_t state = 5;
    for (int i = 0; i < 3 * POINTS; i++) {
        f32[i % 3][i / 3] = check_random_float(&state, span);
        f64[i % 3][i / 3] = (double)f32[i % 3][i / 3];
    }
}

/* FIND(c, noise, first, count, out, scarp_cells): calls scarp_cells2, scarp_cells3 or their _f64 for
   `count` points from `first` on. */
#define FIND(c, noise, first, count, out, call)                                                    \
    ((c).dimensions == 2                                                                           \
         ? (c).doubles ? call##2_f64(noise, count, f64[0] + (first), f64[1] + (first), out)        \
                       : call##2(noise, count, f32[0] + (first), f32[1] + (first), out)            \
     : (c).doubles                                                                                 \
         ? call##3_f64(noise, count, f64[0] + (first), f64[1] + (first), f64[2] + (first), out)    \
         : call##3(noise, count, f32[0] + (first), f32[1] + (first), f32[2] + (first), out))

/* Makes points of those that are nowhere, every fourth, and far ones. */
static inline void draw_special_points(int dimensions)
{
    static const double nowhere[] = {NAN, INFINITY, -INFINITY};
    static const double far[] = {0x1p24, -0x1p31, 0x1p31, -3e9, 1e30, -0.0, -1e-30};
    for (size_t i = 0; i < POINTS; i++) {
        const double special = i % 4 == 0 ? nowhere[i / 4 % 3] : far[i % 7];
        f64[i % (size_t)dimensions][i] = special;
        f32[i % (size_t)dimensions][i] = (float)special;
    }
}

#endif
