/* SPDX-License-Identifier: MIT
 *
 * The peer stb_perlin: gradient noise in space with the quintic fade, one point per call.
 */
#define STB_PERLIN_IMPLEMENTATION
#include "stb_perlin.h"

#include <stdlib.h>

#include "peer.h"

static void *stb_open(const struct bench_work *work, enum scarp_isa isa)
{
    if (isa != SCARP_ISA_SCALAR || work->basis != SCARP_GRADIENT || work->dimensions != 3) {
        return NULL;
    }
    int *const octaves = malloc(sizeof *octaves);
    if (octaves != NULL) {
        *octaves = work->octaves;
    }
    return octaves;
}

static void stb_points(const void *state, size_t count, const float *const x[3], float *value)
{
    const int octaves = *(const int *)state;
    if (octaves == 1) {
        for (size_t i = 0; i < count; i++) {
            value[i] = stb_perlin_noise3(x[0][i], x[1][i], x[2][i], 0, 0, 0);
        }
    } else {
        for (size_t i = 0; i < count; i++) {
            value[i] = stb_perlin_fbm_noise3(x[0][i], x[1][i], x[2][i], 2.0f, 0.5f, octaves);
        }
    }
}

const struct bench_peer bench_peer_stb_perlin = {"stb_perlin", stb_open, free, stb_points, NULL};
