/* SPDX-License-Identifier: MIT
 *
 * Flow noise: whole turns change no bit, nothing jumps at phase 0, the derivative with respect to
 * the phase is that of the value, periods stay, seeds are strangers, and what is refused.
 *
 *     test_phase ISA
 */
#include "fractal.h"

#define POINTS 101

static struct outputs here, there;
static float f32[3][POINTS];
static double f64[3][POINTS];
static const struct inputs in = {{f32[0], f32[1], f32[2]}, {f64[0], f64[1], f64[2]}};

static void make_points(void)
{
    uint64_t state = 21;
    for (int i = 0; i < 3 * POINTS; i++) {
        f32[i % 3][i / 3] = check_random_float(&state, 40.0f);
        f64[i % 3][i / 3] = (double)f32[i % 3][i / 3];
    }
}

static void sample(enum function f, const struct scarp_noise *noise, const struct outputs *o)
{
    const struct scarp_samples out = outputs_subset(o, outputs_of(noise, f));
    CHECK(function_call(f, noise, POINTS, &in, &out) == SCARP_OK, "%s", function_names[f]);
}

/* Noises of all fractals, with straight and turned axes, with periods, of both fades. */
#define NOISES 18

static struct scarp_noise noise_make(int i)
{
    struct scarp_noise noise = {.fractal = (enum scarp_fractal)(i % 6),
                                .fade = (enum scarp_fade)(i / 3 % 2),
                                .octaves = 3.5f,
                                .seed = (uint64_t)i};
    noise.rotate = i / 6 == 1;
    if (i / 6 == 2) {
        noise.period[0] = 7;
        noise.period[1] = 64;
    }
    return noise;
}

static int same(enum function f, const struct scarp_noise *a, const struct scarp_noise *b)
{
    int member;
    size_t index;
    sample(f, a, &here);
    sample(f, b, &there);
    return outputs_equal(&here, &there, outputs_of(a, f), POINTS, &member, &index);
}

/* Whole turns, forwards, backwards and beyond where floats have fractions, change no bit; other
   phases do. Phases are multiples of 2^-12, to which whole turns can be added. */
static void test_whole_turns(void)
{
    static const float turns[] = {1.0f, -1.0f, 3.0f, 1000.0f, -77.0f};
    static const float phases[] = {0.0f, 0.25f, 0.375f, 0x1p-12f, 1365.0f / 4096.0f};
    for (int i = 0; i < NOISES * FUNCTIONS; i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        struct scarp_noise a = noise_make(i / FUNCTIONS), b = a;
        for (size_t p = 0; p < 25; p++) {
            a.phase = phases[p / 5];
            b.phase = a.phase + turns[p % 5];
            CHECK(same(f, &a, &b), "%s, noise %d: phases %g and %g differ", function_names[f],
                  i / FUNCTIONS, (double)a.phase, (double)b.phase);
            b.phase += 0.125f;
            CHECK(!same(f, &a, &b), "%s, noise %d: phases %g and %g are the same",
                  function_names[f], i / FUNCTIONS, (double)a.phase, (double)b.phase);
        }
        a.phase = 0.0f;
        b.phase = -0.0f;
        CHECK(same(f, &a, &b), "-0 is another phase than 0");
        b.phase = 0x1p23f;
        CHECK(same(f, &a, &b), "2^23 is no whole number of turns");
        b.phase = -3e38f;
        CHECK(same(f, &a, &b), "-3e38 is no whole number of turns");
    }
}

/* The derivative of the oracle's value with respect to the phase, by a central difference of
   octaves: their phases are doubles there. */
static double oracle_difference(const struct scarp_noise *noise, int dimensions, const double x[3])
{
    const float step = 0x1p-18f;
    double value[2];
    for (int side = 0; side < 2; side++) {
        struct scarp_noise moved = *noise;
        struct oracle oracle;
        struct oracle_sample n;
        moved.phase += side == 0 ? -step : step;
        oracle_make(&oracle, &moved, dimensions);
        oracle_evaluate(&oracle, ORACLE_EXACT, x, &n);
        value[side] = n.value;
    }
    return (value[1] - value[0]) / (2.0 * (double)step);
}

