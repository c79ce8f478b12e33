/* SPDX-License-Identifier: MIT
 *
 * Prints a hash of the results of each case of the npm package's test: cases.mjs computes the same
 * with the package. expected.txt is what this prints, on any machine:
 *
 *     expected                  prints the lines
 *     expected FILE             compares them with those of a file
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scarp.h"

#define POINTS 301
#define MOST 1024 /* floats of an array */
#define ROW 23
#define ROWS 9
#define SLICE (ROW * ROWS + 4)

static FILE *compared; /* NULL to print */
static int failures;
static uint32_t state;
static float coordinate[3][POINTS];
static double coordinate_f64[3][POINTS];
static float array[3][16][MOST];
static struct scarp_samples samples[3]; /* the first eleven pointers of each are arrays of it */

static uint32_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

/* The same points on every machine: multiples of 2^-14 within 512 of the origin. */
static void make_points(uint32_t seed)
{
    state = seed;
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < POINTS; i++) {
            const double x = ((double)(next_random() >> 8) - 0x1p23) * 0x1p-14;
            coordinate[axis][i] = (float)x;
            coordinate_f64[axis][i] = x * 4097;
        }
    }
}

static uint32_t hash_words(uint32_t hash, const void *from, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t word;
        memcpy(&word, (const char *)from + 4 * i, 4);
        hash = (hash ^ word) * 16777619u;
        hash ^= hash >> 15;
    }
    return hash;
}

static void line(const char *name, const char *more, uint32_t hash)
{
    char text[128], expected[128];
    snprintf(text, sizeof text, "%s%s %08x\n", name, more, (unsigned)hash);
    if (compared == NULL) {
        fputs(text, stdout);
    } else if (fgets(expected, sizeof expected, compared) == NULL || strcmp(text, expected) != 0) {
        printf("computed: %s", text);
        failures++;
    }
}

static void expect_ok(enum scarp_status status, const char *name)
{
    if (status != SCARP_OK) {
        printf("%s: %s\n", name, scarp_status_text(status));
        exit(EXIT_FAILURE);
    }
}

/* The arrays of samples[which] up to an order, in some dimensions; the others are NULL. */
static const struct scarp_samples *ask(int which, int dimensions, int order, int dphase)
{
    static const int rank[] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
    static const int space[] = {2, 2, 2, 3, 2, 2, 3, 2, 3, 3};
    float *pointers[16] = {NULL};
    memset(array[which], 0, sizeof array[which]);
    for (int i = 0; i < 10; i++) {
        if (rank[i] <= order && space[i] <= dimensions) {
            pointers[i] = array[which][i];
        }
    }
    pointers[10] = dphase ? array[which][10] : NULL;
    memcpy(&samples[which], pointers, sizeof pointers);
    return &samples[which];
}

static uint32_t hash_arrays(int which)
{
    uint32_t hash = 2166136261u;
    for (int i = 0; i < 16; i++) {
        hash = hash_words(hash, array[which][i], MOST);
    }
    return hash;
}

static struct scarp_grid grid_of(int dimensions)
{
    struct scarp_grid grid = {.first = {-3, 5, 2}, .count = {21, ROWS, 3}, .row_stride = ROW};
    for (int axis = 0; axis < 3; axis++) {
        grid.origin[axis] = -1.25;
        grid.step[axis] = 0.0625 * (axis + 1);
    }
    grid.slice_stride = dimensions == 3 ? SLICE : 0;
    return grid;
}

/* Points in float and double, and a grid, with all derivatives that there are. */
static void visit_noise(const struct scarp_noise *noise, int dimensions, const char *more)
{
    const int no_hessian = scarp_noise_fault(noise, dimensions, 2, 0, NULL) != NULL;
    const int dphase = scarp_noise_fault(noise, dimensions, 0, 1, NULL) == NULL;
    const struct scarp_samples *const out = ask(0, dimensions, no_hessian ? 1 : 2, dphase);
    const float *const x = coordinate[0], *const y = coordinate[1], *const z = coordinate[2];
    const double *const xd = coordinate_f64[0], *const yd = coordinate_f64[1],
                        *const zd = coordinate_f64[2];
    const struct scarp_grid grid = grid_of(dimensions);
    expect_ok(dimensions == 2 ? scarp_sample2(noise, POINTS, x, y, out)
                              : scarp_sample3(noise, POINTS, x, y, z, out),
              more);
    line(dimensions == 2 ? "sample2" : "sample3", more, hash_arrays(0));
    expect_ok(dimensions == 2 ? scarp_sample2_f64(noise, POINTS, xd, yd, out)
                              : scarp_sample3_f64(noise, POINTS, xd, yd, zd, out),
              more);
    line(dimensions == 2 ? "sample2_f64" : "sample3_f64", more, hash_arrays(0));
    ask(0, dimensions, no_hessian ? 1 : 2, dphase);
    expect_ok(dimensions == 2 ? scarp_grid2(noise, &grid, out) : scarp_grid3(noise, &grid, out),
              more);
    line(dimensions == 2 ? "grid2" : "grid3", more, hash_arrays(0));
}

