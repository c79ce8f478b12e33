/* SPDX-License-Identifier: MIT
 *
 * Random noises on random grids, for tests/test_grid.c.
 */
#ifndef SCARP_TESTS_GRID_CASES_H
#define SCARP_TESTS_GRID_CASES_H

#include <math.h>

#include "check.h"
#include "outputs.h"

/* What a call is asked for. */
struct grid_case {
    struct scarp_noise noise;
    struct scarp_grid grid;
    int dimensions, order;
    unsigned wanted; /* outputs, by bits */
};

static uint32_t pick(uint64_t *state, uint64_t n)
{
    return (uint32_t)(check_random(state) % n);
}

/* Periods come with straight axes and an integral lacunarity. */
static void random_periods(struct scarp_noise *noise, uint64_t *state)
{
    static const float lacunarity[] = {1.0f, 2.0f, 2.0f, 3.0f, 4.0f};
    static const uint32_t periods[] = {0, 1, 2, 3, 16, 289, 1 << 16};
    const int powers = pick(state, 2) == 0;
    noise->rotate = 0;
    noise->lacunarity = lacunarity[pick(state, 5)];
    for (int axis = 0; axis < 3; axis++) {
        const uint32_t period = periods[pick(state, 7)];
        noise->period[axis] = powers && period % 2 != 0 ? 32 : period;
    }
}

/* One that takes the passes of grids, one that bends, and two of them; turned value noise, and
   gradients that flow. */
#define WARPS 5
static const struct scarp_noise warps[WARPS] = {
    {.octaves = 2.0f, .frequency = 0.7, .amplitude = 0.75f},
    {.fractal = SCARP_SWISS, .seed = 2, .octaves = 3.0f, .rotate = 1},
    {.basis = SCARP_VALUE, .seed = 3, .octaves = 2.5f, .frequency = 0.3, .warp = &warps[0]},
    {.basis = SCARP_VALUE, .fade = SCARP_CUBIC, .seed = 4, .octaves = 3.0f, .rotate = 1},
    {.fractal = SCARP_RIDGED, .seed = 5, .octaves = 2.0f, .rotate = 1, .phase = 0.4f},
};

static void random_noise(struct scarp_noise *noise, uint64_t *state)
{
    static const float octaves[] = {1.0f, 1.0f, 2.0f, 3.5f, 8.0f};
    static const float lacunarity[] = {2.0f, 1.9375f, 0.5f, 3.0f};
    memset(noise, 0, sizeof *noise);
    noise->basis = (enum scarp_basis)pick(state, pick(state, 2) == 0 ? 2 : 8);
    noise->jitter = pick(state, 2) == 0 ? 0.5f : 0.0f;
    noise->fade = (enum scarp_fade)pick(state, 2);
    noise->fractal =
        (enum scarp_fractal)(pick(state, 2) * pick(state, (uint64_t)count_names(fractal_name)));
    noise->rotate = pick(state, 4) == 0;
    noise->seed = check_random(state);
    noise->octaves = octaves[pick(state, 5)];
    noise->lacunarity = lacunarity[pick(state, 4)];
    noise->frequency = pick(state, 2) == 0 ? 1.0 : 0.37;
    if (pick(state, 3) == 0) {
        random_periods(noise, state);
    }
    if (noise->basis == SCARP_GRADIENT && pick(state, 2) == 0) {
        noise->phase = check_random_float(state, 2.0f);
    }
}

/* Picks a step: a fraction of a cell, some cells, 0, backwards, too far for the lattice, or such
   that the first and the last lane of a vector lie in one cell because the lattice has repeated in
   between. */
static double random_step(uint64_t *state)
{
    static const double steps[] = {0.0,  0.01,       0.1,        0.3,         0.5,  0.86, 0.97,
                                   1.0,  1.7,        8.0,        1e-9,        1e6,  1.0,  0.3,
                                   0.01, 0x1p32 / 3, 0x1p32 / 7, 0x1p32 / 15, 1e16, 1e300};
    const double step = steps[pick(state, sizeof steps / sizeof steps[0])];
    return pick(state, 3) == 0 ? -step : step;
}

static void random_axis(struct scarp_grid *grid, int axis, uint64_t *state)
{
    static const double origins[] = {0.0, -3.7, 1234.56789, 0x1p40, -0x1p31, 1e300};
    static const int64_t firsts[] = {0, -5, 1000003, INT64_C(1) << 50, -(INT64_C(1) << 50) + 7};
    grid->origin[axis] = origins[pick(state, 40) == 0 ? 5 : pick(state, 5)];
    grid->step[axis] = random_step(state);
    grid->first[axis] = firsts[pick(state, 5)];
    if (fabs(grid->step[axis]) > 1.0 && pick(state, 4) != 0) {
        grid->first[axis] = (int64_t)pick(state, 100) - 50;
    }
}

static void random_case(struct grid_case *c, uint64_t *state)
{
    static const size_t lengths[] = {3, 17, 70, 300, 1100};
    memset(c, 0, sizeof *c);
    random_noise(&c->noise, state);
    c->dimensions = 2 + (int)pick(state, 2);
    fit_noise(&c->noise, c->dimensions);
    c->order = (int)pick(state, ORDERS);
    for (int axis = 0; axis < 3; axis++) {
        random_axis(&c->grid, axis, state);
    }
    c->grid.count[0] = 1 + pick(state, lengths[pick(state, 5)]);
    c->grid.count[1] = 1 + pick(state, c->grid.count[0] > 100 ? 5 : pick(state, 8) == 0 ? 150 : 37);
    c->grid.count[1] = c->noise.basis < SCARP_CELL_F1 ? c->grid.count[1] : 1 + pick(state, 4);
    c->grid.count[2] = 1 + pick(state, 3);
    if (pick(state, 2) == 0) {
        c->grid.row_stride = c->grid.count[0] + pick(state, 9);
        c->grid.slice_stride = c->grid.count[1] * c->grid.row_stride + pick(state, 50);
    }
    if (pick(state, 8) == 0) {
        c->noise.warp = &warps[pick(state, WARPS)];
        c->grid.count[1] = c->grid.count[1] > 8 ? 8 : c->grid.count[1]; /* they take their time */
    }
    c->order = c->order > noise_order(&c->noise) ? noise_order(&c->noise) : c->order;
    c->wanted = outputs_up_to(c->order, c->dimensions);
    if (c->noise.basis == SCARP_GRADIENT && pick(state, 3) == 0) {
        c->wanted |= OUTPUTS_PHASE & outputs_of(&c->noise, SAMPLE2);
    }
    if (pick(state, 3) == 0) {
        c->wanted &= (unsigned)check_random(state);
    }
}

#endif
