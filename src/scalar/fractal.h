/* SPDX-License-Identifier: MIT
 *
 * Reference: how the octaves of a sum are placed and added. Included by points.c only. `dimensions`
 * and `order` are constants wherever these are inlined, so what is not asked for is not computed.
 */
#ifndef SCARP_SCALAR_FRACTAL_H
#define SCARP_SCALAR_FRACTAL_H

#include "shape.h"

SCALAR_INLINE struct sample noise(enum scarp_basis basis, enum scarp_fade fade,
                                  const struct scarp_octave *o, const struct place *place,
                                  int dimensions, int order)
{
    if (basis == SCARP_GRADIENT) {
        return dimensions == 2 ? gradient2(o, place, fade, order)
                               : gradient3(o, place, fade, order);
    }
    return dimensions == 2 ? value2(o, place, fade, order) : value3(o, place, fade, order);
}

/* a n with turned axes: the gradient is (a J)^T g, the Hessian (a J)^T (H J). */
SCALAR_INLINE struct sample turned(const struct scarp_octave *o, const struct sample *n,
                                   int dimensions, int order)
{
    const float(*const aj)[3] = o->gradient;
    struct sample s = {.value = o->amplitude * n->value};
    if (order >= 1) {
        s.dx = column_dot(aj, 0, dimensions, n->dx, n->dy, n->dz);
        s.dy = column_dot(aj, 1, dimensions, n->dx, n->dy, n->dz);
        if (dimensions == 3) {
            s.dz = column_dot(aj, 2, 3, n->dx, n->dy, n->dz);
        }
    }
    if (order >= 2) {
        float hj[3][3] = {{0}}; /* H J */
        for (int j = 0; j < dimensions; j++) {
            hj[0][j] = column_dot(o->jacobian, j, dimensions, n->dxx, n->dxy, n->dxz);
            hj[1][j] = column_dot(o->jacobian, j, dimensions, n->dxy, n->dyy, n->dyz);
            hj[2][j] = column_dot(o->jacobian, j, dimensions, n->dxz, n->dyz, n->dzz);
        }
        s.dxx = column_dot(aj, 0, dimensions, hj[0][0], hj[1][0], hj[2][0]);
        s.dxy = column_dot(aj, 0, dimensions, hj[0][1], hj[1][1], hj[2][1]);
        s.dyy = column_dot(aj, 1, dimensions, hj[0][1], hj[1][1], hj[2][1]);
        if (dimensions == 3) {
            s.dxz = column_dot(aj, 0, 3, hj[0][2], hj[1][2], hj[2][2]);
            s.dyz = column_dot(aj, 1, 3, hj[0][2], hj[1][2], hj[2][2]);
            s.dzz = column_dot(aj, 2, 3, hj[0][2], hj[1][2], hj[2][2]);
        }
    }
    return s;
}

SCALAR_INLINE struct sample scaled(const struct sample *n, float value, float gradient,
                                   float hessian)
{
    const struct sample s = {
        .value = value * n->value,
        .dx = gradient * n->dx,
        .dy = gradient * n->dy,
        .dz = gradient * n->dz,
        .dxx = hessian * n->dxx,
        .dxy = hessian * n->dxy,
        .dxz = hessian * n->dxz,
        .dyy = hessian * n->dyy,
        .dyz = hessian * n->dyz,
        .dzz = hessian * n->dzz,
    };
    return s;
}

/* a n with J = f: the gradient has the factor a f, the Hessian a f^2. */
SCALAR_INLINE struct sample straight(const struct scarp_octave *o, const struct sample *n)
{
    return scaled(n, o->amplitude, o->slope, o->curvature);
}

SCALAR_INLINE void add(struct sample *sum, const struct sample *s)
{
    sum->value += s->value;
    sum->dx += s->dx;
    sum->dy += s->dy;
    sum->dz += s->dz;
    sum->dxx += s->dxx;
    sum->dxy += s->dxy;
    sum->dxz += s->dxz;
    sum->dyy += s->dyy;
    sum->dyz += s->dyz;
    sum->dzz += s->dzz;
}

/* Float or double coordinates. */
struct point {
    float f32[3];
    double f64[3];
};

SCALAR_INLINE struct place place(const struct scarp_octave *o, enum axes axes,
                                 const struct point *x, int dimensions, int doubles)
{
    return doubles ? place_f64(o, axes, x->f64, dimensions)
                   : place_f32(o, axes, x->f32, dimensions);
}

/* Octave k of fBm, as it is added to the sum. */
SCALAR_INLINE struct sample octave(const struct scarp_plan *plan, int k, enum axes axes,
                                   const struct point *x, enum scarp_basis basis, int dimensions,
                                   int order, int doubles)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const struct place p = place(o, axes, x, dimensions, doubles);
    const struct sample n = noise(basis, plan->fade, o, &p, dimensions, order);
    return axes == AXES_TURNED ? turned(o, &n, dimensions, order) : straight(o, &n);
}

SCALAR_INLINE struct sample fbm(const struct scarp_plan *plan, const struct point *x,
                                enum scarp_basis basis, int dimensions, int order, int doubles)
{
    struct sample sum = octave(plan, 0, AXES_FIRST, x, basis, dimensions, order, doubles);
    const enum axes axes = plan->rotate ? AXES_TURNED : AXES_STRAIGHT;
    for (int k = 1; k < plan->octaves; k++) {
        const struct sample n = octave(plan, k, axes, x, basis, dimensions, order, doubles);
        add(&sum, &n);
    }
    return sum;
}

/* The other fractals. Their octaves are scaled by 1 over the supremum of the basis; a_k comes last.
   All in one, and not inlined for each basis: fBm is what must be fast here. */
SCALAR_INLINE struct sample shaped(const struct scarp_plan *plan, const struct point *x,
                                   int dimensions, int order, int doubles)
{
    struct sample sum = {0};
    struct sample weight = {.value = 1.0f};
    struct slopes slopes = {{0}, {{0}}};
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const enum axes axes = k == 0 ? AXES_FIRST : plan->rotate ? AXES_TURNED : AXES_STRAIGHT;
        const struct place p = place(o, axes, x, dimensions, doubles);
        struct sample s;
        if (plan->fractal == SCARP_EROSION) {
            const struct sample n =
                noise(plan->basis, plan->fade, o, &p, dimensions, order < 2 ? order + 1 : 2);
            const struct sample unit = scaled(&n, o->amplitude, o->amplitude, o->amplitude);
            s = erode(&slopes, plan->erosion, o, axes, &unit, dimensions, order);
        } else {
            const struct sample n = noise(plan->basis, plan->fade, o, &p, dimensions, order);
            const struct sample unit = axes == AXES_TURNED && order > 0
                                           ? turned(o, &n, dimensions, order)
                                           : straight(o, &n);
            s = plan->fractal == SCARP_RIDGED ? ridge(&weight, &unit) : magnitude(&unit);
        }
        s = scaled(&s, o->weight, o->weight, o->weight);
        if (k == 0) {
            sum = s;
        } else {
            add(&sum, &s);
        }
    }
    return sum;
}

#endif
