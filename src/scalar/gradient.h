/* SPDX-License-Identifier: MIT
 *
 * Reference: gradient noise (Perlin 1985, 2002).
 *
 *     n(t) = sum over corners c of W_c(t) g_c . (t - c)
 *
 * with W the products of the fades; columns.h has the order of operations, tests/oracle_basis.c the
 * published form. Included by basis.h.
 */
#ifndef SCARP_SCALAR_GRADIENT_H
#define SCARP_SCALAR_GRADIENT_H

#include "columns.h"

/* The 16 directions 11.25 degrees + k * 22.5: cosine and sine. Bit 3 of the index is the sign of x,
   bit 0 that of y. */
#define COS_1 0.980785280f /* cos 11.25 */
#define COS_3 0.831469612f /* cos 33.75 */
#define COS_5 0.555570233f /* cos 56.25 */
#define COS_7 0.195090322f /* cos 78.75 */

static const float directions2[16][2] = {
    {COS_1, COS_7},  {COS_1, -COS_7},  {COS_3, COS_5},  {COS_3, -COS_5},
    {COS_5, COS_3},  {COS_5, -COS_3},  {COS_7, COS_1},  {COS_7, -COS_1},
    {-COS_1, COS_7}, {-COS_1, -COS_7}, {-COS_3, COS_5}, {-COS_3, -COS_5},
    {-COS_5, COS_3}, {-COS_5, -COS_3}, {-COS_7, COS_1}, {-COS_7, -COS_1},
};

/* The 12 edges of a cube, the directions of improved noise (Perlin 2002), which draws four of them
   twice as often. Here the upper half of the hash, times 12, chooses: any two are drawn equally
   often within 1 in 5461, so that the noise is the same along all axes. The edges are twice as long
   as Perlin's, because then only the top byte of each component is not 0, and tables of bytes
   serve; products are exact. */
static const float directions3[12][3] = {
    {2, 2, 0},  {2, -2, 0},  {-2, 2, 0}, {-2, -2, 0}, {2, 0, 2},  {2, 0, -2},
    {-2, 0, 2}, {-2, 0, -2}, {0, 2, 2},  {0, 2, -2},  {0, -2, 2}, {0, -2, -2},
};

/* What directions become after a quarter of a turn (scarp.h, "Flow"): in 3D d x g / |d|, with |d| =
   sqrt(3), which is 2 / sqrt(3) times these. */
static const float quarters3[12][3] = {
    {1, -1, 2}, {1, 1, -2}, {-1, -1, -2}, {-1, 1, 2}, {-1, 2, 1},   {-1, -2, -1},
    {1, -2, 1}, {1, 2, -1}, {2, 1, -1},   {-2, 1, 1}, {-2, -1, -1}, {2, -1, 1},
};
#define TWO_OVER_ROOT_3 1.15470054f

/* The number of the direction that a hash draws. */
static inline uint32_t direction_index2(uint32_t hash)
{
    return hash >> 28;
}

static inline uint32_t direction_index3(uint32_t hash)
{
    return (hash >> 16) * 12 >> 16;
}

/* Whether a direction makes two turns per turn of the phase, in 2D backwards. */
static inline int is_quick2(uint32_t i)
{
    return (i ^ i >> 1 ^ i >> 3) & 1;
}

static inline int is_quick3(uint32_t i)
{
    return i == 2 || i == 3 || i == 4 || i == 5 || i == 8 || i == 11;
}

struct direction {
    float of[3];
};

/* `turn` are cosines and sines as in struct scarp_octave; NULL: the directions are at rest, which
   is what they are after no angle, too. */
static inline struct direction direction2(const float *turn, uint32_t hash)
{
    const uint32_t drawn = direction_index2(hash);
    if (turn == NULL) {
        return (struct direction){{directions2[drawn][0], directions2[drawn][1]}};
    }
    const uint32_t i = drawn < 8 ? drawn : drawn ^ 9; /* the opposite direction */
    const float *const g = directions2[i];
    const float quarter[2] = {is_quick2(i) ? g[1] : -g[1], is_quick2(i) ? -g[0] : g[0]};
    const float *const t = &turn[is_quick2(i) ? 2 : 0];
    struct direction d = {{0.0f}};
    for (int axis = 0; axis < 2; axis++) {
        const float turned = t[0] * g[axis] + t[1] * quarter[axis];
        d.of[axis] = drawn < 8 ? turned : -turned;
    }
    return d;
}

