/* SPDX-License-Identifier: MIT
 *
 * Gradient noise (Perlin 1985, 2002) with gradient and Hessian: see columns.h for the order of
 * operations. The reference is formulas/gradient.h.
 *
 *     n(t) = sum over corners c of W_c(t) g_c . (t - c)
 *
 * with W the products of the fades. The derivatives interpolate the corner gradients too.
 */
#ifndef SCARP_KERNEL_BASIS_GRADIENT_H
#define SCARP_KERNEL_BASIS_GRADIENT_H

#include "columns.h"

/* 16 directions, 11.25 degrees + k * 22.5: cosines and sines of 11.25, 33.75, 56.25 and 78.75, as
   the bits of floats. */
#define COS_1 0x3f7b14beu /* 0.980785280f */
#define COS_3 0x3f54db31u /* 0.831469612f */
#define COS_5 0x3f0e39dau /* 0.555570233f */
#define COS_7 0x3e47c5c2u /* 0.195090322f */

static const struct lookup gradient2_x = LOOKUP_TABLE_HIGH(COS_1, COS_3, COS_5, COS_7);
static const struct lookup gradient2_y = LOOKUP_TABLE_LOW(COS_7, COS_5, COS_3, COS_1);

/* The 12 edges of a cube, with components of 0 and +-2, of which only the top byte is not 0. */
#define P LOOKUP_PLUS_2
#define N LOOKUP_MINUS_2
static const struct lookup_top gradient3_x = LOOKUP_TOP(P, P, N, N, P, P, N, N, 0, 0, 0, 0);
static const struct lookup_top gradient3_y = LOOKUP_TOP(P, N, P, N, 0, 0, 0, 0, P, P, N, N);
static const struct lookup_top gradient3_z = LOOKUP_TOP(0, 0, 0, 0, P, N, P, N, P, N, P, N);
#undef P
#undef N

/* Whether dot products come from tables. Those of values do: where there are derivatives, the
   components along y and z have to be looked up all the same. */
VEC_INLINE int takes_dots(const struct across *p, struct variant v)
{
    return VEC_DOTS && p->has_dots && v.order == 0 && !v.flows;
}

/* The gradients at the two corners of a column, and their dot products along y. */
struct gradients2 {
    vf x0, y0, x1, y1;
    vf dot0, dot1;
};

/* The table of dot products along y at that y, for vf_among with the upper four bits of hashes. Of
   16 gradients, the first eight have the same components as the others. */
VEC_INLINE vf dots2(vf y)
{
    return vf_load((const float *)gradient2_y.entry) * y;
}

/* Makes the dot products where they do not come from tables. */
VEC_INLINE void multiply_out(struct gradients2 *g, const struct across *p)
{
    g->dot0 = g->y0 * p->y;
    g->dot1 = g->y1 * p->v.s;
}

VEC_INLINE struct column gradient_column2(struct gradients2 g, struct fade f, struct variant v)
{
    const vf dgx = g.x1 - g.x0;
    const vf ddot = g.dot1 - g.dot0;
    struct column c;
    c.value.a = g.x0 + f.u * dgx;
    c.value.b = g.dot0 + f.u * ddot;
    if (v.order >= 1) {
        const vf dgy = g.y1 - g.y0;
        c.y.a = f.du * dgx;
        c.y.b = (g.y0 + f.u * dgy) + f.du * ddot;
        if (v.order >= 2) {
            c.yy.a = f.ddu * dgx;
            c.yy.b = 2.0f * f.du * dgy + f.ddu * ddot;
        }
    }
    return c;
}

/* Looks up the gradients of one column. */
VEC_INLINE struct gradients2 gradients2_of(const struct corners *h, const struct across *p,
                                           struct variant v)
{
    const vu h0 = h->h[0][0], h1 = h->h[1][0];
    struct gradients2 g;
    if (v.flows) {
        const vf_sixteen *const x = &p->directions->of[0], *const y = &p->directions->of[1];
        g.x0 = vf_sixteen_odd(x, h0), g.y0 = vf_sixteen_odd(y, h0);
        g.x1 = vf_sixteen_odd(x, h1), g.y1 = vf_sixteen_odd(y, h1);
    } else {
        g.x0 = vf_lookup(&gradient2_x, h0), g.y0 = vf_lookup(&gradient2_y, h0);
        g.x1 = vf_lookup(&gradient2_x, h1), g.y1 = vf_lookup(&gradient2_y, h1);
    }
    if (takes_dots(p, v)) {
        g.dot0 = vf_among(p->dots[0][0], h0 >> 28), g.dot1 = vf_among(p->dots[1][0], h1 >> 28);
    } else {
        multiply_out(&g, p);
    }
    return g;
}

