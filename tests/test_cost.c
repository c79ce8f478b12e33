/* SPDX-License-Identifier: MIT
 *
 * One sample call of a named workload, for test_cost.py to count its instructions with callgrind.
 *
 *     test_cost ISA DIMENSIONS BASIS OUTPUTS FRACTAL OCTAVES
 *
 * BASIS is gradient or value, OUTPUTS value, gradient or hessian, FRACTAL fbm, turbulence, ridged
 * or erosion.
 */
#include "check.h"

#define POINTS 4096 /* test_cost.py divides by it */

static float coordinates[3][POINTS], results[10][POINTS];

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

int main(int argc, char **argv)
{
    if (argc != 7) {
        printf("usage: test_cost ISA DIMENSIONS BASIS OUTPUTS FRACTAL OCTAVES\n");
        return EXIT_FAILURE;
    }
    check_select_isa(argv[1]);
    const int dimensions = atoi(argv[2]);
    const struct scarp_noise noise = {
        .basis = strcmp(argv[3], "value") == 0 ? SCARP_VALUE : SCARP_GRADIENT,
        .fractal = find_fractal(argv[5]),
        .seed = 1,
        .octaves = (float)atoi(argv[6]),
    };
    struct scarp_samples out = {.value = results[0]};
    if (strcmp(argv[4], "value") != 0) {
        out.dx = results[1];
        out.dy = results[2];
        out.dz = dimensions == 3 ? results[3] : NULL;
    }
    if (strcmp(argv[4], "hessian") == 0) {
        out.dxx = results[4];
        out.dxy = results[5];
        out.dyy = results[6];
        out.dxz = dimensions == 3 ? results[7] : NULL;
        out.dyz = dimensions == 3 ? results[8] : NULL;
        out.dzz = dimensions == 3 ? results[9] : NULL;
    }
    uint64_t random = 1;
    for (int i = 0; i < POINTS; i++) {
        for (int axis = 0; axis < 3; axis++) {
            coordinates[axis][i] = check_random_float(&random, 1024.0f);
        }
    }
    const enum scarp_status status =
        dimensions == 2
            ? scarp_sample2(&noise, POINTS, coordinates[0], coordinates[1], &out)
            : scarp_sample3(&noise, POINTS, coordinates[0], coordinates[1], coordinates[2], &out);
    return status == SCARP_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
