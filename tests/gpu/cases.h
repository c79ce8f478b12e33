/* SPDX-License-Identifier: MIT
 *
 * The noises and the points of all tests of the shaders. Points come from integers, so they are the
 * same on every compiler.
 */
#ifndef SCARP_TESTS_GPU_CASES_H
#define SCARP_TESTS_GPU_CASES_H

#include "../../src/plan/traits.h"
#include "../check.h"

/* One noise to compare. The seed is made of the name, so new cases leave the others as they are. */
struct gpu_case {
    const char *name;
    int dimensions;
    struct scarp_noise noise;
};

static const struct scarp_noise gpu_warps[] = {
    {.seed = 5, .octaves = 2.0f, .frequency = 0.75, .amplitude = 0.75f},
    {.seed = 6, .rotate = 1, .octaves = 3.0f, .frequency = 0.3, .lacunarity = 1.5f, .gain = 0.7f},
    {.seed = 7, .octaves = 2.0f, .frequency = 0.5, .amplitude = -1.5f, .warp = &gpu_warps[1]},
    {.seed = 8, .basis = SCARP_SIMPLEX, .rotate = 1, .octaves = 2.0f, .frequency = 0.6},
    {.seed = 9, .basis = SCARP_VALUE, .fractal = SCARP_RIDGED, .octaves = 3.0f, .phase = 0.0f},
    {.seed = 10, .octaves = 2.0f, .phase = 0.37f, .amplitude = 0.5f, .warp = &gpu_warps[4]},
    {.seed = 11, .fractal = SCARP_SWISS, .octaves = 3.0f, .frequency = 0.4, .amplitude = 0.5f},
    {.seed = 12, .octaves = 1.0f, .frequency = 0.25, .period = {4, 8, 12}},
};

/* Fractals that have a Hessian come with straight and with turned axes, the others likewise. What a
   fractal makes of a basis is the same for all of them, so most pairs are left out. */
