/* SPDX-License-Identifier: MIT
 *
 * The peer stb_perlin: gradient noise in space with the quintic fade, and sums of it, one point
 * per call.
 */
#define STB_PERLIN_IMPLEMENTATION
#include "stb_perlin.h"

#include <stdlib.h>

#include "peer.h"

struct stb_state {
    enum scarp_fractal fractal;
    int octaves;
    float lacunarity, gain;
};

static void *stb_open(const struct bench_work *work, enum scarp_isa isa)
{
    if (isa != SCARP_ISA_SCALAR || work->basis != SCARP_GRADIENT || work->dimensions != 3 ||
        work->fractal > SCARP_RIDGED || work->warp != BENCH_WARP_NONE) {
        return NULL;
    }
    struct stb_state *const state = malloc(sizeof *state);
    if (state != NULL) {
        *state = (struct stb_state){work->fractal, work->octaves, work->lacunarity, work->gain};
    }
    return state;
}

/* Its ridged sum weights an octave by (1 - |n|)^2 of the one before, neither doubled nor clamped,
   and leaves out the weight of that one. */
static void stb_points(const void *opaque, size_t count, const float *const x[3], float *value)
{
    const struct stb_state *const state = opaque;
    const int octaves = state->octaves;
    const float lacunarity = state->lacunarity, gain = state->gain;
    if (octaves == 1) {
        for (size_t i = 0; i < count; i++) {
            value[i] = stb_perlin_noise3(x[0][i], x[1][i], x[2][i], 0, 0, 0);
        }
    } else if (state->fractal == SCARP_TURBULENCE) {
        for (size_t i = 0; i < count; i++) {
            value[i] =
                stb_perlin_turbulence_noise3(x[0][i], x[1][i], x[2][i], lacunarity, gain, octaves);
        }
    } else if (state->fractal == SCARP_RIDGED) {
        for (size_t i = 0; i < count; i++) {
            value[i] =
                stb_perlin_ridge_noise3(x[0][i], x[1][i], x[2][i], lacunarity, gain, 1.0f, octaves);
        }
    } else {
        for (size_t i = 0; i < count; i++) {
            value[i] = stb_perlin_fbm_noise3(x[0][i], x[1][i], x[2][i], lacunarity, gain, octaves);
        }
    }
}

const struct bench_peer bench_peer_stb_perlin = {"stb_perlin", stb_open, free,
                                                 stb_points,   NULL,     NULL};
