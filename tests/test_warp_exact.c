/* SPDX-License-Identifier: MIT
 *
 * Are the gradient and the Hessian of noise with warps those of its value? The value is that of
 * y = x + d(x) in double, noise and d being the oracle's; the derivatives are central differences
 * of it. What comes out without the Jacobian of y, the gradient of the noise at y, is measured
 * next to it. Argument: the number of points per case.
 */
#include "fractal.h"
#include "oracle_warp.h"

#define STEP 0x1p-17
#define SECOND_STEP 0x1p-14

static double value_beside(const struct oracle_warped *warped, const double x[3],
                           const double by[3])
{
    const double at[3] = {x[0] + by[0], x[1] + by[1], x[2] + by[2]};
    struct oracle_sample n;
    oracle_warped_at(warped, at, &n);
    return n.value;
}

static double first_difference_along(const struct oracle_warped *warped, const double x[3],
                                     int axis)
{
    double up[3] = {0.0, 0.0, 0.0}, down[3] = {0.0, 0.0, 0.0};
    up[axis] = STEP;
    down[axis] = -STEP;
    return (value_beside(warped, x, up) - value_beside(warped, x, down)) / (2.0 * STEP);
}

static double second_difference_along(const struct oracle_warped *warped, const double x[3], int a,
                                      int b)
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        double by[3] = {0.0, 0.0, 0.0};
        by[a] += i & 1 ? -SECOND_STEP : SECOND_STEP;
        by[b] += i & 2 ? -SECOND_STEP : SECOND_STEP;
        sum += value_beside(warped, x, by) * (i == 0 || i == 3 ? 1.0 : -1.0);
    }
    return sum / (4.0 * SECOND_STEP * SECOND_STEP);
}

/* Largest errors, and sums of squares. */
struct errors {
    double max, squares, of, without;
    double max_second, squares_second, of_second;
};

static void compare_point(const struct oracle_warped *warped, const double x[3],
                          const struct oracle_sample *n, struct errors *e)
{
    struct oracle_sample at_y;
    oracle_warped_at(warped, x, &at_y);
    for (int a = 0; a < warped->dimensions; a++) {
        const double slope = first_difference_along(warped, x, a);
        e->max = larger(e->max, fabs(n->gradient[a] - slope));
        e->squares += pow(n->gradient[a] - slope, 2.0);
        e->of += slope * slope;
        e->without += pow(at_y.gradient[a] - slope, 2.0);
        for (int b = 0; b <= a; b++) {
            const double second = second_difference_along(warped, x, a, b);
            e->max_second = larger(e->max_second, fabs(n->hessian[a][b] - second));
            e->squares_second += pow(n->hessian[a][b] - second, 2.0);
            e->of_second += second * second;
        }
    }
}

/* Bounds are about three times what was measured on 10^4 points. Second differences are rounded,
   and third derivatives jump between cells. */
static void check_case(const struct scarp_noise *noise, int dimensions, long points)
{
    static struct oracle_warped warped;
    struct block *const block = block_make();
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    struct errors e = {.max = 0.0};
    uint64_t random = 1;
    oracle_warped_make(&warped, noise, dimensions);
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 64.0f);
        block_sample(block, noise, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3];
            block_point(block, i, x);
            const struct oracle_sample n = block_result(block, noise, f, i);
            compare_point(&warped, x, &n, &e);
        }
    }
    const double count = (double)(points * dimensions), pairs = 0.5 * (dimensions + 1);
    const double rms = sqrt(e.squares / count), of = sqrt(e.of / count);
    const double without = sqrt(e.without / count);
    const double second = sqrt(e.squares_second / count / pairs);
    const double of_second = sqrt(e.of_second / count / pairs);
    printf("warp %dD, %d deep: gradient max %.1e, rms %.1e of %.2f; without the Jacobian rms %.2f; "
           "Hessian max %.1e, rms %.1e of %.1f\n",
           dimensions, warped.depth, e.max, rms, of, without, e.max_second, second, of_second);
    CHECK(e.max <= 5e-5 * of && rms <= 2e-6 * of, "gradient: off by %g, rms %g", e.max, rms);
    CHECK(without >= 0.2 * of, "without the Jacobian the rms error is %g only", without);
    CHECK(e.max_second <= 5e-2 * of_second && second <= 1e-3 * of_second,
          "Hessian: off by %g, rms %g", e.max_second, second);
    block_free(block);
}

int main(int argc, char **argv)
{
    static const struct scarp_noise chains[ORACLE_WARPS + 1] = {
        {.seed = 5, .octaves = 2.0f, .frequency = 0.5, .amplitude = 0.5f},
        {.seed = 4, .octaves = 2.0f, .frequency = 0.5, .amplitude = 0.5f, .warp = &chains[0]},
        {.seed = 3,
         .octaves = 2.0f,
         .frequency = 0.5,
         .amplitude = 0.5f,
         .offset_first = 1,
         .warp = &chains[1]},
        {.seed = 2, .octaves = 2.0f, .frequency = 0.5, .amplitude = 0.5f, .warp = &chains[2]},
    };
    const long points = check_argument(argc, argv, 1, BLOCK, "POINTS") / BLOCK * BLOCK;
    for (int i = 0; i < 6; i++) {
        const struct scarp_noise noise = {.seed = 1,
                                          .octaves = 3.0f,
                                          .rotate = 1,
                                          .offset_first = 1,
                                          .warp = &chains[i / 2 == 2 ? 3 : i / 2]};
        check_case(&noise, 2 + i % 2, points);
    }
    return check_done();
}
