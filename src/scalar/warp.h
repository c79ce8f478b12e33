/* SPDX-License-Identifier: MIT
 *
 * Reference: noise at displaced positions. The coordinates of y(x) are samples themselves: their
 * values are how far they are displaced, their derivatives those of y by x.
 */
#ifndef SCARP_SCALAR_WARP_H
#define SCARP_SCALAR_WARP_H

#include "bend.h"

/* The sum over the coordinates y_m of v_m times an output of y_m. */
static inline float along(const struct outputs y[3], int output, const float v[3], int dimensions)
{
    const float sum = y[0].of[output] * v[0] + y[1].of[output] * v[1];
    return dimensions == 3 ? sum + y[2].of[output] * v[2] : sum;
}

/* A sample at y with its derivatives by y becomes one with its derivatives by x: with the Jacobian
   J of y, the gradient is J^T g, the Hessian J^T (H J) + sum_m g_m (Hessian of y_m). */
static struct outputs composed(const struct outputs *s, const struct outputs y[3], int dimensions)
{
    const float *const g = &s->of[DX];
    struct outputs r = *s;
    for (int j = 0; j < dimensions; j++) {
        float hj[3] = {0.0f, 0.0f, 0.0f}; /* column j of H J */
        for (int m = 0; m < dimensions; m++) {
            const float row[3] = {s->of[second(m, 0)], s->of[second(m, 1)], s->of[second(m, 2)]};
            hj[m] = along(y, DX + j, row, dimensions);
        }
        r.of[DX + j] = along(y, DX + j, g, dimensions);
        for (int i = 0; i <= j; i++) {
            r.of[second(i, j)] =
                along(y, DX + i, hj, dimensions) + along(y, second(i, j), g, dimensions);
        }
    }
    return r;
}

/* Displaces x, which is not displaced yet. */
static struct point displaced(const struct point *x, const struct outputs y[3], int dimensions)
{
    struct point at = *x;
    at.displaced = 1;
    for (int i = 0; i < dimensions; i++) {
        at.f32[i] += y[i].of[VALUE];
    }
    return at;
}

/* The noise of a plan without its warp. */
static struct outputs octaves_at(const struct scarp_call_plan *plan, const struct point *x,
                                 int dimensions)
{
    return fractal_bends(plan->fractal) ? bend_octaves(plan, x, dimensions)
                                        : sum_octaves(plan, x, dimensions);
}

/* The noise of a plan, or a component of its potentials, with the warps: from the deepest one,
   which looks at x, to the noise. */
static struct outputs component_at(const struct scarp_call_plan *plan, const struct point *x,
                                   int dimensions, int component)
{
    const int depth = plan->warps.depth;
    struct outputs y[3], moved[3];
    struct point at = *x;
    struct scarp_call_plan of_level;
    if (depth == 0 && !plan->warps.vector) {
        return octaves_at(plan, x, dimensions);
    }
    for (int level = depth; level > 0; level--) {
        for (int i = 0; i < dimensions; i++) {
            of_level = scarpi_component_plan(plan, level, i);
            moved[i] = octaves_at(&of_level, &at, dimensions);
            if (level < depth) {
                moved[i] = composed(&moved[i], y, dimensions);
            }
            moved[i].of[DX + i] += 1.0f;
        }
        memcpy(y, moved, (size_t)dimensions * sizeof *y);
        at = displaced(x, y, dimensions);
    }
    of_level = scarpi_component_plan(plan, 0, component);
    const struct outputs s = octaves_at(&of_level, &at, dimensions);
    return depth == 0 ? s : composed(&s, y, dimensions);
}

static struct outputs sample_at(const struct scarp_call_plan *plan, const struct point *x,
                                int dimensions)
{
    return component_at(plan, x, dimensions, 0);
}

#endif
