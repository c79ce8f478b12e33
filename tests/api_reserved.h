/* SPDX-License-Identifier: MIT
 *
 * Reserved members of the structures: every bit of them in every call that takes the structure, and
 * the places of members, which programs and bindings rely on. Part of tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_RESERVED_H
#define SCARP_TESTS_API_RESERVED_H

#include <stddef.h>

#include "outputs.h"

struct reserved_test {
    const struct inputs *in;
    size_t points;
    const struct outputs *one, *two;
};

/* The sample calls, then scarp_grid2 and scarp_grid3 */
#define RESERVED_CALLS (FUNCTIONS + 2)

/* The arguments of a call: all zero except the grid's counts and the outputs. */
struct reserved_arguments {
    struct scarp_noise noise;
    struct scarp_grid grid;
    struct scarp_samples out;
};

static inline struct reserved_arguments reserved_arguments(const struct reserved_test *t, int call)
{
    const int plane =
        call < FUNCTIONS ? function_dimensions((enum function)call) == 2 : call == FUNCTIONS;
    const struct reserved_arguments a = {
        .grid = {.count = {t->points, 1, 1}},
        .out = outputs_subset(t->one, plane ? OUTPUTS_ALL2 : OUTPUTS_ALL3)};
    return a;
}

static inline enum scarp_status reserved_call(const struct reserved_test *t, int call,
                                              const struct reserved_arguments *a)
{
    if (call < FUNCTIONS) {
        return function_call((enum function)call, &a->noise, t->points, t->in, &a->out);
    }
    return grid_call(call == FUNCTIONS ? 2 : 3, &a->noise, &a->grid, &a->out);
}

/* Checks the sizes and offsets, written down as a binding would have them. */
static inline void test_reserved_layout(void)
{
    const size_t pointer = sizeof(void *), size = sizeof(size_t);
    const size_t noise[][2] = {
        {sizeof(struct scarp_noise), 192},
        {offsetof(struct scarp_noise, basis), 0},
        {offsetof(struct scarp_noise, fade), 4},
        {offsetof(struct scarp_noise, fractal), 8},
        {offsetof(struct scarp_noise, rotate), 12},
        {offsetof(struct scarp_noise, seed), 16},
        {offsetof(struct scarp_noise, frequency), 24},
        {offsetof(struct scarp_noise, octaves), 32},
        {offsetof(struct scarp_noise, lacunarity), 36},
        {offsetof(struct scarp_noise, gain), 40},
        {offsetof(struct scarp_noise, amplitude), 44},
        {offsetof(struct scarp_noise, erosion), 48},
        {offsetof(struct scarp_noise, phase), 52},
        {offsetof(struct scarp_noise, jitter), 56},
        {offsetof(struct scarp_noise, sharpness), 60},
        {offsetof(struct scarp_noise, period), 64},
        {offsetof(struct scarp_noise, of_octaves), 76},
        {offsetof(struct scarp_noise, warp), 80},
        {offsetof(struct scarp_noise, plan), 80 + pointer},
        {offsetof(struct scarp_noise, offset_first), 80 + 2 * pointer},
        {offsetof(struct scarp_noise, spare_word), 84 + 2 * pointer},
        {offsetof(struct scarp_noise, spare), 88 + 2 * pointer},
        {sizeof(struct scarp_plan), 12288},
        {offsetof(struct scarp_samples, dphase), 10 * pointer},
        {offsetof(struct scarp_samples, spare), 11 * pointer},
        {sizeof(struct scarp_samples), 16 * pointer},
        {offsetof(struct scarp_grid, step), 24},
        {offsetof(struct scarp_grid, first), 48},
        {offsetof(struct scarp_grid, count), 72},
        {offsetof(struct scarp_grid, row_stride), 72 + 3 * size},
        {offsetof(struct scarp_grid, slice_stride), 72 + 4 * size},
        {offsetof(struct scarp_grid, spare), 72 + 5 * size},
        {sizeof(struct scarp_grid), 192},
    };
    for (size_t i = 0; i < sizeof noise / sizeof noise[0]; i++) {
        CHECK(noise[i][0] == noise[i][1], "size or offset %zu: %zu, not %zu", i, noise[i][0],
              noise[i][1]);
    }
}

/* Checks that every call refuses the noise, blames `spare` and writes nothing. */
static inline void expect_reserved(const struct reserved_test *t, const struct scarp_noise *noise,
                                   const char *what)
{
    for (int call = 0; call < RESERVED_CALLS; call++) {
        struct reserved_arguments a = reserved_arguments(t, call);
        a.noise = *noise;
        const enum scarp_status status = reserved_call(t, call, &a);
        CHECK(status == SCARP_ERROR_UNSUPPORTED, "%s, call %d: %s", what, call,
              scarp_status_text(status));
    }
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        float bounds[2] = {7.0f, 8.0f};
        const char *found = NULL;
        CHECK(scarp_range(noise, dimensions, &bounds[0], &bounds[1]) == SCARP_ERROR_UNSUPPORTED,
              "%s: scarp_range", what);
        CHECK(bounds[0] == 7.0f && bounds[1] == 8.0f, "%s: scarp_range wrote", what);
        CHECK(scarp_noise_check(noise, dimensions, &found) == SCARP_ERROR_UNSUPPORTED,
              "%s: scarp_noise_check", what);
        CHECK(found != NULL && strcmp(found, "spare") == 0, "%s: %s is said to be at fault", what,
              found != NULL ? found : "nothing");
    }
    CHECK(outputs_untouched(t->one, ~0u), "%s: outputs were written", what);
}

