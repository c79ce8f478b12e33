/* SPDX-License-Identifier: MIT
 *
 * What a picture is made of: the camera, the sun, and the ground in bands of distance. Each band
 * has the ground without the octaves whose cells no pixel could show there. Made once, then only
 * read, by all threads.
 */
#ifndef SCARP_CLI_VIEW_SCENE_H
#define SCARP_CLI_VIEW_SCENE_H

#include <stdbool.h>

#include "ground/ground.h"
#include "ground/spread.h"
#include "view/camera.h"
#include "view/colours.h"

#define BANDS 11 /* the first one ends where the far end is halved ten times */

struct band {
    float begin, end;     /* distances from the camera */
    float finest;         /* the ground has no smaller cells */
    struct ground ground; /* for normals also that of the next band, the more so towards its end */
    float slope;          /* little that the picture shows of it rises faster */
    bool jumps;           /* there may be cliffs */
};

/* What a hill as a whole is, and a range of them: cells in units */
#define SMOOTH_CELLS ((const double[2]){16.0, 90.0})

/* What colours depend on */
struct survey {
    float low, high;   /* usual heights, those of `scarp terrain --relief`; low may be the sea */
    float steep;       /* the slope that a fifth of the places in the view exceed */
    float smoothed[2]; /* the mean height that scene.smooth has and the ground has not */
};

struct scene {
    struct camera camera;
    struct ground ground;
    float side;     /* of the view */
    float top;      /* no ground is higher */
    float bottom;   /* or lower */
    float farthest; /* nothing is looked for beyond */
    bool has_sea;
    float sea; /* its height */

    struct band band[BANDS + 1]; /* the last one is behind the far end */
    struct ground smooth[2];     /* the ground without cells smaller than SMOOTH_CELLS */
    struct ground bed;           /* the ground as it is below the sea */
    struct survey survey;

    struct vector sun;      /* towards it */
    struct colour sunlight; /* of sky_sunlight */
    float haze;             /* the distance at which it takes 1 - 1/e of the light; 0: none */
    struct colours colours;
};

/* How wide the square of the view is: in units at least, and in its usual heights */
#define LEAST_SIDE 1024.0f
#define HEIGHTS 4.0f

/* Sets the ground, and what is known of it within the view, which begins at (x, y). */
void scene_set_ground(struct scene *scene, const struct ground *ground, double x, double y);

/* Sets the bands of a scene that has its ground and its camera. */
void scene_set_bands(struct scene *scene);

#endif
