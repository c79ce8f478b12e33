/* SPDX-License-Identifier: MIT
 *
 * What shaders of noises and of recipes share.
 */
#ifndef SCARP_SHADERS_H
#define SCARP_SHADERS_H

#include "../plan/call.h"

/* Writes the levels of a plan, and their octaves, of which the first one is number `first` of all.
   Returns how many octaves these are. Arrays may be NULL. */
int scarpi_shader_levels(const struct scarp_call_plan *plan, int dimensions,
                         struct scarp_gpu_level *level, struct scarp_gpu_octave *octave, int first);

/* The power of two nearest 1 / (256 frequency): test points are multiples of it. */
float scarpi_shader_unit(double frequency);

#endif
