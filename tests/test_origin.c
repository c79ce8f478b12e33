/* SPDX-License-Identifier: MIT
 *
 * The offset of octave 0 (offset_first): it is the one that scarp.h says, it moves a noise and
 * changes nothing else, and with it the origin is a place as any other.
 *
 *     test_origin ISA     one octave is moved by it, to the bit
 *     test_origin seeds   statistics over seeds
 */
#include "gullies.h"
#include "octaves.h"
#include "outputs.h"

#define POINTS 73

static struct outputs here, there;
static float f32[2][3][POINTS];
static double f64[2][3][POINTS];

/* Points, and the same ones moved by o_0 of this seed. Both calls round the same sum, so it may be
   inexact. */
static void make_points(uint64_t seed)
{
    uint64_t random = 6;
    struct octave octave;
    octave_draw(&octave, seed, 0);
    for (int d = 0; d < 3; d++) {
        for (size_t i = 0; i < POINTS; i++) {
            f32[0][d][i] = check_random_float(&random, i % 8 == 0 ? 0x1p20f : 64.0f);
            f64[0][d][i] = (double)f32[0][d][i];
            f32[1][d][i] = f32[0][d][i] + (float)octave.offset[d];
            f64[1][d][i] = f64[0][d][i] + octave.offset[d];
        }
    }
    for (int d = 0; d < 3; d++) {
        f32[0][d][0] = 0.0f;
        f64[0][d][0] = 0.0;
        f32[1][d][0] = (float)octave.offset[d];
        f64[1][d][0] = octave.offset[d];
    }
}

static struct inputs points_at(int moved, size_t first)
{
    float(*const f)[POINTS] = f32[moved];
    double(*const d)[POINTS] = f64[moved];
    const struct inputs in = {{f[0] + first, f[1] + first, f[2] + first},
                              {d[0] + first, d[1] + first, d[2] + first}};
    return in;
}

/* A noise without the offset at points that are moved, and one with it, with and without a plan. */
static void compare_moved(const struct scarp_noise *noise, enum function f, size_t first,
                          size_t count)
{
    const unsigned wanted = outputs_of(noise, f);
    const struct scarp_samples out[2] = {outputs_subset(&here, wanted),
                                         outputs_subset(&there, wanted)};
    const struct inputs moved = points_at(1, first), in = points_at(0, first);
    struct scarp_noise offset = *noise;
    struct scarp_plan plan;
    int member = 0;
    size_t index = 0;
    CHECK(function_call(f, noise, count, &moved, &out[0]) == SCARP_OK, "moved points");
    offset.offset_first = 1;
    CHECK(scarp_plan_make(&offset, function_dimensions(f), &plan) == SCARP_OK, "a plan");
    for (int i = 0; i < 3; i++) {
        offset.plan = i == 1 ? &plan : NULL;
        offset.offset_first = i < 2 ? 1 : 0x80000000u; /* as good as any */
        CHECK(function_call(f, &offset, count, &in, &out[1]) == SCARP_OK, "an offset");
        CHECK_BITS(outputs_equal(&here, &there, wanted, count, &member, &index),
                   "%s, %s, %zu points, try %d: %s[%zu] differs", basis_name((int)noise->basis),
                   function_names[f], count, i, output_names[member], index);
    }
}

/* One octave at frequency 1 is moved by o_0, to the bit, whatever it is made of. */
static void test_moved(void)
{
    for (int i = 0; i < 2 * count_names(basis_name) * count_names(fractal_name); i++) {
        struct scarp_noise noise = {.basis = (enum scarp_basis)(i / 2 % count_names(basis_name)),
                                    .fractal =
                                        (enum scarp_fractal)(i / 2 / count_names(basis_name)),
                                    .rotate = 1,
                                    .seed = (uint64_t)i * 77};
        make_points(noise.seed);
        for (int f = 0; f < FUNCTIONS; f++) {
            noise.period[0] = i % 2 != 0 ? 5 : 0;
            noise.phase = noise.basis == SCARP_GRADIENT && i % 4 == 3 ? 0.3f : 0.0f;
            compare_moved(&noise, (enum function)f, 0, POINTS);
            compare_moved(&noise, (enum function)f, 5, 1);
            compare_moved(&noise, (enum function)f, 0, 21);
        }
    }
}

