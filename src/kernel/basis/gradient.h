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
VEC_INLINE struct gradients2 gradients2_of(const struct corners *h)
{
    const vu h0 = h->h[0][0], h1 = h->h[1][0];
    const struct gradients2 g = {vf_lookup(&gradient2_x, h0), vf_lookup(&gradient2_y, h0),
                                 vf_lookup(&gradient2_x, h1), vf_lookup(&gradient2_y, h1)};
    return g;
}

/* Looks up those of both columns of a cell together; y first, since its products take longer to
   reach the sums. */
VEC_INLINE void gradients2_of_both(struct gradients2 *left, struct gradients2 *right,
                                   const struct corners *l, const struct corners *r)
{
    const vu h[4] = {l->h[0][0], l->h[1][0], r->h[0][0], r->h[1][0]};
    const struct vf_four y = vf_lookup_four(&gradient2_y, h);
    const struct vf_four x = vf_lookup_four(&gradient2_x, h);
    const struct gradients2 g[2] = {{x.v[0], y.v[0], x.v[1], y.v[1]},
                                    {x.v[2], y.v[2], x.v[3], y.v[3]}};
    *left = g[0];
    *right = g[1];
}

/* The lattice edge along z at one x and y, interpolated over z. */
struct edge {
    struct line value; /* in x */
    vf z, zz;          /* first and second z derivative of value.b */
    vf gy, dgy;        /* y component of the gradient, and its z derivative */
    vf dgx;            /* difference of the x components of the corners */
};

/* `h` has the hashes of the edge's two ends; y is the place along y relative to them. */
VEC_INLINE struct edge gradient_edge(const vu h[2], vf y, vf z, struct fade w, int order)
{
    const vu i0 = vu_top_index(h[0]), i1 = vu_top_index(h[1]);
    const vf gx0 = vf_lookup_top(&gradient3_x, i0), gx1 = vf_lookup_top(&gradient3_x, i1);
    const vf gy0 = vf_lookup_top(&gradient3_y, i0), gy1 = vf_lookup_top(&gradient3_y, i1);
    const vf gz0 = vf_lookup_top(&gradient3_z, i0), gz1 = vf_lookup_top(&gradient3_z, i1);
    const vf dot0 = vf_exact_fma(gz0, z, gy0 * y);
    const vf dot1 = vf_exact_fma(gz1, w.s, gy1 * y);
    const vf ddot = dot1 - dot0;
    struct edge e;
    e.dgx = gx1 - gx0;
    e.value.a = vf_exact_fma(w.u, e.dgx, gx0);
    e.value.b = dot0 + w.u * ddot;
    if (order >= 1) {
        const vf dgy = gy1 - gy0;
        const vf dgz = gz1 - gz0;
        e.gy = vf_exact_fma(w.u, dgy, gy0);
        e.z = vf_exact_fma(w.u, dgz, gz0) + w.du * ddot;
        if (order >= 2) {
            e.dgy = w.du * dgy;
            e.zz = vf_exact_fma(2.0f * w.du, dgz, w.ddu * ddot);
        }
    }
    return e;
}

VEC_INLINE struct column gradient_column3(const struct corners *h, const struct across *p,
                                          struct variant variant)
{
    const int order = variant.order;
    const struct fade v = p->v, w = p->w;
    const struct edge e0 = gradient_edge(h->h[0], p->y, p->z, w, order);
    const struct edge e1 = gradient_edge(h->h[1], v.s, p->z, w, order);
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
    return v.dimensions == 2 ? gradient_column2(gradients2_of(h), p, v) : gradient_column3(h, p, v);
}

#endif
