/* SPDX-License-Identifier: MIT
 *
 * Measures how far values, gradients and Hessians are from the oracle's, which works in double
 * precision. Checks continuity across lattice planes, values on lattice points and normalisation.
 * Arguments: the number of points per case, and the instruction set.
 */
#include "fractal.h"

static struct block *block;

/* Samples the first `count` points by the call of that precision. */
static void sample(const struct scarp_noise *noise, int dimensions, enum oracle_rounding precision,
                   size_t count)
{
    const enum function two = precision == ORACLE_F32 ? SAMPLE2 : SAMPLE2_F64;
    const enum function three = precision == ORACLE_F32 ? SAMPLE3 : SAMPLE3_F64;
    block_sample(block, noise, dimensions == 2 ? two : three, count);
}

/* Gives the library's results for point i in the oracle's form. */
static void result(int dimensions, size_t i, struct oracle_sample *n)
{
    static const struct scarp_noise any = {0};
    *n = block_result(block, &any, dimensions == 2 ? SAMPLE2 : SAMPLE3, i);
}

/*
 * The cases. The float calls get small coordinates, so that the fractions have many bits;
 * the double calls get any.
 */
static const struct {
    const char *name;
    struct scarp_noise noise;
    float span_f32;
    double span_f64;
} fractals[] = {
    {"1 octave", {.seed = 1}, 64.0f, 0x1p30},
    {"1 octave, f 0.37",
     {.seed = 0xfedcba9876543210u, .frequency = 0.37, .amplitude = -3.0f, .offset_first = 1},
     1024.0f,
     0x1p20},
    {"4.3, turned",
     {.seed = ~UINT64_C(0), .octaves = 4.3f, .lacunarity = 1.9f, .rotate = 1, .offset_first = 1},
     64.0f,
     0x1p20},
    {"4.3", {.seed = 77, .octaves = 4.3f, .gain = 0.7f, .amplitude = 1000.0f}, 64.0f, 0x1p10},
    {"8", {.seed = UINT64_C(1) << 32, .octaves = 8.0f, .frequency = 0.01}, 1024.0f, 0x1p16},
    {"8, turned",
     {.octaves = 8.0f, .lacunarity = 2.17f, .gain = 0.45f, .amplitude = -0.25f, .rotate = 9},
     16.0f,
     0x1p16},
    {"4, powers", {.seed = 3, .octaves = 4.0f, .period = {4, 1, 64}}, 64.0f, 0x1p40},
    {"4, periods",
     {.seed = 4, .octaves = 4.0f, .lacunarity = 3.0f, .frequency = 0.7, .period = {5, 289, 0}},
     64.0f,
     0x1p30},
    {"3, flow", {.seed = 5, .octaves = 3.0f, .phase = 0.31f}, 64.0f, 0x1p20},
    {"3.5, flow, turned",
     {.seed = 6, .octaves = 3.5f, .phase = -7.77f, .rotate = 1, .amplitude = 2.0f, .jitter = 0.6f},
     64.0f,
     0x1p20},
};

/*
 * Bounds of the error by order, in units of sum |a_k| f_k^order: about one and a half times what
 * was measured on 10^5 points, of simplex and cellular noise on 10^4 and 2000. They
 * are roundings of 2^-24 in some 20 operations. Errors of derivatives of distances grow towards
 * features, as the derivatives do; they are multiplied by the distance, squared for Hessians.
 */
struct bounds {
    double max[3], rms[3];
};

static const struct bounds quintic_bounds = {{7e-7, 2e-6, 8e-6}, {8e-8, 2.5e-7, 1.1e-6}};
static const struct bounds cubic_bounds = {{6e-7, 1.5e-6, 6e-6}, {8e-8, 2.5e-7, 1e-6}};
static const struct bounds own_bounds[] = {
    [SCARP_SIMPLEX] = {{7e-7, 4e-6, 3e-5}, {1.6e-7, 8e-7, 5e-6}},
    [SCARP_CELL_F1] = {{3e-7, 3e-7, 5e-7}, {7e-8, 7e-8, 1e-7}},
    [SCARP_CELL_F2] = {{3e-7, 3e-7, 4e-7}, {7e-8, 7e-8, 8e-8}},
    [SCARP_CELL_EDGE] = {{4e-7, 5e-7, 6e-7}, {1e-7, 1e-7, 1.2e-7}},
    [SCARP_CELL_SOFT] = {{4e-7, 2.5e-6, 1.6e-5}, {1e-7, 4e-7, 2.7e-6}},
    [SCARP_CELL_VALUE] = {{3e-7, 0, 0}, {5e-8, 0, 0}},
};

