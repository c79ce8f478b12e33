/* SPDX-License-Identifier: MIT
 *
 * The points of tests/test_api.c, and two sets of outputs for them; and what calls for a noise are
 * expected to do there.
 */
#ifndef SCARP_TESTS_API_POINTS_H
#define SCARP_TESTS_API_POINTS_H

#include "api_names.h"
#include "outputs.h"

#define POINTS 37 /* two blocks of 16 and a tail */

static float xf[3][POINTS];
static double xd[3][POINTS];
static const struct inputs places = {{xf[0], xf[1], xf[2]}, {xd[0], xd[1], xd[2]}};
static struct outputs out_one, out_two;

static inline void make_inputs(void)
{
    uint64_t state = 1;
    for (int i = 0; i < POINTS; i++) {
        for (int d = 0; d < 3; d++) {
            xf[d][i] = check_random_float(&state, 64.0f);
            xd[d][i] = check_random_double(&state, 0x1p40);
        }
    }
    out_one = outputs_make(POINTS);
    out_two = outputs_make(POINTS);
}

/* Checks that every function refuses the noise with `expected`, that `member` is said to be at
   fault, and that nothing is written. */
static inline void expect_refused(const struct scarp_noise *noise, enum scarp_status expected,
                                  const char *member, const char *what)
{
    const int known =
        basis_name((int)noise->basis) != NULL && fractal_name((int)noise->fractal) != NULL;
    outputs_poison(&out_one);
    for (int f = 0; f < FUNCTIONS; f++) {
        const unsigned wanted = known ? outputs_of(noise, (enum function)f)
                                      : outputs_up_to(1, function_dimensions((enum function)f));
        const struct scarp_samples out = outputs_subset(&out_one, wanted);
        const enum scarp_status status =
            function_call((enum function)f, noise, POINTS, &places, &out);
        CHECK(status == expected, "%s, %s: %s", function_names[f], what, scarp_status_text(status));
        CHECK(function_call((enum function)f, noise, 0, &places, &out) == SCARP_OK,
              "%s, %s: count 0 looks at nothing", function_names[f], what);
    }
    CHECK(outputs_untouched(&out_one, ~0u), "%s: outputs were written", what);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        float bounds[2] = {7.0f, 8.0f};
        const enum scarp_status status = scarp_range(noise, dimensions, &bounds[0], &bounds[1]);
        CHECK(status == expected, "scarp_range, %s: %s", what, scarp_status_text(status));
        CHECK(bounds[0] == 7.0f && bounds[1] == 8.0f, "scarp_range, %s: wrote", what);
        expect_member(noise, dimensions, expected, member);
    }
}

static inline void expect_accepted(const struct scarp_noise *noise, const char *what)
{
    for (int f = 0; f < FUNCTIONS; f++) {
        outputs_poison(&out_one);
        const unsigned mask = outputs_of(noise, (enum function)f);
        const struct scarp_samples out = outputs_subset(&out_one, mask);
        const enum scarp_status status =
            function_call((enum function)f, noise, POINTS, &places, &out);
        CHECK(status == SCARP_OK, "%s, %s: %s", function_names[f], what, scarp_status_text(status));
        for (int m = 0; m < OUTPUTS; m++) {
            for (int i = 0; i < POINTS && (mask >> m & 1) != 0; i++) {
                CHECK(is_finite_bits(out_one.array[m] + i), "%s, %s: %s is not finite",
                      function_names[f], what, output_names[m]);
            }
        }
    }
    float lowest, highest;
    CHECK(scarp_range(noise, 2, &lowest, &highest) == SCARP_OK, "scarp_range, %s", what);
    expect_member(noise, 2, SCARP_OK, NULL);
}

/* Whether two noises give the same bits in outputs of a function. */
static inline int are_alike(enum function f, const struct scarp_noise *a,
                            const struct scarp_noise *b, unsigned outputs)
{
    int member;
    size_t index;
    const struct scarp_samples to_a = outputs_subset(&out_one, outputs);
    const struct scarp_samples to_b = outputs_subset(&out_two, outputs);
    CHECK(function_call(f, a, POINTS, &places, &to_a) == SCARP_OK, "%s", function_names[f]);
    CHECK(function_call(f, b, POINTS, &places, &to_b) == SCARP_OK, "%s", function_names[f]);
    return outputs_equal(&out_one, &out_two, outputs, POINTS, &member, &index);
}

/* Any subset of `all` outputs gives the bits that all of them together give, and writes nothing else.
   A call for another noise comes between, so that leftovers on the stack cannot pass for results. */
static inline void expect_subsets(enum function f, const struct scarp_noise *noise, unsigned all)
{
    const struct scarp_noise other = {.octaves = 2.0f, .seed = 98};
    const struct scarp_samples together = outputs_subset(&out_two, all);
    CHECK(function_call(f, noise, POINTS, &places, &together) == SCARP_OK, "all outputs");
    for (unsigned mask = 0; mask <= all; mask++) {
        if ((mask & ~all) != 0) {
            continue;
        }
        int member = 0;
        size_t index = 0;
        const struct scarp_samples out = outputs_subset(&out_one, mask);
        const struct scarp_samples between = outputs_subset(&out_one, function_outputs(f));
        CHECK(function_call(f, &other, POINTS, &places, &between) == SCARP_OK, "another noise");
        outputs_poison(&out_one);
        CHECK(function_call(f, noise, POINTS, &places, &out) == SCARP_OK, "subset %#x", mask);
        CHECK(outputs_equal(&out_one, &out_two, mask, POINTS, &member, &index),
              "%s, fractal %d, subset %#x: %s[%zu] differs", function_names[f], (int)noise->fractal,
              mask, output_names[member], index);
        CHECK(outputs_untouched(&out_one, ~mask), "%s, fractal %d, subset %#x: others were written",
              function_names[f], (int)noise->fractal, mask);
    }
}

#endif
