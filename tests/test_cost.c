/* SPDX-License-Identifier: MIT
 *
 * One sample or grid call of a named workload, for test_cost.py to count its instructions with
 * callgrind. Prints the number of samples.
 *
 *     test_cost ISA CALL BASIS OUTPUTS FRACTAL OCTAVES
 *
 * CALL is points2, points3, grid2 or grid3, BASIS gradient or value, OUTPUTS value, gradient or
 * hessian, FRACTAL fbm, turbulence, ridged or erosion. Points are random; samples of grids are 0.01
 * cells apart, in rows that are long enough for what is done once per row to count as in large
 * grids.
 */
#include "check.h"

#define POINTS 4096
#define GRID_SAMPLES 65536

static float coordinates[3][POINTS], results[10][GRID_SAMPLES];

/* A fractal that does not exist, which the sample call refuses, for an unknown name */
static enum scarp_fractal find_fractal(const char *name)
{
    static const char *const names[] = {"fbm", "turbulence", "ridged", "erosion"};
    int i = 0;
    while (i < 4 && strcmp(names[i], name) != 0) {
        i++;
    }
    return (enum scarp_fractal)i;
}

static struct scarp_samples choose_outputs(const char *name, int dimensions)
{
    struct scarp_samples out = {.value = results[0]};
    if (strcmp(name, "value") != 0) {
        out.dx = results[1];
        out.dy = results[2];
        out.dz = dimensions == 3 ? results[3] : NULL;
    }
    if (strcmp(name, "hessian") == 0) {
        out.dxx = results[4];
        out.dxy = results[5];
        out.dyy = results[6];
        out.dxz = dimensions == 3 ? results[7] : NULL;
        out.dyz = dimensions == 3 ? results[8] : NULL;
        out.dzz = dimensions == 3 ? results[9] : NULL;
    }
    return out;
}

static enum scarp_status sample_points(const struct scarp_noise *noise, int dimensions,
                                       const struct scarp_samples *out)
{
    uint64_t random = 1;
    for (int i = 0; i < POINTS; i++) {
        for (int axis = 0; axis < 3; axis++) {
            coordinates[axis][i] = check_random_float(&random, 1024.0f);
        }
    }
    printf("%d\n", POINTS);
    return dimensions == 2
               ? scarp_sample2(noise, POINTS, coordinates[0], coordinates[1], out)
               : scarp_sample3(noise, POINTS, coordinates[0], coordinates[1], coordinates[2], out);
}

static enum scarp_status sample_grid(const struct scarp_noise *noise, int dimensions,
                                     const struct scarp_samples *out)
{
    struct scarp_grid grid = {
        .origin = {3.3371, 4.437, 5.533}, .step = {0.01, 0.01, 0.01}, .count = {256, 256, 1}};
    if (dimensions == 3) {
        grid.count[1] = grid.count[2] = 16;
    }
    printf("%d\n", GRID_SAMPLES);
    return dimensions == 2 ? scarp_grid2(noise, &grid, out) : scarp_grid3(noise, &grid, out);
}

int main(int argc, char **argv)
{
    static const char *const calls[] = {"points2", "points3", "grid2", "grid3"};
    int call = 0;
    while (argc == 7 && call < 4 && strcmp(argv[2], calls[call]) != 0) {
        call++;
    }
    if (argc != 7 || call == 4) {
        printf("usage: test_cost ISA CALL BASIS OUTPUTS FRACTAL OCTAVES\n");
        return EXIT_FAILURE;
    }
    check_select_isa(argv[1]);
    const int dimensions = 2 + call % 2;
    const struct scarp_noise noise = {
        .basis = strcmp(argv[3], "value") == 0 ? SCARP_VALUE : SCARP_GRADIENT,
        .fractal = find_fractal(argv[5]),
        .seed = 1,
        .octaves = (float)atoi(argv[6]),
    };
    const struct scarp_samples out = choose_outputs(argv[4], dimensions);
    const enum scarp_status status =
        call >= 2 ? sample_grid(&noise, dimensions, &out) : sample_points(&noise, dimensions, &out);
    return status == SCARP_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
