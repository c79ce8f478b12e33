/* SPDX-License-Identifier: MIT
 *
 * What makes simplex noise worth having: no jumps of value, gradient or Hessian where triangles and
 * tetrahedra meet, and no preferred direction, in slices neither. Then what it shares with cellular
 * noise: mean and variance, that cells lie where the distances say, and tiles without seams.
 *
 *     test_simplex ISA [POINTS]    POINTS for each statistic
 */
#include "fractal.h"

static struct block *block;

static enum function doubles(int dimensions)
{
    return dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
}

/* The corners of a triangle or tetrahedron. */
struct cell {
    double vertex[4][3];
};

static struct cell random_triangle(uint64_t *random)
{
    const double height = sqrt(3.0) / 2.0;
    const double row = floor(check_random_double(random, 64.0));
    const double x = floor(check_random_double(random, 64.0));
    const double shift = fmod(row, 2.0) != 0.0 ? 0.5 : 0.0;
    const double up = (check_random(random) >> 63) != 0 ? 1.0 : -1.0;
    const struct cell c = {{{x + shift, row * height, 0.0},
                            {x + shift + 1.0, row * height, 0.0},
                            {x + shift + 0.5, (row + up) * height, 0.0}}};
    return c;
}

/* Two neighbouring corners of the cubic lattice, and the centres of two neighbouring cubes at the
   edge between them. */
static struct cell random_tetrahedron(uint64_t *random)
{
    struct cell c;
    const int along = (int)(check_random(random) % 3), across = (along + 1) % 3;
    for (int i = 0; i < 3; i++) {
        const double at = floor(check_random_double(random, 64.0));
        for (int v = 0; v < 4; v++) {
            c.vertex[v][i] = at + (v < 2 ? 0.0 : 0.5);
        }
    }
    c.vertex[1][along] += 1.0;
    c.vertex[3][across] -= 1.0;
    if ((check_random(random) >> 63) != 0) {
        c.vertex[2][3 - along - across] -= 1.0;
        c.vertex[3][3 - along - across] -= 1.0;
    }
    return c;
}

/* A random point of the side of a cell that does not have corner `off`; near corners as often as in
   the middle. */
static void point_on_side(const struct cell *c, int dimensions, int off, uint64_t *random,
                          double x[3])
{
    double weight[4], sum = 0.0;
    for (int v = 0; v <= dimensions; v++) {
        const double w = fabs(check_random_double(random, 1.0));
        weight[v] = v == off ? 0.0 : w * w;
        sum += weight[v];
    }
    for (int i = 0; i < 3; i++) {
        x[i] = 0.0;
        for (int v = 0; v <= dimensions; v++) {
            x[i] += c->vertex[v][i] * weight[v] / sum;
        }
    }
}

#define STEP 0x1p-26

/* Compares noise on both sides of random sides. A vertex that is left out or added there would be
   seen: with r^2 = 0.6 in 3D, as it is elsewhere, values jump by up to 5e-3. */
static void test_continuity(int dimensions, long points)
{
    /* Twice the errors of test_accuracy.c, and the step times the largest next derivative. */
    static const double allowed[3] = {1.4e-6 + 16 * STEP, 8e-6 + 100 * STEP, 6e-5 + 2000 * STEP};
    const struct scarp_noise noise = {.basis = SCARP_SIMPLEX, .seed = 3};
    uint64_t random = 1;
    double worst[3] = {0.0, 0.0, 0.0};
    for (long done = 0; done < points; done += BLOCK / 2) {
        for (size_t i = 0; i < BLOCK; i += 2) {
            const struct cell c =
                dimensions == 2 ? random_triangle(&random) : random_tetrahedron(&random);
            double x[3];
            point_on_side(&c, dimensions, (int)(i / 2 % (size_t)(dimensions + 1)), &random, x);
            for (int axis = 0; axis < 3; axis++) {
                const double move = check_random_double(&random, STEP);
                block->d[axis][i] = x[axis] - move;
                block->d[axis][i + 1] = x[axis] + move;
            }
        }
        block_sample(block, &noise, doubles(dimensions), BLOCK);
        for (size_t i = 0; i < BLOCK; i += 2) {
            const struct oracle_sample a = block_result(block, &noise, doubles(dimensions), i);
            const struct oracle_sample b = block_result(block, &noise, doubles(dimensions), i + 1);
            double jump[3];
            difference(&a, &b, jump);
            for (int order = 0; order < 3; order++) {
                worst[order] = larger(worst[order], jump[order]);
            }
        }
    }
    printf("%dD: across sides value, gradient and Hessian change by %.1e, %.1e, %.1e\n", dimensions,
           worst[0], worst[1], worst[2]);
    for (int order = 0; order < 3; order++) {
        CHECK(worst[order] <= allowed[order], "%dD, derivative %d jumps by %g", dimensions, order,
              worst[order]);
    }
}

