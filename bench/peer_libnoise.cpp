/* SPDX-License-Identifier: MIT
 *
 * The peer libnoise: gradient noise in space with the quintic fade (its best quality) and value
 * noise, in double, one point per call; sums by its module Perlin.
 */
#include <noise.h>

#include "peer.h"

namespace
{

struct State {
    bool value_noise;
    bool sum;
    noise::module::Perlin perlin;
};

void *open(const bench_work *work, scarp_isa isa)
{
    const bool value_noise = work->basis == SCARP_VALUE;
    if (isa != SCARP_ISA_SCALAR || work->dimensions != 3 || (value_noise && work->octaves > 1)) {
        return nullptr;
    }
    State *const state = new State;
    state->value_noise = value_noise;
    state->sum = work->octaves > 1;
    state->perlin.SetOctaveCount(work->octaves);
    state->perlin.SetNoiseQuality(noise::QUALITY_BEST);
    return state;
}

void close(void *state)
{
    delete static_cast<State *>(state);
}

void points(const void *opaque, size_t count, const float *const x[3], float *value)
{
    const State *const state = static_cast<const State *>(opaque);
    for (size_t i = 0; i < count; i++) {
        const double a = x[0][i], b = x[1][i], c = x[2][i];
        if (state->sum) {
            value[i] = static_cast<float>(state->perlin.GetValue(a, b, c));
        } else if (state->value_noise) {
            value[i] =
                static_cast<float>(noise::ValueCoherentNoise3D(a, b, c, 7, noise::QUALITY_BEST));
        } else {
            value[i] =
                static_cast<float>(noise::GradientCoherentNoise3D(a, b, c, 7, noise::QUALITY_BEST));
        }
    }
}

} // namespace

extern "C" const bench_peer bench_peer_libnoise = {"libnoise", open, close, points, nullptr};