/* The oracle's derivative is that of its value, but for the third derivatives that a difference
   leaves, (2 pi 2 2^k)^3 step^2 / 6. test_accuracy.c compares scarp's with the oracle's. */
static void test_oracle_derivative(void)
{
    uint64_t state = 3;
    double worst = 0.0;
    for (int i = 0; i < 200; i++) {
        const int dimensions = 2 + i % 2;
        const struct scarp_noise noise = {.fractal = i % 4 < 2 ? SCARP_FBM : SCARP_EROSION,
                                          .octaves = 2.0f,
                                          .seed = (uint64_t)i,
                                          .rotate = (uint32_t)i / 4 % 2,
                                          .phase = (float)(i % 16) * 0.0625f};
        const double x[3] = {check_random_double(&state, 9.0), check_random_double(&state, 9.0),
                             check_random_double(&state, 9.0)};
        struct oracle oracle;
        struct oracle_sample n;
        oracle_make(&oracle, &noise, dimensions);
        oracle_evaluate(&oracle, ORACLE_EXACT, x, &n);
        worst = larger(worst, fabs(n.phase - oracle_difference(&noise, dimensions, x)));
    }
    printf("the oracle's derivative with respect to the phase, from a difference: %.2e\n", worst);
    CHECK(worst < 1e-6, "%g", worst);
}

/* The largest |dphase| that scarp.h allows for fBm and turbulence, of amplitude 1 and gain 1/2. */
static double phase_bound(const struct scarp_noise *noise, int dimensions)
{
    struct oracle oracle;
    float lowest, highest;
    double sum = 0.0;
    struct scarp_noise flowing = *noise;
    flowing.phase = 0.5f;
    oracle_make(&oracle, noise, dimensions);
    for (int k = 0; k < oracle.octaves; k++) {
        sum += ldexp(oracle.octave[k].of.weight, k);
    }
    CHECK(scarp_range(&flowing, dimensions, &lowest, &highest) == SCARP_OK, "range");
    return 4.0 * 3.14159265358979 * sum * (double)highest;
}

/* From phase to phase, values move by no more than their derivative allows, across 0, too; and the
   derivative keeps its bound. Turbulence may have a crease in between, but no jump. */
static void test_steps(void)
{
    static const float steps[][2] = {
        {0.0f, 1e-6f}, {0.0f, -0x1p-20f}, {0.5f, 0.5f - 0x1p-20f}, {0.3f, 0.300001f}};
    double nearest = 0.0;
    for (int i = 0; i < 2 * FUNCTIONS * 4; i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        struct scarp_noise noise = noise_make(i / FUNCTIONS % 2); /* fBm and turbulence */
        const double bound = phase_bound(&noise, function_dimensions(f));
        const float *const step = steps[i / FUNCTIONS / 2];
        noise.phase = step[0];
        sample(f, &noise, &here);
        noise.phase = step[1];
        sample(f, &noise, &there);
        const double moved = fabs((double)step[1] - (double)step[0]);
        for (size_t p = 0; p < POINTS; p++) {
            const double change =
                fabs((double)here.array[OUTPUT_value][p] - (double)there.array[OUTPUT_value][p]);
            const double slope = fabs((double)here.array[OUTPUT_dphase][p]);
            CHECK(change <= bound * moved + 2e-6, "a jump of %g in a step of %g", change, moved);
            CHECK(slope <= bound, "|dphase| is %g, more than %g", slope, bound);
            nearest = larger(nearest, slope / bound);
        }
    }
    printf("|dphase| reaches %.2f of its bound\n", nearest);
    CHECK(nearest > 0.3, "the bound is far from what is reached: %g", nearest);
}

