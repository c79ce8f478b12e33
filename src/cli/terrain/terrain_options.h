/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp terrain`, parsed.
 */
#ifndef SCARP_CLI_TERRAIN_OPTIONS_H
#define SCARP_CLI_TERRAIN_OPTIONS_H

#include "ground/ground_options.h"
#include "look/look_options.h"
#include "shared/options.h"
#include "shared/running_options.h"

struct terrain_options {
    struct ground_options ground;
    struct option_size size, tile; /* no tile: 0 x 0 */
    struct option_range tiles;     /* all: end 0 */
    struct option_share share;     /* all: count 0 */
    struct option_point origin;
    struct look_options look;
    double step;
    struct running_options running;
    size_t compare, overlap;
    int tileable, normal_down, resume;
    const char *heights, *normals, *hillshade, *relief, *gradient, *output;
};

extern const struct option_table terrain_table;

#endif
