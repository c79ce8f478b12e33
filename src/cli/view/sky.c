/* SPDX-License-Identifier: MIT
 *
 * A sky of few terms, made to look like one: blue above, pale at the horizon, bright and warm
 * around the sun. The haze takes blue first and gives back the colour of the sky behind it.
 */
#include "view/sky.h"

#define HAZE_FADES 0.25f /* from this part of the farthest distance on, all becomes haze */

static const struct colour zenith = {0.090f, 0.215f, 0.560f};
static const struct colour horizon = {0.780f, 0.920f, 1.080f};

/* How much of each colour the air leaves: blue goes first, and the more so the lower the sun is. */
struct colour sky_sunlight(struct vector sun)
{
    const float air = 1.0f / (sun.z + 0.04f);
    return (struct colour){3.3f * exponential(-0.055f * air), 3.3f * exponential(-0.105f * air),
                           3.3f * exponential(-0.205f * air)};
}

/* The glow around the sun: wide, narrow, and the sun itself */
static float glow(struct vector ray, struct vector sun)
{
    const float off = 1.0f - dot(ray, sun);
    const float narrow = 1.0f / (1.0f + 900.0f * off);
    return 0.075f / (1.0f + 14.0f * off) + 0.6f * narrow * narrow + (off < 4e-5f ? 25.0f : 0.0f);
}

struct colour sky_clear(const struct scene *scene, struct vector ray)
{
    const float low = 1.0f - clamp(ray.z, 0.0f, 1.0f);
    const float low4 = low * low * low * low;
    const struct colour sun = scene->sunlight;
    /* The pale band above the horizon takes the colour of a low sun. */
    const struct colour band = colour_mix(
        horizon, colour_scaled(colour_product(horizon, sun), 0.42f), 0.45f * (1.0f - scene->sun.z));
    const struct colour sky = colour_mix(zenith, band, low4 * low);
    return colour_sum(sky, colour_scaled(sun, glow(ray, scene->sun)));
}

struct colour sky_cloudy(const struct scene *scene, struct vector ray, float cloud, float lit)
{
    const struct colour clear = sky_clear(scene, ray);
    const struct colour sun = scene->sunlight;
    const struct colour shade = colour_scaled(horizon, 0.80f);
    const struct colour light = colour_sum(shade, colour_scaled(sun, 0.42f * lit));
    return colour_mix(clear, light, cloud);
}

struct colour sky_light(const struct scene *scene, struct vector normal)
{
    static const struct colour from_sky = {0.30f, 0.44f, 0.72f};
    const struct colour from_ground = colour_scaled(scene->sunlight, 0.05f);
    /* The sky is brighter on the side of the sun. */
    const float side = normal.x * scene->sun.x + normal.y * scene->sun.y;
    return colour_mix(from_ground, colour_scaled(from_sky, 1.0f + 0.25f * side),
                      0.5f + 0.5f * normal.z);
}

/* The optical depth of the way: haze thins with height, on the way from the camera
   with the exponential of the mean. */
static float depth(const struct scene *scene, struct vector ray, float distance)
{
    const float thins = 0.45f / (scene->survey.high - scene->survey.low + 40.0f);
    const float start = thins * (scene->camera.z - scene->survey.low);
    const float rise = thins * ray.z * distance;
    const float along =
        rise * rise < 1e-4f ? 1.0f - 0.5f * rise : (1.0f - exponential(-rise)) / rise;
    return distance / scene->haze * exponential(-clamp(start, -1.0f, 20.0f)) * along;
}

struct colour sky_haze(const struct scene *scene, struct vector ray, float distance,
                       struct colour behind)
{
    const float end = ramp(HAZE_FADES, 0.9f, distance / scene->farthest);
    const float thick = scene->haze > 0.0f ? depth(scene, ray, distance) : 0.0f;
    const struct vector level = unit((struct vector){ray.x, ray.y, ray.z > 0.02f ? ray.z : 0.02f});
    const struct colour air = sky_clear(scene, level);
    const struct colour left = {exponential(-0.75f * thick), exponential(-0.95f * thick),
                                exponential(-1.25f * thick)};
    const struct colour seen = {mix(air.r, behind.r, left.r), mix(air.g, behind.g, left.g),
                                mix(air.b, behind.b, left.b)};
    return colour_mix(seen, air, end);
}
