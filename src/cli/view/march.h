/* SPDX-License-Identifier: MIT
 *
 * Marching: where many rays meet the ground.
 */
#ifndef SCARP_CLI_VIEW_MARCH_H
#define SCARP_CLI_VIEW_MARCH_H

#include <stdbool.h>
#include <stdint.h>

#include "view/scene.h"

/* Rays from the camera, and what becomes of them */
struct rays {
    size_t count;
    float *x, *y, *z; /* unit vectors */
    float *begin;     /* where each begins; then how far the rays around it, too, meet nothing */
    float spread;     /* sine of the angle between a ray and those around it; 0: there are none */
    bool is_scout;   /* only `begin` is wanted: rays end where one around them may meet something */
    float *distance; /* to the ground; that of the sky is infinite */
    bool *cliff;     /* whether it ends at a cliff, between what is below and above it */

    /* The rays that meet the ground, band by band: those of band b are the numbers hit[i] with
       first_hit[b] <= i < first_hit[b + 1] */
    uint32_t *hit;
    size_t first_hit[BANDS + 1];
};

/* Rays that are under way */
struct march_list {
    size_t count;
    uint32_t *ray;
    float *x, *y, *z; /* the ray's direction */
    float *at;        /* the distance that is looked at next */
    float *before;    /* the one that was looked at last, where the ray was above the ground */
    float *above;     /* and how far above it was */
    float *beyond;    /* of a ray that bisects: where it was below the ground; else 0 */
};

/* What a thread needs to march, and how often it called the library */
struct march {
    struct march_list live, waiting, hit;
    double *x, *y; /* places */
    float *value;  /* the ground there */
    void *memory;
    uint64_t calls, points;
};

/* Makes room for `most` rays at a time. False without memory. */
bool march_open(struct march *march, size_t most);
void march_close(struct march *march);

/* Finds the distances of all rays, and their order. */
void march_rays(struct march *march, const struct scene *scene, struct rays *rays);

#endif
