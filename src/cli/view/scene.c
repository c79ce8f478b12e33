/* SPDX-License-Identifier: MIT
 *
 * Measures the ground of the view, and makes the bands.
 */
#include "view/scene.h"

#include <stdint.h>
#include <stdlib.h>

#include "shared/interrupt.h"

#define FAR 20.0f        /* sides of the view */
#define CELL_PIXELS 1.5f /* cells of octaves are not smaller than so many pixels */

/* The survey: samples along each side of the view */
#define SIDE 40
#define PLACES (SIDE * SIDE)

/* The slopes: rays across and down the picture, and places along each of them in a band */
#define RAYS_ACROSS 64
#define RAYS_DOWN 32
#define PLACES_ALONG 8
#define SLOPE_MARGIN 1.25f

/* Few slopes are far steeper than all others, as those near cliffs: steps are no shorter for these,
   which saves most of the steps. Without a slope of at least GENTLEST, steps would pass over
   cliffs of ground that jumps. */
#define GENTLEST 3.0f
#define COUNTED 64.0f /* slopes that are counted per 1 */
#define COUNTS 1024   /* up to 16 */
#define RARE 82       /* of the 16384 slopes of a band, so many may be steeper */

static int compare(const void *a, const void *b)
{
    const float first = *(const float *)a, second = *(const float *)b;
    return first < second ? -1 : first > second ? 1 : 0;
}

/* The number that a part of the numbers, which become sorted, are below */
static float quantile(float *numbers, float share)
{
    qsort(numbers, PLACES, sizeof *numbers, compare);
    return numbers[(size_t)(share * (float)(PLACES - 1))];
}

static float mean(const float *numbers)
{
    float sum = 0.0f;
    for (size_t i = 0; i < PLACES; i++) {
        sum += numbers[i];
    }
    return sum / (float)PLACES;
}

static void make_survey(struct scene *scene, double x, double y)
{
    float value[PLACES], dx[PLACES], dy[PLACES];
    const struct scarp_samples out = {.value = value, .dx = dx, .dy = dy};
    struct survey *const survey = &scene->survey;
    struct spread spread;
    ground_spread(&scene->ground, &spread);
    survey->low = spread.low;
    survey->high = spread.high;
    if (!(survey->high - survey->low > 1.0f)) {
        survey->high = survey->low + 1.0f;
    }
    scene->side = clamp(HEIGHTS * (survey->high - survey->low), LEAST_SIDE, 16.0f * LEAST_SIDE);
    const double step = (double)scene->side / SIDE;
    const struct scarp_grid grid = {
        .origin = {x, y}, .step = {step, step}, .count = {SIDE, SIDE, 1}};
    interrupt_unless(ground_grid(&scene->ground, &grid, &out));
    const float height = mean(value);
    for (int i = 0; i < 2; i++) {
        float smooth[PLACES];
        interrupt_unless(
            ground_grid(&scene->smooth[i], &grid, &(struct scarp_samples){.value = smooth}));
        survey->smoothed[i] = mean(smooth) - height;
    }
    for (size_t i = 0; i < PLACES; i++) {
        dx[i] = sqrtf(dx[i] * dx[i] + dy[i] * dy[i]);
    }
    survey->steep = quantile(dx, 0.8f);
}

void scene_set_ground(struct scene *scene, const struct ground *ground, double x, double y)
{
    ground_limit(ground, 0.0, &scene->ground);
    for (int i = 0; i < 2; i++) {
        ground_limit(ground, SMOOTH_CELLS[i], &scene->smooth[i]);
    }
    ground_limit(ground, 0.0, &scene->bed);
    scene->bed.floor = scene->bed.lowest;
    scene->top = ground->highest;
    scene->bottom = ground->floor;
    scene->has_sea = ground_has_sea(ground);
    scene->sea = scene->bottom;
    make_survey(scene, x, y);
}

