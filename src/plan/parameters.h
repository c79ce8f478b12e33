/* SPDX-License-Identifier: MIT
 *
 * What a description says, with defaults filled in: its numbers as doubles, and what follows from
 * them.
 */
#ifndef SCARP_PARAMETERS_H
#define SCARP_PARAMETERS_H

#include "call.h"
#include "refusals.h"

/* The most cells that a period of an octave has. */
#define PERIOD_MAX 0x1p30

/* How many octaves the sum has: the fraction counts as one. `octaves` is in (0, 32]. */
static inline int octave_count(float octaves)
{
    const int whole = (int)octaves;
    return (float)whole < octaves ? whole + 1 : whole;
}

static inline int octaves_in(const struct scarp_noise *noise)
{
    return noise->octaves == 0.0f ? 1 : octave_count(noise->octaves);
}

static inline int is_rotated(const struct scarp_noise *noise, int octaves)
{
    return noise->rotate != 0 && octaves > 1;
}

/* Whether the lattice has a period along any axis of the call. */
static inline int repeats(const struct scarp_noise *noise, int dimensions)
{
    return (noise->period[0] | noise->period[1] | (dimensions == 3 ? noise->period[2] : 0)) != 0;
}

/* The sharpness of a noise, which each fractal that has one has a default for. */
static inline float sharpness_of(const struct scarp_noise *noise)
{
    const float standard = noise->fractal == SCARP_PINGPONG ? 2.0f
                           : noise->fractal == SCARP_HYBRID ? 0.7f
                           : noise->fractal == SCARP_SWISS  ? 0.15f
                           : noise->fractal == SCARP_JORDAN ? 0.35f
                                                            : 1.0f;
    return noise->sharpness == 0.0f ? standard : noise->sharpness;
}

/* Why the noise, without its warp, does not have what is asked for. */
static inline enum scarp_refusal refused_outputs(const struct scarp_noise *noise,
                                                 struct scarp_request request)
{
    const int bends = fractal_bends(noise->fractal);
    return request.order > 1 && (noise->fractal == SCARP_EROSION || bends) ? REFUSED_HESSIAN
           : request.dphase && bends                                       ? REFUSED_DPHASE_FRACTAL
           : request.dphase && noise->basis != SCARP_GRADIENT              ? REFUSED_DPHASE_BASIS
                                                                           : REFUSED_NOT;
}

static inline int has_outputs(const struct scarp_noise *noise, struct scarp_request request)
{
    return refused_outputs(noise, request) == REFUSED_NOT;
}

/* The same of a noise with its warps, which have no derivative by the phase. */
static inline struct scarp_fault outputs_fault(const struct scarp_noise *noise,
                                               struct scarp_request request)
{
    struct scarp_fault fault = {refused_outputs(noise, request), 0};
    request.dphase = 0;
    for (noise = noise->warp; fault.why == REFUSED_NOT && noise != NULL; noise = noise->warp) {
        fault.why = refused_outputs(noise, request);
        fault.warp++;
    }
    return fault;
}

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
