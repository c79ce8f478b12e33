/* SPDX-License-Identifier: MIT
 *
 * Measures how far every fractal but fBm is from the oracle's, which works in double precision, and
 * how far gradients would be without the terms that have Hessians in them: of erosion, and of where
 * octaves of Swiss and Jordan noise look. Checks that octaves fade in without a jump.
 * (oracle_check.c shows that the oracle's gradients and Hessians are those of its values.)
 * Argument: the number of points per case.
 *
 * Next to a crease the two may be on different sides of it, and then their derivatives have
 * nothing to do with each other. Points are left out where, by the oracle, some |n_k| or, in
 * ridged, |2 s_k - 1|, and so on, is below CREASE; the share of such points is printed and bounded.
 */
#include "fractal.h"

#define CREASE 1e-5
#define BENT_CREASE 1e-4
#define BORDER 5e-5  /* where derivatives of distances jump */
#define NEAREST 1e-3 /* errors of theirs are multiplied by the distance: see test_accuracy.c */
#define EXCLUDED 0.02

/* The settings that are compared, with each basis, fade and precision. */
static const struct {
    const char *name;
    struct scarp_noise noise;
} settings[] = {
    {"6", {.seed = 21, .octaves = 6.0f, .frequency = 0.7}},
    {"6, turned",
     {.seed = ~UINT64_C(0), .octaves = 6.0f, .rotate = 1, .gain = 0.6f, .erosion = 0.5f}},
    {"4.3 of 7.75, turned",
     {.seed = 77,
      .octaves = 4.3f,
      .of_octaves = 7.75f,
      .sharpness = 0.8f,
      .lacunarity = 1.9f,
      .gain = 0.7f,
      .amplitude = -1000.0f,
      .rotate = 1,
      .erosion = 4.0f}},
};

#define SETTINGS (sizeof settings / sizeof settings[0])

/*
 * Bounds of the error by [fractal][order], in units of sum |a_k| f_k^order, for all cases: about
 * three times the largest measured on 10^5 points. Those of ridged are larger because
 * its weights double the error of an octave in the next; those of erosion, because of points where
 * a steep d turns.
 */
static const struct {
    double max[3], rms[3];
} bounds[] = {
    [SCARP_TURBULENCE] = {{7e-7, 1.2e-6, 1.1e-5}, {1e-7, 2.2e-7, 1.3e-6}},
    [SCARP_RIDGED] = {{1.3e-6, 7.5e-6, 6.5e-5}, {1.9e-7, 5e-7, 3.6e-6}},
    [SCARP_EROSION] = {{6e-7, 2.3e-5, 0.0}, {5.5e-8, 4.5e-7, 0.0}},
    [SCARP_PINGPONG] = {{2.4e-6, 4.5e-6, 3e-5}, {3.5e-7, 8.5e-7, 5e-6}},
    [SCARP_HYBRID] = {{1.1e-6, 1.2e-6, 3.6e-6}, {1.5e-7, 1.4e-7, 2.2e-7}},
    [SCARP_SWISS] = {{1e-6, 9e-6, 0.0}, {2e-7, 5e-7, 0.0}},
    [SCARP_JORDAN] = {{9e-7, 3e-5, 0.0}, {9e-8, 2.5e-7, 0.0}},
};

/* Simplex and cellular noise may have so many times those. */
#define STEEP 4.0

/* The same of dphase, in units of 2 pi sum |a_k| 2^k. Fractals that bend have none. */
static const double phase_bounds[SCARP_FRACTALS] = {[SCARP_TURBULENCE] = 2e-6,
                                                    [SCARP_RIDGED] = 2e-5,
                                                    [SCARP_EROSION] = 2e-5,
                                                    [SCARP_PINGPONG] = 3e-6,
                                                    [SCARP_HYBRID] = 5e-7};

static int highest_order(enum scarp_fractal fractal)
{
    return fractal_has(fractal, FRACTAL_SLOPES) ? 1 : 2;
}

/* The errors of one fractal, basis and dimension, over all settings, fades and precisions. */
struct errors {
    double max[3], squares[3], phase;
    long points, excluded;
};

