/* SPDX-License-Identifier: MIT
 *
 * Light: the colour that each ray brings to the camera.
 */
#ifndef SCARP_CLI_VIEW_LIGHT_H
#define SCARP_CLI_VIEW_LIGHT_H

#include "view/march.h"
#include "view/shadow.h"
#include "view/textures.h"

#define LIGHT_MOST SHADOW_MOST /* points at a time */

/* What a thread needs for light, and how often it called the library, shadows not counted */
struct light {
    size_t count;
    const uint32_t *ray;                  /* of each point */
    double x[LIGHT_MOST], y[LIGHT_MOST];  /* its place */
    double u[LIGHT_MOST], v[LIGHT_MOST];  /* coordinates of a texture */
    float along[LIGHT_MOST];              /* 0 where its band begins, 1 where it ends */
    float height[LIGHT_MOST];             /* of the ground there */
    float dx[LIGHT_MOST], dy[LIGHT_MOST]; /* its slopes */
    float smooth_dx[LIGHT_MOST], smooth_dy[LIGHT_MOST]; /* those of the hill as a whole */
    float hollow[2][LIGHT_MOST];                        /* how far below the smooth grounds it is */
    float bed[LIGHT_MOST];                              /* the height below the sea */
    float texture[TEXTURE_COUNT][LIGHT_MOST];
    float texture_dx[TEXTURE_COUNT][LIGHT_MOST], texture_dy[TEXTURE_COUNT][LIGHT_MOST];
    float sun[LIGHT_MOST]; /* the part of it that is seen */
    float other[3][LIGHT_MOST];
    uint32_t point[LIGHT_MOST]; /* rays of the sky */
    struct shadow shadow;
    uint64_t calls, points;
};

/* Finds the colours of all rays, those of the sky included. */
void light_rays(struct light *light, const struct scene *scene, const struct rays *rays,
                struct colour *colours);

#endif
