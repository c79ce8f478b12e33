/* SPDX-License-Identifier: MIT
 *
 * Published statistics of nearest features. The oracle's search gets features that are spread as
 * others spread theirs, and must give the mean distances that they published; and the library's
 * cells, one feature in each, must have the means that follow from that by integration. Argument:
 * the number of points in the plane; there are a quarter as many in space, and four times as many
 * of the library.
 */
#include "check.h"
#include "oracle.h"

#define MOST_FEATURES 8 /* in a cell */

#define BLOCK 4096 /* points of a call */

/* Sums of F1, F2, F3, F1^2, and of F2 - F1 as the basis has it. */
struct sums {
    double distance[ORACLE_FEATURES], square, edge;
};

static double uniform(uint64_t *random)
{
    return ldexp((double)(check_random(random) >> 11), -53);
}

/* A count of features, from the chances of 0, 1, ... */
static int draw_count(const double chance[MOST_FEATURES + 1], uint64_t *random)
{
    double left = uniform(random);
    int count = 0;
    while (count < MOST_FEATURES && left >= chance[count]) {
        left -= chance[count++];
    }
    return count;
}

/* The means over points in the middle cells of blocks of 5^n cells, each with its own features. */
static struct sums means(int dimensions, const double chance[MOST_FEATURES + 1], int points)
{
    uint64_t random = 11;
    struct sums mean = {{0.0}, 0.0, 0.0};
    for (int point = 0; point < points; point++) {
        double t[3];
        struct oracle_feature nearest[ORACLE_FEATURES];
        struct oracle_sample n;
        oracle_features_none(nearest);
        for (int i = 0; i < 3; i++) {
            t[i] = uniform(&random);
        }
        for (int cell = 0; cell < (dimensions == 2 ? 25 : 125); cell++) {
            const int corner[3] = {cell % 5 - 2, cell / 5 % 5 - 2, cell / 25 - 2};
            for (int left = draw_count(chance, &random); left > 0; left--) {
                struct oracle_feature f = {0};
                for (int i = 0; i < dimensions; i++) {
                    f.d[i] = t[i] - (corner[i] + uniform(&random));
                }
                oracle_features_add(dimensions, f, nearest);
            }
        }
        for (int rank = 0; rank < ORACLE_FEATURES; rank++) {
            mean.distance[rank] += fmin(3.0, nearest[rank].distance) / points;
        }
        oracle_cell_noise_of(nearest, SCARP_CELL_F1, dimensions, &n);
        mean.square += n.value * n.value / points;
        oracle_cell_noise_of(nearest, SCARP_CELL_EDGE, dimensions, &n);
        mean.edge += fmin(3.0, n.value) / points;
    }
    return mean;
}

/* The chances of a Poisson distribution of this mean. */
static void poisson(double mean, double chance[MOST_FEATURES + 1])
{
    chance[0] = exp(-mean);
    for (int i = 1; i <= MOST_FEATURES; i++) {
        chance[i] = chance[i - 1] * mean / i;
    }
}

/* Whether the mean over `points` of what has this standard deviation is what it should be: chance
   has it 4 standard errors off once in 16,000 times, and the numbers are the same each time. */
static void check_mean(const char *what, double mean, double expected, double deviation,
                       double points)
{
    const double error = deviation / sqrt(points);
    printf("%-48s %.5f, expected %.5f, standard error %.5f\n", what, mean, expected, error);
    CHECK(fabs(mean - expected) <= 4.0 * error, "%s: %.6f, expected %.6f", what, mean, expected);
}

/*
 * Features that are spread evenly, one in each unit of area or volume in the mean: a Poisson
 * process. The mean distance to the nearest and its standard deviation are 0.5 and 0.26136 in the
 * plane (P. J. Clark and F. C. Evans, "Distance to nearest neighbor as a measure of spatial
 * relationships in populations", Ecology 35, 1954), and 0.55396 is the mean in space (P. Hertz,
 * Mathematische Annalen 67, 1909; S. Chandrasekhar, Reviews of Modern Physics 15, 1943). In the
 * plane, that to the second and third are 0.75 and 0.9375 (H. R. Thompson, Ecology 37, 1956). In
 * space, they are 4/3 and 14/9 of the first, and its mean square is Gamma(5/3) (3 / (4 pi))^(2/3).
 */
static void check_poisson(int plane_points)
{
    const int points[2] = {plane_points, plane_points / 4};
    double chance[MOST_FEATURES + 1];
    poisson(1.0, chance);
    const struct sums plane = means(2, chance, points[0]), space = means(3, chance, points[1]);
    const double deviation = sqrt(plane.square - plane.distance[0] * plane.distance[0]);
    check_mean("spread in the plane, F1", plane.distance[0], 0.5, 0.26136, points[0]);
    check_mean("its standard deviation", deviation, 0.26136, 0.19, points[0]);
    check_mean("F2", plane.distance[1], 0.75, 0.273, points[0]);
    check_mean("F3", plane.distance[2], 0.9375, 0.275, points[0]);
    check_mean("F2 - F1", plane.edge, 0.25, 0.20, points[0]);
    check_mean("spread in space, F1", space.distance[0], 0.55396, 0.2013, points[1]);
    check_mean("its square", space.square, 0.34741, 0.232, points[1]);
    check_mean("F2", space.distance[1], 0.55396 * 4.0 / 3.0, 0.186, points[1]);
    check_mean("F3", space.distance[2], 0.55396 * 14.0 / 9.0, 0.175, points[1]);
    check_mean("F2 - F1", space.edge, 0.55396 / 3.0, 0.150, points[1]);
}