static void visit_bases(int dimensions)
{
    for (int basis = 0; basis < 8; basis++) {
        for (int fractal = 0; fractal < 8; fractal++) {
            const int n = ((dimensions - 2) * 8 + basis) * 8 + fractal;
            struct scarp_noise noise = {
                .basis = (enum scarp_basis)basis,
                .fade = (enum scarp_fade)(n % 2),
                .fractal = (enum scarp_fractal)fractal,
                .rotate = n % 3 == 0,
                .seed = UINT64_C(0x9e3779b97f4a7c15) * (uint64_t)(n + 1),
                .frequency = 0.37,
                .octaves = 3.5f,
                .phase = basis == SCARP_GRADIENT && n % 2 == 1 ? 0.3125f : 0.0f,
                .jitter = n % 4 == 2 ? 0.75f : 0.0f,
            };
            char more[64];
            if (n % 5 == 1) {
                noise.gain = 0.4375f;
                noise.lacunarity = 1.9375f;
            }
            snprintf(more, sizeof more, " %s %s", scarp_basis_name(noise.basis),
                     scarp_fractal_name(noise.fractal));
            visit_noise(&noise, dimensions, more);
        }
    }
}

static void visit_special(int dimensions)
{
    const struct scarp_noise deep = {.basis = SCARP_VALUE, .seed = 3, .amplitude = 0.5f};
    const struct scarp_noise warp = {.basis = SCARP_SIMPLEX, .octaves = 2.0f, .warp = &deep};
    const struct scarp_noise warped = {.octaves = 3.0f, .amplitude = 2.0f, .warp = &warp};
    const struct scarp_noise periodic = {
        .octaves = 3.0f, .period = {3, 5, 7}, .of_octaves = 6.0f, .seed = UINT64_MAX};
    const struct scarp_noise folded = {
        .fractal = SCARP_PINGPONG, .octaves = 2.0f, .sharpness = 1.5f, .amplitude = -3.0f};
    const struct scarp_noise eroded = {.fractal = SCARP_EROSION, .octaves = 5.0f, .erosion = 0.3f};
    const struct scarp_noise first = {.octaves = 2.0f, .seed = 6, .offset_first = 1};
    visit_noise(&warped, dimensions, " warped");
    visit_noise(&periodic, dimensions, " periodic");
    visit_noise(&folded, dimensions, " folded");
    visit_noise(&eroded, dimensions, " eroded");
    visit_noise(&first, dimensions, " first");
}

