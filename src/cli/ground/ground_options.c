/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say what the terrain is.
 */
#include "ground/ground_options.h"

#include <stddef.h>
#include <string.h>

#include "presets/presets.h"

#define FIELD(name) offsetof(struct ground_options, name)

const struct option ground_recipe_rows[GROUND_RECIPE_ROWS] = {
    {.name = "--preset",
     .argument = "NAME",
     .standard = "none",
     .allowed = PRESET_NAMES,
     .help = "a recipe of the program, told below:\n" PRESET_NAMES_HELP,
     .parse = option_choice,
     .offset = FIELD(preset),
     .choices = preset_names,
     .of_run = 1},
    {.name = "--recipe",
     .argument = "FILE",
     .allowed = "the name of a file with a recipe",
     .help = "a recipe: a composition of noises whose first output is the\nheight; - is standard "
             "input; see scarp help recipe",
     .parse = option_text,
     .offset = FIELD(recipe),
     .of_run = 1},
    {.name = "--set",
     .argument = "NAME=VALUE",
     .allowed = "a parameter of the recipe and its number: NAME=VALUE, at most 64 times",
     .help = "set a parameter of the recipe; once for each of them",
     .parse = option_list,
     .offset = FIELD(set),
     .of_run = 1},
    {.name = "--scale",
     .argument = "F",
     .standard = "1",
     .allowed = "a number from 2^-20 to 2^20",
     .help = "makes the terrain so many times larger, its places and its\nheights, from 2^-20 to "
             "2^20",
     .parse = option_double,
     .offset = FIELD(scale),
     .lowest = 0x1p-20,
     .highest = 0x1p20},
    {.name = "--print-recipe",
     .help = "print the recipe in place of all else",
     .offset = FIELD(print_recipe),
     .of_run = 1},
};

const struct option ground_period_rows[GROUND_PERIOD_ROWS] = {
    {.name = "--period",
     .argument = "WxH",
     .allowed = "WIDTHxHEIGHT with both from 1 to 1000000",
     .help = "repeat after so many samples (with scarp view, units), both from 1,\nwithout a seam; "
             "the frequency of one noise becomes the nearest that\nhas whole cells there [it never "
             "does]",
     .parse = option_size,
     .offset = FIELD(period),
     .lowest = 1,
     .highest = 1e6},
};

const struct option ground_height_rows[GROUND_HEIGHT_ROWS] = {
    {.name = "--height",
     .argument = "F",
     .standard = "120",
     .allowed = "a number from 0 to 2^24",
     .help = "height of noise value 1, in the unit of x and y, from 0 to 2^24",
     .parse = option_float,
     .offset = FIELD(height),
     .lowest = 0,
     .highest = 0x1p24},
    {.name = "--sea-level",
     .argument = "F",
     .allowed = "a number from -2^24 to 2^24",
     .help = "noise values below F become F, flat as water; taken into the\ninterval of the noise, "
             "from -2^24 to 2^24 [no sea]",
     .parse = option_float,
     .offset = FIELD(sea_level),
     .lowest = -0x1p24,
     .highest = 0x1p24},
    {.name = "--plateau",
     .argument = "F",
     .allowed = "a number from -2^24 to 2^24",
     .help = "noise values above F become F, flat as a table; no lower than\nthe sea, from -2^24 "
             "to 2^24 [no plateau]",
     .parse = option_float,
     .offset = FIELD(plateau),
     .lowest = -0x1p24,
     .highest = 0x1p24},
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
        if ((bits >> i & 1) != 0 && strcmp(rows[i].name, "--seed") != 0) {
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
