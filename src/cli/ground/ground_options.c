/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say what the terrain is.
 */
#include "ground/ground_options.h"

#include <stddef.h>

#include "presets/presets.h"

#define FIELD(name) offsetof(struct ground_options, name)

const struct option ground_recipe_rows[GROUND_RECIPE_ROWS] = {
    {OPTION_CHOICE("--preset", preset, "none", preset_name,
                   "a recipe of the program, listed below"),
     .of_run = 1},
    {OPTION_TEXT("--recipe", recipe, "FILE", "the name of a file with a recipe",
                 "a recipe: a composition of noises whose first output is the height; - is "
                 "standard input; see scarp help recipe"),
     .of_run = 1},
    {OPTION_READ(option_list, "NAME=VALUE", "--set", set,
                 "a parameter of the recipe and its number: NAME=VALUE, at most 64 times",
                 "set a parameter of the recipe; repeat it for others"),
     .highest = OPTION_LIST_MOST, .of_run = 1},
    {OPTION_DOUBLE("--scale", scale, "1", 0x1p-20, 0x1p20,
                   "make the terrain F times larger, in width and in height")},
    {OPTION_FLAG("--print-recipe", print_recipe, "print the recipe, and do nothing else"),
     .of_run = 1},
};

const struct option ground_period_rows[GROUND_PERIOD_ROWS] = {
    {OPTION_SIZE("--period", period, NULL, 1, 1e6,
                 "repeat without a seam after W by H samples (with scarp view, units); one noise "
                 "takes the nearest frequency that has whole cells there"),
     .otherwise = "it never does"},
};

const struct option ground_height_rows[GROUND_HEIGHT_ROWS] = {
    {OPTION_FLOAT("--height", height, "120", 0, 0x1p24,
                  "height of noise value 1, in the unit of x and y")},
    {OPTION_FLOAT("--sea-level", sea_level, NULL, -0x1p24, 0x1p24,
                  "noise values below F become F, flat as water; an F outside their interval "
                  "becomes its end"),
     .otherwise = "no sea"},
    {OPTION_FLOAT("--plateau", plateau, NULL, -0x1p24, 0x1p24,
                  "noise values above F become F, flat as a table; no lower than the sea"),
     .otherwise = "no plateau"},
};

option_words ground_standard = {"--seed", "1",      "--frequency", "0.0025", "--octaves",
                                "9",      "--gain", "0.4",         NULL};

#define ADVICE(expression) "write " expression " in a recipe; see: scarp help recipe"

const struct option_removed ground_removed[] = {
    {"--base-", ADVICE("a + b")},
    {"--mask-", ADVICE("a * smoothstep(mask, from, to)")},
    {"--warp-", ADVICE("warp(a, noise(amplitude=reach))")},
    {"--terrace", ADVICE("terrace(a, steps, riser=0.5, strength=0.75)")},
    {"--wind", ADVICE("wind(a, from, by)")},
    {"--stretch", ADVICE("wind(a, from, by)")},
    {"--crater", ADVICE("min(a, 2 * rim - a)")},
    {NULL, NULL},
};

static const char *typed(uint32_t bits, const struct option *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if ((bits >> i & 1) != 0) {
            return rows[i].name;
        }
    }
    return NULL;
}

const char *ground_noise_option(const struct ground_options *options)
{
    const char *const name = typed(options->noise_typed, noise_option_rows, NOISE_OPTION_COUNT);
    return name != NULL ? name
                        : typed(options->height_typed, ground_height_rows, GROUND_HEIGHT_ROWS);
}
