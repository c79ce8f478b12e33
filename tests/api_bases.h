/* SPDX-License-Identifier: MIT
 *
 * What only some bases have or look at: a phase, periods, the fade, the jitter. Part of
 * tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_BASES_H
#define SCARP_TESTS_API_BASES_H

#include "api_names.h"

struct bases_test {
    const struct inputs *in;
    size_t points;
    const struct outputs *one, *two;
};

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

/* Whether two noises give the same bits in all outputs of a function. */
static inline int bases_alike(const struct bases_test *t, enum function f,
                              const struct scarp_noise *a, const struct scarp_noise *b)
{
    int member;
    size_t index;
    const unsigned mask = function_outputs(f);
    const struct scarp_samples to_a = outputs_subset(t->one, mask);
    const struct scarp_samples to_b = outputs_subset(t->two, mask);
    CHECK(function_call(f, a, t->points, t->in, &to_a) == SCARP_OK, "%s", function_names[f]);
    CHECK(function_call(f, b, t->points, t->in, &to_b) == SCARP_OK, "%s", function_names[f]);
    return outputs_equal(t->one, t->two, mask, t->points, &member, &index);
}

/* The fade is for bases that blend corners, the jitter for cells. */
static inline void test_ignored(const struct bases_test *t)
{
    for (int i = 0; i < FUNCTIONS * count_names(basis_name); i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i / FUNCTIONS),
                                          .octaves = 2.0f};
        const char *const name = basis_name((int)noise.basis);
        struct scarp_noise faded = noise, strayed = noise;
        faded.fade = SCARP_CUBIC;
        CHECK(bases_alike(t, f, &noise, &faded) == !blends_corners(noise.basis), "%s: fade", name);
        strayed.jitter = 0.5f;
        CHECK(bases_alike(t, f, &noise, &strayed) == (noise.basis <= SCARP_SIMPLEX), "%s: jitter",
              name);
        strayed.jitter = 1.0f;
        CHECK(bases_alike(t, f, &noise, &strayed), "%s: 1 is not the default jitter", name);
    }
}

/* 2D calls refuse derivatives along z, and noise of other bases than gradients that by the phase.
 */
static inline void test_unsupported(const struct bases_test *t)
{
    const int bases = count_names(basis_name) - 1;
    for (int i = 0; i < OUTPUTS * bases; i++) {
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(SCARP_VALUE + i % bases)};
        const int m = i / bases;
        if ((OUTPUTS_ALL2 >> m & 1) == 0) {
            outputs_poison(t->one);
            const struct scarp_samples alone = outputs_subset(t->one, 1u << m);
            const struct scarp_samples more = outputs_subset(t->one, 1u << m | OUTPUTS_ALL2);
            CHECK(function_call(SAMPLE2, &noise, t->points, t->in, &alone) ==
                      SCARP_ERROR_UNSUPPORTED,
                  "%s", output_names[m]);
            CHECK(function_call(SAMPLE2, &noise, t->points, t->in, &more) ==
                      SCARP_ERROR_UNSUPPORTED,
                  "%s", output_names[m]);
            CHECK(function_call(SAMPLE2_F64, &noise, t->points, t->in, &more) ==
                      SCARP_ERROR_UNSUPPORTED,
                  "%s", output_names[m]);
            CHECK(function_call(SAMPLE2, &noise, 0, t->in, &alone) == SCARP_OK, "count 0");
            CHECK(outputs_untouched(t->one, ~0u), "%s: outputs were written", output_names[m]);
        }
    }
}

static inline void test_bases(const struct inputs *in, size_t points, const struct outputs *one,
                              const struct outputs *two)
{
    const struct bases_test t = {in, points, one, two};
    test_basis_members();
    test_ignored(&t);
    test_unsupported(&t);
}

#endif
