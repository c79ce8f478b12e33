/* SPDX-License-Identifier: MIT
 *
 * What scarp.h defines for the octaves of a noise, in double: seeds, keys, offsets, turns and
 * weights. Of the library only the traits of fractals come in. Header only; included by the oracle
 * and by tests that rebuild noise from single octaves.
 */
#ifndef SCARP_TESTS_OCTAVES_H
#define SCARP_TESTS_OCTAVES_H

#include "../src/plan/traits.h"
#include "check.h"

struct octave {
    uint64_t seed;     /* s_k */
    uint32_t key[3];   /* of its lattice */
    double frequency;  /* f_k */
    double share;      /* gain^k */
    double weight;     /* a_k, without the normalisation of the basis */
    double axes[3][3]; /* J_k = f_k R^k */
    double offset[3];  /* o_k */
    int turned;        /* whether its axes are not those of x */
};

static inline double octaves_or(double given, double standard)
{
    return given != 0.0 ? given : standard;
}

/* s_0 is the seed, s_k number k of the generator that the first number of the seed's own generator
   starts. Key and offset are drawn likewise from s_k. */
static inline void octave_draw(struct octave *octave, uint64_t seed, int k)
{
    octave->seed = k == 0 ? seed : check_random_number(check_random_number(seed, 1), (uint64_t)k);
    uint64_t state = check_random_number(octave->seed, 1);
    const uint64_t first = check_random(&state), second = check_random(&state),
                   third = check_random(&state);
    octave->key[0] = (uint32_t)first;
    octave->key[1] = (uint32_t)(first >> 32);
    octave->key[2] = (uint32_t)second;
    octave->offset[0] = ldexp((double)(second >> 40), -24);
    octave->offset[1] = ldexp((double)(third % (1 << 24)), -24);
    octave->offset[2] = ldexp((double)(third >> 40), -24);
}

/* axes = R * axes, the turn from one octave to the next */
static inline void octaves_turn(double axes[3][3], int dimensions)
{
    static const double plane[3][3] = {{0.8, -0.6, 0}, {0.6, 0.8, 0}, {0, 0, 1}};
    static const double space[3][3] = {{0, 0.8, 0.6}, {-0.8, 0.36, -0.48}, {-0.6, -0.48, 0.64}};
    const double(*const turn)[3] = dimensions == 2 ? plane : space;
    for (int column = 0; column < 3; column++) {
        const double x = axes[0][column], y = axes[1][column], z = axes[2][column];
        for (int row = 0; row < 3; row++) {
            axes[row][column] = turn[row][0] * x + turn[row][1] * y + turn[row][2] * z;
        }
    }
}

/* The sharpness of a noise, with the default of its fractal */
static inline double octaves_sharpness(const struct scarp_noise *noise)
{
    return octaves_or((double)noise->sharpness, (double)fractal_row(noise->fractal)->sharpness);
}

/* What the amplitude is divided by: w_0 + ... + w_(K-1), where the last one is multiplied by the
   fraction of the octaves; with hybrid noise, w_0 u_0 + ... where every n_k is 1. */
static inline double octaves_sum(const struct scarp_noise *noise)
{
    const double octaves = octaves_or((double)noise->octaves, 1.0);
    const double of = octaves_or((double)noise->of_octaves, octaves);
    double sum = 0.0, v = 1.0;
    for (int k = 0; k < of; k++) {
        const double w = pow(octaves_or((double)noise->gain, 0.5), k);
        const double u =
            noise->fractal == SCARP_HYBRID ? v * (1.0 + octaves_sharpness(noise)) : 1.0;
        sum += w * u * fmin(of - k, 1.0);
        v = fmin(w * u, 1.0);
    }
    return sum;
}

/* The octaves of a noise without its warp; returns how many there are. */
static inline int octaves_make(const struct scarp_noise *noise, int dimensions,
                               struct octave *octave)
{
    const double octaves = octaves_or((double)noise->octaves, 1.0);
    const double lacunarity = octaves_or((double)noise->lacunarity, 2.0);
    const double headroom = noise->fractal == SCARP_HYBRID ? 0x1p-16 : 0x1p-17;
    const int squared = fractal_row(noise->fractal)->range == RANGE_SQUARE;
    const double all = octaves_or((double)noise->amplitude, 1.0) * (1.0 - headroom) /
                       octaves_sum(noise) * (squared ? 1.0 - 0x1p-17 : 1.0);
    const int count = (int)ceil(octaves);
    double turns[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < count; k++) {
        struct octave *const o = &octave[k];
        octave_draw(o, noise->seed, k);
        if (k == 0 && noise->offset_first == 0) {
            memset(o->offset, 0, sizeof o->offset);
        }
        o->turned = noise->rotate != 0 && k > 0;
        o->frequency = k == 0 ? octaves_or(noise->frequency, 1.0) : o[-1].frequency * lacunarity;
        o->share = pow(octaves_or((double)noise->gain, 0.5), k);
        o->weight = all * o->share * fmin(octaves - k, 1.0);
        for (int i = 0; i < 9; i++) {
            o->axes[i / 3][i % 3] = o->frequency * turns[i / 3][i % 3];
        }
        if (noise->rotate != 0) {
            octaves_turn(turns, dimensions);
        }
    }
    return count;
}

#endif
