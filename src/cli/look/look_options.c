/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say how a map is coloured and lit.
 */
#include "look/look_options.h"

#include "look/palette.h"

#define FIELD(name) offsetof(struct look_options, name)

const struct option look_palette_rows[LOOK_PALETTE_ROWS] = {
    {OPTION_TEXT("--palette", palette, "NAME", PALETTE_NAMES ", or a file",
                 "colours of the relief: alpine, temperate, desert, arctic or grey; or a FILE of "
                 "GDAL's or GMT's form: see below"),
     .otherwise = "that of the preset", .of_run = 1},
};

const struct option look_light_rows[LOOK_LIGHT_ROWS] = {
    {OPTION_DOUBLE("--azimuth", azimuth, "315", 0, 360,
                   "where the light comes from, in degrees clockwise from north")},
    {OPTION_DOUBLE("--altitude", altitude, "45", 0, 90,
                   "how high the light is above the horizon, in degrees")},
    {OPTION_FLOAT("--z-factor", z_factor, "1", 0, 0x1p24,
                  "factor of heights, for hillshade and relief only")},
};
