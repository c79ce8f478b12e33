/* SPDX-License-Identifier: MIT
 *
 * Turbulence, ridged and erosion as arguments: what erosion refuses, the default of its parameter,
 * subsets of outputs, ranges, octaves of longer sums. Part of tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_FRACTAL_H
#define SCARP_TESTS_API_FRACTAL_H

#include "api_points.h"

/* Erosion refuses each second derivative, alone and with all others; its own outputs work. */
static inline void test_fractal_unsupported(void)
{
    const struct scarp_noise erosion = {.fractal = SCARP_EROSION, .octaves = 2.0f};
    for (int i = 0; i < FUNCTIONS * OUTPUTS; i++) {
        const enum function f = (enum function)(i / OUTPUTS);
        const unsigned output = 1u << i % OUTPUTS, all = function_outputs(f) | OUTPUTS_PHASE;
        if ((output & all) == 0) {
            continue;
        }
        const int second = output_kinds[i % OUTPUTS].order == 2;
        const enum scarp_status expected = second ? SCARP_ERROR_UNSUPPORTED : SCARP_OK;
        const struct scarp_samples alone = outputs_subset(&out_one, output);
        const struct scarp_samples more =
            outputs_subset(&out_one, output | outputs_of(&erosion, f));
        outputs_poison(&out_one);
        CHECK(function_call(f, &erosion, POINTS, &places, &alone) == expected, "%s: %s",
              function_names[f], output_names[i % OUTPUTS]);
        CHECK(outputs_untouched(&out_one, second ? OUTPUTS_ALL3 : OUTPUTS_ALL3 & ~output),
              "%s: %s: outputs were written", function_names[f], output_names[i % OUTPUTS]);
        outputs_poison(&out_one);
        CHECK(function_call(f, &erosion, POINTS, &places, &more) == expected, "%s: %s and more",
              function_names[f], output_names[i % OUTPUTS]);
        CHECK(outputs_untouched(&out_one, second ? OUTPUTS_ALL3 : OUTPUTS_ALL3 & ~all),
              "%s: %s and more: outputs were written", function_names[f],
              output_names[i % OUTPUTS]);
        CHECK(function_call(f, &erosion, 0, &places, &alone) == SCARP_OK, "count 0");
    }
}

/* Whether two noises give the same bits in all outputs that both have. */
static inline int fractal_same_bits(const struct scarp_noise *a, const struct scarp_noise *b)
{
    int same = 1;
    for (enum function f = 0; f < FUNCTIONS; f++) {
        same &= are_alike(f, a, b, outputs_of(a, f) & outputs_of(b, f));
    }
    return same;
}

/* 0 and -0 mean the default of erosion, 1; other fractals do not use the parameter. */
static inline void test_fractal_parameter(void)
{
    for (int fractal = SCARP_FBM; fractal < count_names(fractal_name); fractal++) {
        const int used = fractal_row((enum scarp_fractal)fractal)->most_erosion != 0.0f;
        struct scarp_noise a = {.fractal = (enum scarp_fractal)fractal, .octaves = 3.0f}, b = a;
        b.erosion = 1.0f;
        CHECK(fractal_same_bits(&a, &b), "fractal %d: the default is not 1", fractal);
        a.erosion = -0.0f;
        CHECK(fractal_same_bits(&a, &b), "fractal %d: -0 is not the default", fractal);
        a.erosion = 0.5f;
        CHECK(fractal_same_bits(&a, &b) == !used, "fractal %d: erosion 1/2", fractal);
        for (int other = SCARP_FBM; other < fractal; other++) {
            b.fractal = (enum scarp_fractal)other;
            CHECK(!fractal_same_bits(&a, &b), "fractals %d and %d are the same", fractal, other);
        }
    }
}

/* 0 and -0 mean the default of the fractal; others do not use the sharpness. */
static inline void test_fractal_sharpness(void)
{
    for (int fractal = SCARP_FBM; fractal < count_names(fractal_name); fractal++) {
        const float standard = fractal_row((enum scarp_fractal)fractal)->sharpness;
        const int used = standard != 0.0f;
        struct scarp_noise a = {.fractal = (enum scarp_fractal)fractal, .octaves = 3.0f}, b = a;
        a.sharpness = -0.0f;
        b.sharpness = used ? standard : 2.0f;
        CHECK(fractal_same_bits(&a, &b), "fractal %d: another default", fractal);
        a.sharpness = 1.5f;
        CHECK(fractal_same_bits(&a, &b) == !used, "fractal %d: sharpness 1.5", fractal);
    }
}

static inline void test_fractal_subsets(void)
{
    for (int i = 0; i < 28 * FUNCTIONS; i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i / FUNCTIONS % 2),
                                          .fractal =
                                              (enum scarp_fractal)(1 + i / FUNCTIONS / 2 % 7),
                                          .octaves = 3.25f,
                                          .rotate = (uint32_t)(i / FUNCTIONS / 14),
                                          .seed = 99};
        expect_subsets(f, &noise, outputs_of(&noise, f));
    }
}

