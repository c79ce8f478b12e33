/* SPDX-License-Identifier: MIT
 *
 * Shaders: gradient noise; as scalar/gradient.h, whose tables of directions are computed here,
 * since memory is slower than arithmetic. Included by value.h.
 */
#ifndef SCARP_GPU_GRADIENT_H
#define SCARP_GPU_GRADIENT_H

#include "corners.h"

/* The cosine of 11.25 degrees times 1, 3, 5, 7. */
static inline float cosine(uint i)
{
    const float first = i == 0u ? 0.980785280f : 0.831469612f;
    const float second = i == 2u ? 0.555570233f : 0.195090322f;
    return i < 2u ? first : second;
}

/* One of the 16 directions of the plane. */
static inline vec3 direction2(uint i)
{
    const uint k = (i >> 1u) & 3u;
    return vec3_of(with_bit(cosine(k), (i >> 3u) & 1u), with_bit(cosine(3u - k), i & 1u), 0.0f);
}

/* One of the 12 edges of a cube, twice as long: 0 along z, y or x. */
static inline vec3 direction3(uint i)
{
    const uint axes = i >> 2u;
    const float first = with_bit(2.0f, (i >> 1u) & 1u);
    const float second = with_bit(2.0f, i & 1u);
    return vec3_of(axes == 2u ? 0.0f : first, axes == 0u ? second : (axes == 1u ? 0.0f : first),
                   axes == 0u ? 0.0f : second);
}

/* An edge after a quarter of a turn: 1, 2, -1 or -2 along each axis, in two bits per edge. */
static inline float quarter3(uint axis, uint i)
{
    const uint bits = axis >> (2u * i);
    return with_bit((bits & 2u) != 0u ? 2.0f : 1.0f, bits & 1u);
}

#define QUARTERS_X 0xbe0550u
#define QUARTERS_Y 0x50be11u
#define QUARTERS_Z 0x1144beu
#define TWO_OVER_ROOT_3 1.15470054f

/* Of directions that flow, the cosine and the sine are those of the angle, or of twice that. */
static inline vec3 turned2(uint drawn, vec4 turn)
{
    const bool opposite = drawn >= 8u;
    const uint i = opposite ? drawn ^ 9u : drawn;
    const uint quick = (i ^ (i >> 1u) ^ (i >> 3u)) & 1u;
    const vec3 g = direction2(i);
    const float c = quick != 0u ? turn.z : turn.x;
    const float s = quick != 0u ? turn.w : turn.y;
    const float x = c * g.x + s * with_bit(g.y, 1u - quick);
    const float y = c * g.y + s * with_bit(g.x, quick);
    return vec3_of(opposite ? -x : x, opposite ? -y : y, 0.0f);
}

static inline vec3 turned3(uint i, vec4 turn)
{
    const bool quick = ((0x93cu >> i) & 1u) != 0u;
    const vec3 g = direction3(i);
    const vec3 q = mul3(TWO_OVER_ROOT_3, vec3_of(quarter3(QUARTERS_X, i), quarter3(QUARTERS_Y, i),
                                                 quarter3(QUARTERS_Z, i)));
    return add3(mul3(quick ? turn.z : turn.x, g), mul3(quick ? turn.w : turn.y, q));
}

/* What draws directions: the octave's keys, and how far directions are turned, if they are. */
struct turning {
    uvec3 key;
    vec4 turn;
    bool flows;
};

static inline vec3 drawn2(struct turning t, uint x, uint y)
{
    const uint i = hash2(t.key, x, y) >> 28u;
    vec3 g = direction2(i);
    if (t.flows) {
        g = turned2(i, t.turn);
    }
    return g;
}

static inline uint edge_of(uint hash)
{
    return ((hash >> 16u) * 12u) >> 16u;
}

static inline vec3 drawn3(struct turning t, uint x, uint y, uint z)
{
    const uint i = edge_of(hash3(t.key, x, y, z));
    vec3 g = direction3(i);
    if (t.flows) {
        g = turned3(i, t.turn);
    }
    return g;
}

