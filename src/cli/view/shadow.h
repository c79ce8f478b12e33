/* SPDX-License-Identifier: MIT
 *
 * Soft shadows: how much of the sun is seen from points on the ground.
 */
#ifndef SCARP_CLI_VIEW_SHADOW_H
#define SCARP_CLI_VIEW_SHADOW_H

#include "view/scene.h"

/* Points at a time */
#define SHADOW_MOST 4096

/* What a thread needs for shadows, and how often it called the library */
struct shadow {
    double x[SHADOW_MOST], y[SHADOW_MOST];
    float value[SHADOW_MOST];
    uint32_t point[SHADOW_MOST]; /* those whose way to the sun is not over */
    uint64_t calls, points;
};

/* Points on the ground of a band: their places, and their heights, which may be a little above it.
   Makes seen[i] the part of the sun that is seen from point i; what is 0 already stays so, and
   costs nothing. */
struct shadow_points {
    size_t count;
    const double *x, *y;
    const float *height;
    float *seen;
};
void shadow_points(struct shadow *shadow, const struct scene *scene, size_t band,
                   const struct shadow_points *points);

#endif
