/* SPDX-License-Identifier: MIT
 *
 * Is the gradient that turbulence, ridged, erosion, ping-pong and hybrid return that of the value
 * they return? By central differences, along a random direction at each point:
 *
 * - of the oracle's values in double, in steps of STEP cells of the finest octave, second order:
 *   their error is below 1e-8, so what shows is the library's own;
 * - of the very values that the library returns. These are floats, so the steps must be large: 2^-7
 *   cells, fourth order. Erosion, whose slope turns within fewer cells, gets 2^-8: with 2^-7
 *   the truncated terms make 2e-3, sixteen times as much; with 2^-9 the roundings double.
 *
 * A point is left out where a crease goes through its stencil, by the oracle: where the sign of
 * some n_k, or in ridged that of 2 s_k - 1, is not the same at all points of it. Where derivatives
 * jump or bend, so with the cubic fade, for erosion, whose value has slopes in it, and in the large
 * steps, it is also left out where a lattice plane of some octave goes through. The shares are
 * printed and bounded.
 *
 * Argument: the number of points per case.
 */
#include "fractal.h"

#define OCTAVES 4
#define STEP 0x1p-17

/* Four cases make one line of the output. */
#define CASES 4

static const struct scarp_noise settings[2] = {
    {.seed = 3, .octaves = OCTAVES},
    {.seed = 4, .octaves = OCTAVES, .rotate = 1, .gain = 0.6f, .amplitude = -5.0f, .erosion = 2.0f},
};

struct errors {
    double max, squares;
    long points, excluded;
};

static enum function function_for(int dimensions)
{
    return dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
}

/* Draws a unit vector: an axis now and then, otherwise any direction. */
static void direction(uint64_t *random, int dimensions, double e[3])
{
    const int choice = (int)(check_random(random) >> 33) % (2 * dimensions);
    double squares = 0.0;
    for (int i = 0; i < 3; i++) {
        e[i] = choice < dimensions ? (double)(i == choice) : check_random_double(random, 1.0);
        e[i] = i < dimensions ? e[i] : 0.0;
        squares += e[i] * e[i];
    }
    for (int i = 0; i < 3; i++) {
        e[i] /= sqrt(squares);
    }
}

static double along(const struct oracle_sample *n, const double e[3])
{
    return n->gradient[0] * e[0] + n->gradient[1] * e[1] + n->gradient[2] * e[2];
}

static void move(const double x[3], const double e[3], double step, double y[3])
{
    for (int i = 0; i < 3; i++) {
        y[i] = x[i] + step * e[i];
    }
}

static void count_error(struct errors *errors, double error)
{
    errors->max = larger(errors->max, error);
    errors->squares += error * error;
    errors->points++;
}

static void report(const struct errors *errors, const struct scarp_noise *noise, int dimensions,
                   const char *of, double max, double rms, double excluded)
{
    const double root = sqrt(errors->squares / (double)errors->points);
    const double share = (double)errors->excluded / (double)(errors->points + errors->excluded);
    printf("%-10s %-8s %dD  of %-8s %7ld points, %6.3f %% excluded: max %.2e RMS %.1e\n",
           fractal_names[noise->fractal], basis_name((int)noise->basis), dimensions, of,
           errors->points, 100.0 * share, errors->max, root);
    CHECK(errors->max <= max, "the gradient is off by %g", errors->max);
    CHECK(root <= rms, "the gradient is off by %g, RMS", root);
    CHECK(share <= excluded, "%g of the points are excluded", share);
    CHECK(errors->points > 0, "nothing was compared");
}

/* The noise of a case: `index` stands for a setting and a fade. */
static struct scarp_noise noise_of(int index, enum scarp_fractal fractal, enum scarp_basis basis)
{
    struct scarp_noise noise = settings[index / 2];
    noise.fractal = fractal;
    noise.basis = basis;
    noise.fade = (enum scarp_fade)(index % 2);
    return noise;
}

static void difference_oracle(struct block *block, const struct scarp_noise *noise, int dimensions,
                              long points, struct errors *errors)
{
    const enum function f = function_for(dimensions);
    const int planes = noise->fade == SCARP_CUBIC || noise->fractal == SCARP_EROSION;
    struct oracle oracle;
    oracle_make(&oracle, noise, dimensions);
    const double step = STEP / oracle.octave[OCTAVES - 1].of.frequency;
    const double unit = fractal_unit(&oracle, 1);
    uint64_t random = 1;
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 16.0f);
        block_sample(block, noise, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3], e[3], y[2][3];
            struct oracle_sample side[2];
            struct oracle_creases creases[2];
            block_point(block, i, x);
            direction(&random, dimensions, e);
            for (int s = 0; s < 2; s++) {
                move(x, e, s == 0 ? -step : step, y[s]);
                oracle_evaluate_creased(&oracle, ORACLE_EXACT, y[s], &side[s], &creases[s]);
            }
            if (creases[0].side != creases[1].side ||
                (planes && oracle_clearance(&oracle, x) <= step)) {
                errors->excluded++;
                continue;
            }
            const struct oracle_sample n = block_result(block, noise, f, i);
            const double slope = (side[1].value - side[0].value) / (2.0 * step);
            count_error(errors, fabs(along(&n, e) - slope) / unit);
        }
    }
}

