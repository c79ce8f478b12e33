/* SPDX-License-Identifier: MIT
 *
 * Reference: gradient noise and value noise of one octave, with gradient and Hessian in units of
 * cells. Included by axes.h only.
 *
 * Both interpolate over z, then y, then x. What does not depend on x is reduced, on the lattice
 * columns s = 0 and 1 at either side, to lines a_s (x - s) + b_s in the fraction x: one for the
 * value (left and right), one for each derivative along y and z. Then
 *
 *     value  = left + u(x) (right - left)
 *     d/dx   = a_0 + u (a_1 - a_0) + u' (right - left)
 *     d2/dx2 = 2 u' (a_1 - a_0) + u'' (right - left)
 *
 * and the derivatives along y and z follow from their lines in the same way. For value noise the
 * lines are constants (a = 0), and the terms with a are left away. These are the published closed
 * forms (Quilez' k0..k7; the corner gradients interpolated too for gradient noise) in another order
 * of operations; tests/oracle.c has them as published.
 */
#ifndef SCARP_SCALAR_BASIS_H
#define SCARP_SCALAR_BASIS_H

#include "fade.h"
#include "lattice.h"

/* A basis, or a sum of octaves, at one point. */
struct sample {
    float value, dx, dy, dz, dxx, dxy, dxz, dyy, dyz, dzz;
};

struct line {
    float a, b;
};

/* What a lattice column contributes. In 2D the members with a z stay unset. */
struct column {
    struct line value, y, z, yy, yz, zz;
};

SCALAR_INLINE float at(struct line line, float x)
{
    return line.a * x + line.b;
}

SCALAR_INLINE struct line mix_lines(struct line p, struct line q, float u)
{
    const struct line line = {mix(p.a, q.a, u), mix(p.b, q.b, u)};
    return line;
}

/* The value and its derivatives along x, from the lines of both columns. */
SCALAR_INLINE float across(struct line l, struct line r, float x, float u)
{
    return mix(at(l, x), at(r, x - 1.0f), u);
}

SCALAR_INLINE float across_dx(struct line l, struct line r, float x, struct fade f)
{
    return mix(l.a, r.a, f.u) + f.du * (at(r, x - 1.0f) - at(l, x));
}

SCALAR_INLINE float across_dxx(struct line l, struct line r, float x, struct fade f)
{
    return 2.0f * f.du * (r.a - l.a) + f.ddu * (at(r, x - 1.0f) - at(l, x));
}

SCALAR_INLINE struct sample join(const struct column *l, const struct column *r, float x,
                                 struct fade f, int dimensions, int order)
{
    struct sample s = {.value = across(l->value, r->value, x, f.u)};
    if (order >= 1) {
        s.dx = across_dx(l->value, r->value, x, f);
        s.dy = across(l->y, r->y, x, f.u);
        if (dimensions == 3) {
            s.dz = across(l->z, r->z, x, f.u);
        }
    }
    if (order >= 2) {
        s.dxx = across_dxx(l->value, r->value, x, f);
        s.dxy = across_dx(l->y, r->y, x, f);
        s.dyy = across(l->yy, r->yy, x, f.u);
        if (dimensions == 3) {
            s.dxz = across_dx(l->z, r->z, x, f);
            s.dyz = across(l->yz, r->yz, x, f.u);
            s.dzz = across(l->zz, r->zz, x, f.u);
        }
    }
    return s;
}

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
   often within 1 in 5461, so that the noise is the same along all axes. Twice as long as there,
   because then only the first byte of each component is not 0, and tables of bytes serve; products
   are exact. */
static const float directions3[12][3] = {
    {2, 2, 0},  {2, -2, 0},  {-2, 2, 0}, {-2, -2, 0}, {2, 0, 2},  {2, 0, -2},
    {-2, 0, 2}, {-2, 0, -2}, {0, 2, 2},  {0, 2, -2},  {0, -2, 2}, {0, -2, -2},
};

SCALAR_INLINE const float *direction2(uint32_t hash)
{
    return directions2[hash >> 28];
}

SCALAR_INLINE const float *direction3(uint32_t hash)
{
    return directions3[(hash >> 16) * 12 >> 16];
}