/* Column x of the cell: v is the fade along y. */
static inline struct column gradient_column2(struct turning t, uint x, struct place p,
                                             struct fade v)
{
    const vec3 g0 = drawn2(t, x, p.cell.y);
    const vec3 g1 = drawn2(t, x, p.next.y);
    const vec3 dg = sub3(g1, g0);
    const float dot0 = g0.y * p.t.y;
    const float dot1 = g1.y * (p.t.y - 1.0f);
    const float ddot = dot1 - dot0;
    struct column c;
    c.value = slope_of(g0.x + v.u * dg.x, dot0 + v.u * ddot);
    c.y = slope_of(v.du * dg.x, mix(g0.y, g1.y, v.u) + v.du * ddot);
    c.yy = slope_of(v.ddu * dg.x, 2.0f * v.du * dg.y + v.ddu * ddot);
    c.z = slope_of(0.0f, 0.0f);
    c.yz = slope_of(0.0f, 0.0f);
    c.zz = slope_of(0.0f, 0.0f);
    return c;
}

/* A lattice edge along z, interpolated over z; z and zz are derivatives of value.b, dgy is that of
   gy, dgx the difference of the corners. */
struct edge {
    struct slope value;
    float z;
    float zz;
    float gy;
    float dgy;
    float dgx;
};

/* The edge at column x and row y of cells, ty from it along y; w is the fade along z. */
static inline struct edge gradient_edge(struct turning t, uint x, uint y, float ty, struct place p,
                                        struct fade w)
{
    const vec3 g0 = drawn3(t, x, y, p.cell.z);
    const vec3 g1 = drawn3(t, x, y, p.next.z);
    const vec3 dg = sub3(g1, g0);
    const float dot0 = g0.y * ty + g0.z * p.t.z;
    const float dot1 = g1.y * ty + g1.z * (p.t.z - 1.0f);
    const float ddot = dot1 - dot0;
    struct edge e;
    e.value = slope_of(g0.x + w.u * dg.x, dot0 + w.u * ddot);
    e.z = g0.z + w.u * dg.z + w.du * ddot;
    e.zz = 2.0f * w.du * dg.z + w.ddu * ddot;
    e.gy = g0.y + w.u * dg.y;
    e.dgy = w.du * dg.y;
    e.dgx = dg.x;
    return e;
}

static inline struct column gradient_column3(struct turning t, uint x, struct place p,
                                             struct fade v, struct fade w)
{
    const struct edge e0 = gradient_edge(t, x, p.cell.y, p.t.y, p, w);
    const struct edge e1 = gradient_edge(t, x, p.next.y, p.t.y - 1.0f, p, w);
    const float da = e1.value.a - e0.value.a;
    const float db = e1.value.b - e0.value.b;
    const float dgy = e1.gy - e0.gy;
    const float dz = e1.z - e0.z;
    const float ddgx = e1.dgx - e0.dgx;
    const float dgx = e0.dgx + v.u * ddgx;
    struct column c;
    c.value = slope_of(e0.value.a + v.u * da, e0.value.b + v.u * db);
    c.y = slope_of(v.du * da, e0.gy + v.u * dgy + v.du * db);
    c.z = slope_of(w.du * dgx, e0.z + v.u * dz);
    c.yy = slope_of(v.ddu * da, 2.0f * v.du * dgy + v.ddu * db);
    c.yz = slope_of(v.du * (w.du * ddgx), mix(e0.dgy, e1.dgy, v.u) + v.du * dz);
    c.zz = slope_of(w.ddu * dgx, mix(e0.zz, e1.zz, v.u));
    return c;
}

static inline struct sample gradient_at(struct octave o, struct level l, struct place p,
                                        int dimensions)
{
    const struct fade f = fade(l.fade, p.t.x);
    const struct fade v = fade(l.fade, p.t.y);
    struct turning t;
    struct column left;
    struct column right;
    t.key = o.key;
    t.turn = o.turn;
    t.flows = l.flows != 0u;
    if (dimensions == 2) {
        left = gradient_column2(t, p.cell.x, p, v);
        right = gradient_column2(t, p.next.x, p, v);
    } else {
        const struct fade w = fade(l.fade, p.t.z);
        left = gradient_column3(t, p.cell.x, p, v, w);
        right = gradient_column3(t, p.next.x, p, v, w);
    }
    return join(left, right, p.t.x, f, false);
}

#endif
