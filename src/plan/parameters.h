/* SPDX-License-Identifier: MIT
 *
 * The numbers of a noise as doubles, with defaults filled in. Included by the files that check a
 * noise and that make its constants.
 */
#ifndef SCARP_PARAMETERS_H
#define SCARP_PARAMETERS_H

#include "kept.h"

/* The most cells that a period of an octave has. */
#define PERIOD_MAX 0x1p30

struct parameters {
    double frequency, octaves, lacunarity, gain, amplitude, erosion, jitter, sharpness, of_octaves;
};

static inline double value_or(double value, double standard)
{
    return value == 0.0 ? standard : value;
}

static inline struct parameters parameters_of(const struct scarp_noise *noise)
{
    const double octaves = value_or((double)noise->octaves, 1.0);
    const struct parameters p = {
        .frequency = value_or(noise->frequency, 1.0),
        .octaves = octaves,
        .lacunarity = value_or((double)noise->lacunarity, 2.0),
        .gain = value_or((double)noise->gain, 0.5),
        .amplitude = value_or((double)noise->amplitude, 1.0),
        .erosion = value_or((double)noise->erosion, 1.0),
        .jitter = value_or((double)noise->jitter, 1.0),
        .sharpness = (double)sharpness_of(noise),
        .of_octaves = value_or((double)noise->of_octaves, octaves),
    };
    return p;
}

#endif
