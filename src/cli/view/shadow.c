/* SPDX-License-Identifier: MIT
 *
 * All points of a batch look towards the sun at the same distances, each some longer than the one
 * before. What is nearest to the line of sight there, seen from the point, decides how much of the
 * sun is hidden. Detail that is small compared with the width of the half-shadow is left out, so
 * that the ground of a farther band serves.
 */
#include "view/shadow.h"

#include "shared/interrupt.h"

#define RADIUS 0.011f /* of the sun, as its tangent */
#define LONGER 1.26f  /* from one distance to the next */
#define DETAIL 0.03f  /* cells that count, as a part of the distance from the point */

/* Looks at one distance, and keeps the points that are not dark yet. Returns how many. */
static size_t look(struct shadow *shadow, const struct scene *scene, const struct ground *ground,
                   const struct shadow_points *points, size_t count, float distance)
{
    const struct vector way = scaled(scene->sun, distance);
    for (size_t i = 0; i < count; i++) {
        shadow->x[i] = points->x[shadow->point[i]] + (double)way.x;
        shadow->y[i] = points->y[shadow->point[i]] + (double)way.y;
    }
    interrupt_unless(ground_points(ground, count, shadow->x, shadow->y,
                                   &(struct scarp_samples){.value = shadow->value}));
    shadow->calls++;
    shadow->points += count;
    size_t left = 0;
    for (size_t i = 0; i < count; i++) {
        const uint32_t point = shadow->point[i];
        const float height = points->height[point] + way.z;
        const float above = height - shadow->value[i];
        const float seen = ramp(-RADIUS * distance, RADIUS * distance, above);
        points->seen[point] = seen < points->seen[point] ? seen : points->seen[point];
        if (seen > 0.0f && height < scene->top) {
            shadow->point[left++] = point;
        }
    }
    return left;
}

void shadow_points(struct shadow *shadow, const struct scene *scene, size_t band,
                   const struct shadow_points *points)
{
    size_t count = 0;
    for (size_t i = 0; i < points->count; i++) {
        if (points->seen[i] > 0.0f) {
            shadow->point[count++] = (uint32_t)i;
        }
    }
    float distance = scene->band[band].finest;
    for (; count > 0 && distance < scene->farthest; distance *= LONGER) {
        while (band < BANDS && scene->band[band + 1].finest < DETAIL * distance) {
            band++;
        }
        count = look(shadow, scene, &scene->band[band].ground, points, count, distance);
    }
}
