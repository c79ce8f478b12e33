/* SPDX-License-Identifier: MIT
 *
 * Terrain that repeats: from the samples of --period to cells of the lattice.
 */
#ifndef SCARP_CLI_REPEAT_H
#define SCARP_CLI_REPEAT_H

#include <stdbool.h>

#include "terrain/terrain_options.h"

/* Turns --period and --tileable into options->noise.period, with the nearest frequency that has
   whole cells in a period, and straight axes in place of a preset's turned ones. False, with a line
   on stderr, if that cannot be. */
bool terrain_repeat(struct terrain_options *options);

#endif
