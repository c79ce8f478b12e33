/* SPDX-License-Identifier: MIT
 *
 * Is the oracle right? Its formulas give the published values of improved noise, and its gradients
 * and Hessians are those of its values: differences in double precision say so, next to lattice
 * planes too. The library is not involved.
 */
#include "check.h"
#include "oracle.h"

/*
 * Improved noise at points that others have published: (3.14, 42, 7) at rosettacode.org; the
 * diagonal to 12 digits in tests of ray tracers; the rest by running the reference implementation.
 */
static void check_published_values(void)
{
    static const struct {
        double x[3], value;
    } published[] = {
        {{3.14, 42.0, 7.0}, 0.13691995878400012},
        {{0.1, 0.1, 0.1}, 0.1861607143544832},
        {{0.5, 0.5, 0.5}, -0.25},
        {{1.25, 1.25, 1.25}, -0.39553093537688255},
        {{1.5, 1.5, 1.5}, -0.5},
        {{2.5, 2.5, 2.5}, 0.25},
        {{4.5, 4.5, 4.5}, -0.125},
        {{5.0, 5.0, 5.0}, 0.0},
        {{3.14, 42.42, 7.7}, 0.46586248706978528},
    };
    for (size_t i = 0; i < sizeof published / sizeof published[0]; i++) {
        const double *const x = published[i].x;
        uint32_t cell[3];
        double t[3];
        for (int axis = 0; axis < 3; axis++) {
            cell[axis] = (uint32_t)x[axis];
            t[axis] = x[axis] - floor(x[axis]);
        }
        struct oracle_sample n;
        oracle_gradient_noise(oracle_perlin_gradient, NULL, 3, SCARP_QUINTIC, cell, t, &n);
        CHECK(fabs(n.value - published[i].value) <= 1e-12, "(%g, %g, %g): %.17g, published %.17g",
              x[0], x[1], x[2], n.value, published[i].value);
    }
}

/* How differences were taken: fourth order away from lattice planes (error h^4 f^(5) / 30), second
   order beside them (h^2 f^(3) / 6), where the step must be tiny to stay on one side. */
struct scheme {
    const char *name;
    int order;
    double step, tolerance; /* relative to f_k^order, summed */
};

/* The partial derivatives along `axis` of the value and of the gradient, by central differences. */
static void differences(const struct oracle *oracle, const struct scheme *scheme, const double x[3],
                        int axis, double first[4])
{
    static const double weights[2][2] = {{1.0 / 2.0, 0.0}, {2.0 / 3.0, -1.0 / 12.0}};
    for (int i = 0; i < 4; i++) {
        first[i] = 0.0;
    }
    for (int n = 1; n <= scheme->order / 2; n++) {
        struct oracle_sample side[2];
        for (int s = 0; s < 2; s++) {
            double y[3] = {x[0], x[1], x[2]};
            y[axis] += (s == 0 ? -n : n) * scheme->step;
            oracle_evaluate(oracle, ORACLE_EXACT, y, &side[s]);
        }
        const double weight = weights[scheme->order / 2 - 1][n - 1] / scheme->step;
        first[0] += weight * (side[1].value - side[0].value);
        for (int i = 0; i < 3; i++) {
            first[1 + i] += weight * (side[1].gradient[i] - side[0].gradient[i]);
        }
    }
}

/* Raises `worst` to the errors at x: of the gradient [0], of the Hessian [1]. */
static void compare(const struct oracle *oracle, const struct scheme *scheme, const double x[3],
                    double worst[2])
{
    struct oracle_sample n;
    oracle_evaluate(oracle, ORACLE_EXACT, x, &n);
    for (int j = 0; j < oracle->dimensions; j++) {
        double along[4];
        differences(oracle, scheme, x, j, along);
        worst[0] = larger(worst[0], fabs(along[0] - n.gradient[j]));
        for (int i = 0; i < oracle->dimensions; i++) {
            worst[1] = larger(worst[1], fabs(along[1 + i] - n.hessian[i][j]));
        }
    }
}

/* Differences see nothing of distances next to a feature, where derivatives of F grow as
   1 / F^n. */
static double nearest_feature(const struct oracle *oracle, const double x[3])
{
    struct oracle_sample n;
    struct oracle_creases creases;
    oracle_evaluate_creased(oracle, ORACLE_EXACT, x, &n, &creases);
    return creases.nearest;
}

/* Whether a crease of a fractal goes through the points that differences at x are made of. */
static int is_creased(const struct oracle *oracle, const struct scheme *scheme, const double x[3])
{
    struct oracle_sample n;
    struct oracle_creases here, there;
    oracle_evaluate_creased(oracle, ORACLE_EXACT, x, &n, &here);
    for (int i = 0; i < 2 * scheme->order / 2 * oracle->dimensions; i++) {
        double y[3] = {x[0], x[1], x[2]};
        y[i % oracle->dimensions] += (i / oracle->dimensions - scheme->order / 2 +
                                      (i / oracle->dimensions >= scheme->order / 2)) *
                                     scheme->step;
        oracle_evaluate_creased(oracle, ORACLE_EXACT, y, &n, &there);
        if (there.side != here.side) {
            return 1;
        }
    }
    return 0;
}

/* Those whose value has slopes in it have none. */
static int has_hessian(enum scarp_fractal fractal)
{
    return !fractal_has(fractal, FRACTAL_SLOPES);
}