/* Sets every reserved bit. */
static inline void test_reserved_noise_bits(const struct reserved_test *t)
{
    outputs_poison(t->one);
    for (size_t bit = 8 * offsetof(struct scarp_noise, spare_word);
         bit < 8 * sizeof(struct scarp_noise); bit++) {
        unsigned char bytes[sizeof(struct scarp_noise)] = {0};
        struct scarp_noise noise;
        char what[64];
        bytes[bit / 8] = (unsigned char)(1u << bit % 8);
        memcpy(&noise, bytes, sizeof noise);
        snprintf(what, sizeof what, "bit %zu of byte %zu of struct scarp_noise", bit % 8, bit / 8);
        expect_reserved(t, &noise, what);
    }
}

static inline void test_reserved_negative_zeros(const struct reserved_test *t)
{
    for (int call = 0; call < RESERVED_CALLS; call++) {
        struct reserved_arguments a = reserved_arguments(t, call);
        const int mask = call == SAMPLE3 || call == SAMPLE3_F64 || call == FUNCTIONS + 1
                             ? OUTPUTS_ALL3
                             : OUTPUTS_ALL2;
        int member = 0;
        size_t index = 0;
        CHECK(reserved_call(t, call, &a) == SCARP_OK, "call %d", call);
        a.noise.phase = a.noise.jitter = a.noise.sharpness = a.noise.of_octaves = -0.0f;
        a.out = outputs_subset(t->two, (unsigned)mask);
        CHECK(reserved_call(t, call, &a) == SCARP_OK, "call %d: -0 is not 0", call);
        CHECK(outputs_equal(t->one, t->two, (unsigned)mask, t->points, &member, &index),
              "call %d: -0 changes %s[%zu]", call, output_names[member], index);
    }
}

/* Sets every bit of the bytes [interval[0], interval[1]) of the structure at the offset `part` of
   the arguments. */
static inline void test_reserved_part(const struct reserved_test *t, const char *what, int first,
                                      size_t part, const size_t interval[2])
{
    outputs_poison(t->one);
    CHECK(interval[0] + 8 <= interval[1], "%s has no spare bytes", what);
    for (size_t bit = 8 * interval[0]; bit < 8 * interval[1]; bit++) {
        for (int call = first; call < RESERVED_CALLS; call++) {
            struct reserved_arguments a = reserved_arguments(t, call);
            ((unsigned char *)&a)[part + bit / 8] = (unsigned char)(1u << bit % 8);
            const enum scarp_status status = reserved_call(t, call, &a);
            CHECK(status == SCARP_ERROR_UNSUPPORTED, "bit %zu of byte %zu of %s, call %d: %s",
                  bit % 8, bit / 8, what, call, scarp_status_text(status));
        }
    }
    CHECK(outputs_untouched(t->one, ~0u), "%s: outputs were written", what);
}

/* A call for no points succeeds whatever the noise and the reserved members hold. */
static inline void test_reserved_order(const struct reserved_test *t)
{
    for (int call = 0; call < RESERVED_CALLS; call++) {
        const struct reserved_test none = {t->in, 0, t->one, t->two};
        struct reserved_arguments a = reserved_arguments(&none, call);
        memset(&a.noise, 0xff, sizeof a.noise);
        memset(a.grid.spare, 0xff, sizeof a.grid.spare);
        a.out.spare[0] = t->one->array[0];
        CHECK(reserved_call(&none, call, &a) == SCARP_OK, "call %d: count 0", call);
    }
}

static inline void test_reserved(const struct inputs *in, size_t points, const struct outputs *one,
                                 const struct outputs *two)
{
    const struct reserved_test t = {in, points, one, two};
    const size_t samples[2] = {offsetof(struct scarp_samples, spare), sizeof(struct scarp_samples)};
    const size_t grid[2] = {offsetof(struct scarp_grid, spare), sizeof(struct scarp_grid)};
    test_reserved_layout();
    test_reserved_noise_bits(&t);
    test_reserved_negative_zeros(&t);
    test_reserved_part(&t, "struct scarp_samples", 0, offsetof(struct reserved_arguments, out),
                       samples);
    test_reserved_part(&t, "struct scarp_grid", FUNCTIONS,
                       offsetof(struct reserved_arguments, grid), grid);
    test_reserved_order(&t);
}

#endif
