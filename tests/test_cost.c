/* SPDX-License-Identifier: MIT
 *
 * Makes one sample or grid call of a named workload, whose instructions test_cost.py counts with
 * callgrind. Prints the number of samples.
 *
 *     test_cost ISA CALL BASIS OUTPUTS FRACTAL OCTAVES
 *
 * CALL is points2, points3, grid2 or grid3, BASIS a word of scarp_basis_name, OUTPUTS value,
 * gradient or hessian, FRACTAL a name of a fractal. Points are random; samples of
 * grids are 0.01 cells apart, in rows that are long enough for what is done once per row to count
 * as in large grids.
 */
#include "outputs.h"

#define POINTS 4096
#define GRID_SAMPLES 65536

static float coordinates[3][POINTS];

/* Finds the number with this name, or else the number after the last one, which the library
   refuses. */
static int find_name(const char *(*name)(int), const char *wanted)
{
    int i = 0;
    while (name(i) != NULL && strcmp(name(i), wanted) != 0) {
        i++;
    }
    return i;
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
    const struct inputs in = {.f = {coordinates[0], coordinates[1], coordinates[2]}};
    return function_call(dimensions == 2 ? SAMPLE2 : SAMPLE3, noise, POINTS, &in, out);
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
    return grid_call(dimensions, noise, &grid, out);
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
        .basis = (enum scarp_basis)find_name(basis_name, argv[3]),
        .fractal = (enum scarp_fractal)find_name(fractal_name, argv[5]),
        .seed = 1,
        .octaves = (float)atoi(argv[6]),
    };
    const int order = strcmp(argv[4], "value") == 0 ? 0 : strcmp(argv[4], "hessian") == 0 ? 2 : 1;
    const struct outputs results = outputs_make(GRID_SAMPLES);
    const struct scarp_samples out = outputs_subset(&results, outputs_up_to(order, dimensions));
    const enum scarp_status status =
        call >= 2 ? sample_grid(&noise, dimensions, &out) : sample_points(&noise, dimensions, &out);
    return status == SCARP_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
