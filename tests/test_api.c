/* SPDX-License-Identifier: MIT
 *
 * The promises of scarp.h about arguments: errors, defaults, subsets of outputs, seeds. Intervals,
 * reserved members, fractals, normals, names and the choice of instruction set are in api_*.h.
 *
 *     test_api ISA
 */
#include <errno.h>
#include <limits.h>

#include "api_bases.h"
#include "api_fractal.h"
#include "api_intervals.h"
#include "api_isa.h"
#include "api_names.h"
#include "api_normals.h"
#include "api_points.h"
#include "api_reserved.h"
#include "chain.h"

/* With all members at the ends of their intervals, no output overflows. */
static void test_extremes(void)
{
    for (int i = 0; i < 256; i++) {
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i & 1),
                                          .fade = (enum scarp_fade)(i >> 1 & 1),
                                          .fractal = (enum scarp_fractal)(i >> 5 & 3),
                                          .erosion = (i >> 7 & 1) != 0 ? 0x1p24f : 0x1p-24f,
                                          .rotate = (uint32_t)(i >> 2 & 1),
                                          .frequency = 0x1p48,
                                          .octaves = (i >> 3 & 1) != 0 ? 32.0f : 1.0f,
                                          .lacunarity = 1.0f,
                                          .gain = (i >> 4 & 1) != 0 ? 16.0f : 0.0625f,
                                          .amplitude = -0x1p24f};
        char what[32];
        snprintf(what, sizeof what, "extremes, case %d", i);
        expect_accepted(&noise, what);
    }
}

static void test_enumerators(void)
{
    static const int unknown[] = {2, 3, 64, 1000, 65536, INT_MAX, -1, -2, INT_MIN};
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        struct scarp_noise noise = {.basis = (enum scarp_basis)unknown[i]};
        char what[64];
        snprintf(what, sizeof what, "basis %d", unknown[i]);
        if (basis_name(unknown[i]) == NULL) {
            expect_refused(&noise, SCARP_ERROR_ENUM, "basis", what);
        }
        noise = (struct scarp_noise){.fade = (enum scarp_fade)unknown[i]};
        snprintf(what, sizeof what, "fade %d", unknown[i]);
        expect_refused(&noise, SCARP_ERROR_ENUM, "fade", what);
        if (fractal_name(unknown[i]) == NULL) {
            noise = (struct scarp_noise){.fractal = (enum scarp_fractal)unknown[i]};
            snprintf(what, sizeof what, "fractal %d", unknown[i]);
            expect_refused(&noise, SCARP_ERROR_ENUM, "fractal", what);
        }
    }
}

static void test_null(void)
{
    static const struct scarp_noise noise = {0};
    static const struct inputs none = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
    outputs_poison(&out_one);
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const struct scarp_samples out = outputs_subset(&out_one, function_outputs(f));
        const struct scarp_samples nothing = {0};
        CHECK(function_call(f, NULL, POINTS, &places, &out) == SCARP_ERROR_NULL, "%s: noise",
              function_names[f]);
        CHECK(function_call(f, &noise, POINTS, &places, NULL) == SCARP_ERROR_NULL, "%s: out",
              function_names[f]);
        CHECK(function_call(f, &noise, 1, &none, &out) == SCARP_ERROR_NULL, "%s: all inputs",
              function_names[f]);
        for (int d = 0; d < function_dimensions(f); d++) {
            struct inputs some = places;
            some.f[d] = NULL;
            some.d[d] = NULL;
            CHECK(function_call(f, &noise, POINTS, &some, &out) == SCARP_ERROR_NULL, "%s: input %d",
                  function_names[f], d);
        }
        CHECK(function_call(f, NULL, 0, &none, NULL) == SCARP_OK, "%s: count 0", function_names[f]);
        CHECK(function_call(f, &noise, POINTS, &places, &nothing) == SCARP_OK, "%s: no output",
              function_names[f]);
    }
    CHECK(outputs_untouched(&out_one, ~0u), "outputs were written");
    float bound = 7.0f;
    CHECK(scarp_range(NULL, 2, &bound, &bound) == SCARP_ERROR_NULL, "noise");
    CHECK(scarp_range(&noise, 2, NULL, &bound) == SCARP_ERROR_NULL, "lowest");
    CHECK(scarp_range(&noise, 2, &bound, NULL) == SCARP_ERROR_NULL, "highest");
    CHECK(bound == 7.0f, "a bound was written");
}