static const struct bounds *bounds_of(const struct scarp_noise *noise)
{
    return !blends_corners(noise->basis)  ? &own_bounds[noise->basis]
           : noise->fade == SCARP_QUINTIC ? &quintic_bounds
                                          : &cubic_bounds;
}

/* Nearer than this to where a derivative of a distance jumps, none is compared, nor a cell's own
   value; and at most this part of the points may be so near, for each octave, and FEW. */
#define BORDER 5e-5
#define NEAREST 1e-3
#define EXCLUDED 0.0025
#define FEW 4.0

/* The same of the derivative with respect to the phase, in units of 2 pi sum |a_k| 2^k; it is 0 in
 * value noise.
 */
#define PHASE_BOUND 1.5e-6

static void random_points(uint64_t *random, enum oracle_rounding precision, size_t fractal)
{
    for (size_t i = 0; i < BLOCK; i++) {
        for (int axis = 0; axis < 3; axis++) {
            if (precision == ORACLE_F32) {
                block->f[axis][i] = check_random_float(random, fractals[fractal].span_f32);
                block->d[axis][i] = (double)block->f[axis][i];
            } else {
                block->d[axis][i] = check_random_double(random, fractals[fractal].span_f64);
            }
        }
    }
}

/* The errors of one case. */
struct errors {
    double max[3], squares[3], phase;
    long points, excluded;
};

static void compare(const struct scarp_noise *noise, const struct oracle *oracle,
                    enum oracle_rounding precision, size_t i, struct errors *errors)
{
    const double x[3] = {block->d[0][i], block->d[1][i], block->d[2][i]};
    struct oracle_sample expected, actual;
    struct oracle_creases creases;
    double error[3];
    oracle_evaluate_creased(oracle, precision, x, &expected, &creases);
    result(oracle->dimensions, i, &actual);
    difference(&actual, &expected, error);
    const int near =
        !basis_smooth(noise->basis) && (creases.border < BORDER || creases.nearest < NEAREST);
    errors->points++;
    errors->excluded += near;
    if (noise->basis == SCARP_GRADIENT) {
        errors->phase = larger(errors->phase, fabs(actual.phase - expected.phase));
    }
    for (int order = 0; order < 3; order++) {
        if (near && (order > 0 || noise->basis == SCARP_CELL_VALUE)) {
            continue;
        }
        const double e = error[order] * pow(creases.nearest, order) / fractal_unit(oracle, order);
        errors->max[order] = larger(errors->max[order], e);
        errors->squares[order] += e * e;
    }
}

static void check_errors(const struct scarp_noise *noise, const struct errors *errors)
{
    const struct bounds *const bounds = bounds_of(noise);
    for (int order = 0; order < 3; order++) {
        const double max = errors->max[order];
        const double rms = sqrt(errors->squares[order] / (double)errors->points);
        printf("  %.2e %.1e", max, rms);
        CHECK(max <= bounds->max[order], "derivative %d: error %g", order, max);
        CHECK(rms <= bounds->rms[order], "derivative %d: RMS error %g", order, rms);
    }
    const double part = EXCLUDED * fmax(1.0, (double)noise->octaves);
    printf("  %.2e  %ld\n", errors->phase, errors->excluded);
    CHECK(errors->phase <= PHASE_BOUND, "dphase: error %g", errors->phase);
    CHECK((double)errors->excluded <= FEW + part * (double)errors->points,
          "%ld of %ld points are excluded", errors->excluded, errors->points);
}