/* Compares the first `count` points. */
static void compare_block(const struct block *block, size_t count, const struct scarp_noise *noise,
                          const struct oracle *oracle, enum function f, struct errors *errors)
{
    const enum oracle_rounding rounding = function_doubles(f) ? ORACLE_F64 : ORACLE_F32;
    for (size_t i = 0; i < count; i++) {
        double x[3], error[3];
        struct oracle_sample expected;
        struct oracle_creases creases;
        block_point(block, i, x);
        oracle_evaluate_creased(oracle, rounding, x, &expected, &creases);
        if (creases.clearance < (fractal_bends(noise->fractal) ? BENT_CREASE : CREASE) ||
            (!basis_smooth(noise->basis) &&
             (creases.border < BORDER || creases.nearest < NEAREST))) {
            errors->excluded++;
            continue;
        }
        const struct oracle_sample actual = block_result(block, noise, f, i);
        difference(&actual, &expected, error);
        for (int order = 0; order < 3; order++) {
            const double e =
                error[order] * pow(creases.nearest, order) / fractal_unit(oracle, order);
            errors->max[order] = larger(errors->max[order], e);
            errors->squares[order] += e * e;
        }
        if (noise->basis == SCARP_GRADIENT && !fractal_bends(noise->fractal)) {
            errors->phase =
                larger(errors->phase, fabs(actual.phase - expected.phase) / phase_unit(oracle));
        }
        errors->points++;
    }
}

static void check_accuracy(struct block *block, enum scarp_fractal fractal, enum scarp_basis basis,
                           int dimensions, long points)
{
    struct errors errors = {.points = 0};
    for (size_t i = 0; i < 4 * SETTINGS; i++) {
        struct scarp_noise noise = settings[i / 4].noise;
        noise.fractal = fractal;
        noise.basis = basis;
        noise.fade = (enum scarp_fade)(i & 1);
        noise.phase = basis == SCARP_GRADIENT && i / 4 < 2 ? -1.71f : 0.0f;
        if (!blends_corners(basis) && noise.fade != SCARP_QUINTIC) {
            continue; /* which they do not look at */
        }
        if (fractal_bends(fractal) && (i & 2) == 0) {
            continue; /* floats so far from the origin: see check_bent() */
        }
        if (fractal_bends(fractal)) { /* bounds are for octaves that bend little */
            noise.octaves = 4.0f;
            noise.gain = noise.sharpness = 0.0f;
            noise.erosion = 0.9f;
        }
        const enum function f =
            dimensions == 2 ? (i & 2 ? SAMPLE2_F64 : SAMPLE2) : (i & 2 ? SAMPLE3_F64 : SAMPLE3);
        struct oracle oracle;
        oracle_make(&oracle, &noise, dimensions);
        uint64_t random = i;
        for (long done = 0; done < points; done += BLOCK) {
            block_random(block, &random, 64.0f);
            block_sample(block, &noise, f, BLOCK);
            const size_t left = (size_t)(points - done);
            compare_block(block, left < BLOCK ? left : BLOCK, &noise, &oracle, f, &errors);
        }
    }
    const double share = (double)errors.excluded / (double)(errors.points + errors.excluded);
    printf("%-10s %-8s %dD %7ld points, %.4f %% excluded", fractal_name((int)fractal),
           basis_name((int)basis), dimensions, errors.points, 100.0 * share);
    CHECK(share <= EXCLUDED, "%g of the points are excluded", share);
    CHECK(errors.points > 0, "nothing was compared");
    for (int order = 0; order <= highest_order(fractal); order++) {
        const double max = errors.max[order];
        const double rms = sqrt(errors.squares[order] / (double)errors.points);
        printf("  %.2e %.1e", max, rms);
        const double steep = blends_corners(basis) ? 1.0 : STEEP;
        CHECK(max <= steep * bounds[fractal].max[order], "derivative %d: error %g", order, max);
        CHECK(rms <= steep * bounds[fractal].rms[order], "derivative %d: RMS error %g", order, rms);
    }
    printf("  dphase %.2e\n", errors.phase);
    CHECK(errors.phase <= phase_bounds[fractal], "dphase: error %g", errors.phase);
}

/* Every number of the noise is other than its default in some case. */
static struct scarp_noise bent_case(enum scarp_fractal fractal, int i)
{
    static const enum scarp_basis bases[] = {SCARP_GRADIENT, SCARP_VALUE, SCARP_SIMPLEX,
                                             SCARP_CELL_SOFT};
    struct scarp_noise noise = {.basis = bases[i % 4],
                                .fade = (enum scarp_fade)(i / 4 % 2),
                                .fractal = fractal,
                                .seed = 1000 + (uint64_t)i,
                                .frequency = 0.75,
                                .octaves = i % 3 == 0 ? 4.4f : 4.0f,
                                .of_octaves = i % 5 == 3 ? 6.75f : 0.0f,
                                .lacunarity = 1.9f,
                                .gain = 0.6f,
                                .amplitude = i % 2 != 0 ? -3.0f : 2.0f,
                                .erosion = i % 5 == 1 ? 0.4f : 0.9f,
                                .sharpness = i % 3 == 1 ? 0.05f : 0.2f,
                                .phase = i / 2 % 2 != 0 ? 0.4f : 0.0f,
                                .jitter = 0.75f};
    if (noise.basis == SCARP_SIMPLEX) { /* whose slopes are steep: small octaves crumple */
        noise.sharpness *= 0.25f;
    }
    noise.rotate = (uint32_t)(i / 8 % 2);
    if (i / 16 == 1) {
        noise.rotate = 0;
        noise.lacunarity = 2.0f;
        noise.period[0] = 3;
        noise.period[1] = 16;
    }
    noise.phase = noise.basis == SCARP_GRADIENT && i / 4 % 2 != 0 ? -1.3f : 0.0f;
    return noise;
}