/* All members: 2D has none along z. The twelve arrays of cells and of flows are in this order. */
static void visit_fields(int dimensions)
{
    static const int cells2[] = {1, 1, 1, 1, 1, 0, 1, 1, 0, 1, 1, 0};
    static const int flow2[] = {1, 1, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0};
    const struct scarp_noise noise = {.frequency = 0.25, .seed = 11, .jitter = 0.875f};
    const float *const x = coordinate[0], *const y = coordinate[1], *const z = coordinate[2];
    const double *const xd = coordinate_f64[0], *const yd = coordinate_f64[1],
                        *const zd = coordinate_f64[2];
    float *cell_pointers[16] = {NULL}, *flow_pointers[16] = {NULL};
    struct scarp_cells cells;
    struct scarp_flow flow;
    for (int i = 0; i < 12; i++) {
        cell_pointers[i] = dimensions == 3 || cells2[i] ? array[0][i] : NULL;
        flow_pointers[i] = dimensions == 3 || flow2[i] ? array[0][i] : NULL;
    }
    memcpy(&cells, cell_pointers, sizeof cells);
    memcpy(&flow, flow_pointers, sizeof flow);
    memset(array[0], 0, sizeof array[0]);
    expect_ok(dimensions == 2 ? scarp_cells2(&noise, POINTS, x, y, &cells)
                              : scarp_cells3(&noise, POINTS, x, y, z, &cells),
              "cells");
    line(dimensions == 2 ? "cells2" : "cells3", "", hash_arrays(0));
    expect_ok(dimensions == 2 ? scarp_cells2_f64(&noise, POINTS, xd, yd, &cells)
                              : scarp_cells3_f64(&noise, POINTS, xd, yd, zd, &cells),
              "cells");
    line(dimensions == 2 ? "cells2_f64" : "cells3_f64", "", hash_arrays(0));
    memset(array[0], 0, sizeof array[0]);
    expect_ok(dimensions == 2 ? scarp_curl2(&noise, POINTS, x, y, &flow)
                              : scarp_curl3(&noise, POINTS, x, y, z, &flow),
              "curl");
    line(dimensions == 2 ? "curl2" : "curl3", "", hash_arrays(0));
    expect_ok(dimensions == 2 ? scarp_curl2_f64(&noise, POINTS, xd, yd, &flow)
                              : scarp_curl3_f64(&noise, POINTS, xd, yd, zd, &flow),
              "curl");
    line(dimensions == 2 ? "curl2_f64" : "curl3_f64", "", hash_arrays(0));
}

/* The components of vector noise, all in one hash. */
static void visit_vector(int dimensions)
{
    const struct scarp_noise warp = {.basis = SCARP_VALUE, .seed = 6};
    const struct scarp_noise noise = {.octaves = 2.0f, .seed = 5, .warp = &warp};
    const float *const x = coordinate[0], *const y = coordinate[1], *const z = coordinate[2];
    const double *const xd = coordinate_f64[0], *const yd = coordinate_f64[1],
                        *const zd = coordinate_f64[2];
    for (int doubles = 0; doubles < 2; doubles++) {
        uint32_t hash = 2166136261u;
        for (int c = 0; c < dimensions; c++) {
            ask(c, dimensions, 2, 1);
        }
        expect_ok(dimensions == 2 ? doubles ? scarp_vector2_f64(&noise, POINTS, xd, yd, samples)
                                            : scarp_vector2(&noise, POINTS, x, y, samples)
                  : doubles ? scarp_vector3_f64(&noise, POINTS, xd, yd, zd, samples)
                                  : scarp_vector3(&noise, POINTS, x, y, z, samples),
                  "vector");
        for (int i = 0; i < 16 * dimensions; i++) {
            hash = hash_words(hash, array[i / 16][i % 16], MOST);
        }
        line(dimensions == 2 ? "vector2" : "vector3", doubles ? "_f64" : "", hash);
    }
}

#define CHAIN(name, camel, call)                                                                   \
    memset(array[2], 0, sizeof array[2]);                                                          \
    expect_ok(call, name);                                                                         \
    line(camel, "", hash_arrays(2));

static void visit_chain(void)
{
    const struct scarp_noise hills = {.octaves = 2.0f}, mountains = {.basis = SCARP_SIMPLEX};
    const struct scarp_samples *const a = ask(0, 3, 2, 0), *const b = ask(1, 3, 2, 0);
    const struct scarp_samples *const out = ask(2, 3, 2, 0);
    const struct scarp_partials partials = {
        .f = a->value, .fa = a->dx, .fb = a->dy, .faa = b->dx, .fab = b->dy, .fbb = b->dz};
    const float knots[] = {-0.25f, 0.125f, 0.5f}, values[] = {0.0f, 1.0f, 0.75f};
    const size_t count = POINTS;
    expect_ok(scarp_sample3(&hills, count, coordinate[0], coordinate[1], coordinate[2], a),
              "hills");
    expect_ok(scarp_sample3(&mountains, count, coordinate[0], coordinate[1], coordinate[2], b),
              "mountains");
#include "chain.h"
    CHAIN("curve", "curve", scarp_curve(count, a, 3, knots, values, out))
    CHAIN("slope", "slope", scarp_slope(count, a, ask(2, 3, 1, 0)))
    ask(2, 3, 2, 0);
    CHAIN("apply1", "apply1", scarp_apply1(count, a, &partials, out))
    CHAIN("apply2", "apply2", scarp_apply2(count, a, b, &partials, out))
    memset(array[2], 0, sizeof array[2]);
    expect_ok(scarp_normals(count, a->dx, a->dy, 1.9f, array[2][0], array[2][1], array[2][2]),
              "normals");
    line("normals", "", hash_arrays(2));
}

