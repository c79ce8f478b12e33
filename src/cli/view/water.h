/* SPDX-License-Identifier: MIT
 *
 * The sea.
 */
#ifndef SCARP_CLI_VIEW_WATER_H
#define SCARP_CLI_VIEW_WATER_H

#include "view/scene.h"

struct water {
    float depth, distance;
    float sun;    /* the part of it that is seen */
    float dx, dy; /* slopes of the waves' texture */
};

/* What is seen of the sea along a ray */
struct colour water_lit(const struct scene *scene, struct vector ray, const struct water *water);

#endif
