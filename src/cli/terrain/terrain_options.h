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

#define LEVELS_MOST 20 /* 2^20 samples are more than a raster has across */

struct terrain_options {
    struct ground_options ground;
    struct option_size size, tile; /* no tile: 0 x 0 */
    struct option_range tiles;     /* all: end 0 */
    struct option_share share;     /* all: count 0 */
    struct option_point origin;
    struct look_options look;
    double step;
    struct running_options running;
    size_t compare, overlap, levels;
    unsigned crs; /* none: 0 */
    int tileable, band_limit, normal_down, resume, verify;
    struct option_list out; /* NAME=FILE */
    const char *heights, *normals, *hillshade, *relief, *gradient, *slope, *curvature;
    const char *masks, *output;
};

extern const struct option_table terrain_table;

#endif