/* Whether no crease and no lattice plane is within `reach` of x, along e. */
static int is_smooth(const struct oracle *oracle, const double x[3], const double e[3],
                     double reach)
{
    struct oracle_sample n;
    struct oracle_creases here, there;
    oracle_evaluate_creased(oracle, ORACLE_EXACT, x, &n, &here);
    for (int s = -4; s <= 4; s++) { /* n_k may change its sign and change it back */
        double y[3];
        move(x, e, s * 0.25 * reach, y);
        oracle_evaluate_creased(oracle, ORACLE_EXACT, y, &n, &there);
        if (there.side != here.side) {
            return 0;
        }
    }
    return oracle_clearance(oracle, x) > reach;
}

static void difference_library(struct block *block, const struct scarp_noise *noise, int dimensions,
                               long points, struct errors *errors)
{
    static const double weights[4] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0};
    static double at[3][BLOCK], e[BLOCK][3];
    static struct oracle_sample gradient[BLOCK];
    static double slope[BLOCK];
    const enum function f = function_for(dimensions);
    struct oracle oracle;
    oracle_make(&oracle, noise, dimensions);
    const double cells = noise->fractal == SCARP_EROSION ? 0x1p-8 : 0x1p-7;
    const double step = cells / oracle.octave[OCTAVES - 1].of.frequency;
    const double unit = fractal_unit(&oracle, 1);
    uint64_t random = 2;
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 16.0f);
        memcpy(at, block->d, sizeof at);
        block_sample(block, noise, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            gradient[i] = block_result(block, noise, f, i);
            direction(&random, dimensions, e[i]);
            slope[i] = 0.0;
        }
        for (int s = 0; s < 4; s++) {
            const double h = (s < 2 ? s - 2 : s - 1) * step;
            for (size_t i = 0; i < BLOCK; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    block->d[axis][i] = at[axis][i] + h * e[i][axis];
                }
            }
            block_sample(block, noise, f, BLOCK);
            for (size_t i = 0; i < BLOCK; i++) {
                slope[i] += weights[s] * (double)block->out.array[0][i] / step;
            }
        }
        for (size_t i = 0; i < BLOCK; i++) {
            const double x[3] = {at[0][i], at[1][i], at[2][i]};
            if (is_smooth(&oracle, x, e[i], 2.0 * step)) {
                count_error(errors, fabs(along(&gradient[i], e[i]) - slope[i]) / unit);
            } else {
                errors->excluded++;
            }
        }
    }
}

/*
 * Bounds by fractal, in units of sum |a_k| f_k: about three times what was measured. Of the
 * oracle's values: the roundings of test_fractal.c, and that of the fractions, 2^-25 cells times
 * the second derivative. Of the library's: a rounding of 2^-24 over the step, 1e-5 times a few, and
 * fourth-order terms.
 */
static const struct {
    double oracle[2], library[2]; /* max, RMS */
} bounds[] = {
    [SCARP_TURBULENCE] = {{1.5e-6, 2e-7}, {2.3e-4, 4e-5}},
    [SCARP_RIDGED] = {{6.5e-6, 4.2e-7}, {5e-4, 7.5e-5}},
    [SCARP_EROSION] = {{1.5e-5, 4e-7}, {5e-4, 5.5e-5}},
    [SCARP_PINGPONG] = {{4.5e-6, 8e-7}, {9e-4, 1.6e-4}},
    [SCARP_HYBRID] = {{1.3e-6, 1.6e-7}, {4e-4, 6e-5}},
};

static void check_gradient(struct block *block, enum scarp_fractal fractal, enum scarp_basis basis,
                           int dimensions, long points)
{
    struct errors of_oracle = {.points = 0}, of_library = {.points = 0};
    struct scarp_noise noise;
    for (int i = 0; i < CASES; i++) {
        noise = noise_of(i, fractal, basis);
        difference_oracle(block, &noise, dimensions, points, &of_oracle);
        difference_library(block, &noise, dimensions, (points + 9) / 10, &of_library);
    }
    const double *const oracle = bounds[fractal].oracle, *const library = bounds[fractal].library;
    report(&of_oracle, &noise, dimensions, "oracle", oracle[0], oracle[1], 0.0005);
    report(&of_library, &noise, dimensions, "library", library[0], library[1], 0.25);
}

int main(int argc, char **argv)
{
    const long points = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    if (points < BLOCK) {
        printf("usage: %s POINTS (at least %d)\n", argv[0], BLOCK);
        return EXIT_FAILURE;
    }
    struct block *const block = block_make();
    printf("gradients against differences of values, in units of sum |a_k| f_k\n");
    for (int i = 0; i < 20; i++) {
        check_gradient(block, (enum scarp_fractal)(SCARP_TURBULENCE + i / 4),
                       (enum scarp_basis)(i / 2 % 2), 2 + i % 2, points);
    }
    block_free(block);
    return check_done();
}
