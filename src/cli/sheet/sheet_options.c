/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp sheet` and its help.
 */
#include "sheet/sheet_options.h"

#include <stddef.h>

#include "presets/presets.h"

#define FIELD(name) offsetof(struct sheet_options, name)

static const char *const layer_words[] = {"relief", "hillshade", NULL};

static const struct option sheet_rows[] = {
    {.name = "--sheet",
     .argument = "LIST",
     .standard = "seed=1..9",
     .allowed = "one or two parameters and their values: NAME=VALUES[,NAME=VALUES]",
     .help = "NAME=VALUES or NAME=VALUES,NAME=VALUES: what cells differ in, first\nfrom left to "
             "right, then "
             "from top to bottom; told below",
     .parse = option_text,
     .offset = FIELD(sheet)},
    {.name = "--output",
     .argument = "FILE",
     .allowed = "a file name, of which the extension tells the format",
     .help = "the picture: .png .ppm [sheet.png, without zlib sheet.ppm]",
     .parse = option_text,
     .offset = FIELD(output)},
    {.name = "--cell",
     .argument = "WxH",
     .standard = "256x192",
     .allowed = "WIDTHxHEIGHT with both from 16 to 1024",
     .help = "pixels of a cell, both from 16 to 1024",
     .parse = option_size,
     .offset = FIELD(cell),
     .lowest = 16,
     .highest = 1024},
    {.name = "--samples",
     .argument = "N",
     .standard = "4",
     .allowed = "an integer from 1 to 8",
     .help = "samples across each pixel and down, of which it is the mean,\nfrom 1 to 8",
     .parse = option_count,
     .offset = FIELD(samples),
     .lowest = 1,
     .highest = 8},
    {.name = "--layer",
     .argument = "NAME",
     .standard = "relief",
     .allowed = "relief or hillshade",
     .help = "what cells show: relief or hillshade, as of scarp terrain",
     .parse = option_choice,
     .offset = FIELD(layer),
     .choices = layer_words},
};

static const struct option place_rows[] = {
    {.name = "--origin",
     .argument = "X,Y",
     .standard = "0,0",
     .allowed = "two numbers X,Y from -2^53 to 2^53",
     .help = "position of the bottom left pixel, each from -2^53 to 2^53",
     .parse = option_point,
     .offset = FIELD(origin),
     .lowest = -0x1p53,
     .highest = 0x1p53},
    {.name = "--step",
     .argument = "F",
     .standard = "4",
     .allowed = "a number from 2^-44 to 2^48",
     .help = "distance between pixels, in the unit of x and y,\nfrom 2^-44 to 2^48",
     .parse = option_double,
     .offset = FIELD(step),
     .lowest = 0x1p-44,
     .highest = 0x1p48},
};

static const struct option_group groups[] = {
    OPTION_GROUP("the sheet", sheet_rows, 0),
    OPTION_GROUP("what cells show", place_rows, 0),
    LOOK_GROUPS(NULL, FIELD(look)),
    GROUND_GROUPS(FIELD(ground)),
    RUNNING_GROUP(FIELD(running)),
};

const struct option_table sheet_table = {
    .command = "sheet",
    .purpose =
        "Draws many small maps of a terrain side by side, which differ in one or two parameters.",
    .notes =
        "NAME       a parameter of the recipe, or any option from --origin to --plateau, without\n"
        "           its dashes: seed, gain, preset, palette, step.\n"
        "VALUES     1..4 are 1, 2, 3 and 4; 0.3..0.6/7 are 7 values, equally far from each other\n"
        "           and rounded to six digits; 0.3..0.6 are 4. fbm|ridged|swiss are these three;\n"
        "           off|on is without and with an option that has no value. There are at most\n"
        "           100 cells.\n"
        "cells      hold the pixels that scarp terrain makes of the same options and size with\n"
        "           --samples 1. The other options are those of all cells. With one parameter,\n"
        "           cells go on in the next row.\n"
        "samples    lie N times as close as pixels, around them; a byte is the root of the mean\n"
        "           of their squares.\n"
        "relief     and palette: see scarp help terrain.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .standard = ground_standard,
    .removed = ground_removed,
};
