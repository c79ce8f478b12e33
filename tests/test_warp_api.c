/* SPDX-License-Identifier: MIT
 *
 * Warps as arguments: which member is at fault, what is not supported, what a warp does not change,
 * and plans of noise with warps.
 */
#include "outputs.h"

#define POINTS 37

static const struct scarp_noise chain[5] = {
    {.seed = 5, .octaves = 2.0f, .warp = &chain[1]},
    {.seed = 4, .warp = &chain[2]},
    {.seed = 3, .warp = &chain[3]},
    {.seed = 2, .warp = &chain[4]},
    {.seed = 1},
};

static float f[3][POINTS];
static double d[3][POINTS];
static const struct inputs in = {{f[0], f[1], f[2]}, {d[0], d[1], d[2]}};
static struct outputs one, two;

/* Checks what all calls say of a noise, and that they write nothing if they refuse it. */
static void expect_status(const struct scarp_noise *noise, enum scarp_status wanted,
                          const char *what)
{
    static struct scarp_plan plan;
    const struct scarp_grid grid = {.step = {0.1, 0.1, 0.1}, .count = {5, 4, 1}};
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function function = (enum function)i;
        const int dimensions = function_dimensions(function);
        const struct scarp_samples out = outputs_subset(&one, 1);
        struct scarp_cells cells = {.f1 = one.array[OUTPUT_dx]};
        const char *member = "none";
        float lowest, highest;
        outputs_poison(&one);
        CHECK(function_call(function, noise, POINTS, &in, &out) == wanted, "%s: %s", what,
              function_names[i]);
        CHECK(grid_call(dimensions, noise, &grid, &out) == wanted, "%s: %dD grid", what,
              dimensions);
        CHECK(scarp_cells2(noise, POINTS, f[0], f[1], &cells) == wanted, "%s: cells", what);
        CHECK(scarp_range(noise, dimensions, &lowest, &highest) == wanted, "%s: range", what);
        CHECK(scarp_plan_make(noise, dimensions, &plan) == wanted, "%s: plan", what);
        CHECK(wanted == SCARP_OK || outputs_untouched(&one, ~0u), "%s: written", what);
        CHECK(scarp_noise_check(noise, dimensions, &member) == wanted, "%s: check", what);
        CHECK(wanted == SCARP_OK ? member == NULL
                                 : member != NULL && strncmp(member, "warp.", 5) == 0,
              "%s: %s is at fault", what, member != NULL ? member : "nothing");
    }
}

/* A warp at each depth with a fault of each kind; the status is that of the warp by itself. */
static void test_faults(void)
{
    const struct scarp_noise bad[] = {
        {.basis = (enum scarp_basis)99},
        {.fractal = (enum scarp_fractal)99},
        {.octaves = 40.0f},
        {.frequency = (double)NAN},
        {.amplitude = 0x1p25f},
        {.basis = SCARP_VALUE, .phase = 1.0f},
        {.rotate = 1, .octaves = 2.0f, .period = {1}},
        {.spare = {1}},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct scarp_noise levels[4];
        const enum scarp_status status = scarp_noise_check(&bad[i], 2, NULL);
        CHECK(status != SCARP_OK, "noise %zu is good", i);
        memcpy(levels, chain, sizeof levels);
        for (int depth = 1; depth <= 4; depth++) {
            for (int level = 0; level < depth; level++) {
                levels[level].warp = level == depth - 1 ? &bad[i] : &levels[level + 1];
            }
            expect_status(&levels[0], status, "a fault in a warp");
        }
    }
}

static void test_depths(void)
{
    const struct scarp_noise five = {.warp = &chain[0]};
    struct scarp_noise self = {.seed = 1}, pair[2] = {{.seed = 1}, {.seed = 2}};
    self.warp = &self;
    pair[0].warp = &pair[1];
    pair[1].warp = &pair[0];
    expect_status(&chain[0], SCARP_OK, "four warps");
    expect_status(&five, SCARP_ERROR_UNSUPPORTED, "five warps");
    expect_status(&self, SCARP_ERROR_UNSUPPORTED, "its own warp");
    expect_status(&pair[0], SCARP_ERROR_UNSUPPORTED, "a circle of two");
}

/* The member of the noise itself comes first. */
static void test_order(void)
{
    const struct scarp_noise bad = {.octaves = -1.0f};
    const struct scarp_noise both = {.rotate = 1, .octaves = 2.0f, .period = {3}, .warp = &bad};
    const char *member = NULL;
    CHECK(scarp_noise_check(&both, 2, &member) == SCARP_ERROR_UNSUPPORTED && member != NULL &&
              strcmp(member, "rotate") == 0,
          "%s comes before rotate", member != NULL ? member : "nothing");
}