/* Grids likewise: to origins that are multiples of 2^-8 the offset is added exactly. */
static void test_moved_grid(void)
{
    enum { SIDE = 19, SAMPLES = SIDE * SIDE * SIDE };
    struct outputs a = outputs_make(SAMPLES), b = outputs_make(SAMPLES);
    for (int i = 0; i < 4 * count_names(basis_name); i++) {
        struct scarp_noise noise = {.basis = (enum scarp_basis)(i / 4), .seed = 500 + (uint64_t)i};
        const int dimensions = 2 + i % 2;
        const unsigned wanted = outputs_of(&noise, dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64);
        const struct scarp_samples out[2] = {outputs_subset(&a, wanted),
                                             outputs_subset(&b, wanted)};
        struct scarp_grid grid = {.origin = {-3.25, 0.0, 1.5},
                                  .step = {0.125, 0.0625, 0.25},
                                  .count = {SIDE, SIDE, dimensions == 2 ? 1 : SIDE}};
        struct octave octave;
        int member = 0;
        size_t index = 0;
        noise.period[0] = i % 4 > 1 ? 3 : 0;
        noise.offset_first = 1;
        CHECK(grid_call(dimensions, &noise, &grid, &out[0]) == SCARP_OK, "grid");
        noise.offset_first = 0;
        octave_draw(&octave, noise.seed, 0);
        for (int d = 0; d < 3; d++) {
            grid.origin[d] += octave.offset[d];
        }
        CHECK(grid_call(dimensions, &noise, &grid, &out[1]) == SCARP_OK, "moved grid");
        CHECK_BITS(
            outputs_equal(&a, &b, wanted, dimensions == 2 ? SIDE * SIDE : SAMPLES, &member, &index),
            "grid, %s, %dD: %s[%zu] differs", basis_name((int)noise.basis), dimensions,
            output_names[member], index);
    }
    outputs_free(&a);
    outputs_free(&b);
}

/* What calls of cells find is moved, too. The cells keep their ids. */
static void test_moved_cells(void)
{
    struct scarp_noise noise = {.seed = 31, .jitter = 0.75f};
    float distance[2][POINTS], x[2][POINTS];
    uint32_t id[2][POINTS];
    struct octave octave;
    make_points(noise.seed);
    octave_draw(&octave, noise.seed, 0);
    for (int i = 0; i < 2; i++) {
        const struct scarp_cells out = {.f1 = distance[i], .id = id[i], .x = x[i]};
        noise.offset_first = i == 0;
        CHECK(scarp_cells2_f64(&noise, POINTS, f64[i][0], f64[i][1], &out) == SCARP_OK, "cells");
    }
    for (size_t i = 0; i < POINTS; i++) {
        const double moved = (double)x[1][i] - (double)x[0][i];
        CHECK_BITS(distance[0][i] == distance[1][i] && id[0][i] == id[1][i], "cell %zu", i);
        CHECK(fabs(moved - octave.offset[0]) <= 0x1p-22 * (1.0 + fabs((double)x[0][i])),
              "feature %zu is moved by %.9g", i, moved);
    }
}

/* Components that share a lattice have the offset of its seed, number 33; others one each. */
static void test_vector(void)
{
    for (int i = 0; i < 2; i++) {
        struct scarp_noise noise = {.seed = 8, .offset_first = 1};
        noise.basis = i == 0 ? SCARP_VALUE : SCARP_SIMPLEX;
        uint64_t seed = noise.seed, state = check_random(&seed), drawn = 0;
        const struct scarp_samples out[2] = {{.value = here.array[0]}, {.value = here.array[1]}};
        const struct scarp_samples expected = {.value = there.array[0]};
        make_points(1);
        CHECK(scarp_vector2(&noise, POINTS, f32[0][0], f32[0][1], out) == SCARP_OK, "vector");
        for (int k = 0; k < 33 + i; k++) { /* of simplex noise, component 1 */
            drawn = check_random(&state);
        }
        noise.seed = drawn;
        noise.offset_first = 0;
        make_points(noise.seed);
        CHECK(scarp_sample2(&noise, POINTS, f32[1][0], f32[1][1], &expected) == SCARP_OK, "noise");
        CHECK_BITS(memcmp(here.array[i], there.array[0], POINTS * sizeof(float)) == 0,
                   "component %d of %s", i, basis_name((int)noise.basis));
    }
}

/* A base that every sample has */
#define BASE_VALUE 0.2f
static float base_value[POINTS], base_dx[POINTS], base_dy[POINTS];
static const struct scarp_samples base = {.value = base_value, .dx = base_dx, .dy = base_dy};