static void check_accuracy(size_t fractal, enum scarp_basis basis, enum scarp_fade fade,
                           int dimensions, enum oracle_rounding precision, long points)
{
    struct scarp_noise noise = fractals[fractal].noise;
    noise.basis = basis;
    noise.fade = fade;
    fit_noise(&noise, dimensions);
    struct oracle oracle;
    oracle_make(&oracle, &noise, dimensions);
    uint64_t random = fractal;
    struct errors errors = {.points = 0};
    while (errors.points < points) {
        random_points(&random, precision, fractal);
        sample(&noise, dimensions, precision, BLOCK);
        for (size_t i = 0; i < BLOCK && errors.points < points; i++) {
            compare(&noise, &oracle, precision, i, &errors);
        }
    }
    errors.phase /= phase_unit(&oracle);
    printf("%-10s %dD %-7s %-4s %-18s", basis_name((int)basis), dimensions, fade_name((int)fade),
           precision == ORACLE_F32 ? "f32" : "f64", fractals[fractal].name);
    check_errors(&noise, &errors);
}

/*
 * Value and gradient of an octave are continuous across lattice planes, and so is the Hessian but
 * for that with the cubic fade, which jumps; of distances only the value is. Ordinary planes are
 * looked at from 2^-30 on either side, where the fraction below rounds to 1; planes where the cell
 * wraps, from as close as doubles allow.
 */
static void check_continuity(enum scarp_basis basis, enum scarp_fade fade, int dimensions,
                             long planes)
{
    static const double wraps[] = {0.0, 0x1p31, 0x1p32, -0x1p31, -0x1p32};
    /* No derivative of the next order exceeds these, per cell. */
    static const double variation[3] = {8.0, 45.0, 1000.0};
    const struct scarp_noise noise = {.basis = basis, .fade = fade, .seed = 11};
    uint64_t random = 3;
    double worst[3] = {0.0, 0.0, 0.0}; /* jumps in units of what is allowed */
    for (long plane = 0; plane < planes; plane++) {
        /* Rows of triangles do not begin at integers. */
        const int axis = basis == SCARP_SIMPLEX && dimensions == 2 ? 0 : (int)(plane % dimensions);
        const int wrap = plane % 10 == 0;
        const double at =
            wrap ? wraps[plane / 10 % 5] : floor(check_random_double(&random, 0x1p20));
        const double step = wrap ? 0x1p-20 : 0x1p-30;
        double x[3];
        for (int i = 0; i < 3; i++) {
            x[i] = check_random_double(&random, 64.0);
        }
        for (int side = 0; side < 3; side++) {
            x[axis] = at + (side - 1) * step;
            for (int i = 0; i < 3; i++) {
                block->d[i][side] = x[i];
            }
        }
        sample(&noise, dimensions, ORACLE_F64, 3);
        struct oracle_sample below, on, above;
        result(dimensions, 0, &below);
        result(dimensions, 1, &on);
        result(dimensions, 2, &above);
        double down[3], up[3];
        difference(&on, &below, down);
        difference(&above, &on, up);
        for (int order = 0; order < 3; order++) {
            const double allowed = 2.0 * bounds_of(&noise)->max[order] + step * variation[order];
            worst[order] = larger(worst[order], larger(down[order], up[order]) / allowed);
        }
    }
    printf("%-10s %dD %-7s  jumps / allowed: %.2f  %.2f  %.2f\n", basis_name((int)basis),
           dimensions, fade_name((int)fade), worst[0], worst[1], worst[2]);
    CHECK(worst[0] <= 1.0, "the value jumps");
    if (basis_smooth(basis)) {
        CHECK(worst[1] <= 1.0, "the gradient jumps");
        CHECK((worst[2] <= 1.0) == (fade == SCARP_QUINTIC), "Hessian: %g of what is allowed",
              worst[2]);
    }
}

/* On lattice points gradient noise is exactly 0; value noise is the drawn value, scaled, and its
   gradient is exactly 0. Floats hold the coordinates, so both calls see the same points. */