static void visit_rest(void)
{
    static struct scarp_gpu_plan plan;
    static uint32_t answer[SCARP_GPU_ANSWERS];
    const struct scarp_noise warp = {.basis = SCARP_SIMPLEX, .seed = 5};
    const struct scarp_noise noise = {.fractal = SCARP_HYBRID, .octaves = 4.5f, .warp = &warp};
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        const char *const more = dimensions == 2 ? " 2" : " 3";
        float range[2];
        expect_ok(scarp_range(&noise, dimensions, &range[0], &range[1]), "range");
        line("range", more, hash_words(2166136261u, range, 2));
        expect_ok(scarp_gpu_plan_make(&noise, dimensions, &plan, NULL), "gpuPlan");
        line("gpuPlan", more, hash_words(2166136261u, &plan, sizeof plan / 4));
        expect_ok(scarp_gpu_answers(&noise, dimensions, 2, answer), "gpuAnswers");
        line("gpuAnswers", more, hash_words(2166136261u, answer, SCARP_GPU_ANSWERS));
    }
}

/* A recipe of the plane and one of space: points in float and double, and a grid. */
static void visit_recipe(const char *text, int dimensions)
{
    static struct scarp_recipe recipe;
    static unsigned char bytes[256 * 1024];
    const struct scarp_scratch scratch = {.memory = bytes, .size = sizeof bytes};
    const struct scarp_samples *const out = ask(0, dimensions, 2, 0);
    const struct scarp_recipe_outputs outputs = {.out = out, .count = 1};
    const struct scarp_grid grid = grid_of(dimensions);
    const char *const more = dimensions == 2 ? " 2" : " 3";
    const float *const *const x =
        (const float *const[]){coordinate[0], coordinate[1], coordinate[2]};
    expect_ok(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL), "recipe");
    expect_ok(scarp_recipe_seed(&recipe, UINT64_MAX - 6), "seed");
    expect_ok(scarp_recipe_set(&recipe, "height", 2.5, NULL), "set");
    expect_ok(scarp_recipe_sample(&recipe, POINTS, x[0], x[1], dimensions == 3 ? x[2] : NULL,
                                  &outputs, &scratch),
              "recipe");
    line("recipe sample", more, hash_arrays(0));
    expect_ok(scarp_recipe_sample_f64(&recipe, POINTS, coordinate_f64[0], coordinate_f64[1],
                                      dimensions == 3 ? coordinate_f64[2] : NULL, &outputs,
                                      &scratch),
              "recipe");
    line("recipe sample_f64", more, hash_arrays(0));
    ask(0, dimensions, 2, 0);
    expect_ok(scarp_recipe_grid(&recipe, &grid, &outputs, &scratch), "recipe");
    line("recipe grid", more, hash_arrays(0));
}

static void visit_recipes(void)
{
    visit_recipe("recipe 1\n"
                 "param height = 1 [0, 4]\n"
                 "bend = noise(size=3, octaves=3, amplitude=0.5)\n"
                 "hills = warp(noise(ridged, size=2, octaves=5, rotate), bend)\n"
                 "out land = height * max(hills, noise(simplex, size=5), smooth=0.25)\n",
                 2);
    visit_recipe("recipe 1\n"
                 "space 3\n"
                 "param height = 1 [0, 4]\n"
                 "out rock = height * noise(size=3, octaves=4) - 0.25 * z\n",
                 3);
}

int main(int argc, char **argv)
{
    if (argc > 1) {
        compared = fopen(argv[1], "r");
        if (compared == NULL) {
            printf("cannot read %s\n", argv[1]);
            return EXIT_FAILURE;
        }
    }
    make_points(20240229);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        visit_bases(dimensions);
        visit_special(dimensions);
        visit_fields(dimensions);
        visit_vector(dimensions);
    }
    visit_chain();
    visit_rest();
    visit_recipes();
    if (compared != NULL && fgetc(compared) != EOF) {
        printf("the file has more lines\n");
        failures++;
    }
    return failures > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
