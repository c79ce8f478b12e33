/* SPDX-License-Identifier: MIT
 *
 * Formulas: noise at displaced positions. The coordinates of y(x) are samples themselves: their
 * values are how far they are displaced, their derivatives those of y with respect to x.
 */
#ifndef SCARP_FORMULAS_WARP_H
#define SCARP_FORMULAS_WARP_H

#include "fractal.h"

/* The coordinates of displaced positions, with their derivatives: how far they are displaced. */
struct displaced {
    struct sample x;
    struct sample y;
    struct sample z;
};

/* A sample with its derivatives with respect to y becomes one with those with respect to x: with
   the Jacobian J of y, the gradient is J^T g, the Hessian J^T (H J) + sum_m g_m (Hessian of y_m).
 */
static inline struct sample composed(struct sample s, struct displaced y, int dimensions)
{
    const struct rows j = transposed(rows_of(y.x.gradient, y.y.gradient, y.z.gradient));
    const vec3 diagonal =
        transposed_times(rows_of(y.x.diagonal, y.y.diagonal, y.z.diagonal), s.gradient, dimensions);
    const vec3 mixed =
        transposed_times(rows_of(y.x.mixed, y.y.mixed, y.z.mixed), s.gradient, dimensions);
    struct sample r = with_hessian(s, j, j, hessian_of(s), dimensions);
    r.gradient = times(j, s.gradient, dimensions);
    r.diagonal = add3(r.diagonal, diagonal);
    r.mixed = add3(r.mixed, mixed);
    return r;
}

/* What nothing has displaced. */
static inline struct displaced not_displaced(void)
{
    struct displaced y;
    y.x = constant(0.0f);
    y.y = y.x;
    y.z = y.x;
    return y;
}

/* Displacements of x become positions: their derivatives are those of x, too. */
static inline struct displaced positions_of(struct displaced d)
{
    struct displaced y = d;
    y.x.gradient.x += 1.0f;
    y.y.gradient.y += 1.0f;
    y.z.gradient.z += 1.0f;
    return y;
}

static inline vec3 values_of(struct displaced y)
{
    return vec3_of(y.x.value, y.y.value, y.z.value);
}

static inline struct displaced displaced_of(struct sample x, struct sample y, struct sample z)
{
    struct displaced d;
    d.x = x;
    d.y = y;
    d.z = z;
    return d;
}

#endif
