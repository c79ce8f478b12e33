/* SPDX-License-Identifier: MIT
 *
 * Normals as made by a program that has nothing but 16-bit heights: from central differences, two
 * steps apart. They are for comparison with the normals from the gradient.
 */
#ifndef SCARP_CLI_COMPARE_H
#define SCARP_CLI_COMPARE_H

#include "raster/surface.h"

/* Adds these normals to a window that was sampled and has room for them. */
void compare_sample(const struct surface *surface, struct window *window);

#endif