/* On a vertex only its own gradient is seen: the value is 0, and the slope r^8 over the supremum.
 */
static void test_vertices(int dimensions)
{
    const struct scarp_noise noise = {.basis = SCARP_SIMPLEX, .seed = 4};
    const double slope = dimensions == 2 ? pow(0.75, 4.0) / 0.062366952212268554
                                         : pow(0.5, 4.0) * sqrt(2.0) / 0.013007101282926131;
    uint64_t random = 2;
    for (size_t i = 0; i < BLOCK; i++) {
        for (int axis = 0; axis < 3; axis++) {
            /* The centres of cubes are vertices, too; of rows only one is at an integer. */
            block->d[axis][i] = floor(check_random_double(&random, 0x1p20)) + (i % 2 ? 0.5 : 0.0);
        }
        if (dimensions == 2) {
            block->d[0][i] = floor(block->d[0][i]);
            block->d[1][i] = 0.0;
        }
    }
    block_sample(block, &noise, doubles(dimensions), BLOCK);
    for (size_t i = 0; i < BLOCK; i++) {
        const struct oracle_sample n = block_result(block, &noise, doubles(dimensions), i);
        const double *const g = n.gradient;
        const double length = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        CHECK(n.value == 0.0, "%dD: %g on a vertex", dimensions, n.value);
        CHECK(fabs(length / slope - 1.0) <= 2e-5, "%dD: slope %g on a vertex, not %g", dimensions,
              length, slope);
    }
}

/* Adds up (u.Hu)^2 by directions u, all in the plane of x and y, or in space. */
#define DIRECTIONS 13

static void directions_make(double u[DIRECTIONS][3], int in_plane)
{
    for (int k = 0; k < DIRECTIONS; k++) {
        const double angle = k * 3.14159265358979 / DIRECTIONS;
        /* the 13 lines through the neighbours of a cube: 1 0 0, then -1 1 0, and so on to 1 1 1 */
        const int n = k + 5, signs[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9};
        const double length = sqrt(signs[0] * signs[0] + signs[1] * signs[1] + signs[2] * signs[2]);
        u[k][0] = in_plane ? cos(angle) : signs[0] / length;
        u[k][1] = in_plane ? sin(angle) : signs[1] / length;
        u[k][2] = in_plane ? 0.0 : signs[2] / length;
    }
}

/* The mean curvature is the same in all directions. Slices: in planes across z, at z = 0. Sampling
   changes the ratio of the largest to the least by some 3 over the square root of the points, if
   these are many: squares of curvatures vary much. */
#define ISOTROPY_LEAST 50000

static void test_isotropy(int dimensions, int slices, long points, double most)
{
    const struct scarp_noise noise = {.basis = SCARP_SIMPLEX, .seed = 5};
    double u[DIRECTIONS][3], sum[DIRECTIONS] = {0.0}, least, greatest;
    uint64_t random = 3;
    directions_make(u, dimensions == 2 || slices);
    for (long done = 0; done < points; done += BLOCK) {
        for (int axis = 0; axis < 3; axis++) {
            for (size_t i = 0; i < BLOCK; i++) {
                block->d[axis][i] = check_random_double(&random, 0x1p20);
                if (slices && axis == 2) {
                    block->d[axis][i] = floor(block->d[axis][i]);
                }
            }
        }
        block_sample(block, &noise, doubles(dimensions), BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            const struct oracle_sample n = block_result(block, &noise, doubles(dimensions), i);
            for (int k = 0; k < DIRECTIONS; k++) {
                double curvature = 0.0;
                for (int a = 0; a < 9; a++) {
                    curvature += u[k][a / 3] * n.hessian[a / 3][a % 3] * u[k][a % 3];
                }
                sum[k] += curvature * curvature;
            }
        }
    }
    least = greatest = sum[0];
    for (int k = 1; k < DIRECTIONS; k++) {
        least = fmin(least, sum[k]);
        greatest = fmax(greatest, sum[k]);
    }
    const double allowed = most + 3.0 / sqrt((double)points);
    printf("%dD%s: mean square of curvature over directions within 1 : %.4f, at most %.4f\n",
           dimensions, slices ? ", slices" : "", greatest / least, allowed);
    CHECK(greatest / least <= allowed, "%dD: %g", dimensions, greatest / least);
}

