/* SPDX-License-Identifier: MIT
 *
 * Marching in batches. Read this to march terrain of your own.
 *
 * A ray p(t) = camera + t d, with d of length 1, is above the ground by c(t) = p_z - height(p_x,
 * p_y). If no slope is steeper than s, then c falls by less than (s |d_xy| - d_z) per unit of t. So
 * the ray may go on by c / (s |d_xy| - d_z) without meeting anything, and without end if that is
 * negative. It takes steps of at least 1 / s of the width of a pixel there: what can rise and fall
 * again within such a step is less than half a pixel high. (Walls steeper than STEEPEST count as
 * that, or steps would be without number.)
 *
 * All rays of a batch take a step together, since the library is fast for many points at a time:
 *
 *     for each band of distance, from the nearest to the farthest
 *         while there are rays in it
 *             sample the ground below all of them: one call
 *             ray by ray: below the ground? it hits; else take a step; is it still in the band?
 *
 * The rays that are left fill the front of their arrays, so that calls have no points in vain. The
 * bands have fewer octaves the farther they are. They come one after the other, so a call has one
 * ground for all its points.
 *
 * A ray crosses the ground between the last point above it and the first one below. These are so
 * close that a straight line between them tells where, within a part of a pixel. What becomes of a
 * ray depends on no other ray.
 *
 * A few places are far steeper than s, and ground that jumps has cliffs, which steps know nothing
 * of. So a ray that is deeper below the ground than half a pixel after a step bisects the step, as
 * one of the batch. It ends where it finds the ground, or at a cliff, just in front of it, where
 * all that is left of the step is shorter than FINEST_STEP.
 *
 * A pixel may need more rays. At the distance t, they are within r t of its first ray, with r
 * small, and their c is at least that of the first ray less (1 + s) r t. As long as that is
 * positive, the first ray takes steps that are safe for all of them; where it ends, the others
 * begin.
 */
#include "view/march.h"

#include <stdlib.h>

#include "shared/interrupt.h"

#define STEEPEST 16.0f       /* 86 degrees */
#define FINEST_STEP 0x1p-20f /* of the distance, so that it is not lost when it is added */
#define LEVEL 0.5f           /* in pixels: steps that fall more are bisected */
#define NEAREST 0.0625f      /* below this distance, pixels are as wide as there */

static void take_list(struct march_list *list, float **numbers, uint32_t **rays, size_t most)
{
    float **const arrays[] = {&list->x,      &list->y,     &list->z,     &list->at,
                              &list->before, &list->above, &list->beyond};
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++) {
        *arrays[i] = *numbers;
        *numbers += most;
    }
    list->ray = *rays;
    *rays += most;
}

bool march_open(struct march *march, size_t most)
{
    *march =
        (struct march){.memory = malloc(most * (2 * sizeof(double) + (3 * 7 + 1) * sizeof(float) +
                                                3 * sizeof(uint32_t)))};
    if (march->memory == NULL) {
        return false;
    }
    march->x = march->memory;
    march->y = march->x + most;
    march->value = (float *)(march->y + most);
    float *numbers = march->value + most;
    uint32_t *rays = (uint32_t *)(numbers + 3 * 7 * most);
    take_list(&march->live, &numbers, &rays, most);
    take_list(&march->waiting, &numbers, &rays, most);
    take_list(&march->hit, &numbers, &rays, most);
    return true;
}

void march_close(struct march *march)
{
    free(march->memory);
}

/* Writes ray number `i` of a list to place `n` of another one, or of the same. */
static void copy(struct march_list *to, size_t n, const struct march_list *from, size_t i)
{
    to->ray[n] = from->ray[i];
    to->x[n] = from->x[i];
    to->y[n] = from->y[i];
    to->z[n] = from->z[i];
    to->at[n] = from->at[i];
    to->before[n] = from->before[i];
    to->above[n] = from->above[i];
    to->beyond[n] = from->beyond[i];
}

/* Takes ray number `i` out of a list, whose last ray takes its place, to another one or to none. */
static void move(struct march_list *from, size_t i, struct march_list *to)
{
    if (to != NULL) {
        copy(to, to->count++, from, i);
    }
    copy(from, i, from, --from->count);
}

/* Has every ray begin where it may first meet the ground: below the highest one. */
static void enter(struct march *march, const struct scene *scene, const struct rays *rays)
{
    struct march_list *const list = &march->waiting;
    const float over = scene->camera.z - scene->top;
    list->count = 0;
    for (size_t i = 0; i < rays->count; i++) {
        const float z = rays->z[i];
        rays->distance[i] = INFINITY;
        rays->cliff[i] = false;
        if (over >= 0.0f && z >= rays->spread) {
            continue;
        }
        const size_t n = list->count++;
        list->ray[n] = (uint32_t)i;
        list->x[n] = rays->x[i];
        list->y[n] = rays->y[i];
        list->z[n] = z;
        const float enters = over > 0.0f ? over / (rays->spread - z) : 0.0f;
        rays->begin[i] = rays->begin[i] > enters ? rays->begin[i] : enters;
        list->at[n] = list->before[n] = rays->begin[i];
        list->above[n] = list->beyond[n] = 0.0f;
    }
}