static inline void test_fractal_ranges(void)
{
    static const float amplitudes[] = {0.0f,  -0.0f,   1.0f,     -1.0f,    0.1f,
                                       -3.5f, 0x1p24f, -0x1p24f, 0x1p-24f, -0x1p-24f};
    for (size_t i = 0; i < 8 * (sizeof amplitudes / sizeof amplitudes[0]); i++) {
        const enum scarp_fractal fractal = (enum scarp_fractal)(SCARP_TURBULENCE + i / 2 % 4);
        const struct scarp_noise noise = {
            .fractal = fractal, .amplitude = amplitudes[i / 8], .octaves = 3.0f};
        const float a = amplitudes[i / 8] == 0.0f ? 1.0f : amplitudes[i / 8];
        const int both = fractal == SCARP_EROSION || fractal == SCARP_PINGPONG;
        float lowest = 7.0f, highest = -7.0f;
        CHECK(scarp_range(&noise, 2 + (int)(i % 2), &lowest, &highest) == SCARP_OK, "range");
        CHECK(lowest == (both       ? -fabsf(a)
                         : a < 0.0f ? a
                                    : 0.0f) &&
                  highest == (both       ? fabsf(a)
                              : a < 0.0f ? 0.0f
                                         : a),
              "fractal %d, amplitude %a: [%a, %a]", (int)fractal, (double)a, (double)lowest,
              (double)highest);
    }
}

/* The largest difference between two noises that have the same outputs. */
static inline double fractal_difference(const struct scarp_noise *a, const struct scarp_noise *b,
                                        enum function f, unsigned mask)
{
    const struct scarp_samples out_a = outputs_subset(&out_one, mask);
    const struct scarp_samples out_b = outputs_subset(&out_two, mask);
    double largest = 0.0;
    CHECK(function_call(f, a, POINTS, &places, &out_a) == SCARP_OK, "%s", function_names[f]);
    CHECK(function_call(f, b, POINTS, &places, &out_b) == SCARP_OK, "%s", function_names[f]);
    for (int m = 0; m < OUTPUTS; m++) {
        for (size_t i = 0; i < POINTS && (mask >> m & 1) != 0; i++) {
            const double difference =
                fabs((double)out_one.array[m][i] - (double)out_two.array[m][i]);
            if (!(difference <= largest)) { /* also a NaN (gcc 12 for AArch64 fails on fmax here) */
                largest = difference;
            }
        }
    }
    return largest;
}

/* Octaves of a longer sum have the bits that they have there, and fade in without a pop.
   test_fractal says which octaves they are. */
static inline void test_fractal_of_octaves(void)
{
    for (int i = 0; i < 2 * count_names(fractal_name); i++) {
        const struct scarp_noise whole = {.fractal = (enum scarp_fractal)(i / 2),
                                          .octaves = i % 2 == 0 ? 8.0f : 7.3f,
                                          .rotate = (uint32_t)i % 2,
                                          .gain = 0.7f,
                                          .seed = 5};
        struct scarp_noise a = whole, b = whole;
        b.of_octaves = whole.octaves;
        CHECK(fractal_same_bits(&a, &b), "fractal %d: %g of as many", i / 2, (double)whole.octaves);
        b.of_octaves = -0.0f;
        CHECK(fractal_same_bits(&a, &b), "fractal %d: -0 is not the default", i / 2);
        b.of_octaves = 8.5f;
        CHECK(!fractal_same_bits(&a, &b), "fractal %d: of_octaves is ignored", i / 2);
        for (int ends = 0; ends < 2; ends++) { /* of the octave that fades in */
            a.of_octaves = b.of_octaves = 8.0f;
            a.octaves = ends == 0 ? 3.0f : 4.0f;
            b.octaves = ends == 0 ? nextafterf(3.0f, 4.0f) : nextafterf(4.0f, 3.0f);
            for (int f = 0; f < FUNCTIONS; f++) {
                const double pop =
                    fractal_difference(&a, &b, (enum function)f,
                                       outputs_up_to(1, function_dimensions((enum function)f)));
                CHECK(pop <= 4e-5, "%s, fractal %d: a pop of %g", function_names[f], i / 2, pop);
            }
        }
    }
}

/* With a gain of 1, amplitudes of two octaves of four are halves of those of two: all bits are the
   same with half the amplitude. */
static inline void test_fractal_of_amplitudes(void)
{
    for (int i = 0; i < 3 * count_names(fractal_name); i++) {
        if (i / 3 == SCARP_HYBRID) {
            continue; /* whose octaves are less than those before, with any gain */
        }
        const struct scarp_noise a = {.fractal = (enum scarp_fractal)(i / 3),
                                      .octaves = (float)(1 << i % 3),
                                      .of_octaves = 8.0f,
                                      .gain = 1.0f,
                                      .amplitude = 3.0f};
        struct scarp_noise b = a;
        b.of_octaves = 0.0f;
        b.amplitude *= a.octaves / 8.0f;
        CHECK(fractal_same_bits(&a, &b), "fractal %d: %g of 8 octaves", i / 3, (double)a.octaves);
        float a_range[2], b_range[2];
        scarp_range(&a, 2, &a_range[0], &a_range[1]);
        b.octaves = 8.0f;
        b.amplitude = 3.0f;
        scarp_range(&b, 2, &b_range[0], &b_range[1]);
        CHECK(a_range[0] == b_range[0] && a_range[1] == b_range[1], "fractal %d: the range of %g",
              i / 3, (double)a.octaves);
    }
}

static inline void test_fractals(void)
{
    test_fractal_unsupported();
    test_fractal_parameter();
    test_fractal_sharpness();
    test_fractal_subsets();
    test_fractal_ranges();
    test_fractal_of_octaves();
    test_fractal_of_amplitudes();
}

#endif