/* Looks up four vectors along axis 0 or 1. */
VEC_INLINE struct vf_four gradients2_along(int axis, const vu h[4], const struct across *p,
                                           struct variant v)
{
    if (v.flows) {
        return vf_sixteen_odd_four(&p->directions->of[axis], h);
    }
    return vf_lookup_four(axis == 0 ? &gradient2_x : &gradient2_y, h);
}

/* Looks up those of both columns of a cell together; y first, since its products take longer to
   reach the sums. */
VEC_INLINE void gradients2_of_both(struct gradients2 of[2], const struct corners *l,
                                   const struct corners *r, const struct across *p,
                                   struct variant v)
{
    const vu h[4] = {l->h[0][0], l->h[1][0], r->h[0][0], r->h[1][0]};
    const struct vf_four y = gradients2_along(1, h, p, v);
    const struct vf_four x = gradients2_along(0, h, p, v);
    for (int i = 0; i < 2; i++) {
        of[i].x0 = x.v[2 * i], of[i].y0 = y.v[2 * i];
        of[i].x1 = x.v[2 * i + 1], of[i].y1 = y.v[2 * i + 1];
        multiply_out(&of[i], p);
    }
}

/* The gradients at the two corners of an edge along z, and their dot products along y and z if
   these come from tables. */
struct gradients3 {
    vf x0, x1, y0, y1, z0, z1;
    vf dot0, dot1;
};

/* Tables of dot products have one for each gradient or, with eight lanes, one for each of the eight
   different pairs of components along y and z. */
#if VEC_LANES == 8
static const struct lookup_top gradient3_pair = LOOKUP_TOP(0, 1, 0, 1, 2, 3, 2, 3, 4, 5, 6, 7);
static const float dots_y[] = {2, -2, 0, 0, 2, 2, -2, -2};
static const float dots_z[] = {0, 0, 2, -2, 2, -2, 2, -2};
#else
static const float dots_y[16] = {2, -2, 2, -2, 0, 0, 0, 0, 2, 2, -2, -2};
static const float dots_z[16] = {0, 0, 0, 0, 2, -2, 2, -2, 2, -2, 2, -2};
#endif

/* The number of a gradient in them, from what vu_top_index makes. */
VEC_INLINE vu dot_number(vu index)
{
#if VEC_LANES == 8
    return (vu)vf_lookup_top(&gradient3_pair, index) >> 24;
#else
    return index >> 24;
#endif
}

/* The table of dot products along y and z at that y and z, in the order of product_plus(). */
VEC_INLINE vf dots3(vf y, vf z)
{
    return vf_exact_fma(vf_load(dots_z), z, vf_load(dots_y) * y);
}

/* Looks up those of an edge, whose hashes are `h`: of the one on side y of the column. */
VEC_INLINE struct gradients3 gradients3_of(const vu h[2], int y, const struct across *p,
                                           struct variant v)
{
    if (v.flows) {
        const vf_sixteen *const of = p->directions->of;
        const vu i0 = vu_twelfth(h[0]), i1 = vu_twelfth(h[1]);
        struct gradients3 g;
        g.x0 = vf_sixteen_of(&of[0], i0), g.x1 = vf_sixteen_of(&of[0], i1);
        g.y0 = vf_sixteen_of(&of[1], i0), g.y1 = vf_sixteen_of(&of[1], i1);
        g.z0 = vf_sixteen_of(&of[2], i0), g.z1 = vf_sixteen_of(&of[2], i1);
        return g;
    }
    const vu i0 = vu_top_index(h[0]), i1 = vu_top_index(h[1]);
    struct gradients3 g;
    g.x0 = vf_lookup_top(&gradient3_x, i0), g.x1 = vf_lookup_top(&gradient3_x, i1);
    g.y0 = vf_lookup_top(&gradient3_y, i0), g.y1 = vf_lookup_top(&gradient3_y, i1);
    g.z0 = vf_lookup_top(&gradient3_z, i0), g.z1 = vf_lookup_top(&gradient3_z, i1);
    if (takes_dots(p, v)) {
        g.dot0 = vf_among(p->dots[y][0], dot_number(i0));
        g.dot1 = vf_among(p->dots[y][1], dot_number(i1));
    }
    return g;
}

