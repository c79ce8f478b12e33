/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say what the terrain is.
 */
#include "ground/ground_options.h"

#include <stddef.h>

#include "ground/presets.h"

#define FIELD(name) offsetof(struct ground_options, name)

const struct option ground_preset_rows[GROUND_PRESET_ROWS] = {
    {.name = "--preset",
     .argument = "NAME",
     .standard = "none",
     .allowed = PRESET_NAMES,
     .help = "other defaults for a kind of terrain, told below:\n" PRESETS_FIRST "\n" PRESETS_LAST,
     .parse = option_choice,
     .offset = FIELD(preset),
     .choices = preset_names,
     .of_run = 1},
};

const struct option ground_shape_rows[GROUND_SHAPE_ROWS] = {
    {.name = "--height",
     .argument = "F",
     .standard = "120",
     .allowed = "a number from 0 to 2^24",
     .help = "vertical size of noise value 1, in the unit of x and y,\nfrom 0 to 2^24",
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
    {.name = "--crater",
     .argument = "F",
     .allowed = "a number from -2^24 to 2^24",
     .help = "what the noise has above F is turned down, a crater in each\nsummit, before mask and "
             "base, from -2^24 to 2^24 [no craters]",
     .parse = option_float,
     .offset = FIELD(crater),
     .lowest = -0x1p24,
     .highest = 0x1p24},
    {.name = "--stretch",
     .argument = "F",
     .standard = "1",
     .allowed = "a number from 1/16 to 16",
     .help = "how many times longer the noise is across the wind than along it,\nfrom 1/16 to 16",
     .parse = option_double,
     .offset = FIELD(stretch),
     .lowest = 0.0625,
     .highest = 16},
    {.name = "--wind",
     .argument = "F",
     .standard = "270",
     .allowed = "a number from 0 to 360",
     .help = "where the wind comes from, in degrees clockwise from north, from\n0 to 360; a "
             "stretched terrain is fastest with 270",
     .parse = option_double,
     .offset = FIELD(wind),
     .lowest = 0,
     .highest = 360},
};

const struct option ground_terrace_rows[GROUND_TERRACE_ROWS] = {
    {.name = "--terraces",
     .argument = "F",
     .standard = "0",
     .allowed = "a number from 0 to 2^16",
     .help = "terraces per 1 of value, from 0, which is none, to 2^16",
     .parse = option_float,
     .offset = FIELD(terraces),
     .lowest = 0,
     .highest = 0x1p16},
    {.name = "--terrace-riser",
     .argument = "F",
     .standard = "0.5",
     .allowed = "a number from 2^-20 to 1",
     .help = "the part of a terrace that rises, from 2^-20 to 1",
     .parse = option_float,
     .offset = FIELD(terrace_riser),
     .lowest = 0x1p-20,
     .highest = 1},
    {.name = "--terrace-strength",
     .argument = "F",
     .standard = "0.75",
     .allowed = "a number from 0 to 1",
     .help = "how level the rest of it is, from 0, as without, to 1",
     .parse = option_float,
     .offset = FIELD(terrace_strength),
     .lowest = 0,
     .highest = 1},
};

const struct option ground_base_rows[1] = {
    {.name = "--base-amplitude",
     .argument = "F",
     .standard = "0",
     .allowed = "0 or a number whose magnitude is from 2^-24 to 2^24",
     .help = "how far another noise, which is added, moves values: 0, which is\nno base, or a "
             "magnitude from 2^-24 to 2^24",
     .parse = noise_parse_amplitude,
     .like = option_float,
     .offset = FIELD(base.amplitude),
     .lowest = -0x1p24,
     .highest = 0x1p24},
};

const struct option ground_mask_rows[1] = {
    {.name = "--mask-band",
     .argument = "A,B",
     .standard = "0,0",
     .allowed = "two numbers A,B from -16 to 16",
     .help = "the noise is multiplied by a number that is 0 where another\nnoise, the mask, is at "
             "most A, 1 where it is B or more, and smooth\nbetween; if A is more than B, the other "
             "way round; both from -16\nto 16; equal: no mask",
     .parse = option_point,
     .offset = FIELD(mask.band),
     .lowest = -16,
     .highest = 16},
};

option_words ground_standard = {"--seed", "1",      "--frequency", "0.0025", "--octaves",
                                "9",      "--gain", "0.4",         NULL};

bool ground_options_complete(struct ground_options *options)
{
    const struct noise_part base = {"base-", "a --base-amplitude", &options->base.noise,
                                    &options->base.given, options->base.amplitude != 0.0f};
    const struct noise_part mask = {"mask-", "a --mask-band", &options->mask.noise,
                                    &options->mask.given,
                                    options->mask.band.x != options->mask.band.y};
    return warp_complete(&options->warp, &options->noise) &&
           noise_part_complete(&base, &options->noise) &&
           noise_part_complete(&mask, &options->noise);
}
