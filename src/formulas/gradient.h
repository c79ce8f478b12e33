/* SPDX-License-Identifier: MIT
 *
 * Formulas: gradient noise (Perlin 1985, 2002).
 *
 *     n(t) = sum over corners c of W_c(t) g_c . (t - c)
 *
 * with W the products of the fades; corners.h has the order of operations, tests/oracle_basis.c the
 * published form. direction2() and direction3() give the directions, quarter3() what they become
 * after a quarter of a turn: C has tables, shaders compute them, since their memory is slower.
 */
#ifndef SCARP_FORMULAS_GRADIENT_H
#define SCARP_FORMULAS_GRADIENT_H

#include "corners.h"

/* The number of the direction that a hash draws. In 3D the upper half of the hash, times 12,
   chooses: any two are drawn equally often within 1 in 5461, so that the noise is the same along
   all axes. */
static inline uint direction_index2(uint hash)
{
    return hash >> 28;
}

static inline uint direction_index3(uint hash)
{
    return (hash >> 16) * 12 >> 16;
}

/* A direction of noise that flows: some make two turns per turn of the phase, in 2D backwards. */
static inline vec3 turned2(uint drawn, vec4 turn)
{
    const bool is_opposite = drawn >= 8;
    const uint i = is_opposite ? drawn ^ 9 : drawn;
    const bool is_quick = ((i ^ i >> 1 ^ i >> 3) & 1) != 0;
    const vec3 g = direction2(i);
    const float c = either(is_quick, turn.z, turn.x);
    const float s = either(is_quick, -turn.w, turn.y);
    const float x = c * g.x - s * g.y;
    const float y = c * g.y + s * g.x;
    return vec3_of(is_opposite ? -x : x, is_opposite ? -y : y, 0.0f);
}

static inline vec3 turned3(uint i, vec4 turn)
{
    const bool is_quick = (0x93c >> i & 1) != 0; /* 2, 3, 4, 5, 8 and 11 */
    const float c = either(is_quick, turn.z, turn.x);
    const float s = either(is_quick, turn.w, turn.y);
    return add3(mul3(c, direction3(i)), mul3(s, quarter3(i)));
}

static inline vec3 drawn2(struct lattice l, uint x, uint y)
{
    const uint i = direction_index2(component_hash2(hash2(l.key, x, y), l.component));
    vec3 g = direction2(i);
    if (l.flows) {
        g = turned2(i, l.turn);
    }
    return g;
}

static inline vec3 drawn3(struct lattice l, uint x, uint y, uint z)
{
    const uint i = direction_index3(component_hash3(hash3(l.key, x, y, z), l.component));
    vec3 g = direction3(i);
    if (l.flows) {
        g = turned3(i, l.turn);
    }
    return g;
}

/* Column x of the cell: v is the fade along y. */
static inline struct column gradient_column2(struct lattice l, uint x, struct location p,
                                             struct fade v)
{
    const vec3 g0 = drawn2(l, x, p.cell.y);
    const vec3 g1 = drawn2(l, x, p.next.y);
    const float dgx = g1.x - g0.x;
    const float dot0 = g0.y * p.t.y;
    const float dot1 = g1.y * (p.t.y - 1.0f);
    const float ddot = dot1 - dot0;
    const struct column c = {
        .value = {g0.x + v.u * dgx, dot0 + v.u * ddot},
        .y = {v.du * dgx, mix(g0.y, g1.y, v.u) + v.du * ddot},
        .yy = {v.ddu * dgx, 2.0f * v.du * (g1.y - g0.y) + v.ddu * ddot},
    };
    return c;
}

/* A lattice edge along z, interpolated over z. */
struct edge {
    struct line value; /* in x */
    float z, zz;       /* first and second z derivative of value.b */
    float gy, dgy;     /* y component of the gradient, and its z derivative */
    float dgx;         /* difference of the x components of the corners */
};

/* The edge at column x and row y of cells, ty from it along y; w is the fade along z. */
static inline struct edge gradient_edge(struct lattice l, uint x, uint y, float ty,
                                        struct location p, struct fade w)
{
    const vec3 g0 = drawn3(l, x, y, p.cell.z);
    const vec3 g1 = drawn3(l, x, y, p.next.z);
    const vec3 dg = sub3(g1, g0);
    const float dot0 = g0.y * ty + g0.z * p.t.z;
    const float dot1 = g1.y * ty + g1.z * (p.t.z - 1.0f);
    const float ddot = dot1 - dot0;
    const struct edge e = {
        .value = {g0.x + w.u * dg.x, dot0 + w.u * ddot},
        .z = (g0.z + w.u * dg.z) + w.du * ddot,
        .zz = 2.0f * w.du * dg.z + w.ddu * ddot,
        .gy = g0.y + w.u * dg.y,
        .dgy = w.du * dg.y,
        .dgx = dg.x,
    };
    return e;
}

static inline struct column gradient_column3(struct lattice l, uint x, struct location p,
                                             struct fade v, struct fade w)
{
    const struct edge e0 = gradient_edge(l, x, p.cell.y, p.t.y, p, w);
    const struct edge e1 = gradient_edge(l, x, p.next.y, p.t.y - 1.0f, p, w);
    const float da = e1.value.a - e0.value.a;
    const float db = e1.value.b - e0.value.b;
    const float dgy = e1.gy - e0.gy;
    const float dz = e1.z - e0.z;
    const float ddgx = e1.dgx - e0.dgx;
    const float dgx = e0.dgx + v.u * ddgx; /* interpolated over y */
    const struct column c = {
        .value = {e0.value.a + v.u * da, e0.value.b + v.u * db},
        .y = {v.du * da, (e0.gy + v.u * dgy) + v.du * db},
        .z = {w.du * dgx, e0.z + v.u * dz},
        .yy = {v.ddu * da, 2.0f * v.du * dgy + v.ddu * db},
        .yz = {v.du * (w.du * ddgx), mix(e0.dgy, e1.dgy, v.u) + v.du * dz},
        .zz = {w.ddu * dgx, mix(e0.zz, e1.zz, v.u)},
    };
    return c;
}

static inline struct sample gradient_at2(struct lattice l, uint kind, struct location p)
{
    const struct fade v = fade(kind, p.t.y);
    return join(gradient_column2(l, p.cell.x, p, v), gradient_column2(l, p.next.x, p, v), p.t.x,
                fade(kind, p.t.x), false);
}

static inline struct sample gradient_at3(struct lattice l, uint kind, struct location p)
{
    const struct fade v = fade(kind, p.t.y);
    const struct fade w = fade(kind, p.t.z);
    return join(gradient_column3(l, p.cell.x, p, v, w), gradient_column3(l, p.next.x, p, v, w),
                p.t.x, fade(kind, p.t.x), false);
}

static inline struct sample gradient_at(struct lattice l, uint kind, struct location p,
                                        int dimensions)
{
    if (dimensions == 2) {
        return gradient_at2(l, kind, p);
    }
    return gradient_at3(l, kind, p);
}

#endif