/* Column x of the cell: v is the fade along y. */
SCALAR_INLINE struct column gradient_column2(const uint32_t key[3], uint32_t x,
                                             const struct place *p, struct fade v)
{
    const float *const g0 = direction2(hash2(key, x, p->cell[1]));
    const float *const g1 = direction2(hash2(key, x, p->cell[1] + 1));
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

/* The lattice edge along z at (x, y): interpolated over z, w being the fade along z. */
struct edge {
    struct line value; /* in x */
    float z, zz;       /* first and second z derivative of value.b */
    float gy, dgy;     /* y component of the gradient, and its z derivative */
    float dgx;         /* difference of the x components of the corners */
};

SCALAR_INLINE struct edge gradient_edge(const uint32_t key[3], uint32_t x, uint32_t y, uint32_t z,
                                        float ty, float tz, struct fade w)
{
    const float *const g0 = direction3(hash3(key, x, y, z));
    const float *const g1 = direction3(hash3(key, x, y, z + 1));
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

SCALAR_INLINE struct column gradient_column3(const uint32_t key[3], uint32_t x,
                                             const struct place *p, struct fade v, struct fade w)
{
    const float y = p->t[1], z = p->t[2];
    const uint32_t *const cell = p->cell;
    const struct edge e0 = gradient_edge(key, x, cell[1], cell[2], y, z, w);
    const struct edge e1 = gradient_edge(key, x, cell[1] + 1, cell[2], y - 1.0f, z, w);
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

SCALAR_INLINE struct sample gradient2(const struct scarp_octave *o, const struct place *p,
                                      enum scarp_fade kind, int order)
{
    const struct fade v = fade(kind, p->t[1]);
    const struct column l = gradient_column2(o->key, p->cell[0], p, v);
    const struct column r = gradient_column2(o->key, p->cell[0] + 1, p, v);
    return join(&l, &r, p->t[0], fade(kind, p->t[0]), 2, order);
}

SCALAR_INLINE struct sample gradient3(const struct scarp_octave *o, const struct place *p,
                                      enum scarp_fade kind, int order)
{
    const struct fade v = fade(kind, p->t[1]);
    const struct fade w = fade(kind, p->t[2]);
    const struct column l = gradient_column3(o->key, p->cell[0], p, v, w);
    const struct column r = gradient_column3(o->key, p->cell[0] + 1, p, v, w);
    return join(&l, &r, p->t[0], fade(kind, p->t[0]), 3, order);
}

/* A lattice value, in units of 2^-31: the hash as a signed number, rounded to float. */
SCALAR_INLINE float lattice_value(uint32_t hash)
{
    return (float)(int32_t)hash;
}

/* What a lattice column contributes to value noise: nothing of it depends on x. */
struct value_column {
    float value, y, z, yy, yz, zz;
};

SCALAR_INLINE struct value_column value_column2(const uint32_t key[3], uint32_t x,
                                                const struct place *p, struct fade v)
{
    const float c0 = lattice_value(hash2(key, x, p->cell[1]));
    const float c1 = lattice_value(hash2(key, x, p->cell[1] + 1));
    const float d = c1 - c0;
    const struct value_column c = {.value = c0 + v.u * d, .y = v.du * d, .yy = v.ddu * d};
    return c;
}

SCALAR_INLINE struct value_column value_column3(const uint32_t key[3], uint32_t x,
                                                const struct place *p, struct fade v, struct fade w)
{
    const uint32_t y = p->cell[1], z = p->cell[2];
    const float c00 = lattice_value(hash3(key, x, y, z));
    const float c01 = lattice_value(hash3(key, x, y, z + 1));
    const float c10 = lattice_value(hash3(key, x, y + 1, z));
    const float c11 = lattice_value(hash3(key, x, y + 1, z + 1));
    const float dz0 = c01 - c00;
    const float dz1 = c11 - c10;
    const float e0 = c00 + w.u * dz0;
    const float e1 = c10 + w.u * dz1;
    const float dy = e1 - e0;
    const float ddz = dz1 - dz0;
    const float dz = dz0 + v.u * ddz; /* interpolated over y */
    const struct value_column c = {
        .value = e0 + v.u * dy,
        .y = v.du * dy,
        .z = w.du * dz,
        .yy = v.ddu * dy,
        .yz = v.du * (w.du * ddz),
        .zz = w.ddu * dz,
    };
    return c;
}

SCALAR_INLINE struct sample value_join(const struct value_column *l, const struct value_column *r,
                                       struct fade f, int dimensions, int order)
{
    struct sample s = {.value = mix(l->value, r->value, f.u)};
    if (order >= 1) {
        s.dx = f.du * (r->value - l->value);
        s.dy = mix(l->y, r->y, f.u);
        if (dimensions == 3) {
            s.dz = mix(l->z, r->z, f.u);
        }
    }
    if (order >= 2) {
        s.dxx = f.ddu * (r->value - l->value);
        s.dxy = f.du * (r->y - l->y);
        s.dyy = mix(l->yy, r->yy, f.u);
        if (dimensions == 3) {
            s.dxz = f.du * (r->z - l->z);
            s.dyz = mix(l->yz, r->yz, f.u);
            s.dzz = mix(l->zz, r->zz, f.u);
        }
    }
    return s;
}

SCALAR_INLINE struct sample value2(const struct scarp_octave *o, const struct place *p,
                                   enum scarp_fade kind, int order)
{
    const struct fade v = fade(kind, p->t[1]);
    const struct value_column l = value_column2(o->key, p->cell[0], p, v);
    const struct value_column r = value_column2(o->key, p->cell[0] + 1, p, v);
    return value_join(&l, &r, fade(kind, p->t[0]), 2, order);
}

SCALAR_INLINE struct sample value3(const struct scarp_octave *o, const struct place *p,
                                   enum scarp_fade kind, int order)
{
    const struct fade v = fade(kind, p->t[1]);
    const struct fade w = fade(kind, p->t[2]);
    const struct value_column l = value_column3(o->key, p->cell[0], p, v, w);
    const struct value_column r = value_column3(o->key, p->cell[0] + 1, p, v, w);
    return value_join(&l, &r, fade(kind, p->t[0]), 3, order);
}

#endif
