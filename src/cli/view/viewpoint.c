/* SPDX-License-Identifier: MIT
 *
 * Tries places around the view, in several directions and heights, and counts what each would see:
 * rays fan out over the ground, and each keeps the highest tangent so far. What rises above that is
 * seen.
 */
#include "view/viewpoint.h"

#include <math.h>

#include "shared/interrupt.h"
#include "shared/sine.h"

#define RAYS 15  /* of a fan */
#define LOOKS 40 /* along each ray */
#define DIRECTIONS 24
#define GROWTH 1.17f /* from one look to the next */

/* In sides of the view */
#define NEAREST 0.006f /* the first look; the last one is at 2.7 */
#define MIDDLE 0.14f   /* where the middle distance begins */
#define BEYOND 1.5f    /* and where it ends */

/* A camera that is tried */
struct trial {
    double x, y;
    float ground; /* the highest one close to the camera */
    float height;
    double azimuth;
    float score;
    float horizon; /* the mean tangent of what is behind everything */
};

/* Heights of the ground on a fan */
struct fan {
    float height[RAYS][LOOKS];
    float light[RAYS][LOOKS]; /* from 0, in the shadow */
    float distance[LOOKS];
};

static double turned(double azimuth, double by)
{
    const double sum = azimuth + by;
    return sum < 0.0 ? sum + 360.0 : sum > 360.0 ? sum - 360.0 : sum;
}

/* Heights, slopes and places along a ray of a fan */
struct profile {
    double x[LOOKS], y[LOOKS];
    float *height;
    float dx[LOOKS], dy[LOOKS];
};

/* The light on these places: of shadows, only the long ones */
static void light_profile(const struct scene *scene, const struct profile *profile, float *light)
{
    for (int look = 0; look < LOOKS; look++) {
        const struct vector normal = {-profile->dx[look], -profile->dy[look], 1.0f};
        light[look] = clamp(dot(unit(normal), scene->sun), 0.0f, 1.0f);
    }
    for (float distance = 0.012f * scene->side; distance < 0.5f * scene->side; distance *= 2.0f) {
        const struct vector way = scaled(scene->sun, distance);
        double x[LOOKS], y[LOOKS];
        float value[LOOKS];
        for (int look = 0; look < LOOKS; look++) {
            x[look] = profile->x[look] + (double)way.x;
            y[look] = profile->y[look] + (double)way.y;
        }
        interrupt_unless(
            ground_points(&scene->smooth[0], LOOKS, x, y, &(struct scarp_samples){.value = value}));
        for (int look = 0; look < LOOKS; look++) {
            if (value[look] > profile->height[look] + way.z) {
                light[look] = 0.0f;
            }
        }
    }
}

static void sample_fan(const struct scene *scene, const struct trial *trial, double fov,
                       struct fan *fan)
{
    float distance = NEAREST * scene->side;
    for (int look = 0; look < LOOKS; look++, distance *= GROWTH) {
        fan->distance[look] = distance;
    }
    for (int ray = 0; ray < RAYS && !interrupted(); ray++) {
        struct profile profile = {.height = fan->height[ray]};
        const struct vector way = direction_of(
            turned(trial->azimuth, fov * 0.96 * ((double)ray / (RAYS - 1) - 0.5)), 0.0);
        for (int look = 0; look < LOOKS; look++) {
            profile.x[look] = trial->x + (double)(way.x * fan->distance[look]);
            profile.y[look] = trial->y + (double)(way.y * fan->distance[look]);
        }
        const struct scarp_samples out = {
            .value = profile.height, .dx = profile.dx, .dy = profile.dy};
        interrupt_unless(ground_points(&scene->ground, LOOKS, profile.x, profile.y, &out));
        light_profile(scene, &profile, fan->light[ray]);
    }
}

/* The highest ground within some steps of the camera */
static float ground_around(const struct scene *scene, double x, double y)
{
    double px[25], py[25];
    float value[25], highest = -INFINITY;
    for (int i = 0; i < 25; i++) {
        px[i] = x + 4.0 * (i % 5 - 2);
        py[i] = y + 4.0 * (i / 5 - 2);
    }
    interrupt_unless(
        ground_points(&scene->ground, 25, px, py, &(struct scarp_samples){.value = value}));
    for (int i = 0; i < 25; i++) {
        const float height = value[i];
        highest = height > highest ? height : highest;
    }
    return highest;
}

/* What the camera sees: ground in the middle distance, in the light, that rises and falls; not
   much of what is near; a sun that is not behind it. */