/* Looks up those of both edges of a column together. */
VEC_INLINE void gradients3_turned_four(struct gradients3 g[2], const struct corners *h,
                                       const vf_sixteen of[3])
{
    const vu index[4] = {vu_twelfth(h->h[0][0]), vu_twelfth(h->h[0][1]), vu_twelfth(h->h[1][0]),
                         vu_twelfth(h->h[1][1])};
    const struct vf_four x = vf_sixteen_four(&of[0], index);
    const struct vf_four y = vf_sixteen_four(&of[1], index);
    const struct vf_four z = vf_sixteen_four(&of[2], index);
    for (int i = 0; i < 2; i++) {
        g[i].x0 = x.v[2 * i], g[i].x1 = x.v[2 * i + 1];
        g[i].y0 = y.v[2 * i], g[i].y1 = y.v[2 * i + 1];
        g[i].z0 = z.v[2 * i], g[i].z1 = z.v[2 * i + 1];
    }
}

/* a b + c, where the product is exact unless the variant flows. */
VEC_INLINE vf product_plus(vf a, vf b, vf c, struct variant v)
{
    return v.flows ? a * b + c : vf_exact_fma(a, b, c);
}

/* The lattice edge along z at one x and y, interpolated over z. */
struct edge {
    struct line value; /* in x */
    vf z, zz;          /* first and second z derivative of value.b */
    vf gy, dgy;        /* y component of the gradient, and its z derivative */
    vf dgx;            /* difference of the x components of the corners */
};

/* The edge on side y of the column. */
VEC_INLINE struct edge gradient_edge(struct gradients3 g, int y, const struct across *p,
                                     struct variant v)
{
    const struct fade w = p->w;
    const vf at = y == 0 ? p->y : p->v.s;
    const int found = takes_dots(p, v);
    const vf dot0 = found ? g.dot0 : product_plus(g.z0, p->z, g.y0 * at, v);
    const vf dot1 = found ? g.dot1 : product_plus(g.z1, w.s, g.y1 * at, v);
    const vf ddot = dot1 - dot0;
    struct edge e;
    e.dgx = g.x1 - g.x0;
    e.value.a = product_plus(w.u, e.dgx, g.x0, v);
    e.value.b = dot0 + w.u * ddot;
    if (v.order >= 1) {
        const vf dgy = g.y1 - g.y0;
        const vf dgz = g.z1 - g.z0;
        e.gy = product_plus(w.u, dgy, g.y0, v);
        e.z = product_plus(w.u, dgz, g.z0, v) + w.du * ddot;
        if (v.order >= 2) {
            e.dgy = w.du * dgy;
            e.zz = product_plus(2.0f * w.du, dgz, w.ddu * ddot, v);
        }
    }
    return e;
}

VEC_INLINE struct column gradient_column3(const struct corners *h, const struct across *p,
                                          struct variant variant)
{
    const int order = variant.order;
    const struct fade v = p->v, w = p->w;
    struct edge e0, e1;
    if (variant.flows && VF_SIXTEEN_FOUR) {
        struct gradients3 g[2];
        gradients3_turned_four(g, h, p->directions->of);
        e0 = gradient_edge(g[0], 0, p, variant);
        e1 = gradient_edge(g[1], 1, p, variant);
    } else { /* one after the other, so that registers suffice */
        e0 = gradient_edge(gradients3_of(h->h[0], 0, p, variant), 0, p, variant);
        e1 = gradient_edge(gradients3_of(h->h[1], 1, p, variant), 1, p, variant);
    }
    const vf da = e1.value.a - e0.value.a;
    const vf db = e1.value.b - e0.value.b;
    struct column c;
    c.value.a = e0.value.a + v.u * da;
    c.value.b = e0.value.b + v.u * db;
    if (order >= 1) {
        const vf dgy = e1.gy - e0.gy;
        const vf dz = e1.z - e0.z;
        const vf ddgx = e1.dgx - e0.dgx;
        const vf dgx = e0.dgx + v.u * ddgx;
        c.y.a = v.du * da;
        c.y.b = (e0.gy + v.u * dgy) + v.du * db;
        c.z.a = w.du * dgx;
        c.z.b = e0.z + v.u * dz;
        if (order >= 2) {
            c.yy.a = v.ddu * da;
            c.yy.b = 2.0f * v.du * dgy + v.ddu * db;
            c.yz.a = v.du * (w.du * ddgx);
            c.yz.b = mix(e0.dgy, e1.dgy, v.u) + v.du * dz;
            c.zz.a = w.ddu * dgx;
            c.zz.b = mix(e0.zz, e1.zz, v.u);
        }
    }
    return c;
}

VEC_INLINE struct column gradient_column(const struct corners *h, const struct across *p,
                                         struct variant v)
{
    return v.dimensions == 2 ? gradient_column2(gradients2_of(h, p, v), p->v, v)
                             : gradient_column3(h, p, v);
}

#endif