/* Means and standard deviations of values, in units of the supremum or of cells, as measured by
   others (research) with 2e5 points or more. */
static void test_statistics(long points)
{
    static const struct {
        enum scarp_basis basis;
        int dimensions;
        double supremum; /* of distances, else 0 */
        double mean, deviation;
    } known[] = {
        {SCARP_SIMPLEX, 2, 0.0, 0.0, 0.539},
        {SCARP_SIMPLEX, 3, 0.0, 0.0, 0.393},
        {SCARP_CELL_F1, 2, 1.4142135624, 0.4304, 0.190},
        {SCARP_CELL_F1, 3, 1.7320508076, 0.5202, 0.173},
        {SCARP_CELL_F2, 2, 1.5811388301, 0.699, 0.0},
        {SCARP_CELL_F2, 3, 1.7320508076, 0.716, 0.0},
        {SCARP_CELL_VALUE, 2, 0.0, 0.0, 0.5773502692},
    };
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
        const struct scarp_noise noise = {.basis = known[k].basis, .seed = 6};
        const double half = known[k].supremum / 2.0, scale = half == 0.0 ? 1.0 : half;
        double mean = 0.0, square = 0.0;
        uint64_t random = 4;
        for (long done = 0; done < points; done += BLOCK) {
            for (int axis = 0; axis < 3; axis++) {
                for (size_t i = 0; i < BLOCK; i++) {
                    block->d[axis][i] = check_random_double(&random, 0x1p20);
                }
            }
            block_sample(block, &noise, doubles(known[k].dimensions), BLOCK);
            for (size_t i = 0; i < BLOCK; i++) {
                const double v = scale * (double)block->out.array[0][i] + half;
                mean += v / (double)points;
                square += v * v / (double)points;
            }
        }
        const double deviation = sqrt(square - mean * mean);
        const double slack = 4.0 / sqrt((double)points) + 1e-3;
        printf("%-10s %dD: mean %.4f, deviation %.4f\n", basis_name((int)noise.basis),
               known[k].dimensions, mean, deviation);
        CHECK(fabs(mean - known[k].mean) <= slack, "mean %g, not %g", mean, known[k].mean);
        CHECK(known[k].deviation == 0.0 || fabs(deviation - known[k].deviation) <= slack,
              "deviation %g, not %g", deviation, known[k].deviation);
    }
}

/* From where a point is, the distance along the gradient leads to the feature: there the distance
   is 0, and the cell's own value the same. */
static void test_features(enum scarp_basis basis, int dimensions)
{
    const enum function f = doubles(dimensions);
    const struct scarp_noise noise = {.basis = basis, .seed = 7};
    const struct scarp_noise first = {.basis = SCARP_CELL_F1, .seed = 7};
    const struct scarp_noise value = {.basis = SCARP_CELL_VALUE, .seed = 7};
    const double n = (double)dimensions;
    const double half1 = sqrt(n) / 2.0;
    const double half = basis == SCARP_CELL_F1 || dimensions == 3 ? half1 : sqrt(2.5) / 2.0;
    static float before[BLOCK];
    uint64_t random = 5;
    block_random(block, &random, 64.0f);
    block_sample(block, &value, f, BLOCK);
    memcpy(before, block->out.array[0], sizeof before);
    block_sample(block, &noise, f, BLOCK);
    for (size_t i = 0; i < BLOCK; i++) {
        const struct oracle_sample s = block_result(block, &noise, f, i);
        for (int axis = 0; axis < dimensions; axis++) {
            block->d[axis][i] -= half * half * (s.value + 1.0) * s.gradient[axis];
        }
    }
    block_sample(block, &first, f, BLOCK);
    for (size_t i = 0; i < BLOCK; i++) {
        const double distance = half1 * ((double)block->out.array[0][i] + 1.0);
        CHECK(distance <= 3e-5, "%s %dD: the feature is %g away from where it should be",
              basis_name((int)basis), dimensions, distance);
    }
    block_sample(block, &value, f, BLOCK);
    long same = 0;
    for (size_t i = 0; i < BLOCK; i++) {
        same += block->out.array[0][i] == before[i];
    }
    CHECK(same == (basis == SCARP_CELL_F1 ? BLOCK : 0), "%s %dD: %ld values are those of the cell",
          basis_name((int)basis), dimensions, same);
}

