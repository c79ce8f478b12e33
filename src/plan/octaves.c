/* SPDX-License-Identifier: MIT
 *
 * Computes the constants of octaves, in double and in one fixed order, without libm, so that every
 * platform computes the same.
 */
#include "octaves.h"

#include <string.h>

#include "hybrid.h"
#include "parameters.h"
#include "suprema.h"

/*
 * The head-room for rounding. In units of the supremum, what is interpolated is at most 2 (a
 * corner's dot product: 1.995 in 2D, 1.930 in 3D; with a phase 2.0 and 2.008 of the supremum over
 * all phases) and differences are at most 4. Three fades, each within 1.94e-7 of the exact one, err
 * by at most 2.4e-6. Three levels of interpolation of three roundings each, and the dot products
 * before, err by at most 2.4e-6, the sum of 32 octaves by 32 * 2^-24 = 1.9e-6. Together that
 * is 6.7e-6, less than 2^-17 = 7.6e-6. Gradients that a phase turns are rounded to floats,
 * by 3.2e-7 at most, and products with them are no longer exact, which makes 7.4e-6.
 * Where simplex noise is largest, w is more than .4 at the vertices that matter, and within 2.4e-7,
 * so w^4 is within 2.4e-6 of itself. Distances are within 4e-7.
 */
#define HEADROOM (1.0 - 0x1p-17)

/* The turn between octaves. The 2D turn is Quilez' (3-4-5 triangle), the 3D one has rational
   entries too, so neither accumulates more error than the products of doubles. */
static const double turn2[3][3] = {{0.8, -0.6, 0.0}, {0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}};
static const double turn3[3][3] = {{0.0, 0.8, 0.6}, {-0.8, 0.36, -0.48}, {-0.6, -0.48, 0.64}};

/* The finaliser of splitmix64 (Steele, Lea and Flood 2014, with Stafford's mix 13): a bijection. */
static uint64_t mix64(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

#define GOLDEN_GAMMA UINT64_C(0x9e3779b97f4a7c15) /* 2^64 / golden ratio, odd */

/*
 * The seed of octave k > 0, such that the octave by itself is single-octave noise of that seed. The
 * seed is mixed before k comes in, so seeds that people choose (neighbours, complements, powers of
 * two) have no octaves in common. `mixed` is mix64(seed + GOLDEN_GAMMA). Octave 0 has `seed`
 * itself.
 */
static uint64_t octave_seed(uint64_t mixed, int k)
{
    return mix64(mixed + (uint64_t)k * GOLDEN_GAMMA);
}

/* Draws the keys of an octave from its stream, mix64(its seed + GOLDEN_GAMMA). The keys of x and y
   are a bijection of the seed, so no two seeds share an octave k. */
static void draw_keys(struct scarp_octave *octave, uint64_t stream)
{
    const uint64_t a = mix64(stream + GOLDEN_GAMMA);
    const uint64_t b = mix64(stream + 2 * GOLDEN_GAMMA);
    octave->key[0] = (uint32_t)a;
    octave->key[1] = (uint32_t)(a >> 32);
    octave->key[2] = (uint32_t)b;
}

static void draw_offset(struct scarp_octave *octave, uint64_t stream)
{
    const uint64_t b = mix64(stream + 2 * GOLDEN_GAMMA);
    const uint64_t c = mix64(stream + 3 * GOLDEN_GAMMA);
    const int32_t draws[3] = {(int32_t)(b >> 40), (int32_t)(c & 0xffffff), (int32_t)(c >> 40)};
    for (int i = 0; i < 3; i++) {
        octave->offset[i] = (double)draws[i] * 0x1p-24;
    }
}

/* `mixed` is as in octave_seed(). The first octave has the offset 0 unless `offset_first` is set.
 */
static void draw_octave(struct scarp_octave *octave, uint64_t mixed, int k, uint32_t offset_first)
{
    const uint64_t stream = k == 0 ? mixed : mix64(octave_seed(mixed, k) + GOLDEN_GAMMA);
    draw_keys(octave, stream);
    if (k > 0 || offset_first != 0) {
        draw_offset(octave, stream);
    } else {
        memset(octave->offset, 0, sizeof octave->offset);
    }
}

/* A row of the Jacobian, frequency times a row of the turn, and what the kernels need of it. */
static void set_axis(struct scarp_octave *octave, int i, const double turn[3], double amplitude)
{
    for (int j = 0; j < 3; j++) {
        const double slope = octave->frequency64 * turn[j];
        octave->jacobian64[i][j] = slope;
        octave->jacobian[i][j] = (float)slope;
        octave->gradient[i][j] = (float)(amplitude * slope);
    }
}

/* turn = by turn */
static void multiply(double turn[3][3], const double by[3][3])
{
    double product[3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            product[i][j] = by[i][0] * turn[0][j] + by[i][1] * turn[1][j] + by[i][2] * turn[2][j];
        }
    }
    memcpy(turn, product, sizeof product);
}