static const struct gpu_case gpu_cases[] = {
    /* every basis, both fades */
    {"2d/gradient", 2, {.frequency = 1.0}},
    {"2d/gradient/cubic/8", 2, {.fade = SCARP_CUBIC, .octaves = 8.0f, .frequency = 0.37}},
    {"2d/value/3", 2, {.basis = SCARP_VALUE, .octaves = 3.0f}},
    {"2d/value/cubic/turned/8",
     2,
     {.basis = SCARP_VALUE, .fade = SCARP_CUBIC, .rotate = 1, .octaves = 8.0f, .frequency = 0.37}},
    {"2d/simplex", 2, {.basis = SCARP_SIMPLEX, .frequency = 1.0}},
    {"2d/simplex/turned/8",
     2,
     {.basis = SCARP_SIMPLEX, .rotate = 1, .octaves = 8.0f, .frequency = 0.37}},
    {"2d/cell-f1", 2, {.basis = SCARP_CELL_F1}},
    {"2d/cell-f2/turned/3", 2, {.basis = SCARP_CELL_F2, .rotate = 1, .octaves = 3.0f}},
    {"2d/cell-edge/2", 2, {.basis = SCARP_CELL_EDGE, .octaves = 2.0f, .jitter = 0.75f}},
    {"2d/cell-soft/turned/3",
     2,
     {.basis = SCARP_CELL_SOFT, .rotate = 1, .octaves = 3.0f, .frequency = 0.37}},
    {"2d/cell-value/4", 2, {.basis = SCARP_CELL_VALUE, .octaves = 4.0f, .jitter = 0.25f}},
    {"3d/gradient", 3, {.frequency = 1.0}},
    {"3d/gradient/cubic/turned/8",
     3,
     {.fade = SCARP_CUBIC, .rotate = 1, .octaves = 8.0f, .frequency = 0.37}},
    {"3d/value/turned/3", 3, {.basis = SCARP_VALUE, .rotate = 1, .octaves = 3.0f}},
    {"3d/value/cubic/8",
     3,
     {.basis = SCARP_VALUE, .fade = SCARP_CUBIC, .octaves = 8.0f, .frequency = 0.37}},
    {"3d/simplex", 3, {.basis = SCARP_SIMPLEX, .frequency = 1.0}},
    {"2d/gradient/first", 2, {.frequency = 0.37, .offset_first = 1}},
    {"2d/simplex/first", 2, {.basis = SCARP_SIMPLEX, .offset_first = 1}},
    {"3d/value/turned/first/2",
     3,
     {.basis = SCARP_VALUE, .rotate = 1, .octaves = 2.0f, .offset_first = 1}},
    {"3d/cell-f1/first", 3, {.basis = SCARP_CELL_F1, .offset_first = 1}},
    {"2d/jordan/first/3", 2, {.fractal = SCARP_JORDAN, .octaves = 3.0f, .offset_first = 1}},
    {"3d/simplex/turned/8",
     3,
     {.basis = SCARP_SIMPLEX, .rotate = 1, .octaves = 8.0f, .frequency = 0.37}},
    {"3d/cell-f1/turned/2", 3, {.basis = SCARP_CELL_F1, .rotate = 1, .octaves = 2.0f}},
    {"3d/cell-f2", 3, {.basis = SCARP_CELL_F2, .frequency = 0.37}},
    {"3d/cell-edge/2", 3, {.basis = SCARP_CELL_EDGE, .octaves = 2.0f, .jitter = 0.375f}},
    {"3d/cell-soft", 3, {.basis = SCARP_CELL_SOFT, .frequency = 2.0}},
    {"3d/cell-value/2", 3, {.basis = SCARP_CELL_VALUE, .rotate = 1, .octaves = 2.0f}},

    /* every fractal */
    {"2d/turbulence/5", 2, {.fractal = SCARP_TURBULENCE, .octaves = 5.0f}},
    {"2d/ridged/turned/8",
     2,
     {.fractal = SCARP_RIDGED, .rotate = 1, .octaves = 8.0f, .frequency = 0.37}},
    {"2d/erosion/8", 2, {.fractal = SCARP_EROSION, .octaves = 8.0f, .frequency = 0.75}},
    {"2d/pingpong/turned/3", 2, {.fractal = SCARP_PINGPONG, .rotate = 1, .octaves = 3.0f}},
    {"2d/hybrid/6", 2, {.fractal = SCARP_HYBRID, .octaves = 6.0f, .gain = 0.84f}},
    {"2d/swiss/turned/6", 2, {.fractal = SCARP_SWISS, .rotate = 1, .octaves = 6.0f}},
    {"2d/jordan/8", 2, {.fractal = SCARP_JORDAN, .octaves = 8.0f, .frequency = 0.37}},
    {"3d/turbulence/turned/5", 3, {.fractal = SCARP_TURBULENCE, .rotate = 1, .octaves = 5.0f}},
    {"3d/ridged/4", 3, {.fractal = SCARP_RIDGED, .octaves = 4.0f, .gain = 0.8f}},
    {"3d/erosion/turned/5",
     3,
     {.fractal = SCARP_EROSION, .rotate = 1, .octaves = 5.0f, .erosion = 0.75f}},
    {"3d/pingpong/4", 3, {.fractal = SCARP_PINGPONG, .octaves = 4.0f, .sharpness = 1.25f}},
    {"3d/hybrid/turned/5", 3, {.fractal = SCARP_HYBRID, .rotate = 1, .octaves = 5.0f}},
    {"3d/swiss/5", 3, {.fractal = SCARP_SWISS, .octaves = 5.0f, .sharpness = 0.25f}},
    {"3d/jordan/turned/5",
     3,
     {.fractal = SCARP_JORDAN, .rotate = 1, .octaves = 5.0f, .erosion = 0.75f}},

    /* other bases under fractals */
    {"2d/value/turbulence/turned/4",
     2,
     {.basis = SCARP_VALUE, .fractal = SCARP_TURBULENCE, .rotate = 1, .octaves = 4.0f}},
    {"2d/simplex/ridged/5",
     2,
     {.basis = SCARP_SIMPLEX, .fractal = SCARP_RIDGED, .octaves = 5.0f, .frequency = 0.3}},
    {"2d/simplex/swiss/4", 2, {.basis = SCARP_SIMPLEX, .fractal = SCARP_SWISS, .octaves = 4.0f}},
    {"2d/cell-soft/pingpong/2",
     2,
     {.basis = SCARP_CELL_SOFT, .fractal = SCARP_PINGPONG, .octaves = 2.0f}},
    {"3d/value/erosion/4", 3, {.basis = SCARP_VALUE, .fractal = SCARP_EROSION, .octaves = 4.0f}},
    {"3d/value/cubic/jordan/3",
     3,
     {.basis = SCARP_VALUE, .fade = SCARP_CUBIC, .fractal = SCARP_JORDAN, .octaves = 3.0f}},
    {"3d/cell-f1/hybrid/2",
     3,
     {.basis = SCARP_CELL_F1, .fractal = SCARP_HYBRID, .octaves = 2.0f, .jitter = 0.5f}},

    /* periods: powers of two and others, and an axis without one */
    {"2d/periods/powers/4", 2, {.octaves = 4.0f, .period = {1, 64}}},
    {"2d/periods/3", 2, {.octaves = 2.5f, .lacunarity = 3.0f, .period = {49, 7}}},
    {"2d/value/periods/ridged/3",
     2,
     {.basis = SCARP_VALUE, .fractal = SCARP_RIDGED, .octaves = 3.0f, .period = {0, 1000003}}},
    {"2d/simplex/periods/3", 2, {.basis = SCARP_SIMPLEX, .octaves = 3.0f, .period = {5}}},
    {"2d/cell-f2/periods/2", 2, {.basis = SCARP_CELL_F2, .octaves = 2.0f, .period = {2, 3}}},
    {"3d/periods/powers/3", 3, {.octaves = 3.0f, .period = {16, 0, 1}}},
    {"3d/periods/swiss/3",
     3,
     {.fractal = SCARP_SWISS, .octaves = 3.0f, .lacunarity = 3.0f, .period = {49, 7, 1000003}}},
    {"3d/simplex/periods/2", 3, {.basis = SCARP_SIMPLEX, .octaves = 2.0f, .period = {3, 8, 11}}},
    {"3d/cell-edge/periods", 3, {.basis = SCARP_CELL_EDGE, .period = {1, 2, 5}}},

    /* phases */
    {"2d/phase/3", 2, {.octaves = 3.0f, .phase = 0.3f}},
    {"2d/cubic/phase/erosion/turned/3",
     2,
     {.fade = SCARP_CUBIC,
      .fractal = SCARP_EROSION,
      .rotate = 1,
      .octaves = 2.5f,
      .phase = -1.71f}},
    {"2d/phase/jordan/3", 2, {.fractal = SCARP_JORDAN, .octaves = 3.0f, .phase = 0.125f}},
    {"3d/phase", 3, {.frequency = 0.37, .phase = 0.6f}},
    {"3d/phase/ridged/turned/4",
     3,
     {.fractal = SCARP_RIDGED, .rotate = 1, .octaves = 4.0f, .phase = 17.43f}},

    /* warps: one and two deep */
    {"2d/warped/4", 2, {.octaves = 4.0f, .frequency = 0.75, .warp = &gpu_warps[0]}},
    {"2d/cell-f1/warped/turned/2",
     2,
     {.basis = SCARP_CELL_F1, .rotate = 1, .octaves = 2.0f, .warp = &gpu_warps[1]}},
    {"2d/ridged/warped-twice/turned/8",
     2,
     {.fractal = SCARP_RIDGED, .rotate = 1, .octaves = 8.0f, .warp = &gpu_warps[2]}},
    {"2d/simplex/warped/3",
     2,
     {.basis = SCARP_SIMPLEX, .octaves = 3.0f, .frequency = 0.3, .warp = &gpu_warps[3]}},
    {"2d/erosion/warped-twice/4",
     2,
     {.fractal = SCARP_EROSION, .octaves = 4.0f, .warp = &gpu_warps[5]}},
    {"2d/warped-swiss/2", 2, {.octaves = 2.0f, .warp = &gpu_warps[6]}},
    {"3d/warped/turned/3", 3, {.rotate = 1, .octaves = 3.0f, .warp = &gpu_warps[1]}},
    {"3d/value/hybrid/warped-twice/3",
     3,
     {.basis = SCARP_VALUE, .fractal = SCARP_HYBRID, .octaves = 3.0f, .warp = &gpu_warps[2]}},
    {"3d/periods/phase/warped/2",
     3,
     {.octaves = 2.0f,
      .frequency = 0.25,
      .phase = 0.3f,
      .period = {4, 4, 4},
      .warp = &gpu_warps[7]}},
    {"3d/jordan/warped/3", 3, {.fractal = SCARP_JORDAN, .octaves = 3.0f, .warp = &gpu_warps[3]}},

    /* other numbers: fractions of octaves, a part of a sum, signs, ratios, far frequencies */
    {"2d/level-of-detail",
     2,
     {.octaves = 3.25f,
      .of_octaves = 6.5f,
      .lacunarity = 1.875f,
      .gain = 0.625f,
      .amplitude = -3.5f}},
    {"2d/fine", 2, {.octaves = 4.5f, .frequency = 1234.5, .lacunarity = 2.5f, .amplitude = 1e4f}},
    {"3d/coarse/turned",
     3,
     {.rotate = 1, .octaves = 7.75f, .frequency = 0.0031, .lacunarity = 1.1f, .amplitude = 1e-3f}},

    /* positions of small octaves beyond 2^31 cells */
    {"2d/gradient/turned/28", 2, {.rotate = 1, .octaves = 28.0f}},
    {"3d/value/28", 3, {.basis = SCARP_VALUE, .octaves = 28.0f, .frequency = 0.37}},
};