/* Along an axis with a period, noise meets itself without a seam; in the middle of a long period it
   is that without one. */
static void test_seams(enum scarp_basis basis, int dimensions, int axis, uint32_t period)
{
    struct scarp_noise noise = {.basis = basis, .seed = 8};
    const struct scarp_noise plain = noise;
    const enum function f = doubles(dimensions);
    static float kept[BLOCK];
    double worst[2] = {0.0, 0.0};
    uint64_t random = 6;
    noise.period[axis] = period;
    block_random(block, &random, 64.0f);
    for (size_t i = 0; i < BLOCK; i++) { /* pairs before and behind a seam */
        const double seam = (double)period * (double)((int)(i / 2 % 5) - 2);
        for (int d = 0; d < 3; d++) {
            block->d[d][i] = block->d[d][i - i % 2];
        }
        block->d[axis][i] = seam + (i % 2 == 0 ? -STEP : STEP);
    }
    block_sample(block, &noise, f, BLOCK);
    for (size_t i = 0; i < BLOCK; i += 2) {
        const struct oracle_sample a = block_result(block, &noise, f, i);
        const struct oracle_sample b = block_result(block, &noise, f, i + 1);
        double jump[3];
        difference(&a, &b, jump);
        worst[0] = larger(worst[0], jump[0]);
        worst[1] = larger(worst[1], basis_smooth(basis) ? jump[1] : 0.0);
    }
    CHECK(worst[0] <= 2e-6 + 20 * STEP && worst[1] <= 1e-5 + 200 * STEP,
          "%s %dD, period %u along axis %d: value and gradient jump by %g, %g",
          basis_name((int)basis), dimensions, period, axis, worst[0], worst[1]);
    for (size_t i = 0; i < BLOCK && period >= 7; i++) {
        block->d[axis][i] = 3.0 + (double)i / (2.0 * BLOCK);
    }
    block_sample(block, &noise, f, BLOCK);
    memcpy(kept, block->out.array[0], sizeof kept);
    block_sample(block, &plain, f, BLOCK);
    const size_t same = first_difference(kept, block->out.array[0], BLOCK);
    CHECK((same == BLOCK) == (period >= 7), "%s %dD, period %u along axis %d: point %zu",
          basis_name((int)basis), dimensions, period, axis, same);
}

static void test_all_seams(void)
{
    static const uint32_t periods[] = {1, 2, 7};
    for (int i = 0; i < 3 * 5 * (SCARP_CELL_VALUE - SCARP_SIMPLEX); i++) { /* but CELL_VALUE */
        const int dimensions = i / 3 % 5 < 2 ? 2 : 3,
                  axis = i / 3 % 5 < 2 ? i / 3 % 5 : i / 3 % 5 - 2;
        const enum scarp_basis basis = (enum scarp_basis)(SCARP_SIMPLEX + i / 15);
        if (basis != SCARP_SIMPLEX || dimensions == 3 || axis == 0) {
            test_seams(basis, dimensions, axis, periods[i % 3]);
        }
    }
}

int main(int argc, char **argv)
{
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    const long points = argc > 2 ? strtol(argv[2], NULL, 10) : 100000;
    const long isotropy_points = points > ISOTROPY_LEAST ? points : ISOTROPY_LEAST;
    if (points < BLOCK || points % BLOCK != 0) {
        printf("usage: test_simplex ISA [POINTS] (a multiple of %d)\n", BLOCK);
        return EXIT_FAILURE;
    }
    block = block_make();
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        test_continuity(dimensions, points);
        test_vertices(dimensions);
        test_isotropy(dimensions, 0, isotropy_points, dimensions == 2 ? 1.005 : 1.01);
        test_features(SCARP_CELL_F1, dimensions);
        test_features(SCARP_CELL_F2, dimensions);
    }
    test_isotropy(3, 1, isotropy_points, 1.01);
    test_statistics(points);
    test_all_seams();
    block_free(block);
    return check_done();
}
