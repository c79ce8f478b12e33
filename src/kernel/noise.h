/* SPDX-License-Identifier: MIT
 *
 * One octave of noise at a block of points: the results, and the interpolation over x that both
 * bases end with. Included by gradient.h and value.h; the reference is scalar/basis.h.
 *
 * Both bases interpolate over z, then y, then x. What does not depend on x is reduced, on the
 * lattice columns s = 0 and 1 at either side, to lines a_s (x - s) + b_s in the fraction x, one for
 * the value (left and right) and one for each derivative along y and z. With u the fade of x:
 *
 *     value  = left + u (right - left)
 *     d/dx   = a_0 + u (a_1 - a_0) + u' (right - left)
 *     d2/dx2 = 2 u' (a_1 - a_0) + u'' (right - left)
 *
 * and likewise for the derivatives along y and z. Along a row of a grid the lines are constants of
 * the column, which is why x comes last. Value noise has a = 0 throughout; there the terms
 * with a are left away.
 *
 * `order`, the highest derivative wanted, and `dimensions` are compile-time constants everywhere.
 */
#ifndef SCARP_KERNEL_NOISE_H
#define SCARP_KERNEL_NOISE_H

#include "fade.h"
#include "lattice.h"

/* Members beyond the order and the dimensions are unset. */
struct sample {
    vf value, dx, dy, dz, dxx, dxy, dxz, dyy, dyz, dzz;
};

struct line {
    vf a, b;
};

struct column {
    struct line value, y, z, yy, yz, zz;
};

/* A line at the left column and one at the right, evaluated at the points. */
struct ends {
    vf left, right, da; /* da: a_1 - a_0 */
};

VEC_INLINE struct ends ends(struct line l, struct line r, vf x, struct fade u)
{
    const struct ends e = {l.a * x + l.b, r.a * u.s + r.b, r.a - l.a};
    return e;
}

VEC_INLINE vf across(struct ends e, struct fade u)
{
    return e.left + u.u * (e.right - e.left);
}

VEC_INLINE vf across_dx(struct ends e, struct line l, struct fade u)
{
    return (l.a + u.u * e.da) + u.du * (e.right - e.left);
}

VEC_INLINE vf across_dxx(struct ends e, struct fade u)
{
    return 2.0f * u.du * e.da + u.ddu * (e.right - e.left);
}

VEC_INLINE struct sample join(const struct column *l, const struct column *r, vf x, struct fade u,
                              int dimensions, int order)
{
    struct sample s;
    const struct ends value = ends(l->value, r->value, x, u);
    s.value = across(value, u);
    if (order >= 1) {
        s.dx = across_dx(value, l->value, u);
        const struct ends y = ends(l->y, r->y, x, u);
        s.dy = across(y, u);
        if (order >= 2) {
            s.dxx = across_dxx(value, u);
            s.dxy = across_dx(y, l->y, u);
            s.dyy = across(ends(l->yy, r->yy, x, u), u);
        }
        if (dimensions == 3) {
            const struct ends z = ends(l->z, r->z, x, u);
            s.dz = across(z, u);
            if (order >= 2) {
                s.dxz = across_dx(z, l->z, u);
                s.dyz = across(ends(l->yz, r->yz, x, u), u);
                s.dzz = across(ends(l->zz, r->zz, x, u), u);
            }
        }
    }
    return s;
}

#endif
