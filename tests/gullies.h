/* SPDX-License-Identifier: MIT
 *
 * What the tests of gullies share: the descriptions, the members of struct scarp_eroded as a list,
 * and calls on points and grids.
 */
#ifndef SCARP_TESTS_GULLIES_H
#define SCARP_TESTS_GULLIES_H

#include "check.h"

enum {
    OUT_VALUE,
    OUT_DX,
    OUT_DY,
    OUT_DISPLACEMENT,
    OUT_DISPLACEMENT_DX,
    OUT_DISPLACEMENT_DY,
    OUTS
};
enum { IN_VALUE, IN_DX, IN_DY, IN_DXX, IN_DXY, IN_DYY, INS };

static const char *const out_names[OUTS] = {
    "value", "dx", "dy", "displacement", "displacement_dx", "displacement_dy"};

#define OUT_ALL ((1u << OUTS) - 1)
#define OUT_VALUES (1u << OUT_VALUE | 1u << OUT_DISPLACEMENT)

/* The defaults, and each member by itself. */
static const struct scarp_gullies descriptions[] = {
    {.seed = 7},
    {.seed = 8, .rotate = 1},
    {.seed = 9, .frequency = 0.37, .amplitude = 250.0f, .rotate = 1},
    {.seed = 10, .octaves = 1.0f, .keep = 0x1p-24f},
    {.seed = 11, .octaves = 3.4f, .of_octaves = 7.0f, .gain = 0.6f},
    {.seed = 12, .lacunarity = 2.3f, .depth = 1.5f, .cells = 1.7f},
    {.seed = 13, .slope = 0.5f, .slope_low = 4.0f, .low = -0.3f, .high = 0.1f},
    {.seed = 14, .floor = -1.0f, .stripes = 2.5f, .branch = 1.4f, .round = 0.02f},
    {.seed = 15, .floor = 1.0f, .branch = 0x1p-24f, .round = 1.0f, .keep = 0.5f},
    {.seed = 16, .period = {4, 0}},
    {.seed = 17, .period = {3, 5}, .cells = 4.0f, .octaves = 4.0f},
    {.seed = 18, .frequency = 1e-5, .amplitude = 1e-5f, .octaves = 8.0f},
    {.seed = 19, .rotate = 1, .octaves = 3.0f, .offset_first = 1},
    {.seed = 20, .period = {3, 5}, .cells = 4.0f, .octaves = 2.0f, .offset_first = 1},
};
#define DESCRIPTIONS (sizeof descriptions / sizeof descriptions[0])

static inline struct scarp_samples base_of(float *const in[INS])
{
    const struct scarp_samples base = {.value = in[IN_VALUE],
                                       .dx = in[IN_DX],
                                       .dy = in[IN_DY],
                                       .dxx = in[IN_DXX],
                                       .dxy = in[IN_DXY],
                                       .dyy = in[IN_DYY]};
    return base;
}

/* Two arrays for all members. */
static inline struct scarp_samples base_of_two(float *a, float *b)
{
    float *const in[INS] = {a, b, a, b, a, b};
    return base_of(in);
}

/* The outputs whose bits are in `wanted`. */
static inline struct scarp_eroded eroded_of(float *const out[OUTS], unsigned wanted)
{
    float *of[OUTS];
    for (int i = 0; i < OUTS; i++) {
        of[i] = (wanted >> i & 1) != 0 ? out[i] : NULL;
    }
    const struct scarp_eroded eroded = {of[OUT_VALUE],
                                        of[OUT_DX],
                                        of[OUT_DY],
                                        of[OUT_DISPLACEMENT],
                                        of[OUT_DISPLACEMENT_DX],
                                        of[OUT_DISPLACEMENT_DY],
                                        {NULL}};
    return eroded;
}

#endif
