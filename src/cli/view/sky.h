/* SPDX-License-Identifier: MIT
 *
 * The sky, the light that comes from it and from the sun, and the haze before everything.
 */
#ifndef SCARP_CLI_VIEW_SKY_H
#define SCARP_CLI_VIEW_SKY_H

#include "view/scene.h"

/* The light of the sun on a surface that faces it */
struct colour sky_sunlight(struct vector sun);

/* What is seen of the clear sky in a direction, which may lead below the horizon */
struct colour sky_clear(const struct scene *scene, struct vector ray);

/* What is seen of it with its clouds. `cloud` is how dense they are there, and `lit` how much of
   the sun's light they pass on. */
struct colour sky_cloudy(const struct scene *scene, struct vector ray, float cloud, float lit);

/* The light of the sky on a surface with this normal, which sees the sky whole */
struct colour sky_light(const struct scene *scene, struct vector normal);

/* What is seen of a colour through the haze, at a distance along a ray */
struct colour sky_haze(const struct scene *scene, struct vector ray, float distance,
                       struct colour behind);

#endif
