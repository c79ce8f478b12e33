/* SPDX-License-Identifier: MIT
 *
 * One noise that repeats: from the samples of --period to cells of the lattice.
 */
#ifndef SCARP_CLI_REPEAT_H
#define SCARP_CLI_REPEAT_H

#include <stdbool.h>

#include "shared/noise_options.h"

/* Gives the noise the nearest frequency that has whole cells in a period, and that number of cells.
   `step` is the distance between samples. False, with a line on stderr, if that cannot be. */
bool repeat_noise(struct noise_options *noise, struct option_size period, double step);

#endif