/*
 * The program of S. Worley ("A cellular texture basis function", SIGGRAPH 1996; cellular.c of
 * "Texturing and Modeling", 2nd edition 1998) has 0 to 5 features in a cube, by a table of 256
 * counts, and multiplies coordinates by 0.398150, "to make sure that the mean value of F[0] is
 * 1.0". How often each count is in the table:
 */
static void check_worley(int points)
{
    static const int table[6] = {6, 41, 92, 55, 35, 27};
    double chance[MOST_FEATURES + 1] = {0.0};
    for (int i = 0; i < 6; i++) {
        chance[i] = table[i] / 256.0;
    }
    const struct sums space = means(3, chance, points);
    check_mean("Worley's cubes, F1", space.distance[0] / 0.398150, 1.0, 0.35, points);
}

/* The area of a disc of radius r around 0 in the rectangle between 0 and (a, b), negative where one
   of a, b is. */
static double corner_area(double r, double a, double b)
{
    const double x = fmin(r, fabs(a)), y = fmin(r, fabs(b));
    double area = x * y;
    if (x * x + y * y > r * r) {
        const double left = sqrt(r * r - y * y); /* from here on the circle is below y */
        area = left * y +
               (x * sqrt(r * r - x * x) - left * y + r * r * (asin(x / r) - asin(left / r))) / 2.0;
    }
    return (a < 0.0) != (b < 0.0) ? -area : area;
}

/* The chance that at most `most` features, 0 or 1, are nearer than r to a point (x, y) of a cell,
   where each cell has one anywhere. */
static double chance_of_few(double x, double y, double r, int most)
{
    double none = 1.0, one = 0.0;
    for (int cell = 0; cell < 25; cell++) {
        const double left = cell % 5 - 2 - x, low = cell / 5 - 2 - y;
        const double in = corner_area(r, left + 1.0, low + 1.0) - corner_area(r, left, low + 1.0) -
                          corner_area(r, left + 1.0, low) + corner_area(r, left, low);
        one = one * (1.0 - in) + none * in;
        none *= 1.0 - in;
    }
    return most == 0 ? none : none + one;
}

/* The means of F1 and F2, and that of the square of F1. The mean of a distance is the integral of
   the chance that it is more than r, and that of its square is the integral of 2 r times the same;
   both are smooth and symmetric on the cell, where few points are enough. */
static void integrate(double mean[3])
{
    const int points = 8, steps = 160;
    const double step = 1.6 / steps; /* F2 is at most sqrt(5/2) */
    mean[0] = mean[1] = mean[2] = 0.0;
    for (int point = 0; point < points * points; point++) {
        const double x = (point % points + 0.5) / points / 2.0;
        const double y = (point / points + 0.5) / points / 2.0;
        for (int i = 0; i < steps; i++) {
            const double r = (i + 0.5) * step, weight = step / (points * points);
            const double nearer = chance_of_few(x, y, r, 0);
            mean[0] += weight * nearer;
            mean[1] += weight * chance_of_few(x, y, r, 1);
            mean[2] += weight * 2.0 * r * nearer;
        }
    }
}

/* The library's cells. */
static void check_library(int blocks)
{
    const double points = (double)blocks * BLOCK;
    static float x[BLOCK], y[BLOCK], f1[BLOCK], f2[BLOCK];
    const struct scarp_noise noise = {.seed = 3};
    const struct scarp_cells out = {.f1 = f1, .f2 = f2};
    uint64_t random = 13;
    double mean[3] = {0.0, 0.0, 0.0}, expected[3];
    for (int block = 0; block < blocks; block++) {
        for (int i = 0; i < BLOCK; i++) {
            x[i] = check_random_float(&random, 4096.0f);
            y[i] = check_random_float(&random, 4096.0f);
        }
        CHECK(scarp_cells2(&noise, BLOCK, x, y, &out) == SCARP_OK, "cells fail");
        for (int i = 0; i < BLOCK; i++) {
            mean[0] += (double)f1[i] / points;
            mean[1] += (double)f2[i] / points;
            mean[2] += (double)f1[i] * (double)f1[i] / points;
        }
    }
    integrate(expected);
    check_mean("the library's cells, F1", mean[0], expected[0], 0.190, points);
    check_mean("F2", mean[1], expected[1], 0.183, points);
    check_mean("the square of F1", mean[2], expected[2], 0.175, points);
}

int main(int argc, char **argv)
{
    const int points = (int)check_argument(argc, argv, 1, 1000, "POINTS");
    check_poisson(points);
    check_worley(points / 4);
    check_library((4 * points + BLOCK - 1) / BLOCK);
    return check_done();
}
