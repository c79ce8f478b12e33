/* SPDX-License-Identifier: MIT
 *
 * Reference: how the octaves of a sum are placed and added. Included by points.c only. `dimensions`
 * and `order` are constants wherever these are inlined, so what is not asked for is not computed.
 */
#ifndef SCARP_SCALAR_FRACTAL_H
#define SCARP_SCALAR_FRACTAL_H

#include "basis.h"

/* p_k = J_k x + o_k, split into cell and fraction. */
SCALAR_INLINE struct place place_f32(const struct scarp_octave *o, int turned, const float x[3],
                                     int dimensions)
{
    struct place place;
    for (int i = 0; i < dimensions; i++) {
        const float *const j = o->jacobian[i];
        float p = turned ? j[0] * x[0] + j[1] * x[1] : o->frequency * x[i];
        if (turned && dimensions == 3) {
            p += j[2] * x[2];
        }
        split_f32(p + o->offset[i], &place.cell[i], &place.t[i]);
    }
    return place;
}

SCALAR_INLINE struct place place_f64(const struct scarp_octave *o, int turned, const double x[3],
                                     int dimensions)
{
    struct place place;
    for (int i = 0; i < dimensions; i++) {
        const double *const j = o->jacobian64[i];
        double p = turned ? j[0] * x[0] + j[1] * x[1] : o->frequency64 * x[i];
        if (turned && dimensions == 3) {
            p += j[2] * x[2];
        }
        split_f64(p + o->offset64[i], &place.cell[i], &place.t[i]);
    }
    return place;
}

SCALAR_INLINE struct sample basis(const struct scarp_plan *plan, const struct scarp_octave *o,
                                  const struct place *place, int dimensions, int order)
{
    if (plan->basis == SCARP_GRADIENT) {
        return dimensions == 2 ? gradient2(o, place, plan->fade, order)
                               : gradient3(o, place, plan->fade, order);
    }
    return dimensions == 2 ? value2(o, place, plan->fade, order)
                           : value3(o, place, plan->fade, order);
}

/* Column j of a matrix, transposed, times the vector (x, y, z). */
SCALAR_INLINE float column_dot(const float m[3][3], int j, int dimensions, float x, float y,
                               float z)
{
    const float dot = m[0][j] * x + m[1][j] * y;
    return dimensions == 3 ? dot + m[2][j] * z : dot;
}

/* sum += a n with turned axes: the gradient gains (a J)^T g, the Hessian (a J)^T (H J). */
SCALAR_INLINE void add_turned(struct sample *sum, const struct scarp_octave *o,
                              const struct sample *n, int dimensions, int order)
{
    if (order >= 1) {
        sum->dx += column_dot(o->gradient, 0, dimensions, n->dx, n->dy, n->dz);
        sum->dy += column_dot(o->gradient, 1, dimensions, n->dx, n->dy, n->dz);
        sum->dz += dimensions == 3 ? column_dot(o->gradient, 2, 3, n->dx, n->dy, n->dz) : 0.0f;
    }
    if (order >= 2) {
        float hj[3][3] = {{0}}; /* H J */
        for (int j = 0; j < dimensions; j++) {
            hj[0][j] = column_dot(o->jacobian, j, dimensions, n->dxx, n->dxy, n->dxz);
            hj[1][j] = column_dot(o->jacobian, j, dimensions, n->dxy, n->dyy, n->dyz);
            hj[2][j] = column_dot(o->jacobian, j, dimensions, n->dxz, n->dyz, n->dzz);
        }
        sum->dxx += column_dot(o->gradient, 0, dimensions, hj[0][0], hj[1][0], hj[2][0]);
        sum->dxy += column_dot(o->gradient, 0, dimensions, hj[0][1], hj[1][1], hj[2][1]);
        sum->dyy += column_dot(o->gradient, 1, dimensions, hj[0][1], hj[1][1], hj[2][1]);
        if (dimensions == 3) {
            sum->dxz += column_dot(o->gradient, 0, 3, hj[0][2], hj[1][2], hj[2][2]);
            sum->dyz += column_dot(o->gradient, 1, 3, hj[0][2], hj[1][2], hj[2][2]);
            sum->dzz += column_dot(o->gradient, 2, 3, hj[0][2], hj[1][2], hj[2][2]);
        }
    }
}

/* sum += a n with J = f: the gradient gains a f g, the Hessian a f^2 H. */
SCALAR_INLINE void add_straight(struct sample *sum, const struct scarp_octave *o,
                                const struct sample *n, int order)
{
    if (order >= 1) {
        sum->dx += o->slope * n->dx;
        sum->dy += o->slope * n->dy;
        sum->dz += o->slope * n->dz;
    }
    if (order >= 2) {
        sum->dxx += o->curvature * n->dxx;
        sum->dxy += o->curvature * n->dxy;
        sum->dxz += o->curvature * n->dxz;
        sum->dyy += o->curvature * n->dyy;
        sum->dyz += o->curvature * n->dyz;
        sum->dzz += o->curvature * n->dzz;
    }
}

SCALAR_INLINE void add_octave(struct sample *sum, const struct scarp_octave *o, int turned,
                              const struct sample *n, int dimensions, int order)
{
    sum->value += o->amplitude * n->value;
    if (turned) {
        add_turned(sum, o, n, dimensions, order);
    } else {
        add_straight(sum, o, n, order);
    }
}

#endif
