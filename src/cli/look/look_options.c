/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say how a map is coloured and lit.
 */
#include "look/look_options.h"

#include "look/palette.h"

#define FIELD(name) offsetof(struct look_options, name)

const struct option look_palette_rows[LOOK_PALETTE_ROWS] = {
    {.name = "--palette",
     .argument = "NAME",
     .allowed = PALETTE_NAMES ", or a file",
     .help = "colours of the relief: alpine, temperate, desert, arctic or grey;\nor a FILE of "
             "GDAL's or "
             "GMT's form; told below [that of the preset]",
     .parse = option_text,
     .offset = FIELD(palette),
     .of_run = 1},
};

const struct option look_light_rows[LOOK_LIGHT_ROWS] = {
    {.name = "--azimuth",
     .argument = "F",
     .standard = "315",
     .allowed = "a number from 0 to 360",
     .help = "where the light comes from, in degrees\nclockwise from north, from 0 "
             "to 360",
     .parse = option_double,
     .offset = FIELD(azimuth),
     .lowest = 0,
     .highest = 360},
    {.name = "--altitude",
     .argument = "F",
     .standard = "45",
     .allowed = "a number from 0 to 90",
     .help = "its height above the horizon, in degrees, from 0 to 90",
     .parse = option_double,
     .offset = FIELD(altitude),
     .lowest = 0,
     .highest = 90},
    {.name = "--z-factor",
     .argument = "F",
     .standard = "1",
     .allowed = "a number from 0 to 2^24",
     .help = "exaggerates heights, for hillshade and relief only, from 0 to 2^24",
     .parse = option_float,
     .offset = FIELD(z_factor),
     .lowest = 0,
     .highest = 0x1p24},
};