static void test_size(void)
{
    static const struct scarp_noise noise = {0};
    outputs_poison(&out_one);
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const size_t bytes = function_doubles(f) ? sizeof(double) : sizeof(float);
        const size_t counts[] = {(size_t)PTRDIFF_MAX / bytes + 1,
                                 SIZE_MAX / bytes,
                                 SIZE_MAX / bytes + 1,
                                 SIZE_MAX / 2,
                                 SIZE_MAX - 15,
                                 SIZE_MAX};
        const struct scarp_samples out = outputs_subset(&out_one, function_outputs(f));
        for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
            CHECK(function_call(f, &noise, counts[c], &places, &out) == SCARP_ERROR_SIZE,
                  "%s: count %zu", function_names[f], counts[c]);
        }
    }
    CHECK(outputs_untouched(&out_one, ~0u), "outputs were written");
}

/* Whether two noises give the same bits in all outputs of all functions. */
static int same_bits(const struct scarp_noise *a, const struct scarp_noise *b)
{
    int same = 1, member;
    size_t index;
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const unsigned mask = function_outputs(f);
        const struct scarp_samples out_a = outputs_subset(&out_one, mask);
        const struct scarp_samples out_b = outputs_subset(&out_two, mask);
        CHECK(function_call(f, a, POINTS, &places, &out_a) == SCARP_OK, "%s", function_names[f]);
        CHECK(function_call(f, b, POINTS, &places, &out_b) == SCARP_OK, "%s", function_names[f]);
        same &= outputs_equal(&out_one, &out_two, mask, POINTS, &member, &index);
    }
    return same;
}

static void test_defaults(void)
{
    static const struct scarp_noise explicit_defaults = {.basis = SCARP_GRADIENT,
                                                         .fade = SCARP_QUINTIC,
                                                         .fractal = SCARP_FBM,
                                                         .frequency = 1.0,
                                                         .octaves = 1.0f,
                                                         .lacunarity = 2.0f,
                                                         .gain = 0.5f,
                                                         .amplitude = 1.0f};
    struct scarp_noise zeroed, written = explicit_defaults;
    memset(&zeroed, 0, sizeof zeroed);
    CHECK(same_bits(&zeroed, &written), "one octave");
    zeroed.octaves = written.octaves = 5.5f;
    CHECK(same_bits(&zeroed, &written), "several octaves");
    zeroed.frequency = -0.0;
    zeroed.lacunarity = zeroed.gain = zeroed.amplitude = -0.0f;
    CHECK(same_bits(&zeroed, &written), "negative zeros");
    zeroed.rotate = 1;
    CHECK(!same_bits(&zeroed, &written), "rotate does nothing");
    for (int bit = 0; bit < 32; bit++) {
        written.rotate = UINT32_C(1) << bit;
        CHECK(same_bits(&zeroed, &written), "rotate = 1 << %d", bit);
    }
}

static void test_subsets(void)
{
    const int bases = count_names(basis_name);
    for (int i = 0; i < 2 * bases * FUNCTIONS; i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        const int many = i / FUNCTIONS / bases;
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i / FUNCTIONS % bases),
                                          .octaves = many ? 3.25f : 0.0f,
                                          .rotate = (uint32_t)many,
                                          .seed = 99};
        expect_subsets(f, &noise, function_outputs(f));
    }
}

static void test_range(void)
{
    static const float amplitudes[] = {0.0f, 1.0f, -1.0f, 0.1f, -3.5f, 0x1p24f, -0x1p24f, 0x1p-24f};
    for (size_t i = 0; i < sizeof amplitudes / sizeof amplitudes[0]; i++) {
        const struct scarp_noise noise = {.amplitude = amplitudes[i], .octaves = 3.0f};
        const float expected = amplitudes[i] == 0.0f ? 1.0f : fabsf(amplitudes[i]);
        for (int dimensions = 2; dimensions <= 3; dimensions++) {
            float lowest = 0.0f, highest = 0.0f;
            CHECK(scarp_range(&noise, dimensions, &lowest, &highest) == SCARP_OK, "range");
            CHECK(lowest == -expected && highest == expected, "amplitude %a: [%a, %a]",
                  (double)amplitudes[i], (double)lowest, (double)highest);
        }
    }
    static const int wrong[] = {0, 1, 4, -2, -3, 258, INT_MAX, INT_MIN};
    static const struct scarp_noise noise = {0};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        float bounds[2] = {7.0f, 8.0f};
        CHECK(scarp_range(&noise, wrong[i], &bounds[0], &bounds[1]) == SCARP_ERROR_PARAMETER,
              "%d dimensions", wrong[i]);
        CHECK(bounds[0] == 7.0f && bounds[1] == 8.0f, "%d dimensions: wrote", wrong[i]);
    }
}