static void make_base(void)
{
    for (size_t i = 0; i < POINTS; i++) {
        base_value[i] = BASE_VALUE;
        base_dx[i] = 0.7f;
        base_dy[i] = -0.3f;
    }
}

/* One octave of gullies, whose cells are as long as a unit of input, is moved by o_0. */
static void test_moved_gullies(void)
{
    struct scarp_gullies g = {.seed = 12, .octaves = 1.0f, .frequency = 0.5, .cells = 2.0f};
    const struct scarp_eroded out[2] = {{.displacement = here.array[0]},
                                        {.displacement = there.array[0]}};
    for (int i = 0; i < 4; i++) {
        g.seed++;
        g.period[0] = i % 2 != 0 ? 3 : 0;
        make_points(g.seed);
        for (int k = 0; k < 2; k++) {
            g.offset_first = k == 0;
            CHECK((i < 2 ? scarp_gullies2(&g, POINTS, f32[k][0], f32[k][1], &base, &out[k])
                         : scarp_gullies2_f64(&g, POINTS, f64[k][0], f64[k][1], &base, &out[k])) ==
                      SCARP_OK,
                  "gullies");
        }
        CHECK_BITS(memcmp(here.array[0], there.array[0], POINTS * sizeof(float)) == 0, "gullies %d",
                   i);
    }
}

/* Doubles repeat to the bit after a period, with all octaves. */
static void test_periods(void)
{
    const struct scarp_gullies g = {
        .seed = 3, .octaves = 3.0f, .period = {3, 2}, .offset_first = 1};
    const struct scarp_eroded out[2] = {{.displacement = here.array[0]},
                                        {.displacement = there.array[0]}};
    make_points(1);
    for (size_t i = 0; i < POINTS; i++) {
        f64[1][0][i] = f64[0][0][i] - 3.0;
        f64[1][1][i] = f64[0][1][i] + 4.0;
    }
    for (int k = 0; k < 2; k++) {
        CHECK(scarp_gullies2_f64(&g, POINTS, f64[k][0], f64[k][1], &base, &out[k]) == SCARP_OK,
              "gullies");
    }
    CHECK_BITS(memcmp(here.array[0], there.array[0], POINTS * sizeof(float)) == 0,
               "gullies a period away");
}

/*
 * Statistics over seeds: at the origin, and elsewhere, which is at another point for each seed.
 */
#define SEEDS 20000

/* Two samples of one distribution differ by more than this with a probability of 1e-5, in the
   largest difference of their distribution functions (Kolmogorov and Smirnov). */
#define DIFFERENCE (2.47 * 0.01 /* sqrt(2 / SEEDS) */)

