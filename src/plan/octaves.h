/* SPDX-License-Identifier: MIT
 *
 * The constants of octaves, which plans are made of.
 */
#ifndef SCARP_OCTAVES_H
#define SCARP_OCTAVES_H

#include "call.h"

/* Computes all octaves of a checked noise, as if it had no warp, but for what the phase sets. */
void scarpi_octaves_make(struct scarp_octave *octave, const struct scarp_noise *noise,
                         int dimensions);

/* The seed of a component of vector noise: a number that no octave has. Components that share a
   lattice have the seed of component 0. */
uint64_t scarpi_component_seed(uint64_t seed, int component);

#endif
