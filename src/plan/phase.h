/* SPDX-License-Identifier: MIT
 *
 * The phase of flow noise (scarp.h, "Flow"): how far the gradients of each octave are turned.
 */
#ifndef SCARP_PHASE_H
#define SCARP_PHASE_H

#include "plan.h"

/* Sets `turn` of all octaves. */
void scarp_phase_set(struct scarp_octave *octave, int octaves, float phase);

/* amplitude d angle / d phase of octave k: 2 pi 2^k times the amplitude */
static inline float scarp_phase_slope(const struct scarp_octave *octave, int k)
{
    return octave->amplitude * (6.28318531f * (float)(1u << k));
}

/* The supremum of gradient noise over all phases. */
double scarp_phase_supremum(enum scarp_fade fade, int dimensions);

/* d turn / d angle: of an angle x, then of 2 x. The products with 2 are exact. */
static inline void scarp_phase_derivative(float derivative[4], const float turn[4])
{
    derivative[0] = -turn[1];
    derivative[1] = turn[0];
    derivative[2] = -2.0f * turn[3];
    derivative[3] = 2.0f * turn[2];
}

#endif