static void count_slope(uint32_t counts[COUNTS], float slope)
{
    const float place = COUNTED * slope;
    counts[place < (float)(COUNTS - 1) ? (size_t)place : COUNTS - 1]++;
}

/* The slope that no more than RARE of them exceed */
static float usual_slope(const uint32_t counts[COUNTS])
{
    size_t place = COUNTS;
    for (uint32_t steeper = 0; place > 1 && steeper + counts[place - 1] <= RARE; place--) {
        steeper += counts[place - 1];
    }
    return (float)place / COUNTED;
}

/* The slope that few of the band's ground exceed where rays of the picture pass over it, with a
   margin for what lies between the places looked at */
static float measure_slope(const struct scene *scene, const struct band *band)
{
    double x[RAYS_ACROSS * PLACES_ALONG], y[RAYS_ACROSS * PLACES_ALONG];
    float value[RAYS_ACROSS * PLACES_ALONG], dx[RAYS_ACROSS * PLACES_ALONG],
        dy[RAYS_ACROSS * PLACES_ALONG];
    const struct camera *const camera = &scene->camera;
    uint32_t counts[COUNTS] = {0};
    for (size_t row = 0; row < RAYS_DOWN && !interrupted(); row++) {
        for (size_t i = 0; i < RAYS_ACROSS * PLACES_ALONG; i++) {
            const float column = (float)(i / PLACES_ALONG) + 0.5f;
            const float along = ((float)(i % PLACES_ALONG) + 0.5f) / PLACES_ALONG;
            const struct vector ray =
                camera_ray(camera, column / RAYS_ACROSS * (float)camera->width,
                           ((float)row + 0.5f) / RAYS_DOWN * (float)camera->height);
            /* Rows differ, so that rays of one column do not look at the same places. */
            const float distance =
                mix(band->begin, band->end, along + (float)row / (RAYS_DOWN * PLACES_ALONG));
            x[i] = camera->x + (double)(ray.x * distance);
            y[i] = camera->y + (double)(ray.y * distance);
        }
        interrupt_unless(
            ground_points(&band->ground, RAYS_ACROSS * PLACES_ALONG, x, y,
                          &(struct scarp_samples){.value = value, .dx = dx, .dy = dy}));
        for (size_t i = 0; i < RAYS_ACROSS * PLACES_ALONG; i++) {
            count_slope(counts, sqrtf(dx[i] * dx[i] + dy[i] * dy[i]));
        }
    }
    const float usual = SLOPE_MARGIN * usual_slope(counts);
    return band->jumps && usual < GENTLEST ? GENTLEST : usual;
}

/* Distances double from band to band. */
void scene_set_bands(struct scene *scene)
{
    const float above = scene->camera.z - scene->bottom;
    const float pixel = CELL_PIXELS * scene->camera.pixel;
    scene->farthest = FAR * (above > scene->side ? above : scene->side);
    float end = scene->farthest;
    for (size_t i = BANDS; i-- > 0; end *= 0.5f) {
        struct band *const band = &scene->band[i];
        band->slope = 0.0f;
        band->begin = i > 0 ? 0.5f * end : 0.0f;
        band->end = end;
        band->finest = 0.5f * pixel * end;
        ground_limit(&scene->ground, band->finest, &band->ground);
        band->jumps = band->ground.jumps;
    }
    struct band *const last = &scene->band[BANDS];
    last->finest = pixel * scene->farthest;
    ground_limit(&scene->ground, last->finest, &last->ground);
    /* What a band does not show may begin just behind it. */
    float slope[BANDS + 2] = {0.0f};
    for (size_t i = 0; i < BANDS; i++) {
        slope[i + 1] = measure_slope(scene, &scene->band[i]);
    }
    for (size_t i = 0; i < BANDS; i++) {
        for (size_t j = 0; j < 3; j++) {
            float *const steepest = &scene->band[i].slope;
            *steepest = *steepest > slope[i + j] ? *steepest : slope[i + j];
        }
    }
}
