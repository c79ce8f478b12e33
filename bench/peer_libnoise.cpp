/* SPDX-License-Identifier: MIT
 *
 * The peer libnoise: gradient noise in space with the quintic fade (its best quality) and value
 * noise, in double, one point per call; sums by its modules Perlin, Billow (turbulence) and
 * RidgedMulti.
 */
#include <memory>

#include <noise.h>

#include "peer.h"

namespace
{

struct State {
    bool value_noise;
    std::unique_ptr<noise::module::Module> sum; /* null: a single octave */
};

template <typename Sum> std::unique_ptr<Sum> make_sum_of(const bench_work *work)
{
    auto sum = std::make_unique<Sum>();
    sum->SetOctaveCount(work->octaves);
    sum->SetLacunarity(work->lacunarity);
    sum->SetNoiseQuality(noise::QUALITY_BEST);
    return sum;
}

template <typename Sum>
std::unique_ptr<noise::module::Module> make_sum_with_gain(const bench_work *work)
{
    auto sum = make_sum_of<Sum>(work);
    sum->SetPersistence(work->gain);
    return sum;
}

/* Its ridged sum is Musgrave's, like scarp's (scarp.h has the constants between them); turbulence
   is 2 |n| - 1 per octave. The gain of the ridged sum cannot be chosen. */
std::unique_ptr<noise::module::Module> make_sum(const bench_work *work)
{
    switch (work->fractal) {
    case SCARP_TURBULENCE: return make_sum_with_gain<noise::module::Billow>(work);
    case SCARP_RIDGED: return make_sum_of<noise::module::RidgedMulti>(work);
    default: return make_sum_with_gain<noise::module::Perlin>(work);
    }
}

void *open(const bench_work *work, scarp_isa isa)
{
    const bool value_noise = work->basis == SCARP_VALUE;
    if (isa != SCARP_ISA_SCALAR || work->dimensions != 3 || work->basis > SCARP_VALUE ||
        work->fractal > SCARP_RIDGED || work->warp != BENCH_WARP_NONE ||
        (value_noise && work->octaves > 1)) {
        return nullptr;
    }
    return new State{value_noise, work->octaves > 1 ? make_sum(work) : nullptr};
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
            value[i] = static_cast<float>(state->sum->GetValue(a, b, c));
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