/* Samples the ground below all rays of a list. */
static void sample(struct march *march, const struct scene *scene, const struct band *band,
                   const struct march_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        march->x[i] = scene->camera.x + (double)(list->x[i] * list->at[i]);
        march->y[i] = scene->camera.y + (double)(list->y[i] * list->at[i]);
    }
    const struct scarp_samples out = {.value = march->value};
    interrupt_unless(ground_points(&band->ground, list->count, march->x, march->y, &out));
    march->calls++;
    march->points += list->count;
}

/* How far ray number `i` of a list is above the ground that was sampled */
static float clearance(const struct march *march, const struct scene *scene,
                       const struct march_list *list, size_t i)
{
    return scene->camera.z + list->z[i] * list->at[i] - march->value[i];
}

/* Has ray number `i` bisect its step, if it must: it is below the ground, or was so further on. A
   ray that begins below it begins again with the band. False if the ray goes on. */
static bool bisect(struct march *march, const struct scene *scene, const struct band *band,
                   const struct rays *rays, size_t i, float above)
{
    struct march_list *const live = &march->live;
    const float at = live->at[i], level = LEVEL * scene->camera.pixel * at;
    const bool is_below = above <= 0.0f;
    if (is_below ? live->above[i] - above <= level : live->beyond[i] == 0.0f) {
        return false;
    }
    if (is_below && live->before[i] == at && at > band->begin) {
        live->at[i] = live->before[i] = band->begin;
        return true;
    }
    if (is_below) {
        live->beyond[i] = at;
    } else {
        live->before[i] = at;
        live->above[i] = above;
    }
    if (live->beyond[i] - live->before[i] <= FINEST_STEP * (at > NEAREST ? at : NEAREST)) {
        live->at[i] = live->before[i];
        rays->cliff[live->ray[i]] = true;
        move(live, i, &march->hit);
    } else if (!is_below && above < 0.5f * level) {
        move(live, i, &march->hit);
    } else {
        live->at[i] = 0.5f * (live->before[i] + live->beyond[i]);
    }
    return true;
}

/* Takes the live rays on by a step, and sorts out those that are done here. Counts down: what takes
   the place of a ray has been looked at. */
static void step(struct march *march, const struct scene *scene, const struct band *band,
                 const struct rays *rays)
{
    struct march_list *const live = &march->live;
    const float width = scene->camera.pixel / clamp(band->slope, 1.0f, STEEPEST);
    const float least = width > FINEST_STEP ? width : FINEST_STEP; /* of the distance */
    const float around = (1.0f + band->slope) * rays->spread;
    sample(march, scene, band, live);
    for (size_t i = live->count; i-- > 0;) {
        const float above = clearance(march, scene, live, i), z = live->z[i], at = live->at[i];
        float *const begin = &rays->begin[live->ray[i]];
        if (rays->is_scout && !(*begin == live->before[i] && above > around * at)) {
            move(live, i, NULL);
            continue;
        }
        if (bisect(march, scene, band, rays, i, above)) {
            continue;
        }
        if (above <= 0.0f) {
            const float between = live->above[i] - above; /* the last point and this one */
            const float part = between > 0.0f ? live->above[i] / between : 1.0f;
            live->at[i] = mix(live->before[i], at, part);
            move(live, i, &march->hit);
            continue;
        }
        if (z >= 0.0f && scene->camera.z + z * at >= scene->top) {
            move(live, i, NULL); /* the sky */
            continue;
        }
        const bool is_wide = *begin == live->before[i] && above > around * at;
        if (is_wide) {
            *begin = at;
        }
        const float room = above - (is_wide ? around * at : 0.0f);
        const float falls = band->slope * sqrtf(1.0f - z * z) - z + (is_wide ? around : 0.0f);
        const float safe = falls > 0.0f ? room / falls : INFINITY;
        const float short_step = least * (at > NEAREST ? at : NEAREST);
        const float next = at + (safe > short_step ? safe : short_step);
        live->before[i] = at;
        live->above[i] = above;
        live->at[i] = next < band->end ? next : band->end;
        if (next >= band->end) {
            move(live, i, &march->waiting);
        }
    }
}

/* Has the rays that wait for the band take part again. */
static void begin_band(struct march *march, const struct band *band)
{
    struct march_list *const waiting = &march->waiting;
    march->live.count = march->hit.count = 0;
    for (size_t i = waiting->count; i-- > 0;) {
        if (waiting->at[i] < band->end) {
            move(waiting, i, &march->live);
        }
    }
}

void march_rays(struct march *march, const struct scene *scene, struct rays *rays)
{
    size_t hits = 0;
    enter(march, scene, rays);
    for (size_t b = 0; b < BANDS; b++) {
        const struct band *const band = &scene->band[b];
        begin_band(march, band);
        while (march->live.count > 0 && !interrupted()) {
            step(march, scene, band, rays);
        }
        rays->first_hit[b] = hits;
        for (size_t i = 0; i < march->hit.count; i++) {
            rays->hit[hits++] = march->hit.ray[i];
            rays->distance[march->hit.ray[i]] = march->hit.at[i];
        }
    }
    rays->first_hit[BANDS] = hits;
}
