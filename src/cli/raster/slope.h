/* SPDX-License-Identifier: MIT
 *
 * What derivatives say about a surface z = f(x, y): how steep it is, and how it bends. The same on
 * every machine, to the bit.
 */
#ifndef SCARP_CLI_SLOPE_H
#define SCARP_CLI_SLOPE_H

#include <stddef.h>

#include "scarp.h"

/* The angle between the ground and level ground, from 0 to 90 degrees */
void slope_degrees(size_t count, const float *dx, const float *dy, float *degrees);

/* The mean curvature, in 1 / unit: 1 / R on top of a sphere of radius R. It is above 0 on crests
   and below 0 in hollows. Samples have dx, dy, dxx, dxy and dyy. */
void slope_curvature(size_t count, const struct scarp_samples *samples, float *curvature);

#endif