static void judge(const struct scene *scene, const struct fan *fan, struct trial *trial)
{
    const float range = scene->survey.high - scene->survey.low;
    float seen = 0.0f, lit = 0.0f, close = 0.0f, horizons = 0.0f, squares = 0.0f, risen = 0.0f;
    float walls = 0.0f; /* what hides much of the sky */
    for (int ray = 0; ray < RAYS; ray++) {
        float horizon = -0.25f, lowest = 1e9f; /* the first one is about where the picture ends */
        for (int look = 0; look < LOOKS; look++) {
            const float distance = fan->distance[look], height = fan->height[ray][look];
            const float tangent = (height - trial->height) / distance;
            if (tangent <= horizon) {
                continue;
            }
            if (distance < MIDDLE * scene->side) {
                close += tangent - horizon;
            } else if (distance < BEYOND * scene->side) {
                seen += tangent - horizon;
                lit += (tangent - horizon) * ramp(0.05f, 0.3f, fan->light[ray][look]);
                lowest = height < lowest ? height : lowest;
                risen = height - lowest > risen ? height - lowest : risen;
            }
            horizon = tangent;
        }
        horizons += horizon;
        walls += clamp(horizon - 0.2f, 0.0f, 1.0f);
        squares += horizon * horizon;
    }
    const float mean = horizons / RAYS;
    const float spread = sqrtf(clamp(squares / RAYS - mean * mean, 0.0f, 1.0f));
    const struct vector look = direction_of(trial->azimuth, 0.0);
    const float across = sqrtf(1.0f - scene->sun.z * scene->sun.z) + 1e-6f;
    const float towards = (look.x * scene->sun.x + look.y * scene->sun.y) / across;
    trial->horizon = mean;
    trial->score = seen / (seen + close + 0.05f * RAYS) +
                   1.3f * lit / (seen + close + 0.05f * RAYS) +
                   0.5f * clamp(risen / range, 0.0f, 1.3f) + 8.0f * clamp(spread, 0.0f, 0.06f) -
                   1.3f * (towards - 0.1f) * (towards - 0.1f) -
                   0.4f * (trial->height - trial->ground) / range -
                   3.0f * clamp(mean - 0.12f, 0.0f, 1.0f) - 12.0f * walls / RAYS;
}

/* An angle in degrees from its tangent, within 0.1 of it up to 35 degrees */
static double degrees_of(float tangent)
{
    const double t = (double)tangent, s = t * t;
    return 57.29577951 * t * (1.0 - s * (1.0 / 3.0 - s * (0.2 - s * (1.0 / 7.0))));
}

static double rounded(double number, double parts)
{
    return floor(number * parts + 0.5) / parts;
}

static void try_heights(const struct scene *scene, const struct view_options *options,
                        struct trial *trial, struct trial *best)
{
    static const float over[] = {0.12f, 0.22f, 0.36f, 0.55f};
    const bool has_place = options->camera.x != INFINITY;
    const float range = scene->survey.high - scene->survey.low;
    struct fan fan;
    sample_fan(scene, trial, options->fov, &fan);
    for (int i = 0; i < (has_place ? 1 : 4) && !interrupted(); i++) {
        trial->height =
            has_place ? (float)options->camera.height : trial->ground + over[i] * range + 2.0f;
        judge(scene, &fan, trial);
        if (trial->score > best->score) {
            *best = *trial;
        }
    }
}

void viewpoint_choose(struct view_options *options, const struct scene *scene)
{
    static const double back[] = {0.35, 0.5, 0.65};
    const bool has_place = options->camera.x != INFINITY,
               has_look = options->look.azimuth != INFINITY;
    const double side = (double)scene->side;
    struct trial best = {.score = -INFINITY};
    for (int i = 0; i < (has_look ? 1 : DIRECTIONS) && !interrupted(); i++) {
        const double azimuth = has_look ? options->look.azimuth : 360.0 / DIRECTIONS * i;
        const struct vector look = direction_of(azimuth, 0.0);
        for (int j = 0; j < (has_place ? 1 : 3) && !interrupted(); j++) {
            struct trial trial = {.azimuth = azimuth};
            trial.x =
                has_place
                    ? options->camera.x
                    : rounded(options->origin.x + side * (0.5 - back[j] * (double)look.x), 1.0);
            trial.y =
                has_place
                    ? options->camera.y
                    : rounded(options->origin.y + side * (0.5 - back[j] * (double)look.y), 1.0);
            trial.ground = ground_around(scene, trial.x, trial.y);
            try_heights(scene, options, &trial, &best);
        }
    }
    if (!has_place) {
        options->camera =
            (struct view_camera){best.x, best.y, rounded((double)best.height, 1.0) + 1.0};
    }
    if (!has_look) {
        const double half = sine(options->fov * 0.5) / sine(options->fov * 0.5 + 90.0) *
                            (double)options->size.height / (double)options->size.width;
        const float tangent = clamp(best.horizon - 0.3f * (float)half, -0.6f, 0.6f);
        options->look = (struct view_direction){best.azimuth, rounded(degrees_of(tangent), 10.0)};
    }
}
