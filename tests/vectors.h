/* SPDX-License-Identifier: MIT
 *
 * The noises of which tests make vector noise: each basis and fractal, with what they share.
 */
#ifndef SCARP_TESTS_VECTORS_H
#define SCARP_TESTS_VECTORS_H

#include "check.h"

static const struct scarp_noise vector_deep = {.seed = 21, .amplitude = 0.25f, .frequency = 0.5},
                                vector_warp = {.seed = 22, .amplitude = 0.5f, .octaves = 2.0f},
                                vector_tile = {.seed = 24, .amplitude = 3.0f, .period = {3, 5, 4}},
                                vector_first = {.seed = 27,
                                                .basis = SCARP_SIMPLEX,
                                                .offset_first = 1},
                                vector_warped = {
                                    .seed = 23, .basis = SCARP_SIMPLEX, .warp = &vector_deep};

static const struct scarp_noise vector_noises[] = {
    {.seed = 1},
    {.seed = 2, .basis = SCARP_VALUE},
    {.seed = 3, .basis = SCARP_VALUE, .fade = SCARP_CUBIC, .octaves = 3.0f, .rotate = 1},
    {.seed = 4, .octaves = 3.5f, .gain = 0.4f, .frequency = 0.37, .amplitude = 2.5f},
    {.seed = 5, .fade = SCARP_CUBIC, .octaves = 10.0f, .rotate = 1},
    {.seed = 6, .octaves = 32.0f, .lacunarity = 1.25f, .basis = SCARP_VALUE},
    {.seed = 7, .fade = SCARP_CUBIC, .octaves = 2.0f, .phase = 0.3f},
    {.seed = 8, .octaves = 3.0f, .period = {4, 7, 5}, .phase = -0.2f},
    {.seed = 9, .octaves = 2.0f, .period = {4, 8, 16}, .basis = SCARP_VALUE},
    {.seed = 10, .fractal = SCARP_RIDGED, .octaves = 3.0f},
    {.seed = 11, .fractal = SCARP_TURBULENCE, .octaves = 2.0f, .basis = SCARP_VALUE, .rotate = 1},
    {.seed = 12, .fractal = SCARP_EROSION, .octaves = 3.0f, .rotate = 1},
    {.seed = 13, .fractal = SCARP_SWISS, .octaves = 3.0f},
    {.seed = 14,
     .fractal = SCARP_JORDAN,
     .octaves = 3.0f,
     .basis = SCARP_VALUE,
     .warp = &vector_warp},
    {.seed = 15, .fractal = SCARP_HYBRID, .octaves = 3.0f, .phase = 0.6f},
    {.seed = 16, .basis = SCARP_SIMPLEX, .octaves = 2.0f, .rotate = 1},
    {.seed = 17, .basis = SCARP_CELL_SOFT, .warp = &vector_warp},
    {.seed = 18, .octaves = 2.0f, .warp = &vector_warped},
    {.seed = 20, .octaves = 2.0f, .period = {5, 4, 3}, .warp = &vector_tile},
    {.seed = 19, .octaves = 3.0f, .warp = &vector_warp, .phase = 0.7f, .basis = SCARP_GRADIENT},
    {.seed = 25, .octaves = 2.0f, .rotate = 1, .offset_first = 1},
    {.seed = 26, .basis = SCARP_CELL_F1, .offset_first = 1, .warp = &vector_first},
};
#define VECTORS ((int)(sizeof vector_noises / sizeof vector_noises[0]))

#endif
