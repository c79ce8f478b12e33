/* SPDX-License-Identifier: MIT
 *
 * The sea shows the sky, the more so the flatter one looks at it (Schlick's approximation of
 * Fresnel's law), its bed where it is shallow, and the sun on its waves.
 */
#include "view/water.h"

#include "view/sky.h"

#define WAVE_HEIGHT 0.55f
#define GLINT 0.004f /* the variance of slopes of waves that are too small to be seen */

struct colour water_lit(const struct scene *scene, struct vector ray, const struct water *water)
{
    const struct vector normal =
        unit((struct vector){-WAVE_HEIGHT * water->dx, -WAVE_HEIGHT * water->dy, 1.0f});
    const float facing = clamp(-dot(ray, normal), 0.0f, 1.0f);
    const float off = 1.0f - facing;
    const float mirror = 0.02f + 0.98f * off * off * off * off * off;
    struct vector away = {ray.x + 2.0f * facing * normal.x, ray.y + 2.0f * facing * normal.y,
                          ray.z + 2.0f * facing * normal.z};
    away.z = away.z < 0.0f ? -away.z : away.z;
    const struct colour reflected = sky_clear(scene, unit(away));

    /* What comes back from below, less with every unit of depth */
    const struct colours *const colours = &scene->colours;
    const float clear = exponential(-0.16f * water->depth);
    const float shore = exponential(-1.1f * water->depth);
    struct colour below = colour_mix(colours->depths, colours->shallows, clear);
    below = colour_mix(below, colours->sand, 0.75f * shore);
    const float daylight = 0.45f + scene->sun.z * water->sun;
    below = colour_product(below, colour_scaled(scene->sunlight, 0.8f * daylight));

    /* The part of the small waves that reflect the sun here */
    const struct vector half =
        unit((struct vector){scene->sun.x - ray.x, scene->sun.y - ray.y, scene->sun.z - ray.z});
    const float along = dot(half, normal);
    const float tangent = along > 0.05f ? (1.0f - along * along) / (along * along) : 400.0f;
    const float spread = 1.0f + tangent / (2.0f * GLINT);
    const float glint = water->sun * mirror * 6.0f / (spread * spread * spread);
    return colour_sum(
        colour_sum(colour_scaled(below, 1.0f - mirror), colour_scaled(reflected, mirror)),
        colour_scaled(scene->sunlight, glint));
}