/* What lies a period further is the same at every phase; the positions of floats are rounded. */
static void test_periods(void)
{
    for (int f = SAMPLE2_F64; f <= SAMPLE3_F64; f++) {
        struct scarp_noise noise = noise_make(12);
        int member = 0;
        size_t index = 0;
        noise.phase = 0.7f;
        sample((enum function)f, &noise, &here);
        for (int p = 0; p < POINTS; p++) {
            f64[0][p] += 7.0;
        }
        sample((enum function)f, &noise, &there);
        make_points();
        const unsigned wanted = outputs_of(&noise, (enum function)f);
        CHECK(outputs_equal(&here, &there, wanted, POINTS, &member, &index), "%s: %s[%zu]",
              function_names[f], output_names[member], index);
    }
}

/* Neighbouring seeds have nothing in common at any phase: correlations of N samples that are
   independent are below 4.5 / sqrt(N). Samples are some cells apart. */
static void test_seeds(void)
{
    enum { SEEDS = 40 };
    for (int phase = 0; phase < 8; phase++) {
        double sum = 0.0, squares[2] = {0.0, 0.0};
        for (uint64_t seed = 0; seed < SEEDS; seed++) {
            struct scarp_noise noise = {.seed = 2 * seed, .phase = (float)phase * 0.12f};
            sample(SAMPLE2_F64, &noise, &here);
            noise.seed++;
            sample(SAMPLE2_F64, &noise, &there);
            for (int p = 0; p < POINTS; p++) {
                const double a = (double)here.array[0][p], b = (double)there.array[0][p];
                sum += a * b;
                squares[0] += a * a;
                squares[1] += b * b;
            }
        }
        const double correlation = sum / sqrt(squares[0] * squares[1]);
        CHECK(fabs(correlation) < 4.5 / sqrt((double)SEEDS * POINTS),
              "seeds correlate by %g at phase %g", correlation, phase * 0.12);
    }
}

static void expect_refused(const struct scarp_noise *noise, enum scarp_status expected)
{
    for (int d = 2; d <= 3; d++) {
        const char *member = NULL;
        CHECK(scarp_noise_check(noise, d, &member) == expected, "phase %g", (double)noise->phase);
        CHECK(member != NULL && strcmp(member, "phase") == 0, "%s is at fault", member);
    }
    for (int f = 0; f < FUNCTIONS; f++) {
        const struct scarp_samples out = outputs_subset(&here, 1);
        outputs_poison(&here);
        CHECK(function_call((enum function)f, noise, POINTS, &in, &out) == expected, "%s",
              function_names[f]);
        CHECK(outputs_untouched(&here, ~0u), "outputs were written");
    }
}

static void test_refused(void)
{
    const struct scarp_noise bad[] = {{.phase = NAN}, {.phase = INFINITY}, {.phase = -INFINITY}};
    const struct scarp_noise value = {.basis = SCARP_VALUE, .phase = 1.0f};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        expect_refused(&bad[i], SCARP_ERROR_PARAMETER);
    }
    expect_refused(&value, SCARP_ERROR_UNSUPPORTED);
    const struct scarp_noise still = {.basis = SCARP_VALUE};
    for (int f = 0; f < FUNCTIONS; f++) {
        const struct scarp_samples out = outputs_subset(&here, 1 | OUTPUTS_PHASE);
        outputs_poison(&here);
        CHECK(function_call((enum function)f, &still, POINTS, &in, &out) == SCARP_ERROR_UNSUPPORTED,
              "dphase of value noise");
        CHECK(outputs_untouched(&here, ~0u), "outputs were written");
    }
}

int main(int argc, char **argv)
{
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    here = outputs_make(POINTS);
    there = outputs_make(POINTS);
    make_points();
    test_whole_turns();
    test_oracle_derivative();
    test_steps();
    test_periods();
    test_seeds();
    test_refused();
    outputs_free(&here);
    outputs_free(&there);
    return check_done();
}