static void turn_axes(struct scarp_octave *octave, int octaves, int dimensions,
                      const double amplitude[SCARP_MAX_OCTAVES])
{
    double turn[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (int k = 0; k < octaves; k++) {
        for (int i = 0; i < dimensions; i++) {
            set_axis(&octave[k], i, turn[i], amplitude[k]);
        }
        multiply(turn, dimensions == 2 ? turn2 : turn3);
    }
}

/* The periods of all octaves. A check lets pass what is too long for an axis that the call does not
   have. */
static void set_periods(struct scarp_octave *octave, int octaves, const struct scarp_noise *noise,
                        double lacunarity)
{
    double ratio = 1.0;
    for (int k = 0; k < octaves; k++) {
        for (int i = 0; i < 3; i++) {
            const double period = (double)noise->period[i] * ratio;
            octave[k].last[i] = (period <= PERIOD_MAX ? (uint32_t)period : 0) - 1;
        }
        ratio *= lacunarity;
    }
}

/* Sets the weights w_k of the octaves that are summed, and gives the sum of those that the
   amplitudes are for. */
static double weigh_octaves(double weights[SCARP_MAX_OCTAVES], const struct parameters *p)
{
    const int octaves = octave_count((float)p->octaves), of = octave_count((float)p->of_octaves);
    double weight = 1.0, sum = 0.0;
    for (int k = 0; k < of; k++) {
        weights[k] = k == octaves - 1 ? weight * (p->octaves - (double)k) : weight;
        sum += k == of - 1 ? weight * (p->of_octaves - (double)k) : weight;
        weight *= p->gain;
    }
    return sum;
}

/* What weights are multiplied by to be amplitudes of 1 in all, `sum` being that of the weights. */
static double share_of(const struct scarp_noise *noise, const struct parameters *p, double sum)
{
    const enum fractal_range range = fractal_row(noise->fractal)->range;
    if (range != RANGE_RAISED) {
        return (range == RANGE_SQUARE ? HEADROOM * HEADROOM : HEADROOM) / sum;
    }
    return SCARP_HYBRID_HEADROOM /
           scarpi_hybrid_interval(p->sharpness, p->gain, p->of_octaves, 1.0).highest;
}

/* What an octave's noise, which reaches 1, is multiplied by before anything else. The head-room of
   hybrid noise, which adds the sharpness to it, is here; `weighted` has that of others. */
static double factor_of(enum scarp_fractal fractal, double weighted)
{
    return fractal == SCARP_FBM ? weighted : fractal == SCARP_HYBRID ? HEADROOM : 1.0;
}

void scarpi_octaves_make(struct scarp_octave *octave, const struct scarp_noise *noise,
                         int dimensions)
{
    const struct parameters of_noise = parameters_of(noise), *const p = &of_noise;
    const int octaves = octave_count((float)p->octaves);
    const double supremum = scarpi_supremum(noise, dimensions);
    double weights[SCARP_MAX_OCTAVES], factors[SCARP_MAX_OCTAVES];
    const double scale = p->amplitude * share_of(noise, p, weigh_octaves(weights, p));
    const double stretch =
        dimensions == 2 && basis_has(noise->basis, BASIS_TRIANGLES) ? SCARP_TRIANGLE_ROWS : 1.0;
    const uint64_t mixed = mix64(noise->seed + GOLDEN_GAMMA);
    double frequency = p->frequency, share = 1.0;
    for (int k = 0; k < octaves; k++) {
        struct scarp_octave *const o = &octave[k];
        const double weighted = weights[k] * scale;
        const double factor = factor_of(noise->fractal, weighted) / supremum;
        factors[k] = factor;
        o->weight = (float)weighted;
        o->amplitude = (float)factor;
        o->slope = (float)(factor * frequency);
        o->curvature = (float)(factor * frequency * frequency);
        o->frequency = (float)frequency;
        o->share = (float)share;
        if (!blends_corners(noise->basis)) {
            o->jitter = scarpi_stray(noise);
            o->middle = (float)scarpi_middle(noise, dimensions);
            o->stretch = stretch;
        }
        o->frequency64 = frequency;
        draw_octave(o, mixed, k, noise->offset_first);
        memset(o->last, 0xff, sizeof o->last);
        frequency *= p->lacunarity;
        share *= p->gain;
    }
    if (repeats(noise, dimensions)) {
        set_periods(octave, octaves, noise, p->lacunarity);
    }
    if (is_rotated(noise, octaves)) {
        turn_axes(octave, octaves, dimensions, factors);
    }
}

uint64_t scarpi_component_seed(uint64_t seed, int component)
{
    return octave_seed(mix64(seed + GOLDEN_GAMMA), SCARP_MAX_OCTAVES + 1 + component);
}
