/* SPDX-License-Identifier: MIT
 *
 * Reference: how the octaves of a sum are placed and added. Included by points.c only. `dimensions`
 * and `order` are constants wherever these are inlined, so what is not asked for is not computed.
 */
#ifndef SCARP_SCALAR_FRACTAL_H
#define SCARP_SCALAR_FRACTAL_H

#include "basis.h"

/* How the axes of an octave lie: p = f x, p = f x + o, p = J x + o. */
enum axes { AXES_FIRST, AXES_STRAIGHT, AXES_TURNED };

/* p_k = J_k x + o_k, split into cell and fraction. (The offset of octave 0 is 0, and turns -0 into
   0.) */
SCALAR_INLINE struct place place_f32(const struct scarp_octave *o, enum axes axes, const float x[3],
                                     int dimensions)
{
    struct place place;
    for (int i = 0; i < dimensions; i++) {
        const float *const j = o->jacobian[i];
        float p = axes == AXES_TURNED ? j[0] * x[0] + j[1] * x[1] : o->frequency * x[i];
        if (axes == AXES_TURNED && dimensions == 3) {
            p += j[2] * x[2];
        }
        split_f32(p + (axes == AXES_FIRST ? 0.0f : o->offset[i]), &place.cell[i], &place.t[i]);
    }
    return place;
}

SCALAR_INLINE struct place place_f64(const struct scarp_octave *o, enum axes axes,
                                     const double x[3], int dimensions)
{
    struct place place;
    for (int i = 0; i < dimensions; i++) {
        const double *const j = o->jacobian64[i];
        double p = axes == AXES_TURNED ? j[0] * x[0] + j[1] * x[1] : o->frequency64 * x[i];
        if (axes == AXES_TURNED && dimensions == 3) {
            p += j[2] * x[2];
        }
        split_f64(p + (axes == AXES_FIRST ? 0.0 : o->offset64[i]), &place.cell[i], &place.t[i]);
    }
    return place;
}

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

/* Column j of a matrix, transposed, times the vector (x, y, z). */
SCALAR_INLINE float column_dot(const float m[3][3], int j, int dimensions, float x, float y,
                               float z)
{
    const float dot = m[0][j] * x + m[1][j] * y;
    return dimensions == 3 ? dot + m[2][j] * z : dot;
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

/* a n with J = f: the gradient has the factor a f, the Hessian a f^2. */
SCALAR_INLINE struct sample straight(const struct scarp_octave *o, const struct sample *n)
{
    const struct sample s = {
        .value = o->amplitude * n->value,
        .dx = o->slope * n->dx,
        .dy = o->slope * n->dy,
        .dz = o->slope * n->dz,
        .dxx = o->curvature * n->dxx,
        .dxy = o->curvature * n->dxy,
        .dxz = o->curvature * n->dxz,
        .dyy = o->curvature * n->dyy,
        .dyz = o->curvature * n->dyz,
        .dzz = o->curvature * n->dzz,
    };
    return s;
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

/* Octave k, as it is added to the sum. */
SCALAR_INLINE struct sample octave(const struct scarp_plan *plan, int k, enum axes axes,
                                   const struct point *x, enum scarp_basis basis, int dimensions,
                                   int order, int doubles)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const struct place place =
        doubles ? place_f64(o, axes, x->f64, dimensions) : place_f32(o, axes, x->f32, dimensions);
    const struct sample n = noise(basis, plan->fade, o, &place, dimensions, order);
    return axes == AXES_TURNED ? turned(o, &n, dimensions, order) : straight(o, &n);
}

SCALAR_INLINE struct sample sum_of_octaves(const struct scarp_plan *plan, const struct point *x,
                                           enum scarp_basis basis, int dimensions, int order,
                                           int doubles)
{
    struct sample sum = octave(plan, 0, AXES_FIRST, x, basis, dimensions, order, doubles);
    const enum axes axes = plan->rotate ? AXES_TURNED : AXES_STRAIGHT;
    for (int k = 1; k < plan->octaves; k++) {
        const struct sample n = octave(plan, k, axes, x, basis, dimensions, order, doubles);
        add(&sum, &n);
    }
    return sum;
}

#endif