static inline struct direction direction3(const float *turn, uint32_t hash)
{
    const uint32_t i = direction_index3(hash);
    if (turn == NULL) {
        return (struct direction){{directions3[i][0], directions3[i][1], directions3[i][2]}};
    }
    const float *const t = &turn[is_quick3(i) ? 2 : 0];
    struct direction d;
    for (int axis = 0; axis < 3; axis++) {
        d.of[axis] = t[0] * directions3[i][axis] + t[1] * (TWO_OVER_ROOT_3 * quarters3[i][axis]);
    }
    return d;
}

/* The lattice that draws directions: its keys, and how far they are turned. */
struct turning {
    const uint32_t *key;
    const float *turn;
};

/* Column x of the cell: v is the fade along y. */
static inline struct column gradient_column2(struct turning lattice, uint32_t x,
                                             const struct place *p, struct fade v)
{
    const struct direction d0 = direction2(lattice.turn, hash2(lattice.key, x, p->cell[1][0]));
    const struct direction d1 = direction2(lattice.turn, hash2(lattice.key, x, p->cell[1][1]));
    const float *const g0 = d0.of, *const g1 = d1.of;
    const float y = p->t[1];
    const float dgx = g1[0] - g0[0];
    const float dot0 = g0[1] * y;
    const float dot1 = g1[1] * (y - 1.0f);
    const float ddot = dot1 - dot0;
    const struct column c = {
        .value = {g0[0] + v.u * dgx, dot0 + v.u * ddot},
        .y = {v.du * dgx, mix(g0[1], g1[1], v.u) + v.du * ddot},
        .yy = {v.ddu * dgx, 2.0f * v.du * (g1[1] - g0[1]) + v.ddu * ddot},
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

/* The edge at column x on the lower or upper side of the cell along y, w being the fade along z. */
static inline struct edge gradient_edge(struct turning lattice, uint32_t x, const struct place *p,
                                        int side, struct fade w)
{
    const uint32_t y = p->cell[1][side], *const z = p->cell[2];
    const struct direction d0 = direction3(lattice.turn, hash3(lattice.key, x, y, z[0]));
    const struct direction d1 = direction3(lattice.turn, hash3(lattice.key, x, y, z[1]));
    const float *const g0 = d0.of, *const g1 = d1.of;
    const float ty = p->t[1] - (float)side, tz = p->t[2];
    const float dgx = g1[0] - g0[0];
    const float dgy = g1[1] - g0[1];
    const float dgz = g1[2] - g0[2];
    const float dot0 = g0[1] * ty + g0[2] * tz;
    const float dot1 = g1[1] * ty + g1[2] * (tz - 1.0f);
    const float ddot = dot1 - dot0;
    const struct edge e = {
        .value = {g0[0] + w.u * dgx, dot0 + w.u * ddot},
        .z = (g0[2] + w.u * dgz) + w.du * ddot,
        .zz = 2.0f * w.du * dgz + w.ddu * ddot,
        .gy = g0[1] + w.u * dgy,
        .dgy = w.du * dgy,
        .dgx = dgx,
    };
    return e;
}

static inline struct column gradient_column3(struct turning lattice, uint32_t x,
                                             const struct place *p, struct fade v, struct fade w)
{
    const struct edge e0 = gradient_edge(lattice, x, p, 0, w);
    const struct edge e1 = gradient_edge(lattice, x, p, 1, w);
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

static inline struct column gradient_column(struct turning lattice, uint32_t x,
                                            const struct place *p, enum scarp_fade kind,
                                            int dimensions)
{
    const struct fade v = fade(kind, p->t[1]);
    return dimensions == 2 ? gradient_column2(lattice, x, p, v)
                           : gradient_column3(lattice, x, p, v, fade(kind, p->t[2]));
}

#endif
