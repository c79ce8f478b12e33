/* SPDX-License-Identifier: MIT
 *
 * What C computes for some calls, as names and hashes of the outputs: the tests of the modules for
 * Python, C# and Rust make the same calls and compare.
 *
 *     bindings_hashes RECIPE    RECIPE is the file of a recipe with two outputs or more
 */
#include <inttypes.h>
#include <scarp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNT 1031
#define ROWS 37
#define COLUMNS 53
#define MEMBERS 11

static float array[3 * MEMBERS + 2][COUNT * 2], xf[3][COUNT];
static double xd[3][COUNT];
static struct scarp_recipe recipe;

static void check(enum scarp_status status, const char *what)
{
    if (status != SCARP_OK) {
        fprintf(stderr, "%s: %s\n", what, scarp_status_text(status));
        exit(EXIT_FAILURE);
    }
}

/* FNV-1a of the first arrays, so many bytes of each. */
static void tell(const char *name, int arrays, size_t size)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int a = 0; a < arrays; a++) {
        const unsigned char *const byte = (const unsigned char *)array[a];
        for (size_t i = 0; i < size; i++) {
            hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
        }
    }
    printf("%s %016" PRIx64 "\n", name, hash);
}

/* Members of the plane, in the order of the structure: value, dx, dy, dxx, dxy, dyy. */
static struct scarp_samples plane(int first)
{
    return (struct scarp_samples){.value = array[first],
                                  .dx = array[first + 1],
                                  .dy = array[first + 2],
                                  .dxx = array[first + 3],
                                  .dxy = array[first + 4],
                                  .dyy = array[first + 5]};
}

static struct scarp_samples space(void)
{
    return (struct scarp_samples){.value = array[0],
                                  .dx = array[1],
                                  .dy = array[2],
                                  .dz = array[3],
                                  .dxx = array[4],
                                  .dxy = array[5],
                                  .dxz = array[6],
                                  .dyy = array[7],
                                  .dyz = array[8],
                                  .dzz = array[9],
                                  .dphase = array[10]};
}

static const struct scarp_noise warp = {
    .basis = SCARP_SIMPLEX, .seed = 7, .frequency = 0.02, .octaves = 2, .amplitude = 15};
static const struct scarp_noise warped = {.fractal = SCARP_RIDGED,
                                          .rotate = 1,
                                          .seed = UINT64_C(0xfedcba9876543210),
                                          .frequency = 0.01,
                                          .octaves = 6,
                                          .warp = &warp};
static const struct scarp_noise tile = {.basis = SCARP_VALUE,
                                        .fade = SCARP_CUBIC,
                                        .fractal = SCARP_PINGPONG,
                                        .seed = 3,
                                        .frequency = 0.25,
                                        .octaves = 2.5f,
                                        .gain = 0.4f,
                                        .sharpness = 1.5f,
                                        .period = {8, 16, 4},
                                        .of_octaves = 4};
static const struct scarp_noise flowing = {
    .seed = 5, .octaves = 3, .phase = 0.3f, .offset_first = 1};
static const struct scarp_noise worley = {.basis = SCARP_CELL_F1, .seed = 9, .jitter = 0.75f};

static void tell_points(void)
{
    const struct scarp_samples out2 = plane(0), out3 = space();
    check(scarp_sample2(&warped, COUNT, xf[0], xf[1], &out2), "sample2");
    tell("sample2", 6, sizeof xf[0]);
    check(scarp_sample2_f64(&warped, COUNT, xd[0], xd[1], &out2), "sample2_f64");
    tell("sample2_f64", 6, sizeof xf[0]);
    check(scarp_sample3(&flowing, COUNT, xf[0], xf[1], xf[2], &out3), "sample3");
    tell("sample3", 11, sizeof xf[0]);
    check(scarp_sample3_f64(&flowing, COUNT, xd[0], xd[1], xd[2], &out3), "sample3_f64");
    tell("sample3_f64", 11, sizeof xf[0]);
    const struct scarp_samples vector[2] = {plane(0), plane(6)};
    check(scarp_vector2(&warp, COUNT, xf[0], xf[1], vector), "vector2");
    tell("vector2", 12, sizeof xf[0]);
    const struct scarp_cells cells = {.f1 = array[0],
                                      .f2 = array[1],
                                      .id = (uint32_t *)(void *)array[2],
                                      .x = array[3],
                                      .y = array[4],
                                      .dx1 = array[5],
                                      .dy1 = array[6],
                                      .dx2 = array[7],
                                      .dy2 = array[8]};
    check(scarp_cells2_f64(&worley, COUNT, xd[0], xd[1], &cells), "cells2_f64");
    tell("cells2_f64", 9, sizeof xf[0]);
    const struct scarp_flow flow = {.vx = array[0], .vy = array[1], .vz = array[2]};
    check(scarp_curl3(&flowing, COUNT, xf[0], xf[1], xf[2], &flow), "curl3");
    tell("curl3", 3, sizeof xf[0]);
}