/*
 * Bounds of these by [basis is simplex or cellular noise][fractal is Jordan noise][order], in units
 * of sum |a_k| f_k^order: about three times what was measured. Where an octave looks is off by the
 * errors of all octaves before, times c_k f_k, which is sharpness f_k / f_0 with Swiss noise.
 */
static const double bent_bounds[2][2][2] = {{{1.1e-6, 3.2e-5}, {7e-7, 1e-5}},
                                            {{1.4e-6, 7e-4}, {1.5e-6, 5e-5}}};
static const double bent_rms_bounds[2][2][2] = {{{1.8e-7, 9e-7}, {6.5e-8, 2.8e-7}},
                                                {{2.8e-7, 2e-5}, {2.3e-7, 2.6e-6}}};

/* Swiss and Jordan noise of all kinds, by the calls for floats and for doubles */
static void check_bent(struct block *block, enum scarp_fractal fractal, enum function f, int own)
{
    const int jordan = fractal == SCARP_JORDAN;
    struct errors errors = {.points = 0};
    for (int i = 0; i < 24; i++) {
        struct scarp_noise noise = bent_case(fractal, i);
        struct oracle oracle;
        uint64_t random = noise.seed;
        if (own == blends_corners(noise.basis)) {
            continue;
        }
        fit_noise(&noise, function_dimensions(f));
        oracle_make(&oracle, &noise, function_dimensions(f));
        block_random(block, &random, function_doubles(f) ? 64.0f : 1.0f);
        block_sample(block, &noise, f, BLOCK);
        compare_block(block, own ? BLOCK / 10 : BLOCK, &noise, &oracle, f, &errors);
    }
    printf("%-10s %-17s %s, %5ld points, %2ld excluded", fractal_name((int)fractal),
           function_names[f], own ? "own " : "cube", errors.points, errors.excluded);
    for (int order = 0; order < 2; order++) {
        const double rms = sqrt(errors.squares[order] / (double)errors.points);
        printf("  %.2e %.1e", errors.max[order], rms);
        CHECK(errors.max[order] <= bent_bounds[own][jordan][order] &&
                  rms <= bent_rms_bounds[own][jordan][order],
              "derivative %d: off by %g, RMS %g", order, errors.max[order], rms);
    }
    printf("\n");
    CHECK(errors.excluded <= errors.points / 100, "%ld points are excluded", errors.excluded);
}

/*
 * Checks that the gradient of erosion needs the term -2 erosion n_k q_k^2 D_k^T d_k. What is
 * commonly taken for the gradient, sum a_k q_k G_k alone, is far from it: much farther than scarp's
 * own error. Likewise those of Swiss and Jordan noise without the Jacobians of where octaves look.
 */
static void check_frozen(struct block *block, enum scarp_fractal fractal, enum scarp_basis basis,
                         int dimensions, long points)
{
    const enum oracle_rounding rounding = fractal_bends(fractal) ? ORACLE_EXACT : ORACLE_F64;
    const struct scarp_noise noise = {.fractal = fractal,
                                      .basis = basis,
                                      .octaves = 8.0f,
                                      .frequency = 0.25,
                                      .rotate = 1,
                                      .seed = 31};
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    struct oracle oracle;
    oracle_make(&oracle, &noise, dimensions);
    double squares = 0.0, frozen = 0.0, actual = 0.0;
    uint64_t random = 1;
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 64.0f);
        block_sample(block, &noise, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3], gradient[3];
            struct oracle_sample exact;
            block_point(block, i, x);
            oracle_evaluate(&oracle, rounding, x, &exact);
            oracle_frozen_gradient(&oracle, rounding, x, gradient);
            const struct oracle_sample result = block_result(block, &noise, f, i);
            for (int axis = 0; axis < dimensions; axis++) {
                squares += exact.gradient[axis] * exact.gradient[axis];
                frozen += pow(gradient[axis] - exact.gradient[axis], 2.0);
                actual += pow(result.gradient[axis] - exact.gradient[axis], 2.0);
            }
        }
    }
    frozen = sqrt(frozen / squares);
    actual = sqrt(actual / squares);
    printf("%-10s %-8s %dD RMS error of the gradient, relative: %.1e; without the Hessians: "
           "%.3f\n",
           fractal_name((int)fractal), basis_name((int)basis), dimensions, actual, frozen);
    CHECK(frozen >= (fractal_bends(fractal) ? 0.2 : 0.3),
          "without the Hessians the gradient is off by %g only", frozen);
    CHECK(actual * 1000.0 <= frozen, "scarp's is off by %g, without the Hessians %g", actual,
          frozen);
}

