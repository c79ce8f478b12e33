/* SPDX-License-Identifier: MIT
 *
 * The options that say which noise, the same for every command that samples: the members of struct
 * scarp_noise under their own names, within the intervals of scarp.h.
 */
#ifndef SCARP_CLI_NOISE_H
#define SCARP_CLI_NOISE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "scarp.h"
#include "shared/options.h"

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
#define WARP_OPTIONS_UNSET                                                                         \
    {                                                                                              \
        .noise = NOISE_OPTIONS_UNSET                                                               \
    }

#define NOISE_OPTION_COUNT 15
extern const struct option noise_option_rows[NOISE_OPTION_COUNT]; /* --amplitude is the last one */

/* The warp: a noise whose options have --warp- before their names. Its amplitude is the reach. */
struct warp_options {
    struct noise_options noise;
    struct option_given given; /* of its rows */
    float reach;               /* 0: no warp */
};

/* The two groups of a warp, whose struct is at an offset in the values */
#define WARP_GROUPS(name, at)                                                                      \
    OPTION_GROUP(name, warp_option_rows, at),                                                      \
    {                                                                                              \
        .options = noise_option_rows, .count = NOISE_OPTION_COUNT - 1,                             \
        .offset = (at) + offsetof(struct warp_options, noise), .prefix = "warp-",                  \
        .about = WARP_ABOUT, .given = (at) + offsetof(struct warp_options, given)                  \
    }
#define WARP_ABOUT                                                                                 \
    "The warp is a noise of its own for each axis, with the options of the\n"                      \
    "noise by names with warp- before them, but no amplitude. Its seed and\n"                      \
    "frequency are those of the noise unless they are given; it has one\n"                         \
    "octave and the gain 0.5 unless told otherwise."
extern const struct option warp_option_rows[1];

/* float: 0, for a noise that is not there, or a number in [lowest, highest] whose magnitude is one
   of an amplitude. Like option_float. */
option_parse_fn noise_parse_amplitude;

/* A noise beside the first one, whose options have a prefix */
struct noise_part {
    const char *prefix;
    const char *needs; /* what there must be, so that there is such a noise: "a --base-amplitude" */
    struct noise_options *noise;
    const struct option_given *given;
    bool is_there;
};

/* Gives it the seed and the frequency of the first one where it has none of its own. False, with a
   line on stderr, if it is not there and options of it were typed. */
bool noise_part_complete(const struct noise_part *part, const struct noise_options *first);

/* Makes it, complete, with the amplitude 1. `prefix` stands in a message as in its options. False,
   with a line on stderr, if the numbers do not go together. */
bool noise_make_part(const struct noise_options *options, const char *prefix, int dimensions,
                     struct scarp_noise *made);

/* Gives a warp the seed and the frequency of the noise where it has none of its own. False, with a
   line on stderr, if options of a warp were typed for no warp. */
bool warp_complete(struct warp_options *warp, const struct noise_options *noise);

/* Gives a complete warp the period, in its own cells, after which it repeats where the noise does.
   False, with a line on stderr, if that is no whole number of cells. */
bool warp_repeat(struct warp_options *warp, const struct noise_options *noise);

/* Makes the noise and its warp, which are complete, for so many dimensions: made[0], which points
   to made[1] if there is a warp. False, with a line on stderr, if the numbers do not go together.
 */
bool noise_make(const struct noise_options *options, const struct warp_options *warp,
                int dimensions, struct scarp_noise made[2]);

#endif
