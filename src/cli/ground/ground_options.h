/* SPDX-License-Identifier: MIT
 *
 * The options that say what the terrain is: its noises and how they make heights. The same for
 * every command that shows a terrain; presets consist of them.
 */
#ifndef SCARP_CLI_GROUND_OPTIONS_H
#define SCARP_CLI_GROUND_OPTIONS_H

#include "shared/noise.h"
#include "shared/options.h"

/* A noise that is added. Its amplitude is that of the values. */
struct base_options {
    struct noise_options noise;
    struct option_given given;
    float amplitude; /* 0: no base */
};

/* A noise that says where the first one is */
struct mask_options {
    struct noise_options noise;
    struct option_given given;
    struct option_point band; /* from nowhere to everywhere; two equal numbers: no mask */
};

struct ground_options {
    struct noise_options noise;
    struct warp_options warp;
    struct base_options base;
    struct mask_options mask;
    double stretch, wind;
    float height, sea_level, plateau, crater;        /* no sea: -infinity; else infinity for none */
    float terraces, terrace_riser, terrace_strength; /* no terraces: 0 */
    int preset;
};

#define GROUND_OPTIONS_UNSET                                                                       \
    {                                                                                              \
        .noise = NOISE_OPTIONS_UNSET, .warp = WARP_OPTIONS_UNSET,                                  \
        .base = {.noise = NOISE_OPTIONS_UNSET}, .mask = {.noise = NOISE_OPTIONS_UNSET},            \
        .sea_level = -INFINITY, .plateau = INFINITY, .crater = INFINITY                            \
    }

#define GROUND_PRESET_ROWS 1
#define GROUND_SHAPE_ROWS 6
#define GROUND_TERRACE_ROWS 3
extern const struct option ground_preset_rows[GROUND_PRESET_ROWS];
extern const struct option ground_shape_rows[GROUND_SHAPE_ROWS];
extern const struct option ground_terrace_rows[GROUND_TERRACE_ROWS];
extern const struct option ground_base_rows[1];
extern const struct option ground_mask_rows[1];

#define GROUND_FIELD(at, member) ((at) + offsetof(struct ground_options, member))

/* A noise whose options have a prefix, in the member `part` of struct ground_options */
#define GROUND_PART(part, word, text, at)                                                          \
    {                                                                                              \
        .options = noise_option_rows, .count = NOISE_OPTION_COUNT - 1,                             \
        .offset = GROUND_FIELD(at, part.noise), .prefix = word, .about = text,                     \
        .given = GROUND_FIELD(at, part.given)                                                      \
    }
#define BASE_ABOUT                                                                                 \
    "The base is a noise of its own, with the options of the noise by names\n"                     \
    "with base- before them. Its seed and frequency are those of the noise\n"                      \
    "unless they are given."
#define MASK_ABOUT                                                                                 \
    "The mask is a noise of its own, with the options of the noise by names\n"                     \
    "with mask- before them. Its seed and frequency are those of the noise\n"                      \
    "unless they are given."

/* All groups, for a table; the struct is at an offset in the values. */
#define GROUND_GROUPS(at)                                                                          \
    OPTION_GROUP("the terrain", ground_preset_rows, at),                                           \
        OPTION_GROUP(NULL, ground_shape_rows, at), OPTION_GROUP(NULL, ground_terrace_rows, at),    \
        OPTION_GROUP("the noise", noise_option_rows, GROUND_FIELD(at, noise)),                     \
        WARP_GROUPS("the warp", GROUND_FIELD(at, warp)),                                           \
        OPTION_GROUP("the base", ground_base_rows, at),                                            \
        GROUND_PART(base, "base-", BASE_ABOUT, at),                                                \
        OPTION_GROUP("the mask", ground_mask_rows, at), GROUND_PART(mask, "mask-", MASK_ABOUT, at)

/* With the frequency 1, all samples at a distance of 1 would be lattice points. */
extern option_words ground_standard;

/* Gives the noises that follow the first one what they have of it. False, with a line on stderr, if
   options were typed for a noise that is not there. */
bool ground_options_complete(struct ground_options *options);

#endif