static void check_scheme(const struct oracle *oracle, const struct scheme *scheme, int near_planes,
                         const char *name)
{
    uint64_t random = 7;
    double worst[2] = {0.0, 0.0};
    /* Brute force takes its time. */
    const int points = oracle->basis < SCARP_SIMPLEX ? 2000 : oracle->dimensions == 2 ? 400 : 100;
    int compared = 0;
    while (compared < points) {
        double x[3];
        for (int i = 0; i < 3; i++) {
            x[i] = check_random_double(&random, 16.0);
            /* On most points at least one coordinate is next to a plane, on either side. */
            const uint64_t choice = check_random(&random) >> 62;
            if (near_planes && choice < 2) {
                x[i] = floor(x[i]) + (choice == 0 ? 1e-7 : -1e-7);
            }
        }
        if (oracle_clearance(oracle, x) <= scheme->step * scheme->order / 2 ||
            nearest_feature(oracle, x) < 0.2 || is_creased(oracle, scheme, x)) {
            continue;
        }
        compare(oracle, scheme, x, worst);
        compared++;
    }
    printf("%-34s %-14s %.1e  %.1e\n", name, scheme->name, worst[0], worst[1]);
    CHECK(worst[0] <= scheme->tolerance, "%s, %s: gradient off by %g", name, scheme->name,
          worst[0]);
    CHECK(!has_hessian(oracle->fractal) || worst[1] <= 10.0 * scheme->tolerance,
          "%s, %s: Hessian off by %g", name, scheme->name, worst[1]);
}

/* With steps of 2^-12 the fourth-order error is below 2^-48 * 720 * 8 / 30 = 7e-13 per cell, and
   rounding 2^-53 * 2^12 times a few; 2^-25 gives 2^-50 * 60 * 8 / 6 = 7e-14, and rounding 4e-9
   times a few. Sums of three octaves at up to 1.9^2 lose f^5 = 600 more. */
static const struct scheme inside = {"inside cells", 4, 0x1p-12, 4e-11};
static const struct scheme several = {"inside cells", 4, 0x1p-12, 2e-9};
static const struct scheme beside = {"1e-7 of planes", 2, 0x1p-25, 1e-7};

/* Fractals fold octaves, and make quotients of their slopes. Where octaves of bent ones look, there
   may be lattice planes. */
static const struct scheme folds = {"inside cells", 4, 0x1p-14, 2e-8};
static const struct scheme bends = {"anywhere", 2, 0x1p-19, 2e-7};

/* Derivatives of simplex and cellular noise grow faster with their order. */
static const struct scheme inside_steep = {"inside", 4, 0x1p-12, 4e-9};
static const struct scheme several_steep = {"inside", 4, 0x1p-12, 4e-6};
static const struct scheme beside_steep = {"1e-7 of planes", 2, 0x1p-25, 1e-6};

static void check_basis(struct scarp_noise noise, int dimensions)
{
    const int on_cube = noise.basis == SCARP_GRADIENT || noise.basis == SCARP_VALUE;
    char name[80];
    struct oracle oracle;
    snprintf(name, sizeof name, "%s %dD %s", basis_name((int)noise.basis), dimensions,
             fade_name((int)noise.fade));
    oracle_make(&oracle, &noise, dimensions);
    check_scheme(&oracle, on_cube ? &inside : &inside_steep, 0, name);
    check_scheme(&oracle, on_cube ? &beside : &beside_steep, 1, name);
    noise.octaves = 2.5f;
    noise.lacunarity = 1.9f;
    noise.rotate = 1;
    oracle_make(&oracle, &noise, dimensions);
    strcat(name, ", fBm turned");
    check_scheme(&oracle, on_cube ? &several : &several_steep, 0, name);
}

static void check_fractal(enum scarp_fractal fractal, enum scarp_basis basis, int dimensions)
{
    const struct scarp_noise noise = {.fractal = fractal,
                                      .basis = basis,
                                      .seed = 5,
                                      .octaves = 3.5f,
                                      .of_octaves = 4.5f,
                                      .lacunarity = 1.9f,
                                      .gain = 0.6f,
                                      .erosion = 0.7f,
                                      .rotate = 1,
                                      .sharpness = fractal_bends(fractal) ? 0.2f : 1.3f};
    char name[80];
    struct oracle oracle;
    snprintf(name, sizeof name, "%s %dD %s, turned", basis_name((int)basis), dimensions,
             fractal_name((int)fractal));
    oracle_make(&oracle, &noise, dimensions);
    check_scheme(&oracle, fractal_bends(fractal) ? &bends : &folds, 0, name);
}

static void check_derivatives(void)
{
    printf("largest difference from the differences:             gradient  Hessian\n");
    for (int i = 0; i < 4; i++) {
        const enum scarp_fade fade = i & 1 ? SCARP_CUBIC : SCARP_QUINTIC;
        check_basis((struct scarp_noise){.seed = 5, .fade = fade}, i & 2 ? 3 : 2);
        check_basis((struct scarp_noise){.basis = SCARP_VALUE, .seed = 5, .fade = fade},
                    i & 2 ? 3 : 2);
    }
    /* Each cell's own value has no derivatives. */
    for (int basis = SCARP_SIMPLEX; basis < SCARP_CELL_VALUE; basis++) {
        for (int dimensions = 2; dimensions <= 3; dimensions++) {
            check_basis((struct scarp_noise){.basis = (enum scarp_basis)basis, .seed = 5},
                        dimensions);
        }
    }
    check_basis((struct scarp_noise){.basis = SCARP_CELL_F2, .seed = 5, .jitter = 0.3f}, 3);
    for (int i = 4 * SCARP_TURBULENCE; i < 4 * count_names(fractal_name); i++) {
        check_fractal((enum scarp_fractal)(i / 4), (enum scarp_basis)(i / 2 % 2), 2 + i % 2);
    }
}

int main(void)
{
    check_published_values();
    check_derivatives();
    return check_done();
}
