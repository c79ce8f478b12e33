/* SPDX-License-Identifier: MIT
 *
 * The arrays that workloads read and write.
 */
#include "arrays.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static uint64_t splitmix64(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* Draws a multiple of 2^-24, uniform in [0, 1). */
static float uniform(uint64_t *state)
{
    return (float)(splitmix64(state) >> 40) * 0x1p-24f;
}

static void fill_points(const struct bench_arrays *arrays, size_t count)
{
    static const float row[3] = {0.0f, 0.37f, 0.71f};
    uint64_t state = 1;
    for (size_t i = 0; i < count; i++) {
        for (int d = 0; d < 3; d++) {
            const float random = uniform(&state);
            arrays->points[BENCH_RANDOM][d][i] = random * 2000.0f - 1000.0f;
            arrays->points[BENCH_SEQUENTIAL][d][i] = d == 0 ? (float)i * 0.01f : row[d];
            arrays->points[BENCH_SAME_CELL][d][i] = random;
            arrays->points_f64[d][i] = (double)random * 2000.0 - 1000.0;
        }
    }
}

int bench_count_outputs(const struct bench_work *work)
{
    if (work->layout == BENCH_NORMALS || work->layout == BENCH_VECTOR ||
        work->layout == BENCH_CURL) {
        return 3;
    }
    return work->output == BENCH_VALUE          ? 1
           : work->output == BENCH_PLUS_PHASE   ? 2
           : work->output == BENCH_PLUS_HESSIAN ? 10
                                                : 1 + work->dimensions;
}

void bench_sizes_raise(struct bench_sizes *sizes, const struct bench_work *work)
{
    if (work->layout != BENCH_GRID && work->layout != BENCH_RECIPE_GRID &&
        work->points > sizes->points) {
        sizes->points = work->points;
    }
    for (int i = 0; i < bench_count_outputs(work); i++) {
        if (work->points > sizes->outputs[i]) {
            sizes->outputs[i] = work->points;
        }
    }
}

#define CACHE_LINE 64

void *bench_array_make(size_t count, size_t element)
{
    const size_t size = (count * element / CACHE_LINE + 1) * CACHE_LINE;
#ifdef _WIN32
    void *const array = malloc(size); /* memory that free() takes */
#else
    void *const array = aligned_alloc(CACHE_LINE, size);
#endif
    if (array != NULL) {
        memset(array, 0, size);
    }
    return array;
}

int bench_arrays_make(struct bench_arrays *arrays, const struct bench_sizes *sizes)
{
    memset(arrays, 0, sizeof *arrays);
    int complete = 1;
    for (int d = 0; d < 3; d++) {
        for (int pattern = 0; pattern < 3; pattern++) {
            arrays->points[pattern][d] = bench_array_make(sizes->points, sizeof(float));
            complete &= arrays->points[pattern][d] != NULL;
        }
        arrays->points_f64[d] = bench_array_make(sizes->points, sizeof(double));
        complete &= arrays->points_f64[d] != NULL;
    }
    for (int i = 0; i < 10; i++) {
        arrays->outputs[i] = bench_array_make(sizes->outputs[i], sizeof(float));
        complete &= arrays->outputs[i] != NULL;
    }
    if (complete) {
        fill_points(arrays, sizes->points);
    }
    return complete;
}

void bench_arrays_free(struct bench_arrays *arrays)
{
    for (int d = 0; d < 3; d++) {
        for (int pattern = 0; pattern < 3; pattern++) {
            free(arrays->points[pattern][d]);
        }
        free(arrays->points_f64[d]);
    }
    for (int i = 0; i < 10; i++) {
        free(arrays->outputs[i]);
    }
    for (struct bench_coordinates *at = arrays->coordinates, *next; at != NULL; at = next) {
        next = at->next;
        free(at->axis[0]);
        free(at);
    }
}

/* Fills the coordinates in. All have the same origin. */
static void fill_coordinates(const struct bench_coordinates *at, const struct bench_work *work)
{
    for (size_t i = 0; i < work->points; i++) {
        const size_t n[3] = {i % at->grid[0], i / at->grid[0] % at->grid[1],
                             i / at->grid[0] / at->grid[1]};
        for (int d = 0; d < 3; d++) {
            at->axis[d][i] = (double)work->origin[d] + (double)n[d] * (double)at->step;
        }
    }
}

const struct bench_coordinates *bench_arrays_samples(struct bench_arrays *arrays,
                                                     const struct bench_work *work)
{
    for (struct bench_coordinates *at = arrays->coordinates; at != NULL; at = at->next) {
        if (memcmp(at->grid, work->grid, sizeof at->grid) == 0 && at->step == work->step) {
            return at;
        }
    }
    struct bench_coordinates *const made = malloc(sizeof *made);
    double *const doubles = bench_array_make(3 * work->points, sizeof *doubles);
    if (made == NULL || doubles == NULL) {
        free(made);
        free(doubles);
        return NULL;
    }
    memcpy(made->grid, work->grid, sizeof made->grid);
    made->step = work->step;
    for (size_t d = 0; d < 3; d++) {
        made->axis[d] = doubles + d * work->points;
    }
    fill_coordinates(made, work);
    made->next = arrays->coordinates;
    arrays->coordinates = made;
    return made;
}
