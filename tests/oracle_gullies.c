/* SPDX-License-Identifier: MIT
 *
 * The displacement by gullies, as scarp.h defines it: a sum over the corners of each cell, with the
 * exponentials of libm. There are no derivatives: tests take differences.
 */
#include "oracle_gullies.h"

#include <complex.h>
#include <math.h>

#define TAU 0.05
#define EPS 0.5
#define TURN 6.283185307179586

static double or_default(double value, double standard)
{
    return value != 0.0 ? value : standard;
}

void oracle_gullies_make(struct oracle_gullies *oracle, const struct scarp_gullies *g)
{
    const double cells = or_default((double)g->cells, 3.0);
    const double frequency = or_default(g->frequency, 1.0);
    const struct scarp_noise lattice = {
        .rotate = g->rotate,
        .seed = g->seed,
        .frequency = frequency * cells,
        .octaves = g->octaves != 0.0f ? g->octaves : 5.0f,
        .of_octaves = g->of_octaves,
        .lacunarity = g->lacunarity,
        .gain = g->gain != 0.0f ? g->gain : 0.45f,
        .amplitude = g->depth != 0.0f ? g->depth : 0.25f,
        .period = {(uint32_t)((double)g->period[0] * cells),
                   (uint32_t)((double)g->period[1] * cells)},
        .offset_first = g->offset_first,
    };
    oracle_make(&oracle->lattice, &lattice, 2);
    oracle->frequency = frequency;
    oracle->amplitude = or_default((double)g->amplitude, 1.0);
    oracle->low = or_default((double)g->low, -1.0);
    oracle->high = or_default((double)g->high, 1.0);
    oracle->slope = or_default((double)g->slope, 1.125);
    oracle->slope_low = or_default((double)g->slope_low, 1.75);
    oracle->floor = or_default((double)g->floor, 0.5);
    oracle->stripes = or_default((double)g->stripes, 1.5);
    oracle->branch = or_default((double)g->branch, (double)0.8f);
    oracle->round = or_default((double)g->round, (double)0.15f);
    oracle->keep = or_default((double)g->keep, 1.0);
}

static double quintic(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/* The phase psi of the corner `step` from `cell`, in turns: the value that its hash draws. */
static double phase_of(const struct oracle_octave *octave, const uint32_t cell[3],
                       const int step[3])
{
    const struct oracle_lattice lattice = {
        .key = octave->of.key, .period = octave->period, .dimensions = 2};
    const double hash = (double)oracle_hash(oracle_mixed(&lattice, cell, step));
    return (double)(float)(hash >= 0x1p31 ? hash - 0x1p32 : hash) * 0x1p-32;
}

/* A cell within the period. */
static uint32_t cell_within(double lower, int64_t period)
{
    const int64_t remainder = (int64_t)lower % period;
    return (uint32_t)(remainder < 0 ? remainder + period : remainder);
}

/* The blend of the corners' waves, with `across` in the axes of the octave. */
static double complex blend(const struct oracle_octave *octave, const double p[2],
                            const double across[2], double stripes)
{
    const double lower[2] = {floor(p[0]), floor(p[1])};
    const uint32_t cell[3] = {cell_within(lower[0], octave->period[0]),
                              cell_within(lower[1], octave->period[1]), 0};
    double complex sum = 0.0;
    for (int corner = 0; corner < 4; corner++) {
        const int step[3] = {corner % 2, corner / 2, 0};
        double weight = 1.0, waves = 0.0;
        for (int i = 0; i < 2; i++) {
            const double t = p[i] - lower[i];
            weight *= step[i] == 1 ? quintic(t) : 1.0 - quintic(t);
            waves += stripes * across[i] * (t - step[i]);
        }
        sum += weight * cexp(I * TURN * (phase_of(octave, cell, step) + waves));
    }
    return sum;
}

double oracle_gullies_at(const struct oracle_gullies *g, const double x[2], double height,
                         const double gradient[2])
{
    const double unit = g->amplitude * g->frequency;
    const double slopes[2] = {gradient[0] / unit, gradient[1] / unit};
    const double z = fmin(fmax((height / g->amplitude - g->low) / (g->high - g->low), 0.0), 1.0);
    const double step = z * z * (3.0 - 2.0 * z);
    const double soft = g->slope_low * g->slope_low * (1.0 - step) + g->slope * g->slope * step;
    const double length = sqrt(slopes[0] * slopes[0] + slopes[1] * slopes[1] + soft);
    double s[2] = {slopes[0] / length, slopes[1] / length};
    const double steep = s[0] * s[0] + s[1] * s[1];
    double exposure = 1.0 - (1.0 - step) * (1.0 + g->floor), sum = 0.0;
    for (int k = 0; k < g->lattice.octaves; k++) {
        const struct oracle_octave *const o = &g->lattice.octave[k];
        const double t_length = sqrt(s[0] * s[0] + s[1] * s[1] + TAU * TAU);
        const double t[2] = {-s[1] / t_length, s[0] / t_length};
        double p[2], across[2];
        for (int i = 0; i < 2; i++) {
            p[i] = o->of.axes[i][0] * x[0] + o->of.axes[i][1] * x[1] + o->of.offset[i];
            across[i] = (o->of.axes[i][0] * t[0] + o->of.axes[i][1] * t[1]) / o->of.frequency;
        }
        double complex wave = blend(o, p, across, g->stripes);
        wave /= sqrt(creal(wave * conj(wave)) + EPS * EPS);
        const double profile =
            1.0 - 2.0 * (sqrt((1.0 - creal(wave)) / 2.0 + g->round * g->round) - g->round) /
                      (sqrt(1.0 + g->round * g->round) - g->round);
        const double m = steep * (1.0 - (k > 0 ? g->keep : 0.0) * exposure * exposure);
        exposure += m * (profile - exposure);
        sum += o->of.weight * exposure;
        for (int i = 0; i < 2; i++) {
            s[i] -= g->branch * m * cimag(wave) * t[i];
        }
    }
    return g->amplitude * sum;
}