static int by_value(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* The largest difference. Sorts the samples. */
static double difference_of(float a[SEEDS], float b[SEEDS])
{
    double largest = 0.0;
    qsort(a, SEEDS, sizeof *a, by_value);
    qsort(b, SEEDS, sizeof *b, by_value);
    for (int i = 0, j = 0; i < SEEDS && j < SEEDS;) {
        const float at = a[i] < b[j] ? a[i] : b[j];
        while (i < SEEDS && a[i] <= at) {
            i++;
        }
        while (j < SEEDS && b[j] <= at) {
            j++;
        }
        largest = fmax(largest, fabs((double)(i - j)) / SEEDS);
    }
    return largest;
}

static float at_origin[SEEDS], elsewhere[SEEDS];

/* Fills in both samples of a noise. Seeds of one are not those of the other. */
static void sample_seeds(const struct scarp_noise *described, int dimensions)
{
    struct scarp_noise noise = *described;
    uint64_t random = 99;
    for (int i = 0; i < 2 * SEEDS; i++) {
        float x[3] = {0.0f, 0.0f, 0.0f}, *const to = i < SEEDS ? at_origin : elsewhere;
        const struct scarp_samples out = {.value = &to[i % SEEDS]};
        for (int d = 0; d < 3 && i >= SEEDS; d++) {
            x[d] = check_random_float(&random, 1024.0f);
        }
        noise.seed = (uint64_t)i;
        CHECK((dimensions == 2 ? scarp_sample2(&noise, 1, &x[0], &x[1], &out)
                               : scarp_sample3(&noise, 1, &x[0], &x[1], &x[2], &out)) == SCARP_OK,
              "seed %d", i);
    }
}

/* With the offset, the origin is as elsewhere; without it the test says that it is not, but in
   noise that is one value per cell. */
static void test_noise_at_origin(const struct scarp_noise *described, int dimensions)
{
    struct scarp_noise noise = *described;
    for (int offset = 0; offset < 2; offset++) {
        noise.offset_first = (uint32_t)offset;
        sample_seeds(&noise, dimensions);
        const double found = difference_of(at_origin, elsewhere);
        CHECK(offset ? found < DIFFERENCE : found > DIFFERENCE || noise.basis == SCARP_CELL_VALUE,
              "%dD, %s, %s, %g octaves, offset_first %d: %.4f of %.4f", dimensions,
              basis_name((int)noise.basis), fractal_name((int)noise.fractal), (double)noise.octaves,
              offset, found, DIFFERENCE);
    }
}

static void test_noises_at_origin(void)
{
    for (int i = 0; i < 2 * count_names(basis_name); i++) {
        const struct scarp_noise one = {.basis = (enum scarp_basis)(i / 2)};
        const struct scarp_noise ridged = {
            .basis = one.basis, .fractal = SCARP_RIDGED, .octaves = 6.0f};
        test_noise_at_origin(&one, 2 + i % 2);
        test_noise_at_origin(&ridged, 2 + i % 2);
    }
}

/* Ridges cross at the origin of every seed, unless octave 0 has its offset. */
static void test_ridges(void)
{
    double mean[3] = {0.0, 0.0, 0.0}, high[3] = {0.0, 0.0, 0.0};
    for (int offset = 0; offset < 2; offset++) {
        const struct scarp_noise noise = {
            .fractal = SCARP_RIDGED, .octaves = 6.0f, .offset_first = (uint32_t)offset};
        sample_seeds(&noise, 2);
        for (int i = 0; i < SEEDS; i++) {
            mean[offset] += (double)at_origin[i] / SEEDS;
            high[offset] += (double)(at_origin[i] > 0.7f) / SEEDS;
            mean[2] += (double)elsewhere[i] / (2 * SEEDS);
            high[2] += (double)(elsewhere[i] > 0.7f) / (2 * SEEDS);
        }
    }
    printf("ridges at the origin: mean %.3f, %.1f %% above .7; with the offset %.3f, %.1f %%; "
           "elsewhere %.3f, %.1f %%\n",
           mean[0], 100.0 * high[0], mean[1], 100.0 * high[1], mean[2], 100.0 * high[2]);
    CHECK(mean[0] > 0.7 && high[0] > 0.6, "without the offset there are no ridges");
    CHECK(fabs(mean[1] - mean[2]) < 0.01 && fabs(high[1] - high[2]) < 0.02, "see above");
}

/* Gullies in the same base: the displacement by one octave, and by several. */
static void test_gullies_at_origin(void)
{
    for (int i = 0; i < 4; i++) {
        struct scarp_gullies g = {.octaves = i < 2 ? 1.0f : 5.0f, .offset_first = (uint32_t)i % 2};
        uint64_t random = 98;
        for (int k = 0; k < 2 * SEEDS; k++) {
            float *const to = k < SEEDS ? at_origin : elsewhere;
            const struct scarp_eroded out = {.displacement = &to[k % SEEDS]};
            float x[2] = {0.0f, 0.0f};
            for (int d = 0; d < 2 && k >= SEEDS; d++) {
                x[d] = check_random_float(&random, 1024.0f);
            }
            g.seed = (uint64_t)k;
            CHECK(scarp_gullies2(&g, 1, &x[0], &x[1], &base, &out) == SCARP_OK, "seed %d", k);
        }
        const double found = difference_of(at_origin, elsewhere);
        CHECK(g.offset_first != 0 ? found < DIFFERENCE : found > DIFFERENCE,
              "gullies %d: %.4f of %.4f", i, found, DIFFERENCE);
    }
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    if (argc != 2) {
        printf("usage: test_origin [--must-differ] ISA | seeds\n");
        return EXIT_FAILURE;
    }
    make_base();
    if (strcmp(argv[1], "seeds") == 0) {
        test_noises_at_origin();
        test_ridges();
        test_gullies_at_origin();
        return check_done();
    }
    check_select_isa(argv[1]);
    here = outputs_make(POINTS);
    there = outputs_make(POINTS);
    test_moved();
    test_moved_grid();
    test_moved_cells();
    test_vector();
    test_moved_gullies();
    test_periods();
    outputs_free(&here);
    outputs_free(&there);
    return check_done();
}