/* Most values differ between the seeds: equal ones can only be chance. */
static void expect_other_field(uint64_t a, uint64_t b)
{
    /* One basis for each kind of draws. */
    static const enum scarp_basis bases[] = {SCARP_GRADIENT, SCARP_VALUE, SCARP_SIMPLEX,
                                             SCARP_CELL_F1};
    for (int i = 0; i < 4 * FUNCTIONS; i++) {
        const enum function f = (enum function)(i / 4);
        const struct scarp_noise noise_a = {.basis = bases[i % 4], .seed = a};
        const struct scarp_noise noise_b = {.basis = bases[i % 4], .seed = b};
        const struct scarp_samples out_a = outputs_subset(&out_one, 1);
        const struct scarp_samples out_b = outputs_subset(&out_two, 1);
        CHECK(function_call(f, &noise_a, POINTS, &places, &out_a) == SCARP_OK, "seed");
        CHECK(function_call(f, &noise_b, POINTS, &places, &out_b) == SCARP_OK, "seed");
        int equal = 0;
        for (int p = 0; p < POINTS; p++) {
            equal += float_bits(out_one.array[0] + p) == float_bits(out_two.array[0] + p);
        }
        /* One vertex of a triangle is all that counts in the middle of its reach. */
        CHECK(equal <= (noise_a.basis == SCARP_SIMPLEX ? 8 : 2),
              "%s: %d of %d values of seeds %#llx and %#llx are equal", function_names[f], equal,
              POINTS, (unsigned long long)a, (unsigned long long)b);
    }
}

static void test_seeds(void)
{
    uint64_t state = 2;
    for (int i = 0; i < 8; i++) {
        const uint64_t s = i == 0 ? 0 : i == 1 ? UINT64_MAX : check_random(&state);
        expect_other_field(s, s + 1);
        expect_other_field(s, s + (UINT64_C(1) << 32));
        expect_other_field(s, ~s);
        for (int bit = 0; bit < 64; bit++) {
            expect_other_field(s, s ^ UINT64_C(1) << bit);
        }
    }
}

/* No call changes errno, not even where it takes square roots of NaN or converts it. */
static void test_errno(void)
{
    static const float odd[4] = {NAN, INFINITY, -3e38f, 1e-45f};
    static const double odd64[4] = {(double)NAN, (double)-INFINITY, 1e308, 1e-320};
    const struct inputs points = {{odd, odd, odd}, {odd64, odd64, odd64}};
    const struct scarp_noise valid = {0}, invalid = {.octaves = -1.0f};
    errno = 12345;
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const struct scarp_samples out = outputs_subset(&out_one, function_outputs(f));
        const enum scarp_status good = function_call(f, &valid, 4, &points, &out);
        const enum scarp_status bad = function_call(f, &invalid, 4, &points, &out);
        CHECK(good == SCARP_OK && bad == SCARP_ERROR_PARAMETER && errno == 12345, "errno is %d",
              errno);
    }
    const enum scarp_status status =
        scarp_normals(4, odd, odd, -3e38f, out_one.array[0], out_one.array[1], out_one.array[2]);
    CHECK(status == SCARP_OK && errno == 12345, "errno is %d", errno);
    const struct scarp_samples out = outputs_subset(&out_one, OUTPUTS_ALL3);
    float *const x[3] = {out_two.array[0], out_two.array[1], out_two.array[2]};
    for (int i = 0; i < 3; i++) {
        memcpy(x[i], odd, sizeof odd);
    }
    for (int f = 0; f < CHAINS; f++) {
        CHECK(chain_call_arrays((enum chain)f, 4, x, &out) == SCARP_OK && errno == 12345,
              "errno is %d", errno);
    }
}

int main(int argc, char **argv)
{
    test_isa(); /* before anything has selected one */
    if (argc > 1) {
        check_select_isa(argv[1]);
    }
    make_inputs();
    test_intervals();
    test_narrow_intervals();
    test_last_frequency();
    test_extremes();
    test_enumerators();
    test_null();
    test_size();
    test_defaults();
    test_subsets();
    test_range();
    test_fractals();
    test_reserved(&places, POINTS, &out_one, &out_two);
    test_seeds();
    test_texts();
    test_names();
    test_check_order();
    test_bases();
    test_normals();
    test_errno();
    return check_done();
}
