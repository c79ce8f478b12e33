/* SPDX-License-Identifier: MIT
 *
 * The options that say how a map of a terrain is coloured and lit: the same for every command that
 * makes one.
 */
#ifndef SCARP_CLI_LOOK_OPTIONS_H
#define SCARP_CLI_LOOK_OPTIONS_H

#include "shared/options.h"

struct look_options {
    const char *palette; /* NULL: that of the preset */
    double azimuth, altitude;
    float z_factor;
};

#define LOOK_PALETTE_ROWS 1
#define LOOK_LIGHT_ROWS 3
extern const struct option look_palette_rows[LOOK_PALETTE_ROWS];
extern const struct option look_light_rows[LOOK_LIGHT_ROWS];

/* The options of palette and relief, for a table; the struct is at an offset in the values. */
#define LOOK_GROUPS(name, at)                                                                      \
    OPTION_GROUP(name, look_palette_rows, at), OPTION_GROUP(NULL, look_light_rows, at)

#endif
