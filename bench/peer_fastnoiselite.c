/* SPDX-License-Identifier: MIT
 *
 * The peer FastNoiseLite: gradient noise with the quintic fade, value noise with the cubic one, and
 * sums of them, ridged ones too, one point per call.
 */
#define FNL_IMPL
#include "FastNoiseLite.h"

#include <stdlib.h>

#include "peer.h"

/* Its ridged sum has no Musgrave weights (as long as `weighted_strength` is 0, the default): it
   adds 1 - 2 |n_k| where scarp adds v_k (1 - |n_k|)^2. There is no turbulence or erosion. */
static fnl_fractal_type fnl_peer_fractal(const struct bench_work *work)
{
    if (work->octaves == 1) {
        return FNL_FRACTAL_NONE;
    }
    return work->fractal == SCARP_RIDGED ? FNL_FRACTAL_RIDGED : FNL_FRACTAL_FBM;
}

/* Sets the type of noise; returns 0 for one that it does not have. Its features stray on circles.
 */
static int fnl_peer_basis(fnl_state *noise, enum scarp_basis basis)
{
    static const fnl_cellular_return_type cellular[] = {
        [SCARP_CELL_F1] = FNL_CELLULAR_RETURN_TYPE_DISTANCE,
        [SCARP_CELL_F2] = FNL_CELLULAR_RETURN_TYPE_DISTANCE2,
        [SCARP_CELL_EDGE] = FNL_CELLULAR_RETURN_TYPE_DISTANCE2SUB,
        [SCARP_CELL_VALUE] = FNL_CELLULAR_RETURN_TYPE_CELLVALUE,
    };
    switch (basis) {
    case SCARP_GRADIENT: noise->noise_type = FNL_NOISE_PERLIN; return 1;
    case SCARP_VALUE: noise->noise_type = FNL_NOISE_VALUE; return 1;
    case SCARP_SIMPLEX: noise->noise_type = FNL_NOISE_OPENSIMPLEX2; return 1;
    case SCARP_CELL_SOFT: return 0;
    default:
        noise->noise_type = FNL_NOISE_CELLULAR;
        noise->cellular_distance_func = FNL_CELLULAR_DISTANCE_EUCLIDEAN;
        noise->cellular_return_type = cellular[basis];
        return 1;
    }
}

struct fnl_peer_state {
    fnl_state noise;
    int dimensions, warps;
};

static void *fnl_peer_open(const struct bench_work *work, enum scarp_isa isa)
{
    if (isa != SCARP_ISA_SCALAR || (work->fractal != SCARP_FBM && work->fractal != SCARP_RIDGED)) {
        return NULL;
    }
    struct fnl_peer_state *const state = malloc(sizeof *state);
    if (state != NULL) {
        state->dimensions = work->dimensions;
        state->noise = fnlCreateState();
        state->noise.frequency = 1.0f;
        if (!fnl_peer_basis(&state->noise, work->basis)) {
            free(state);
            return NULL;
        }
        state->noise.fractal_type = fnl_peer_fractal(work);
        state->noise.octaves = work->octaves;
        state->noise.lacunarity = work->lacunarity;
        state->noise.gain = work->gain;
        state->noise.domain_warp_type = FNL_DOMAIN_WARP_BASICGRID;
        state->noise.domain_warp_amp = BENCH_WARP_REACH;
        state->warps = work->warp != BENCH_WARP_NONE;
    }
    return state;
}

static void fnl_peer_warped(const struct fnl_peer_state *state, size_t count,
                            const float *const x[3], float *value)
{
    fnl_state noise = state->noise;
    for (size_t i = 0; i < count; i++) {
        float p[3] = {x[0][i], x[1][i], state->dimensions == 3 ? x[2][i] : 0.0f};
        if (state->dimensions == 2) {
            fnlDomainWarp2D(&noise, &p[0], &p[1]);
            value[i] = fnlGetNoise2D(&noise, p[0], p[1]);
        } else {
            fnlDomainWarp3D(&noise, &p[0], &p[1], &p[2]);
            value[i] = fnlGetNoise3D(&noise, p[0], p[1], p[2]);
        }
    }
}

static void fnl_peer_points(const void *opaque, size_t count, const float *const x[3], float *value)
{
    const struct fnl_peer_state *const state = opaque;
    /* A copy that no store can change: the compiler may keep its fields in registers. */
    const fnl_state noise = state->noise;
    if (state->warps) {
        fnl_peer_warped(state, count, x, value);
    } else if (state->dimensions == 2) {
        for (size_t i = 0; i < count; i++) {
            value[i] = fnlGetNoise2D(&noise, x[0][i], x[1][i]);
        }
    } else {
        for (size_t i = 0; i < count; i++) {
            value[i] = fnlGetNoise3D(&noise, x[0][i], x[1][i], x[2][i]);
        }
    }
}

const struct bench_peer bench_peer_fastnoiselite = {"FastNoiseLite", fnl_peer_open, free,
                                                    fnl_peer_points, NULL};
