/* SPDX-License-Identifier: MIT
 *
 * The options that say what the terrain is: a recipe, from a preset or a file, or one noise, of
 * which the program writes a recipe. The same for every command that shows a terrain.
 */
#ifndef SCARP_CLI_GROUND_OPTIONS_H
#define SCARP_CLI_GROUND_OPTIONS_H

#include "shared/noise_options.h"
#include "shared/options.h"

struct ground_options {
    struct noise_options noise;
    uint32_t seed_typed, noise_typed, height_typed; /* which of these rows were typed */
    float height, sea_level, plateau;               /* no sea: -infinity; no plateau: infinity */
    double scale;
    struct option_size period; /* in samples; none: 0 x 0 */
    struct option_list set;    /* NAME=VALUE */
    const char *recipe;        /* a file; NULL: none */
    int preset;                /* its number, 0 is none */
    int print_recipe;
};

#define GROUND_OPTIONS_UNSET                                                                       \
    {                                                                                              \
        .noise = NOISE_OPTIONS_UNSET, .sea_level = -INFINITY, .plateau = INFINITY                  \
    }

#define GROUND_RECIPE_ROWS 5
#define GROUND_PERIOD_ROWS 1
#define GROUND_HEIGHT_ROWS 3
extern const struct option ground_recipe_rows[GROUND_RECIPE_ROWS];
extern const struct option ground_period_rows[GROUND_PERIOD_ROWS];
extern const struct option ground_height_rows[GROUND_HEIGHT_ROWS];

#define GROUND_FIELD(at, member) ((at) + offsetof(struct ground_options, member))

/* All groups, for a table; the struct is at an offset in the values. */
#define GROUND_GROUPS(at)                                                                          \
    OPTION_GROUP("the terrain", ground_recipe_rows, at),                                           \
        OPTION_GROUP(NULL, ground_period_rows, at),                                                \
        OPTION_GROUP(NULL, noise_seed_rows, GROUND_FIELD(at, noise)),                              \
        OPTION_GROUP_TYPED("one noise, without --preset and --recipe", noise_option_rows,          \
                           GROUND_FIELD(at, noise), GROUND_FIELD(at, noise_typed)),                \
        OPTION_GROUP_TYPED(NULL, ground_height_rows, at, GROUND_FIELD(at, height_typed))

#define GROUND_NOISE_GROUPS 2 /* the last ones are those of one noise */

/* With the frequency 1, all samples at a distance of 1 would be lattice points. */
extern option_words ground_standard;

/* Options of compositions that recipes say better */
extern const struct option_removed ground_removed[];

/* The option of one noise that was typed; NULL if none was. */
const char *ground_noise_option(const struct ground_options *options);

#endif
