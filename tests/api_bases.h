/* SPDX-License-Identifier: MIT
 *
 * What only some bases have or look at: a phase, periods, the fade, the jitter. Part of
 * tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_BASES_H
#define SCARP_TESTS_API_BASES_H

#include "api_names.h"
#include "api_points.h"

/* What only some bases have: a phase, and periods across the rows of 2D simplex noise. */
static inline void test_basis_members(void)
{
    for (int basis = 0; basis < count_names(basis_name); basis++) {
        const enum scarp_basis of = (enum scarp_basis)basis;
        const struct scarp_noise flowing = {.basis = of, .phase = 0x1p-149f};
        const struct scarp_noise across = {.basis = of, .period = {3, 5, 7}};
        for (int dimensions = 2; dimensions <= 3; dimensions++) {
            const int flows = of == SCARP_GRADIENT;
            const int repeats = of != SCARP_SIMPLEX || dimensions == 3;
            expect_member(&flowing, dimensions, flows ? SCARP_OK : SCARP_ERROR_UNSUPPORTED,
                          flows ? NULL : "phase");
            expect_member(&across, dimensions, repeats ? SCARP_OK : SCARP_ERROR_UNSUPPORTED,
                          repeats ? NULL : "period[1]");
        }
    }
    const struct scarp_noise along = {.basis = SCARP_SIMPLEX, .period = {7, 0, 0}};
    expect_member(&along, 2, SCARP_OK, NULL);
}

/* The fade is for bases that blend corners, the jitter for cells. */
static inline void test_ignored(void)
{
    for (int i = 0; i < FUNCTIONS * count_names(basis_name); i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i / FUNCTIONS),
                                          .octaves = 2.0f};
        const char *const name = basis_name((int)noise.basis);
        struct scarp_noise faded = noise, strayed = noise;
        faded.fade = SCARP_CUBIC;
        CHECK(are_alike(f, &noise, &faded, function_outputs(f)) == !blends_corners(noise.basis),
              "%s: fade", name);
        strayed.jitter = 0.5f;
        CHECK(are_alike(f, &noise, &strayed, function_outputs(f)) == (noise.basis <= SCARP_SIMPLEX),
              "%s: jitter", name);
        strayed.jitter = 1.0f;
        CHECK(are_alike(f, &noise, &strayed, function_outputs(f)),
              "%s: 1 is not the default jitter", name);
    }
}

/* 2D calls refuse derivatives along z, and noise of other bases than gradients that by the phase.
 */
static inline void test_unsupported(void)
{
    const int bases = count_names(basis_name) - 1;
    for (int i = 0; i < OUTPUTS * bases; i++) {
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(SCARP_VALUE + i % bases)};
        const int m = i / bases;
        if ((OUTPUTS_ALL2 >> m & 1) == 0) {
            outputs_poison(&out_one);
            const struct scarp_samples alone = outputs_subset(&out_one, 1u << m);
            const struct scarp_samples more = outputs_subset(&out_one, 1u << m | OUTPUTS_ALL2);
            CHECK(function_call(SAMPLE2, &noise, POINTS, &places, &alone) ==
                      SCARP_ERROR_UNSUPPORTED,
                  "%s", output_names[m]);
            CHECK(function_call(SAMPLE2, &noise, POINTS, &places, &more) == SCARP_ERROR_UNSUPPORTED,
                  "%s", output_names[m]);
            CHECK(function_call(SAMPLE2_F64, &noise, POINTS, &places, &more) ==
                      SCARP_ERROR_UNSUPPORTED,
                  "%s", output_names[m]);
            CHECK(function_call(SAMPLE2, &noise, 0, &places, &alone) == SCARP_OK, "count 0");
            CHECK(outputs_untouched(&out_one, ~0u), "%s: outputs were written", output_names[m]);
        }
    }
}

static inline void test_bases(void)
{
    test_basis_members();
    test_ignored();
    test_unsupported();
}

#endif
