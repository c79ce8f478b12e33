/* SPDX-License-Identifier: MIT
 *
 * Swiss and Jordan noise against the oracle: how far values and gradients are from its, and whether
 * the gradient is that of the value, by central differences of the oracle's values in double along
 * each axis. What comes out without the Jacobians of where octaves look is measured beside.
 * Argument: the number of points per case.
 *
 * A point is left out where a crease goes through its stencil, by the oracle: Swiss noise has one
 * where n_k is 0, and where what octaves are multiplied by is clamped.
 */
#include "fractal.h"

#define STEP 0x1p-20
#define CREASE 1e-5 /* nearer than this to a crease, the library may be on its other side */

struct errors {
    double max[3], squares[3], of, without; /* of value, gradient, gradient by differences */
    long points, excluded;
};

/* Gives the oracle's difference along an axis. Returns whether no crease is near. */
static int difference_along(const struct oracle *oracle, const double x[3], int axis, double *slope)
{
    struct oracle_sample sum[2];
    struct oracle_creases creases[2];
    for (int i = 0; i < 2; i++) {
        double at[3] = {x[0], x[1], x[2]};
        at[axis] += i == 0 ? STEP : -STEP;
        oracle_evaluate_creased(oracle, ORACLE_EXACT, at, &sum[i], &creases[i]);
    }
    *slope = (sum[0].value - sum[1].value) / (2.0 * STEP);
    return creases[0].side == creases[1].side;
}

static void add_point(struct errors *e, int order, double off, double unit)
{
    e->max[order] = larger(e->max[order], fabs(off) / unit);
    e->squares[order] += pow(off / unit, 2.0);
}

static void compare_point(const struct oracle *oracle, const double x[3],
                          const struct oracle_sample *n, struct errors *e)
{
    struct oracle_sample expected, frozen;
    struct oracle_creases creases;
    double slope[3] = {0.0, 0.0, 0.0};
    int clear = 1;
    oracle_evaluate_creased(oracle, ORACLE_EXACT, x, &expected, &creases);
    oracle_frozen_gradient(oracle, ORACLE_EXACT, x, frozen.gradient);
    for (int axis = 0; axis < oracle->dimensions; axis++) {
        clear &= difference_along(oracle, x, axis, &slope[axis]);
    }
    if (!clear || creases.clearance < CREASE) {
        e->excluded++;
        return;
    }
    const double unit = fractal_unit(oracle, 1);
    e->points++;
    add_point(e, 0, n->value - expected.value, fractal_unit(oracle, 0));
    for (int axis = 0; axis < oracle->dimensions; axis++) {
        add_point(e, 1, n->gradient[axis] - expected.gradient[axis], unit);
        add_point(e, 2, n->gradient[axis] - slope[axis], unit);
        e->of += pow(slope[axis] / unit, 2.0);
        e->without += pow((frozen.gradient[axis] - slope[axis]) / unit, 2.0);
    }
}

/* Bounds by [Jordan], about three times what was measured, in units of sum |a_k| f_k^order: value,
   gradient, and gradient by differences. */
static const double max_bounds[2][3] = {{1e-6, 9e-6, 9e-6}, {9e-7, 3e-5, 3e-5}};
static const double rms_bounds[2][3] = {{2e-7, 5e-7, 5e-7}, {9e-8, 2.5e-7, 2.5e-7}};

static void check_case(struct block *block, const struct scarp_noise *noise, int dimensions,
                       long points)
{
    static struct oracle oracle;
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    const int jordan = noise->fractal == SCARP_JORDAN;
    struct errors e = {.points = 0};
    uint64_t random = 1;
    oracle_make(&oracle, noise, dimensions);
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 64.0f);
        block_sample(block, noise, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3];
            block_point(block, i, x);
            const struct oracle_sample n = block_result(block, noise, f, i);
            compare_point(&oracle, x, &n, &e);
        }
    }
    double rms[3];
    for (int i = 0; i < 3; i++) {
        rms[i] = sqrt(e.squares[i] / (double)(e.points * (i == 0 ? 1 : dimensions)));
        CHECK(e.max[i] <= max_bounds[jordan][i] && rms[i] <= rms_bounds[jordan][i],
              "%s %dD, %s: off by %g, rms %g", fractal_names[noise->fractal], dimensions,
              i == 0   ? "value"
              : i == 1 ? "gradient"
                       : "differences",
              e.max[i], rms[i]);
    }
    const double of = sqrt(e.of / (double)(e.points * dimensions));
    const double without = sqrt(e.without / (double)(e.points * dimensions));
    printf("%-7s %dD %-8s value max %.1e, rms %.1e; gradient max %.1e, rms %.1e; by differences "
           "max %.1e, rms %.1e of %.2f; without the Jacobians rms %.2f; %ld points excluded\n",
           fractal_names[noise->fractal], dimensions, basis_name((int)noise->basis), e.max[0],
           rms[0], e.max[1], rms[1], e.max[2], rms[2], of, without, e.excluded);
    CHECK(without >= 0.1 * of, "without the Jacobians rms %g of %g only", without, of);
    CHECK(e.excluded <= points / 500, "%ld points excluded", e.excluded);
}

int main(int argc, char **argv)
{
    const long points = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    if (points < BLOCK || points % BLOCK != 0) {
        printf("usage: %s POINTS (a multiple of %d)\n", argv[0], BLOCK);
        return EXIT_FAILURE;
    }
    struct block *const block = block_make();
    printf("errors in units of sum |a_k| f_k^order\n");
    for (int i = 0; i < 8; i++) {
        const struct scarp_noise noise = {.fractal = i / 4 == 0 ? SCARP_SWISS : SCARP_JORDAN,
                                          .basis = i / 2 % 2 == 0 ? SCARP_GRADIENT : SCARP_VALUE,
                                          .seed = 3,
                                          .octaves = 4.0f,
                                          .rotate = 1,
                                          .amplitude = i / 2 % 2 == 0 ? 1.0f : -5.0f,
                                          .erosion = 0.9f,
                                          .phase = i % 4 == 1 ? 0.3f : 0.0f};
        check_case(block, &noise, 2 + i % 2, points);
    }
    block_free(block);
    return check_done();
}