/* Derivatives that a warp does not have, at any depth, the noise has not. */
static void test_orders(void)
{
    for (int i = 0; i < 2 * SCARP_FRACTALS; i++) {
        const enum scarp_fractal fractal = (enum scarp_fractal)(i / 2);
        struct scarp_noise w[2] = {{.fractal = fractal}, {.warp = &w[0]}};
        const struct scarp_noise noise = {.warp = &w[i % 2]};
        const int order = fractal_has(fractal, FRACTAL_SLOPES) ? 1 : 2;
        for (int m = 0; m < OUTPUTS; m++) {
            const unsigned mask = 1u << m;
            const struct scarp_samples out = outputs_subset(&one, mask);
            const enum scarp_status wanted =
                output_kinds[m].order > order ? SCARP_ERROR_UNSUPPORTED : SCARP_OK;
            outputs_poison(&one);
            CHECK(scarp_sample3(&noise, POINTS, f[0], f[1], f[2], &out) == wanted, "%s, %s",
                  fractal_name((int)fractal), output_names[m]);
            CHECK(outputs_untouched(&one, wanted == SCARP_OK ? ~mask : ~0u), "%s: written",
                  output_names[m]);
        }
    }
    const struct scarp_noise value = {.basis = SCARP_VALUE}, flows = {.warp = &value};
    const struct scarp_noise still = {.basis = SCARP_VALUE, .warp = &chain[4]};
    const struct scarp_samples dphase = outputs_subset(&one, OUTPUTS_PHASE);
    CHECK(scarp_sample2(&flows, POINTS, f[0], f[1], &dphase) == SCARP_OK, "dphase of the noise");
    CHECK(scarp_sample2(&still, POINTS, f[0], f[1], &dphase) == SCARP_ERROR_UNSUPPORTED,
          "dphase of the warp alone");
}

/* Ranges and cells are those without the warp. */
static void test_unchanged(void)
{
    for (int i = 0; i < count_names(fractal_name) * 2; i++) {
        struct scarp_noise noise = {.fractal = (enum scarp_fractal)(i / 2),
                                    .amplitude = -3.0f,
                                    .phase = i % 2 == 0 ? 0.0f : 0.4f,
                                    .frequency = 0.7};
        float range[4];
        const struct scarp_cells plain = {.f1 = one.array[0], .dx1 = one.array[1]};
        const struct scarp_cells warped = {.f1 = two.array[0], .dx1 = two.array[1]};
        scarp_range(&noise, 2, &range[0], &range[1]);
        CHECK(scarp_cells2(&noise, POINTS, f[0], f[1], &plain) == SCARP_OK, "cells");
        noise.warp = &chain[1];
        CHECK(scarp_range(&noise, 2, &range[2], &range[3]) == SCARP_OK, "range");
        CHECK(range[0] == range[2] && range[1] == range[3], "fractal %d: another range", i / 2);
        CHECK(scarp_cells2(&noise, POINTS, f[0], f[1], &warped) == SCARP_OK, "cells");
        CHECK(first_difference(one.array[0], two.array[0], POINTS) == POINTS &&
                  first_difference(one.array[1], two.array[1], POINTS) == POINTS,
              "a warp changes cells");
    }
}

/* A plan of noise with a warp changes nothing, also when the warp changes, or goes. */
static void test_plans(void)
{
    static struct scarp_plan plan;
    for (int i = 0; i < FUNCTIONS * 3; i++) {
        const enum function function = (enum function)(i / 3);
        struct scarp_noise w = {.seed = 7, .octaves = 2.0f};
        struct scarp_noise noise = {.seed = 8, .octaves = 3.0f, .phase = 0.2f, .warp = &w};
        CHECK(scarp_plan_make(&noise, function_dimensions(function), &plan) == SCARP_OK, "plan");
        struct scarp_noise with = noise;
        with.plan = &plan;
        if (i % 3 == 1) {
            w.seed = 9;
            w.amplitude = 0.25f;
        } else if (i % 3 == 2) {
            noise.warp = with.warp = NULL;
        }
        const unsigned mask = outputs_of(&noise, function);
        const struct scarp_samples out[2] = {outputs_subset(&one, mask),
                                             outputs_subset(&two, mask)};
        int member = 0;
        size_t index = 0;
        CHECK(function_call(function, &noise, POINTS, &in, &out[0]) == SCARP_OK, "without");
        CHECK(function_call(function, &with, POINTS, &in, &out[1]) == SCARP_OK, "with the plan");
        CHECK(outputs_equal(&one, &two, mask, POINTS, &member, &index), "%s, change %d: %s[%zu]",
              function_names[function], i % 3, output_names[member], index);
    }
}

/* A warp does move all points. */
static void test_moved(void)
{
    const struct scarp_noise w = {.seed = 7, .octaves = 2.0f};
    struct scarp_noise noise = {.seed = 8};
    const struct scarp_samples out = outputs_subset(&one, 1), warped = outputs_subset(&two, 1);
    CHECK(scarp_sample2(&noise, POINTS, f[0], f[1], &out) == SCARP_OK, "plain");
    noise.warp = &w;
    CHECK(scarp_sample2(&noise, POINTS, f[0], f[1], &warped) == SCARP_OK, "warped");
    int same = 0;
    for (int i = 0; i < POINTS; i++) {
        same += one.array[0][i] == two.array[0][i];
    }
    CHECK(same == 0, "%d points are where they were", same);
}

int main(void)
{
    uint64_t random = 1;
    for (int i = 0; i < 3 * POINTS; i++) {
        f[i % 3][i / 3] = check_random_float(&random, 64.0f);
        d[i % 3][i / 3] = check_random_double(&random, 64.0);
    }
    one = outputs_make(64);
    two = outputs_make(64);
    test_faults();
    test_depths();
    test_order();
    test_orders();
    test_unchanged();
    test_plans();
    test_moved();
    outputs_free(&one);
    outputs_free(&two);
    return check_done();
}
