/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp sheet` and its help.
 */
#include "sheet/sheet_options.h"

#include <stddef.h>

#include "presets/presets.h"

#define FIELD(name) offsetof(struct sheet_options, name)

static const char *layer_word(int index)
{
    static const char *const words[] = {"relief", "hillshade", NULL};
    return words[index];
}

static const struct option sheet_rows[] = {
    {OPTION_TEXT(
         "--sheet", sheet, "LIST",
         "one or two parameters and their values: NAME=VALUES[,NAME=VALUES]",
         "NAME=VALUES or NAME=VALUES,NAME=VALUES: what panels differ in, the first from left "
         "to right, the second from top to bottom; see below"),
     .standard = "seed=1..9"},
    {OPTION_FILE("--output", output, "the picture: .png .ppm .img .tif .npy"),
     .otherwise = "sheet.png, without zlib sheet.ppm"},
    {OPTION_SIZE("--panel", panel, "256x192", 16, 1024, "pixels of a panel")},
    {OPTION_COUNT("--samples", samples, "4", 1, 8, "a pixel is the mean of N x N samples")},
    {OPTION_CHOICE("--layer", layer, "relief", layer_word,
                   "what panels show, as scarp terrain makes it")},
};

static const struct option place_rows[] = {
    {OPTION_POINT("--origin", origin, "0,0", -0x1p53, 0x1p53, "position of the bottom left pixel")},
    {OPTION_DOUBLE("--step", step, "4", 0x1p-44, 0x1p48,
                   "distance between pixels, in the unit of x and y")},
};

static const struct option_group groups[] = {
    OPTION_GROUP("the sheet", sheet_rows, 0),
    OPTION_GROUP("what panels show", place_rows, 0),
    LOOK_GROUPS(NULL, FIELD(look)),
    GROUND_GROUPS(FIELD(ground)),
    RUNNING_GROUP(FIELD(running)),
};

const struct option_table sheet_table = {
    .command = "sheet",
    .purpose =
        "Draws a sheet of panels: small maps of a terrain that differ in one or two parameters.",
    .notes[0] =
        "NAME       A parameter of the recipe, or any option from --origin to --plateau, without\n"
        "           its dashes: seed, gain, preset, palette, step.\n"
        "VALUES     1..4 are 1, 2, 3 and 4. 0.3..0.6/7 are 7 values, equally far from each other\n"
        "           and rounded to six digits; 0.3..0.6 are 4. fbm|ridged|swiss are these three.\n"
        "           off|on is without and with an option that has no value. There are at most\n"
        "           100 panels.\n"
        "panels     A panel holds the pixels that scarp terrain makes with the same options and\n"
        "           size, if --samples is 1. All panels have the other options in common. With\n"
        "           one parameter, panels go on in the next row.\n"
        "samples    They lie N times as close as pixels, around them. A byte is the root of the\n"
        "           mean of their squares.\n"
        "relief     and palette: see scarp help terrain.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .standard = ground_standard,
    .removed = ground_removed,
};
