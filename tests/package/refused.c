/* SPDX-License-Identifier: MIT
 *
 * Calls one function of each family of a library whose compiler may not have kept to its
 * operations. Argument: `refused`, if all have to return SCARP_ERROR_UNSUPPORTED and leave outputs
 * alone, or `served`, and the instruction set that then has to serve: any, if none is named.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scarp.h"

#define N 40 /* more than one vector of every set */
#define SENTINEL 12345.0f

static float number[20][N], x[N], y[N], z[N];
static double x64[N], y64[N], z64[N];
static enum scarp_status expected;
static int failures;

static void expect(const char *name, enum scarp_status status)
{
    int touched = 0;
    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++) {
        for (size_t k = 0; k < N; k++) {
            touched |= number[i][k] != SENTINEL;
            number[i][k] = SENTINEL;
        }
    }
    if (status != expected) {
        printf("%s: %s\n", name, scarp_status_text(status));
        failures++;
    }
    if (expected != SCARP_OK && touched) {
        printf("%s wrote something\n", name);
        failures++;
    }
}

static void try_noise(const struct scarp_noise *noise)
{
    static struct scarp_plan plan;
    const struct scarp_samples out = {.value = number[0], .dx = number[1]};
    const struct scarp_samples vector[2] = {{.value = number[0]}, {.value = number[1]}};
    const struct scarp_flow flow = {.vx = number[0], .vy = number[1]};
    const struct scarp_grid grid = {.count = {N, 1, 1}, .step = {0.1, 0.1, 0.1}};
    expect("scarp_sample2", scarp_sample2(noise, N, x, y, &out));
    expect("scarp_sample2 of one", scarp_sample2(noise, 1, x, y, &out));
    expect("scarp_sample3", scarp_sample3(noise, N, x, y, z, &out));
    expect("scarp_sample2_f64", scarp_sample2_f64(noise, N, x64, y64, &out));
    expect("scarp_sample3_f64", scarp_sample3_f64(noise, N, x64, y64, z64, &out));
    expect("scarp_grid2", scarp_grid2(noise, &grid, &out));
    expect("scarp_grid3", scarp_grid3(noise, &grid, &out));
    expect("scarp_vector2", scarp_vector2(noise, N, x, y, vector));
    expect("scarp_curl2", scarp_curl2(noise, N, x, y, &flow));
    expect("scarp_normals", scarp_normals(N, x, y, 1.0f, number[0], number[1], number[2]));
    expect("scarp_range", scarp_range(noise, 2, &number[0][0], &number[1][0]));
    expect("scarp_plan_make", scarp_plan_make(noise, 2, &plan));
}

static void try_samples(void)
{
    const struct scarp_samples a = {.value = x, .dx = y, .dy = y, .dxx = z, .dxy = z, .dyy = z};
    const struct scarp_samples out = {.value = number[0], .dx = number[1]};
    const struct scarp_gullies gullies = {.seed = 1};
    const struct scarp_eroded eroded = {.value = number[0]};
    const struct scarp_grid grid = {.count = {N, 1, 1}, .step = {0.1, 0.1, 0.1}};
    const float knot[2] = {0.0f, 1.0f};
    expect("scarp_multiply", scarp_multiply(N, &a, &a, &out));
    expect("scarp_affine", scarp_affine(N, &a, 2.0f, 1.0f, &out));
    expect("scarp_divide", scarp_divide(N, &a, &a, &out));
    expect("scarp_curve", scarp_curve(N, &a, 2, knot, knot, &out));
    expect("scarp_slope", scarp_slope(N, &a, &out));
    expect("scarp_gullies2", scarp_gullies2(&gullies, N, x, y, &a, &eroded));
    expect("scarp_gullies_grid2", scarp_gullies_grid2(&gullies, &grid, &a, &eroded));
    expect("scarp_gullies_range",
           scarp_gullies_range(&gullies, -1.0f, 1.0f, &number[0][0], &number[1][0]));
}

static void try_others(const struct scarp_noise *noise)
{
    static struct scarp_recipe recipe;
    static struct scarp_gpu_plan plan;
    static uint32_t answer[SCARP_GPU_ANSWERS];
    static const char text[] = "recipe 1\nout o = noise()\n";
    const char *member = "?";
    expect("scarp_gpu_plan_make", scarp_gpu_plan_make(noise, 2, &plan, &member));
    if (member != NULL) {
        printf("scarp_gpu_plan_make names %s\n", member);
        failures++;
    }
    expect("scarp_gpu_answers", scarp_gpu_answers(noise, 2, 0, answer));
    expect("scarp_recipe_parse", scarp_recipe_parse(text, sizeof text - 1, &recipe, NULL, 0, NULL));
}

int main(int argc, char **argv)
{
    const struct scarp_noise noise = {.seed = 1, .octaves = 3.0f};
    const struct scarp_noise cells = {.basis = SCARP_CELL_F1};
    if (argc < 2) {
        return EXIT_FAILURE;
    }
    expected = strcmp(argv[1], "refused") == 0 ? SCARP_ERROR_UNSUPPORTED : SCARP_OK;
    if (argc > 2) {
        for (int isa = 1; scarp_isa_name((enum scarp_isa)isa) != NULL; isa++) {
            if (strcmp(scarp_isa_name((enum scarp_isa)isa), argv[2]) == 0 &&
                scarp_isa_select((enum scarp_isa)isa) != SCARP_OK) {
                printf("%s cannot be selected\n", argv[2]);
                return EXIT_FAILURE;
            }
        }
    }
    for (size_t k = 0; k < N; k++) {
        x64[k] = x[k] = 0.5f + 0.25f * (float)k;
        y64[k] = y[k] = z[k] = 0.75f;
        z64[k] = 0.75;
    }
    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++) {
        for (size_t k = 0; k < N; k++) {
            number[i][k] = SENTINEL;
        }
    }
    try_noise(&noise);
    const struct scarp_cells near = {.f1 = number[0]};
    expect("scarp_cells2", scarp_cells2(&cells, N, x, y, &near));
    try_samples();
    try_others(&noise);
    if ((scarp_isa_active() == SCARP_ISA_NONE) != (expected != SCARP_OK) ||
        (expected != SCARP_OK && scarp_isa_select(SCARP_ISA_NONE) != expected)) {
        printf("the set in use is %s\n", scarp_isa_name(scarp_isa_active()));
        failures++;
    }
    printf("%s: %d failures\n", argv[1], failures);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