/*
 * The last of 4 octaves fades in. At 3.0001 octaves it has a 10^-4 of its weight, at 3.9999 it
 * lacks as much: values and gradients differ by about that from those of 3 and of 4 octaves. Half
 * of it must differ visibly from both, or the comparison would say nothing. Creases are excluded:
 * there ridged's slopes do jump, though never with the number of octaves.
 */
static void check_fading(struct block *block, enum scarp_fractal fractal, int dimensions)
{
    static const float octaves[5] = {3.0f, 3.0001f, 3.5f, 3.9999f, 4.0f};
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    static struct oracle_sample n[5][BLOCK];
    double unit[2] = {0.0, 0.0};
    uint64_t random = 9;
    block_random(block, &random, 64.0f);
    for (int o = 0; o < 5; o++) {
        const struct scarp_noise noise = {.fractal = fractal,
                                          .octaves = octaves[o],
                                          .gain = fractal == SCARP_HYBRID ? 0.8f : 0.5f,
                                          .rotate = 1,
                                          .seed = 8};
        struct oracle oracle;
        oracle_make(&oracle, &noise, dimensions);
        unit[0] = fractal_unit(&oracle, 0);
        unit[1] = fractal_unit(&oracle, 1);
        block_sample(block, &noise, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            n[o][i] = block_result(block, &noise, f, i);
        }
    }
    double pop[2] = {0.0, 0.0}, fade[2] = {0.0, 0.0};
    for (size_t i = 0; i < BLOCK; i++) {
        for (int pair = 0; pair < 4; pair++) {
            double d[3];
            difference(&n[pair][i], &n[pair + 1][i], d);
            double *const largest = pair == 0 || pair == 3 ? pop : fade;
            largest[0] = larger(largest[0], d[0] / unit[0]);
            largest[1] = larger(largest[1], d[1] / unit[1]);
        }
    }
    printf("%-10s %dD fading: 0.0001 of an octave changes values by %.1e, gradients by %.1e; half "
           "of one by %.2f, %.2f\n",
           fractal_name((int)fractal), dimensions, pop[0], pop[1], fade[0], fade[1]);
    CHECK(pop[0] <= 2.5e-5 && pop[1] <= 4e-4, "values jump by %g, gradients by %g", pop[0], pop[1]);
    CHECK(fade[0] >= 0.01 && fade[1] >= 0.1, "values fade by %g only, gradients by %g", fade[0],
          fade[1]);
}

int main(int argc, char **argv)
{
    const long points = check_argument(argc, argv, 1, BLOCK, "POINTS");
    struct block *const block = block_make();
    printf("error in units of sum |a_k| f_k^order: max, RMS of value; of gradient; of Hessian\n");
    for (int i = 0; i < 4 * (SCARP_FRACTALS - 1); i++) {
        check_accuracy(block, (enum scarp_fractal)(SCARP_TURBULENCE + i / 4),
                       (enum scarp_basis)(i / 2 % 2), 2 + i % 2, points);
    }
    static const enum scarp_basis own[] = {SCARP_SIMPLEX, SCARP_CELL_F1, SCARP_CELL_SOFT};
    for (int i = 0; i < 30; i++) { /* the oracle is slow */
        check_accuracy(block, (enum scarp_fractal)(SCARP_TURBULENCE + i / 6), own[i / 2 % 3],
                       2 + i % 2, points / 9);
    }
    for (int i = 0; i < 4 * FUNCTIONS; i++) {
        check_bent(block, (enum scarp_fractal)(SCARP_SWISS + i / FUNCTIONS % 2),
                   (enum function)(i % FUNCTIONS), i / FUNCTIONS / 2);
    }
    for (int i = 0; i < 4 * SCARP_FRACTALS; i++) {
        const enum scarp_fractal fractal = (enum scarp_fractal)(i / 4);
        if (fractal_has(fractal, FRACTAL_SLOPES)) {
            check_frozen(block, fractal, (enum scarp_basis)(i / 2 % 2), 2 + i % 2, points);
        }
    }
    for (int i = 0; i < 12; i++) {
        check_fading(block, (enum scarp_fractal)(i / 2), 2 + i % 2);
    }
    block_free(block);
    return check_done();
}
