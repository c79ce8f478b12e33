/* SPDX-License-Identifier: MIT
 *
 * The peer FastNoise2: gradient noise with the quintic fade, value noise, and sums of them, ridged
 * ones and warped ones too, for arrays of points and uniform grids, at each of its feature levels.
 * Its build options decide whether it fuses multiplications into additions; the strict build is
 * told apart by name.
 */
#include <cstring>

#include <FastNoise/FastNoise.h>

#include "peer.h"

namespace
{

struct State {
    FastNoise::SmartNode<FastNoise::Generator> noise;
    int dimensions;
};

const int seed = 7;

FastSIMD::FeatureSet level(scarp_isa isa)
{
    switch (isa) {
    case SCARP_ISA_SSE41: return FastSIMD::FeatureSet::SSE41;
    case SCARP_ISA_AVX2: return FastSIMD::FeatureSet::AVX2;
    case SCARP_ISA_AVX512: return FastSIMD::FeatureSet::AVX512;
    case SCARP_ISA_NEON: return FastSIMD::FeatureSet::AARCH64;
    default: return FastSIMD::FeatureSet::Invalid;
    }
}

template <typename Node> FastNoise::SmartNode<FastNoise::Generator> basis(FastSIMD::FeatureSet set)
{
    auto node = FastNoise::New<Node>(set);
    if (node) {
        node->SetScale(1.0f);
    }
    return node;
}

/* Its features stray on circles, which is why it searches no further than the cells around. */
FastNoise::SmartNode<FastNoise::Generator> distance(FastSIMD::FeatureSet set, scarp_basis of)
{
    auto node = FastNoise::New<FastNoise::CellularDistance>(set);
    if (node) {
        node->SetScale(1.0f);
        node->SetDistanceFunction(FastNoise::DistanceFunction::Euclidean);
        node->SetDistanceIndex0(of == SCARP_CELL_F2 ? 1 : 0);
        node->SetReturnType(of == SCARP_CELL_EDGE
                                ? FastNoise::CellularDistance::ReturnType::Index0Sub1
                                : FastNoise::CellularDistance::ReturnType::Index0);
    }
    return node;
}

FastNoise::SmartNode<FastNoise::Generator> cell_value(FastSIMD::FeatureSet set)
{
    auto node = FastNoise::New<FastNoise::CellularValue>(set);
    if (node) {
        node->SetScale(1.0f);
        node->SetDistanceFunction(FastNoise::DistanceFunction::Euclidean);
    }
    return node;
}

/* The basis; null of one that it does not have. */
FastNoise::SmartNode<FastNoise::Generator> basis_of(FastSIMD::FeatureSet set, scarp_basis of)
{
    switch (of) {
    case SCARP_GRADIENT: return basis<FastNoise::Perlin>(set);
    case SCARP_VALUE: return basis<FastNoise::Value>(set);
    case SCARP_SIMPLEX: return basis<FastNoise::Simplex>(set);
    case SCARP_CELL_F1:
    case SCARP_CELL_F2:
    case SCARP_CELL_EDGE: return distance(set, of);
    case SCARP_CELL_VALUE: return cell_value(set);
    default: return {};
    }
}

/* Its ridged sum has no Musgrave weights (as long as the weighted strength is 0, the default): it
   adds 1 - 2 |n_k| where scarp adds v_k (1 - |n_k|)^2. Turbulence is its fBm of magnitudes. */
template <typename Sum>
FastNoise::SmartNode<FastNoise::Generator> sum(FastSIMD::FeatureSet set,
                                               FastNoise::SmartNodeArg<FastNoise::Generator> source,
                                               const bench_work *work)
{
    auto node = FastNoise::New<Sum>(set);
    node->SetSource(source);
    node->SetOctaveCount(work->octaves);
    node->SetLacunarity(work->lacunarity);
    node->SetGain(work->gain);
    return node;
}

using Node = FastNoise::SmartNode<FastNoise::Generator>;

/* Gradient noise whose cells are so large, and a sum of its octaves */
template <typename Sum> Node octaves(FastSIMD::FeatureSet set, float size, int count, int of_seed)
{
    auto perlin = FastNoise::New<FastNoise::Perlin>(set);
    auto sum = FastNoise::New<Sum>(set);
    perlin->SetScale(size);
    perlin->SetSeedOffset(of_seed);
    sum->SetSource(perlin);
    sum->SetOctaveCount(count);
    sum->SetGain(0.5f);
    sum->SetLacunarity(2.0f);
    return sum;
}

Node fbm(FastSIMD::FeatureSet set, float size, int count, int of_seed)
{
    return octaves<FastNoise::FractalFBm>(set, size, count, of_seed);
}

/* a and b: nodes, or b a number */
template <typename Operator, typename A, typename B>
Node join(FastSIMD::FeatureSet set, const A &a, const B &b)
{
    auto node = FastNoise::New<Operator>(set);
    node->SetLHS(a);
    node->SetRHS(b);
    return node;
}

Node constant(FastSIMD::FeatureSet set, float value)
{
    auto node = FastNoise::New<FastNoise::Constant>(set);
    node->SetValue(value);
    return node;
}

Node fade(FastSIMD::FeatureSet set, const Node &a, const Node &b, const Node &by, float edge)
{
    auto node = FastNoise::New<FastNoise::Fade>(set);
    node->SetA(a);
    node->SetB(b);
    node->SetFade(by);
    node->SetFadeMin(-edge);
    node->SetFadeMax(edge);
    node->SetInterpolation(FastNoise::Fade::Interpolation::Quintic);
    return node;
}

/* offset - z */
Node minus_z(FastSIMD::FeatureSet set, float offset)
{
    auto node = FastNoise::New<FastNoise::Gradient>(set);
    node->SetMultiplier<FastNoise::Dim::Z>(-1.0f);
    node->SetOffset<FastNoise::Dim::Z>(-offset);
    return node;
}

Node flat(FastSIMD::FeatureSet set, const Node &source)
{
    auto node = FastNoise::New<FastNoise::RemoveDimension>(set);
    node->SetRemoveDimension(FastNoise::Dim::Z);
    node->SetSource(source);
    return node;
}

/* Two sums of octaves, faded by a third */
Node make_fade(FastSIMD::FeatureSet set)
{
    using namespace FastNoise;
    return join<Multiply>(
        set, fade(set, fbm(set, 400, 6, 0), fbm(set, 250, 8, 1), fbm(set, 900, 3, 2), 0.2f),
        100.0f);
}

/* bench/density.recipe. Ridged noise is as `sum` has it. */
Node make_density(FastSIMD::FeatureSet set)
{
    using namespace FastNoise;
    auto biome = New<GeneratorCache>(set); /* it is needed twice */
    biome->SetSource(fbm(set, 900, 2, 1));
    const auto between = [&](float a, float b) {
        return fade(set, constant(set, a), constant(set, b), biome, 0.15f);
    };
    const Node hills = fbm(set, 250, 4, 2);
    const Node height = join<Add>(set, join<Multiply>(set, hills, between(6, 66)), 20.0f);
    const Node rock = join<Multiply>(set, fbm(set, 60, 4, 3), flat(set, between(2, 16)));
    const Node ground = join<Multiply>(
        set, join<Add>(set, join<Add>(set, flat(set, height), minus_z(set, 0)), rock), 1 / 16.0f);
    const Node caves = join<Min>(set, octaves<FractalRidged>(set, 80, 2, 4),
                                 octaves<FractalRidged>(set, 80, 2, 5));
    const Node cut = join<Add>(set, join<Multiply>(set, caves, -12.0f), 9.6f);
    return join<Max>(set, join<Min>(set, ground, cut), minus_z(set, 4));
}

/* The recipes that it can do, too; null of others. */
Node recipe_of(const char *title, FastSIMD::FeatureSet set)
{
    return std::strcmp(title, "fade") == 0      ? make_fade(set)
           : std::strcmp(title, "density") == 0 ? make_density(set)
                                                : Node();
}

void *open(const bench_work *work, scarp_isa isa)
{
    const FastSIMD::FeatureSet set = level(isa);
    if (work->layout == BENCH_RECIPE || work->layout == BENCH_RECIPE_GRID) {
        const auto any = FastNoise::New<FastNoise::Constant>(set);
        const bool can =
            work->output == BENCH_VALUE && !work->f64 && any && any->GetActiveFeatureSet() == set;
        const Node noise = can ? recipe_of(work->title, set) : Node();
        return noise ? new State{noise, work->dimensions} : nullptr;
    }
    if (set == FastSIMD::FeatureSet::Invalid || work->fractal > SCARP_RIDGED ||
        (work->period != 0 && work->dimensions != 2)) {
        return nullptr;
    }
    auto noise = basis_of(set, work->basis);
    if (!noise || noise->GetActiveFeatureSet() != set) {
        return nullptr;
    }
    if (work->fractal == SCARP_TURBULENCE) {
        auto magnitude = FastNoise::New<FastNoise::Abs>(set);
        magnitude->SetSource(noise);
        noise = magnitude;
    }
    if (work->fractal == SCARP_RIDGED) {
        noise = sum<FastNoise::FractalRidged>(set, noise, work);
    } else if (work->octaves > 1) {
        noise = sum<FastNoise::FractalFBm>(set, noise, work);
    }
    if (work->warp != BENCH_WARP_NONE) {
        /* All components come from one hash per corner of a lattice of values, with a cubic fade.
         */
        auto warp = FastNoise::New<FastNoise::DomainWarpGradient>(set);
        warp->SetSource(noise);
        warp->SetScale(1.0f);
        warp->SetWarpAmplitude(BENCH_WARP_REACH);
        noise = warp;
    }
    return new State{noise, work->dimensions};
}

void close(void *state)
{
    delete static_cast<State *>(state);
}

void points(const void *opaque, size_t count, const float *const x[3], float *value)
{
    const State *const state = static_cast<const State *>(opaque);
    const int n = static_cast<int>(count);
    if (state->dimensions == 2) {
        state->noise->GenPositionArray2D(value, n, x[0], x[1], 0, 0, seed);
    } else {
        state->noise->GenPositionArray3D(value, n, x[0], x[1], x[2], 0, 0, 0, seed);
    }
}

void grid(const void *opaque, const bench_work *work, float *value)
{
    const State *const state = static_cast<const State *>(opaque);
    const int n[3] = {static_cast<int>(work->grid[0]), static_cast<int>(work->grid[1]),
                      static_cast<int>(work->grid[2])};
    const float *const x = work->origin;
    const float step = work->step;
    if (work->period != 0) { /* the grid's own size, which bench/work.c has it be */
        state->noise->GenTileable2D(value, n[0], n[1], step, step, seed);
    } else if (state->dimensions == 2) {
        state->noise->GenUniformGrid2D(value, x[0], x[1], n[0], n[1], step, step, seed);
    } else {
        state->noise->GenUniformGrid3D(value, x[0], x[1], x[2], n[0], n[1], n[2], step, step, step,
                                       seed);
    }
}

void recipe(void *state, const bench_work *work, const void *const x[3], const scarp_samples *out)
{
    if (work->layout == BENCH_RECIPE_GRID) {
        grid(state, work, out->value);
        return;
    }
    const float *const at[3] = {static_cast<const float *>(x[0]), static_cast<const float *>(x[1]),
                                static_cast<const float *>(x[2])};
    points(state, work->points, at, out->value);
}

#if defined(FASTSIMD_IS_RELAXED) && FASTSIMD_IS_RELAXED
const char *const library = "FastNoise2";
#else
const char *const library = "FastNoise2-strict";
#endif

} // namespace

extern "C" const bench_peer bench_peer_fastnoise2 = {library, open,    close, points,
                                                     grid,    nullptr, recipe};
