/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp view`, parsed.
 */
#ifndef SCARP_CLI_VIEW_OPTIONS_H
#define SCARP_CLI_VIEW_OPTIONS_H

#include "ground/ground_options.h"
#include "shared/options.h"
#include "shared/running_options.h"

struct view_camera {
    double x, y, height;
};

struct view_direction {
    double azimuth, elevation;
};

/* What is not given is infinite. */
struct view_options {
    struct ground_options ground;
    struct option_size size;
    struct option_point origin;
    struct view_camera camera;
    struct view_direction look, sun;
    double fov;
    float haze;
    struct running_options running;
    size_t samples;
    const char *output, *palette; /* that of the preset: NULL */
};

#define VIEW_OPTIONS_UNSET                                                                         \
    {                                                                                              \
        .ground = GROUND_OPTIONS_UNSET, .camera = {.x = INFINITY}, .look = {.azimuth = INFINITY},  \
        .haze = INFINITY,                                                                          \
    }

extern const struct option_table view_table;

#endif
