/* SPDX-License-Identifier: MIT
 *
 * Gullies against the oracle, with the reference: values, and gradients, which are what differences
 * of the oracle in double show. The base is a sum of waves, with every derivative in closed form.
 *
 *     test_gullies_exact POINTS
 */
#include <inttypes.h>

#include "gullies.h"
#include "oracle_gullies.h"

/* A base of unit amplitude and frequency: value, gradient, Hessian. */
static void waves_at(const double x[2], double of[INS])
{
    static const double wave[5][4] = {/* amplitude, along x, along y, phase */
                                      {0.42, 1.9, 0.7, 0.3},
                                      {0.31, -1.1, 2.3, 1.1},
                                      {0.17, 3.1, 2.9, 2.0},
                                      {0.12, -4.3, 1.7, 0.9},
                                      {0.06, 2.1, -6.1, 2.7}};
    memset(of, 0, INS * sizeof *of);
    for (int i = 0; i < 5; i++) {
        const double a = wave[i][0], u = wave[i][1], v = wave[i][2];
        const double angle = u * x[0] + v * x[1] + wave[i][3];
        of[IN_VALUE] += a * sin(angle);
        of[IN_DX] += a * u * cos(angle);
        of[IN_DY] += a * v * cos(angle);
        of[IN_DXX] -= a * u * u * sin(angle);
        of[IN_DXY] -= a * u * v * sin(angle);
        of[IN_DYY] -= a * v * v * sin(angle);
    }
}

/* The base of a description, at x in units of input. */
static void base_at(const struct oracle_gullies *g, const double x[2], double of[INS])
{
    static const int order[INS] = {0, 1, 1, 2, 2, 2};
    const double cells[2] = {x[0] * g->frequency, x[1] * g->frequency};
    waves_at(cells, of);
    for (int i = 0; i < INS; i++) {
        of[i] *= g->amplitude * pow(g->frequency, order[i]);
    }
}

static double displacement_at(const struct oracle_gullies *g, const double x[2])
{
    double base[INS];
    base_at(g, x, base);
    return oracle_gullies_at(g, x, base[IN_VALUE], &base[IN_DX]);
}

/* The derivative along an axis: differences of sixth order. */
static double slope_at(const struct oracle_gullies *g, const double x[2], int axis)
{
    static const double factor[3] = {0.75, -0.15, 1.0 / 60.0};
    const double step = 0x1p-18 / g->frequency;
    double sum = 0.0;
    for (int i = 1; i <= 3; i++) {
        double before[2] = {x[0], x[1]}, after[2] = {x[0], x[1]};
        before[axis] -= i * step;
        after[axis] += i * step;
        sum += factor[i - 1] * (displacement_at(g, after) - displacement_at(g, before));
    }
    return sum / step;
}

struct errors {
    double value, gradient, squares, gradients;
    long count;
};

/* Compares a point, in units of the amplitude and of the base's cells. */
static void compare_at(struct errors *e, const struct oracle_gullies *g, const double x[2],
                       const float of[OUTS])
{
    const double unit = g->amplitude * g->frequency;
    e->value =
        larger(fabs((double)of[OUT_DISPLACEMENT] - displacement_at(g, x)) / g->amplitude, e->value);
    for (int axis = 0; axis < 2; axis++) {
        const double slope = slope_at(g, x, axis) / unit;
        const double error = (double)of[OUT_DISPLACEMENT_DX + axis] / unit - slope;
        e->gradient = larger(fabs(error), e->gradient);
        e->squares += error * error;
        e->gradients += slope * slope;
        e->count++;
    }
}

/* The points are multiples of 2^-16 cells, so floats have them, too. */
static struct errors compare(const struct scarp_gullies *gullies, int points, int doubles)
{
    struct oracle_gullies g;
    struct errors e = {0};
    uint64_t random = gullies->seed;
    oracle_gullies_make(&g, gullies);
    for (int n = 0; n < points; n++) {
        const double x[2] = {(double)check_random_float(&random, 4.0f) / g.frequency,
                             (double)check_random_float(&random, 4.0f) / g.frequency};
        const float x32[2] = {(float)x[0], (float)x[1]};
        const double rounded[2] = {(double)x32[0], (double)x32[1]};
        const double *const at = doubles ? x : rounded;
        double base[INS];
        float in[INS], of[OUTS];
        float *ins[INS], *outs[OUTS];
        base_at(&g, at, base);
        for (int i = 0; i < INS; i++) {
            in[i] = (float)base[i];
            ins[i] = &in[i];
            outs[i] = &of[i];
        }
        const struct scarp_samples samples = base_of(ins);
        const struct scarp_eroded out = eroded_of(outs, OUT_ALL);
        const enum scarp_status status =
            doubles ? scarp_gullies2_f64(gullies, 1, &x[0], &x[1], &samples, &out)
                    : scarp_gullies2(gullies, 1, &x32[0], &x32[1], &samples, &out);
        CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
        CHECK(of[OUT_VALUE] == in[IN_VALUE] + of[OUT_DISPLACEMENT] &&
                  of[OUT_DX] == in[IN_DX] + of[OUT_DISPLACEMENT_DX] &&
                  of[OUT_DY] == in[IN_DY] + of[OUT_DISPLACEMENT_DY],
              "the sums of seed %" PRIu64, gullies->seed);
        compare_at(&e, &g, at, of);
    }
    return e;
}

int main(int argc, char **argv)
{
    const int points = argc == 2 ? atoi(argv[1]) : 0;
    scarp_isa_select(SCARP_ISA_SCALAR);
    for (size_t n = 0; n < DESCRIPTIONS; n++) {
        for (int doubles = 0; doubles < 2; doubles++) {
            const struct errors e = compare(&descriptions[n], points, doubles);
            const double rms = sqrt(e.squares / (double)e.count);
            /* Sharp crests (seed 14, round 0.02) bend the surface a hundred times as much. */
            const double sharp = descriptions[n].seed == 14 ? 100.0 : 1.0;
            CHECK(e.value < (doubles ? 3e-6 : 2e-5), "value %g", e.value);
            CHECK(e.gradient < sharp * (doubles ? 5e-4 : 1e-2), "gradient %g", e.gradient);
            CHECK(rms < sharp * (doubles ? 5e-6 : 5e-4), "rms %g", rms);
            printf("seed %2" PRIu64 " %s: value %.2g, gradient %.2g, rms %.2g of %.2g\n",
                   descriptions[n].seed, doubles ? "doubles" : "floats ", e.value, e.gradient, rms,
                   sqrt(e.gradients / (double)e.count));
        }
    }
    CHECK(points > 0, "usage: test_gullies_exact POINTS");
    return check_done();
}
