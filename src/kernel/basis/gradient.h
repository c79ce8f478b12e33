/* SPDX-License-Identifier: MIT
 *
 * Gradient noise (Perlin 1985, 2002) with gradient and Hessian: see columns.h for the order of
 * operations. Included by basis.h; the reference is scalar/gradient.h.
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

/* The gradients at the two corners of a column. */
struct gradients2 {
    vf x0, y0, x1, y1;
};

VEC_INLINE struct column gradient_column2(struct gradients2 g, const struct across *p,
                                          struct variant v)
{
    const struct fade f = p->v;
    const vf gx0 = g.x0, gy0 = g.y0, gx1 = g.x1, gy1 = g.y1;
    const vf dgx = gx1 - gx0;
    const vf dot0 = gy0 * p->y;
    const vf dot1 = gy1 * f.s;
    const vf ddot = dot1 - dot0;
    struct column c;
    c.value.a = gx0 + f.u * dgx;
    c.value.b = dot0 + f.u * ddot;
    if (v.order >= 1) {
        const vf dgy = gy1 - gy0;
        c.y.a = f.du * dgx;
        c.y.b = (gy0 + f.u * dgy) + f.du * ddot;
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
    if (v.flows) {
        const vf_sixteen *const x = &p->directions->of[0], *const y = &p->directions->of[1];
        const struct gradients2 g = {vf_sixteen_odd(x, h0), vf_sixteen_odd(y, h0),
                                     vf_sixteen_odd(x, h1), vf_sixteen_odd(y, h1)};
        return g;
    }
    const struct gradients2 g = {vf_lookup(&gradient2_x, h0), vf_lookup(&gradient2_y, h0),
                                 vf_lookup(&gradient2_x, h1), vf_lookup(&gradient2_y, h1)};
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
    const struct gradients2 g[2] = {{x.v[0], y.v[0], x.v[1], y.v[1]},
                                    {x.v[2], y.v[2], x.v[3], y.v[3]}};
    of[0] = g[0];
    of[1] = g[1];
}

/* The gradients at the two corners of an edge along z. */
struct gradients3 {
    vf x0, x1, y0, y1, z0, z1;
};

/* Looks up those of an edge, whose hashes are `h`. */
VEC_INLINE struct gradients3 gradients3_of(const vu h[2], const struct across *p, struct variant v)
{
    if (v.flows) {
        const vf_sixteen *const of = p->directions->of;
        const vu i0 = vu_twelfth(h[0]), i1 = vu_twelfth(h[1]);
        const struct gradients3 g = {
            vf_sixteen_of(&of[0], i0), vf_sixteen_of(&of[0], i1), vf_sixteen_of(&of[1], i0),
            vf_sixteen_of(&of[1], i1), vf_sixteen_of(&of[2], i0), vf_sixteen_of(&of[2], i1),
        };
        return g;
    }
    const vu i0 = vu_top_index(h[0]), i1 = vu_top_index(h[1]);
    const struct gradients3 g = {
        vf_lookup_top(&gradient3_x, i0), vf_lookup_top(&gradient3_x, i1),
        vf_lookup_top(&gradient3_y, i0), vf_lookup_top(&gradient3_y, i1),
        vf_lookup_top(&gradient3_z, i0), vf_lookup_top(&gradient3_z, i1),
    };
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
    const struct gradients3 found[2] = {{x.v[0], x.v[1], y.v[0], y.v[1], z.v[0], z.v[1]},
                                        {x.v[2], x.v[3], y.v[2], y.v[3], z.v[2], z.v[3]}};
    g[0] = found[0];
    g[1] = found[1];
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

/* y is the place along y relative to the edge. */
VEC_INLINE struct edge gradient_edge(struct gradients3 g, vf y, vf z, struct fade w,
                                     struct variant v)
{
    const vf dot0 = product_plus(g.z0, z, g.y0 * y, v);
    const vf dot1 = product_plus(g.z1, w.s, g.y1 * y, v);
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
        e0 = gradient_edge(g[0], p->y, p->z, w, variant);
        e1 = gradient_edge(g[1], v.s, p->z, w, variant);
    } else { /* one after the other, so that registers suffice */
        e0 = gradient_edge(gradients3_of(h->h[0], p, variant), p->y, p->z, w, variant);
        e1 = gradient_edge(gradients3_of(h->h[1], p, variant), v.s, p->z, w, variant);
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
    return v.dimensions == 2 ? gradient_column2(gradients2_of(h, p, v), p, v)
                             : gradient_column3(h, p, v);
}

#endif
