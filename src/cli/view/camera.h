/* SPDX-License-Identifier: MIT
 *
 * The camera: where it is, and the ray of each point of the picture.
 */
#ifndef SCARP_CLI_VIEW_CAMERA_H
#define SCARP_CLI_VIEW_CAMERA_H

#include <stddef.h>

#include "view/maths.h"

struct camera {
    double x, y;
    float z;
    size_t width, height;             /* of the picture, in pixels */
    struct vector forward, right, up; /* the last two reach to the edges of the picture */
    float pixel;                      /* size of a pixel at the distance 1, in the middle */
};

/* A unit vector, of an azimuth in degrees clockwise from north, from 0 to 360, and an elevation
   from -90 to 90 */
struct vector direction_of(double azimuth, double elevation);

/* Turns the camera, whose place and size are set. The field of view is horizontal, in degrees. */
void camera_turn(struct camera *camera, double azimuth, double elevation, double fov);

/* The unit vector of the ray through a point of the picture: columns from the left and rows from
   the top, in pixels */
struct vector camera_ray(const struct camera *camera, float column, float row);

#endif
