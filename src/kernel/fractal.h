/* SPDX-License-Identifier: MIT
 *
 * Adding an octave to a sum, with the derivatives carried through the octave's axes. Included by
 * points.h; the reference is scalar/fractal.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_H
#define SCARP_KERNEL_FRACTAL_H

#include "noise.h"

/* Column j of a matrix, transposed, times the vector (x, y, z). */
VEC_INLINE vf column_dot(const float m[3][3], int j, int dimensions, vf x, vf y, vf z)
{
    vf dot = vf_set(m[0][j]) * x + vf_set(m[1][j]) * y;
    if (dimensions == 3) {
        dot += vf_set(m[2][j]) * z;
    }
    return dot;
}

/* One column of H J. */
struct product {
    vf x, y, z;
};

VEC_INLINE struct product hessian_times(const struct sample *n, const float jacobian[3][3], int j,
                                        int dimensions)
{
    struct product p;
    p.x = column_dot(jacobian, j, dimensions, n->dxx, n->dxy, n->dxz);
    p.y = column_dot(jacobian, j, dimensions, n->dxy, n->dyy, n->dyz);
    if (dimensions == 3) {
        p.z = column_dot(jacobian, j, dimensions, n->dxz, n->dyz, n->dzz);
    }
    return p;
}

/* Derivatives with turned axes: the gradient gains (a J)^T g, the Hessian (a J)^T (H J). */
VEC_INLINE void add_turned(struct sample *sum, const struct scarp_octave *o, const struct sample *n,
                           int dimensions, int order)
{
    const float(*const aj)[3] = o->gradient;
    if (order >= 1) {
        sum->dx += column_dot(aj, 0, dimensions, n->dx, n->dy, n->dz);
        sum->dy += column_dot(aj, 1, dimensions, n->dx, n->dy, n->dz);
        if (dimensions == 3) {
            sum->dz += column_dot(aj, 2, dimensions, n->dx, n->dy, n->dz);
        }
    }
    if (order >= 2) {
        const struct product p0 = hessian_times(n, o->jacobian, 0, dimensions);
        const struct product p1 = hessian_times(n, o->jacobian, 1, dimensions);
        sum->dxx += column_dot(aj, 0, dimensions, p0.x, p0.y, p0.z);
        sum->dxy += column_dot(aj, 0, dimensions, p1.x, p1.y, p1.z);
        sum->dyy += column_dot(aj, 1, dimensions, p1.x, p1.y, p1.z);
        if (dimensions == 3) {
            const struct product p2 = hessian_times(n, o->jacobian, 2, dimensions);
            sum->dxz += column_dot(aj, 0, dimensions, p2.x, p2.y, p2.z);
            sum->dyz += column_dot(aj, 1, dimensions, p2.x, p2.y, p2.z);
            sum->dzz += column_dot(aj, 2, dimensions, p2.x, p2.y, p2.z);
        }
    }
}

/* Derivatives with J = f: the gradient gains a f g, the Hessian a f^2 H. */
VEC_INLINE void add_straight(struct sample *sum, const struct scarp_octave *o,
                             const struct sample *n, int dimensions, int order)
{
    if (order >= 1) {
        const vf slope = vf_set(o->slope);
        sum->dx += slope * n->dx;
        sum->dy += slope * n->dy;
        if (dimensions == 3) {
            sum->dz += slope * n->dz;
        }
    }
    if (order >= 2) {
        const vf curvature = vf_set(o->curvature);
        sum->dxx += curvature * n->dxx;
        sum->dxy += curvature * n->dxy;
        sum->dyy += curvature * n->dyy;
        if (dimensions == 3) {
            sum->dxz += curvature * n->dxz;
            sum->dyz += curvature * n->dyz;
            sum->dzz += curvature * n->dzz;
        }
    }
}

#endif
