/* SPDX-License-Identifier: MIT
 *
 * The phase of flow noise (scarp.h, "Flow"): how far the gradients of each octave are turned.
 */
#ifndef SCARP_PHASE_H
#define SCARP_PHASE_H

#include "call.h"

/* Sets `turn` of all octaves. */
void scarpi_phase_set(struct scarp_octave *octave, int octaves, float phase);

/* The supremum of gradient noise over all phases. */
double scarpi_phase_supremum(enum scarp_fade fade, int dimensions);

#endif
