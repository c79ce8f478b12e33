/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp terrain`, parsed.
 */
#ifndef SCARP_CLI_TERRAIN_OPTIONS_H
#define SCARP_CLI_TERRAIN_OPTIONS_H

#include "shared/noise.h"
#include "shared/options.h"

struct terrain_options {
    struct noise_options noise;
    struct warp_options warp;
    struct option_size size, tile, period; /* no tile, no period: 0 x 0 */
    struct option_range tiles;             /* all: end 0 */
    struct option_share share;             /* all: count 0 */
    struct option_point origin;
    double step, azimuth, altitude;
    float height, sea_level, plateau, z_factor; /* no sea: -infinity; no plateau: infinity */
    size_t compare, overlap, threads;           /* all threads: 0 */
    int tileable, preset, normal_down, resume, isa, quiet;
    const char *heights, *normals, *hillshade, *gradient, *output;
};

extern const struct option_table terrain_table;

#endif