static void check_lattice_points(enum scarp_basis basis, enum scarp_fade fade, int dimensions)
{
    uint64_t random = 5;
    for (uint64_t seed = 0; seed < 4; seed++) {
        const struct scarp_noise noise = {
            .basis = basis, .fade = fade, .seed = check_random(&random), .amplitude = 1.5f};
        struct oracle oracle;
        oracle_make(&oracle, &noise, dimensions);
        for (int precision = ORACLE_F32; precision <= ORACLE_F64; precision++) {
            for (size_t i = 0; i < BLOCK; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    const float span = i % 2 == 0 ? 16.0f : 0x1p23f;
                    block->f[axis][i] = floorf(check_random_float(&random, span));
                    block->d[axis][i] = (double)block->f[axis][i];
                }
            }
            sample(&noise, dimensions, (enum oracle_rounding)precision, BLOCK);
            for (size_t i = 0; i < BLOCK; i++) {
                uint32_t point[3] = {0, 0, 0};
                for (int axis = 0; axis < dimensions; axis++) {
                    point[axis] = (uint32_t)(int32_t)block->f[axis][i];
                }
                struct oracle_sample n;
                result(dimensions, i, &n);
                if (basis == SCARP_GRADIENT) {
                    CHECK(n.value == 0.0, "gradient noise on a lattice point: %g", n.value);
                    continue;
                }
                const double expected =
                    1.5 * (1.0 - 0x1p-17) * oracle_lattice_value(&oracle, 0, point);
                /* The scale and the product are each rounded once. */
                CHECK(fabs(n.value - expected) <= 0x1p-23 * fabs(expected), "%.9g, drawn %.9g",
                      n.value, expected);
                CHECK(n.gradient[0] == 0.0 && n.gradient[1] == 0.0 && n.gradient[2] == 0.0,
                      "value noise slopes on a lattice point");
            }
        }
    }
}

/*
 * The library divides by the very supremum that test_range.c proves (and leaves the head-room of
 * 2^-17): values, as a whole, are the oracle's times a factor of 1. The scale is rounded to float,
 * by 6e-8 at most; the errors of 1000 values average out.
 */
static void check_normalisation(enum scarp_basis basis, enum scarp_fade fade, int dimensions)
{
    const struct scarp_noise noise = {.basis = basis, .fade = fade, .seed = 13};
    struct oracle oracle;
    oracle_make(&oracle, &noise, dimensions);
    uint64_t random = 17;
    random_points(&random, ORACLE_F64, 0);
    sample(&noise, dimensions, ORACLE_F64, BLOCK);
    double product = 0.0, square = 0.0;
    for (size_t i = 0; i < BLOCK; i++) {
        const double x[3] = {block->d[0][i], block->d[1][i], block->d[2][i]};
        struct oracle_sample expected;
        oracle_evaluate(&oracle, ORACLE_F64, x, &expected);
        product += (double)block->out.array[0][i] * expected.value;
        square += expected.value * expected.value;
    }
    CHECK(fabs(product / square - 1.0) <= 1e-7, "%s %dD %s: the scale is off by %g",
          basis_name((int)basis), dimensions, fade_name((int)fade), product / square - 1.0);
}

static void check_noise(enum scarp_basis basis, enum scarp_fade fade, int dimensions, long points)
{
    /* The oracle's sums over all vertices and cells near a point take their time. */
    const long compared = blends_corners(basis) ? points : points / 50;
    for (size_t i = 0; i < sizeof fractals / sizeof fractals[0]; i++) {
        check_accuracy(i, basis, fade, dimensions, ORACLE_F32, compared);
        check_accuracy(i, basis, fade, dimensions, ORACLE_F64, compared);
    }
    if (basis != SCARP_CELL_VALUE) {
        check_continuity(basis, fade, dimensions, points / 10);
    }
    if (blends_corners(basis)) {
        check_lattice_points(basis, fade, dimensions);
    }
    check_normalisation(basis, fade, dimensions);
}

int main(int argc, char **argv)
{
    const long points = check_argument(argc, argv, argc > 2 ? 1 : 2, BLOCK, "POINTS ISA");
    check_select_isa(argv[2]);
    block = block_make();
    printf("error in units of sum |a_k| f_k^order: max, RMS of value; of gradient; of Hessian; "
           "then of dphase; points excluded\n");
    for (int i = 0; i < 8; i++) {
        check_noise(i & 4 ? SCARP_VALUE : SCARP_GRADIENT, i & 1 ? SCARP_CUBIC : SCARP_QUINTIC,
                    i & 2 ? 3 : 2, points);
    }
    for (int basis = SCARP_SIMPLEX; basis < count_names(basis_name); basis++) {
        for (int dimensions = 2; dimensions <= 3; dimensions++) {
            check_noise((enum scarp_basis)basis, SCARP_QUINTIC, dimensions, points);
        }
    }
    block_free(block);
    return check_done();
}
