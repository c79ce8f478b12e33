/* SPDX-License-Identifier: MIT
 *
 * What a description says, with defaults filled in: its numbers as doubles, and what follows from
 * them.
 */
#ifndef SCARP_PARAMETERS_H
#define SCARP_PARAMETERS_H

#include "call.h"
#include "members.h"
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
    return octave_count((float)value_or((double)noise->octaves, noise_bounds.octaves.standard));
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
    return noise->sharpness == 0.0f ? fractal_row(noise->fractal)->sharpness : noise->sharpness;
}

/* Why the noise, without its warp, does not have what is asked for. */
static inline enum scarp_refusal refused_outputs(const struct scarp_noise *noise,
                                                 struct scarp_request request)
{
    return request.order > 1 && fractal_has(noise->fractal, FRACTAL_SLOPES) ? REFUSED_HESSIAN
           : request.dphase && fractal_bends(noise->fractal)                ? REFUSED_DPHASE_FRACTAL
           : request.dphase && !basis_has(noise->basis, BASIS_FLOWS)        ? REFUSED_DPHASE_BASIS
                                                                            : REFUSED_NOT;
}

static inline int has_outputs(const struct scarp_noise *noise, struct scarp_request request)
{
    return refused_outputs(noise, request) == REFUSED_NOT;
}

/* The same of a noise with its warps, which have no derivative with respect to the phase. */
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

#define DECLARE(X, member, ...) double member;
struct parameters {
    SCARP_NOISE_MEMBERS(DECLARE, SCARP_NO_MEMBER, )
};
#undef DECLARE

static inline struct parameters parameters_of(const struct scarp_noise *noise)
{
#define FILL(X, member, refusal, standard, ...) .member = value_or((double)noise->member, standard),
    struct parameters p = {SCARP_NOISE_MEMBERS(FILL, SCARP_NO_MEMBER, )};
#undef FILL
    p.sharpness = (double)sharpness_of(noise);
    p.of_octaves = value_or(p.of_octaves, p.octaves);
    return p;
}

#endif