enum { GPU_CASES = sizeof gpu_cases / sizeof gpu_cases[0] };

static inline struct scarp_noise gpu_noise_of(const struct gpu_case *c)
{
    struct scarp_noise noise = c->noise;
    noise.seed = fnv_text(c->name);
    return noise;
}

/* The order of the highest derivatives that the noise and its warps have. */
static inline int gpu_order_of(const struct scarp_noise *noise)
{
    const int order = fractal_has(noise->fractal, FRACTAL_SLOPES) ? 1 : 2;
    const int of_warp = noise->warp != NULL ? gpu_order_of(noise->warp) : 2;
    return of_warp < order ? of_warp : order;
}

/*
 * One coordinate of a point. Half of the points lie within +-4096 cells of the first octave, an
 * eighth within +-2^20, a quarter on lattice points and in the middles between them if the
 * frequency is a power of two, and the rest on small integers and 0. So frequency times coordinate
 * is 0, or far above 2^-24.
 */
static inline float gpu_coordinate(uint32_t point, float cell, uint64_t *state)
{
    const uint64_t r = check_random(state);
    const int32_t any = (int32_t)(r >> 40) - (1 << 23);
    switch (point % 8) {
    case 0:
    case 1: return (float)((int32_t)(r >> 32 & 511) - 256) * (cell * 0.5f);
    case 2: return (float)((int32_t)(r >> 32 & 15) - 8);
    case 3: return (float)any * (cell * 0x1p-3f);
    default: return (float)any * (cell * 0x1p-11f);
    }
}

/* Fills arrays of `count` coordinates along each axis. */
static inline void gpu_points(const struct gpu_case *c, uint32_t count, float *const axis[3])
{
    uint64_t state = fnv_text(c->name);
    int exponent;
    frexp(c->noise.frequency == 0.0 ? 1.0 : c->noise.frequency, &exponent);
    const float cell = ldexpf(1.0f, 1 - exponent);
    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            axis[k][i] = gpu_coordinate(i, cell, &state);
        }
    }
}

#endif
