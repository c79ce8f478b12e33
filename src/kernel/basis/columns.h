/* SPDX-License-Identifier: MIT
 *
 * The interpolation over x, the last step of bases that interpolate between lattice points. The
 * reference is formulas/corners.h.
 *
 * Such bases interpolate over z, then y, then x. On the lattice columns s = 0 and 1 at either side
 * of a point, what does not depend on x is reduced to lines a_s (x - s) + b_s in the fraction x,
 * one for the value (left and right) and one for each derivative along y and z:
 *
 *     value
 *       |  *                       left  = a_0 x + b_0
 *       |     *               *    right = a_1 (x - 1) + b_1
 *       |        *        *
 *       |           *  *           The value goes from left to right as u goes from 0 to 1.
 *       |        *     *
 *       |    *            *
 *       +--|----------------|--> x
 *        s = 0            s = 1
 *
 * With u the fade of x:
 *
 *     value  = left + u (right - left)
 *     d/dx   = a_0 + u (a_1 - a_0) + u' (right - left)
 *     d2/dx2 = 2 u' (a_1 - a_0) + u'' (right - left)
 *
 * and likewise for the derivatives along y and z. Along a row of a grid the lines are constants of
 * the column, which is why x comes last. Value noise has a = 0 throughout; there the slopes are
 * never set, and the terms with them are left out.
 */
#ifndef SCARP_KERNEL_BASIS_COLUMNS_H
#define SCARP_KERNEL_BASIS_COLUMNS_H

#include "../lattice.h"
#include "../sample.h"
#include "directions.h"
#include "fade.h"

struct line {
    vf a, b;
};

/* A lattice column. Lines beyond the order and the dimensions are unset. */
struct column {
    struct line value, y, z, yy, yz, zz;
};

/* The hashes of a column's corners, by [y][z]; [y][0] in 2D. */
struct corners {
    vu h[2][2];
};

/* The hash that replaces h in what a component of vector noise draws: components.h. The
   reference is formulas/lattice.h. */
VEC_INLINE vu component_hash(vu h, int component, struct variant v)
{
    static const uint32_t values[3] = {1, 0x9e3779b1u, 0x85ebca6bu}, twelves[3] = {1, 12, 144};
    if (v.basis == SCARP_VALUE) {
        return component == 0 ? h : vu_turn16(h) * vu_set(values[component]);
    }
    return v.dimensions == 2 ? h << (4 * component) : vu_upper_times(h, twelves[component]);
}

VEC_INLINE struct corners component_corners(const struct corners *c, int component,
                                            struct variant v)
{
    struct corners of;
    for (int y = 0; y < 2; y++) {
        of.h[y][0] = component_hash(c->h[y][0], component, v);
        if (v.dimensions == 3) {
            of.h[y][1] = component_hash(c->h[y][1], component, v);
        }
    }
    return of;
}

/* Where a point lies across the columns, and the gradients of a variant that flows. All samples of
   a row of a grid lie at the same y and z. There, `dots` has tables of the products of gradients
   with the way from corner [y][z] ([y][0] in 2D): gradient.h. */
struct across {
    vf y, z;
    struct fade v, w;
    const struct directions *directions;
    int has_dots; /* a constant in each pass */
    vf dots[2][2];
};

/* Whether all slopes of a basis are 0. */
VEC_INLINE int flat(struct variant v)
{
    return v.basis == SCARP_VALUE;
}

/* A line at the left column and one at the right, evaluated at the points. */
struct ends {
    vf left, right;
};

VEC_INLINE struct ends ends_of(struct line l, struct line r, vf x, vf s, int is_flat)
{
    const struct ends sloped = {is_flat ? l.b : l.a * x + l.b, is_flat ? r.b : r.a * s + r.b};
    return sloped;
}

VEC_INLINE vf across_value(struct ends e, struct fade u)
{
    return e.left + u.u * (e.right - e.left);
}

VEC_INLINE vf across_dx(struct ends e, struct line l, struct line r, struct fade u, int is_flat)
{
    const vf step = u.du * (e.right - e.left);
    return is_flat ? step : (l.a + u.u * (r.a - l.a)) + step;
}

VEC_INLINE vf across_dxx(struct ends e, struct line l, struct line r, struct fade u, int is_flat)
{
    const vf bend = u.ddu * (e.right - e.left);
    return is_flat ? bend : 2.0f * u.du * (r.a - l.a) + bend;
}

/* The sample at the fraction x, of fade u, between two columns. */
VEC_INLINE struct sample join(const struct column *l, const struct column *r, vf x, struct fade u,
                              struct variant v)
{
    const int is_flat = flat(v);
    struct sample s;
#define ENDS(name) ends_of(l->name, r->name, x, u.s, is_flat)
    const struct ends value = ENDS(value);
    s.value = across_value(value, u);
    if (v.order >= 1) {
        s.dx = across_dx(value, l->value, r->value, u, is_flat);
        const struct ends y = ENDS(y);
        s.dy = across_value(y, u);
        if (v.order >= 2) {
            s.dxx = across_dxx(value, l->value, r->value, u, is_flat);
            s.dxy = across_dx(y, l->y, r->y, u, is_flat);
            s.dyy = across_value(ENDS(yy), u);
        }
        if (v.dimensions == 3) {
            const struct ends z = ENDS(z);
            s.dz = across_value(z, u);
            if (v.order >= 2) {
                s.dxz = across_dx(z, l->z, r->z, u, is_flat);
                s.dyz = across_value(ENDS(yz), u);
                s.dzz = across_value(ENDS(zz), u);
            }
        }
    }
#undef ENDS
    return s;
}

#endif
