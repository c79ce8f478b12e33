/* SPDX-License-Identifier: MIT
 *
 * Normals from differences of 16-bit heights.
 */
#include "terrain/compare.h"

#include "shared/interrupt.h"

/* slope[i] = the central difference of 16-bit heights along (right, up) */
static void difference(const struct surface *surface, const struct window *window, int right,
                       int up, float *slope)
{
    float *const before = window->differences_x;
    float *const after = window->differences_y;
    const struct surface_scale scale = surface->scale;
    surface_values(surface, window, -right, -up, before);
    surface_values(surface, window, right, up, after);
    const double distance = 2.0 * surface->step * surface->scale.steps; /* 0: all are alike */
    for (size_t i = 0; i < window->columns * window->rows; i++) {
        const int steps =
            (int)surface_quantise(scale, after[i]) - (int)surface_quantise(scale, before[i]);
        slope[i] = steps != 0 ? (float)(steps / distance) : 0.0f;
    }
}

/* Neighbours are sampled again instead of looked up, so that the outermost samples have theirs too.
   The third difference array holds one slope until the normals replace it. */
void compare_sample(const struct surface *surface, struct window *window)
{
    float *const slope_x = window->differences_z;
    float *const slope_y = window->value;
    difference(surface, window, 1, 0, slope_x);
    difference(surface, window, 0, 1, slope_y);
    interrupt_unless(scarp_normals(window->columns * window->rows, slope_x, slope_y, 1.0f,
                                   window->differences_x, window->differences_y,
                                   window->differences_z) == SCARP_OK);
    surface_values(surface, window, 0, 0, window->value);
}