static void tell_grids(void)
{
    const struct scarp_grid grid = {
        .origin = {-3, 5}, .step = {0.5, -0.25}, .first = {-20, 7}, .count = {COLUMNS, ROWS}};
    const struct scarp_grid voxels = {
        .origin = {1, 2, 3}, .step = {0.125, 0.25, 0.5}, .first = {1, -2, 3}, .count = {11, 13, 7}};
    const size_t size = sizeof(float) * ROWS * COLUMNS;
    const struct scarp_samples out2 = plane(0);
    check(scarp_grid2(&warped, &grid, &out2), "grid2");
    tell("grid2", 6, size);
    check(scarp_grid3(&tile, &voxels,
                      &(struct scarp_samples){
                          .value = array[0], .dx = array[1], .dy = array[2], .dz = array[3]}),
          "grid3");
    tell("grid3", 4, sizeof(float) * 11 * 13 * 7);

    const struct scarp_gullies gullies = {
        .seed = 4, .frequency = 0.02, .depth = 0.3f, .offset_first = 1};
    const struct scarp_noise base = {.seed = 4, .frequency = 0.02, .octaves = 2};
    const struct scarp_samples in = plane(6);
    const struct scarp_eroded eroded = {.value = array[0],
                                        .dx = array[1],
                                        .dy = array[2],
                                        .displacement = array[3],
                                        .displacement_dx = array[4],
                                        .displacement_dy = array[5]};
    check(scarp_grid2(&base, &grid, &in), "the base");
    check(scarp_gullies_grid2(&gullies, &grid, &in, &eroded), "gullies_grid2");
    tell("gullies_grid2", 6, size);

    const struct scarp_samples a = plane(6), b = plane(12);
    check(scarp_grid2(&warped, &grid, &b), "b");
    check(scarp_smooth_max(ROWS * COLUMNS, &a, &b, 0.25f, &out2), "smooth_max");
    check(scarp_multiply(ROWS * COLUMNS, &out2, &b, &out2), "multiply");
    check(scarp_affine(ROWS * COLUMNS, &out2, 3.0f, -1.0f, &out2), "affine");
    tell("chain", 6, size);
    check(scarp_normals(ROWS * COLUMNS, b.dx, b.dy, 20.0f, array[0], array[1], array[2]),
          "normals");
    tell("normals", 3, size);

    const struct scarp_samples outs[2] = {{.value = array[0], .dx = array[1], .dy = array[2]},
                                          {.value = array[3], .dx = array[4], .dy = array[5]}};
    const struct scarp_recipe_outputs outputs = {.out = outs, .count = 2};
    check(scarp_recipe_seed(&recipe, 8), "seed");
    check(scarp_recipe_set(&recipe, "height", 900, NULL), "height");
    check(scarp_recipe_grid(&recipe, &grid, &outputs, NULL), "recipe_grid");
    tell("recipe_grid", 6, size);
    check(scarp_recipe_sample(&recipe, COUNT, xf[0], xf[1], NULL, &outputs, NULL), "recipe_sample");
    tell("recipe_sample", 6, sizeof xf[0]);
}

#define CHAIN(name, camel, call)                                                                   \
    check(call, name);                                                                             \
    tell(name, 6, sizeof xf[0]);

/* Each function of the chain rule */
static void tell_functions(void)
{
    const struct scarp_samples first = plane(6), second = plane(12), third = plane(0);
    const struct scarp_samples *const a = &first, *const b = &second, *const out = &third;
    const size_t count = COUNT;
    check(scarp_sample2(&warp, count, xf[0], xf[1], a), "a");
    check(scarp_sample2(&warped, count, xf[0], xf[1], b), "b");
#include "chain.h"
}

int main(int count, char **arguments)
{
    static char text[16384];
    FILE *const file = count == 2 ? fopen(arguments[1], "rb") : NULL;
    if (file == NULL) {
        fprintf(stderr, "a recipe is needed\n");
        return EXIT_FAILURE;
    }
    const size_t length = fread(text, 1, sizeof text, file);
    fclose(file);
    check(scarp_recipe_parse(text, length, &recipe, NULL, 0, NULL), "the recipe");
    for (int i = 0; i < COUNT; i++) {
        for (int axis = 0; axis < 3; axis++) { /* exact in floats */
            xd[axis][i] = (double)((i * (7 + 4 * axis)) % 1024) * 0.375 - 100.0 * axis;
            xf[axis][i] = (float)xd[axis][i];
        }
    }
    tell_points();
    tell_grids();
    tell_functions();
    return EXIT_SUCCESS;
}
