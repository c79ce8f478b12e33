/* SPDX-License-Identifier: MIT
 *
 * The options that say which noise, the same for every command that samples: the members of struct
 * scarp_noise under their own names, within the intervals of scarp.h.
 */
#ifndef SCARP_CLI_NOISE_OPTIONS_H
#define SCARP_CLI_NOISE_OPTIONS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "scarp.h"
#include "shared/options.h"
#include "shared/text.h"

/* Before options are parsed, `phase`, `sharpness` and `of_octaves` must be NOISE_UNSET. */
struct noise_options {
    uint64_t seed;
    double frequency;
    float octaves, lacunarity, gain, amplitude, erosion, jitter, phase, sharpness, of_octaves;
    uint32_t period[3];
    int basis, fade, fractal, rotate; /* enumerators of scarp.h */
};

/* Not given, which is not the same as --phase 0 */
#define NOISE_UNSET INFINITY
#define NOISE_OPTIONS_UNSET                                                                        \
    {                                                                                              \
        .phase = NOISE_UNSET, .sharpness = NOISE_UNSET, .of_octaves = NOISE_UNSET                  \
    }
#define NOISE_SEED_ROWS 1
#define NOISE_OPTION_COUNT 14
extern const struct option noise_seed_rows[NOISE_SEED_ROWS];      /* of recipes, too */
extern const struct option noise_option_rows[NOISE_OPTION_COUNT]; /* --amplitude is the last one */

/* Makes the noise for so many dimensions. False, with a line on stderr, if the numbers do not go
   together. */
bool noise_make(const struct noise_options *options, int dimensions, struct scarp_noise *made);

/* Adds the noise as a recipe has it: noise(ridged, frequency=0.01). The seed is that of the world.
   With a phase, its number is the parameter `phase`. */
void noise_write(const struct noise_options *options, struct text *text);

#endif
