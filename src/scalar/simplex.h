/* SPDX-License-Identifier: MIT
 *
 * Reference: simplex noise (Perlin 2001, Gustavson 2005).
 *
 *     n(p) = sum over vertices v of w^4 q,   w = max(0, r^2 - d.d),   q = g_v . d,   d = p - v
 *
 *     gradient = sum of w^4 g - 8 w^3 q d
 *     Hessian  = sum of 48 w^2 q d d^T - 8 w^3 (g d^T + d g^T + q I)
 *
 * The lattice is made of triangles or tetrahedra. r is so small that the vertices of the one around
 * p are all that count: a vertex is further than r from what it is no corner of. Included by
 * basis.h.
 */
#ifndef SCARP_SCALAR_SIMPLEX_H
#define SCARP_SCALAR_SIMPLEX_H

#include "gradient.h"

/* What a vertex adds; `g` is its gradient, `r2` is r^2. */
static inline struct sample vertex_at(const float d[3], const struct direction *g, float r2,
                                      int dimensions)
{
    const float across = dimensions == 3 ? d[1] * d[1] + d[2] * d[2] : d[1] * d[1];
    const float left = (r2 - across) - d[0] * d[0];
    const float w = left > 0.0f ? left : 0.0f;
    const float *const of = g->of;
    const float q = of[0] * d[0] + (dimensions == 3 ? of[1] * d[1] + of[2] * d[2] : of[1] * d[1]);
    const float w2 = w * w, w4 = w2 * w2, w3 = 8.0f * (w2 * w);
    const float wq = w3 * q, bend = 48.0f * w2 * q;
    struct sample s = {{[VALUE] = w4 * q}};
    for (int i = 0; i < dimensions; i++) {
        s.of[DX + i] = w4 * of[i] - wq * d[i];
    }
    s.of[DXX] = bend * d[0] * d[0] - w3 * (2.0f * of[0] * d[0] + q);
    s.of[DYY] = bend * d[1] * d[1] - w3 * (2.0f * of[1] * d[1] + q);
    s.of[DXY] = bend * d[0] * d[1] - w3 * (of[0] * d[1] + of[1] * d[0]);
    if (dimensions == 3) {
        s.of[DZZ] = bend * d[2] * d[2] - w3 * (2.0f * of[2] * d[2] + q);
        s.of[DXZ] = bend * d[0] * d[2] - w3 * (of[0] * d[2] + of[2] * d[0]);
        s.of[DYZ] = bend * d[1] * d[2] - w3 * (of[1] * d[2] + of[2] * d[1]);
    }
    return s;
}

static inline struct sample sum_of(const struct sample *a, const struct sample *b)
{
    struct sample s;
    for (int i = 0; i < OUTPUTS; i++) {
        s.of[i] = a->of[i] + b->of[i];
    }
    return s;
}

/*
 * 2D: triangles of edge 1 in rows along x, sqrt(3) / 2 apart: p->t[1] and the cells along y count
 * rows. In odd rows vertex i stands at x = i + 1/2. The triangle's lower side lies in the row below
 * p or its upper side in the row above; two of its corners are the same for both.
 */
#define ROW_HEIGHT 0.866025404f /* sqrt(3) / 2 */
#define TRIANGLE_R2 0.75f

/* The vertex `column` to the right of the cell, in the row below p or above, at (dx, dy) from p. */
static inline struct sample vertex2(const struct scarp_octave *o, const struct place *p, int column,
                                    int above, float dx, float dy)
{
    const uint32_t x = cell_beside(o, 0, p->cell[0][0], column);
    const struct direction g = direction2(NULL, hash2(o->key, x, p->cell[1][above]));
    const float d[3] = {dx, dy, 0.0f};
    return vertex_at(d, &g, TRIANGLE_R2, 2);
}

static inline struct sample simplex_at2(const struct scarp_octave *o, const struct place *p)
{
    const int odd = p->cell[1][0] & 1;
    const float shift = 0.5f * p->t[1];
    const float from = p->t[0] - (odd ? 0.5f : 0.0f);
    const int before = from < shift; /* p is left of the line that vertex 0 of the cell begins */
    const int k = before ? -1 : 0;
    const float x = before ? from + 1.0f : from; /* from vertex k of the row below */
    const int lower = x + shift < 1.0f;
    const float y = ROW_HEIGHT * p->t[1];
    const struct sample a = vertex2(o, p, k + 1, 0, x - 1.0f, y);
    const struct sample b = vertex2(o, p, k + odd, 1, x - 0.5f, y - ROW_HEIGHT);
    const struct sample c =
        lower ? vertex2(o, p, k, 0, x, y) : vertex2(o, p, k + odd + 1, 1, x - 1.5f, y - ROW_HEIGHT);
    const struct sample both = sum_of(&a, &b);
    return sum_of(&both, &c);
}

/*
 * 3D: the corners and the centres of cubes. A tetrahedron has two centres, next to each other along
 * the axis on which p is furthest from the first; and two corners, next to each other along the
 * axis on which it is nearest. (r^2 is a little less than 1/2, so that the other vertices add
 * exactly 0 in float arithmetic, too: rows of grids may add any of them.)
 */
#define TETRAHEDRON_R2 (0.5f - 0x1p-21f)

/* Centres draw with another number than corners. */
#define HASH_CENTRE 0xbcfa3e4du

/* The corner or the centre whose cell is `step` from that of p, at d from p. */
static inline struct sample vertex3(const struct scarp_octave *o, const struct place *p,
                                    const int step[3], int is_centre, const float d[3])
{
    uint32_t cell[3];
    for (int i = 0; i < 3; i++) {
        cell[i] = cell_beside(o, i, p->cell[i][0], step[i]);
    }
    const uint32_t h = joined3(o->key, cell[0], cell[1], cell[2]);
    const struct direction g = direction3(NULL, h * (h + (is_centre ? HASH_CENTRE : HASH_K)));
    return vertex_at(d, &g, TETRAHEDRON_R2, 3);
}

static inline struct sample simplex_at3(const struct scarp_octave *o, const struct place *p)
{
    float d[4][3], m[3]; /* from the two centres and the two corners */
    int step[4][3], up[3];
    for (int i = 0; i < 3; i++) {
        const float t = p->t[i] - 0.5f;
        m[i] = fabsf(t);
        up[i] = !(t < 0.0f);
        d[0][i] = d[1][i] = t;
        d[2][i] = d[3][i] = t - (up[i] ? 0.5f : -0.5f);
        step[0][i] = step[1][i] = 0;
        step[2][i] = step[3][i] = up[i];
    }
    const int furthest = m[0] >= m[1] && m[0] >= m[2] ? 0 : m[1] >= m[2] ? 1 : 2;
    const int nearest = m[2] <= m[0] && m[2] <= m[1] ? 2 : m[1] <= m[0] ? 1 : 0;
    d[1][furthest] = d[0][furthest] - (up[furthest] ? 1.0f : -1.0f);
    step[1][furthest] = up[furthest] ? 1 : -1;
    d[3][nearest] = d[0][nearest] + (up[nearest] ? 0.5f : -0.5f);
    step[3][nearest] = !up[nearest];
    const struct sample h0 = vertex3(o, p, step[0], 1, d[0]);
    const struct sample h1 = vertex3(o, p, step[1], 1, d[1]);
    const struct sample i0 = vertex3(o, p, step[2], 0, d[2]);
    const struct sample i1 = vertex3(o, p, step[3], 0, d[3]);
    const struct sample zero = {{0.0f}}; /* turns a sum of -0 into 0 */
    const struct sample centres = sum_of(&h0, &h1), corners = sum_of(&i0, &i1);
    const struct sample all = sum_of(&corners, &centres);
    return sum_of(&all, &zero);
}

static inline struct sample simplex_at(const struct scarp_octave *o, const struct place *p,
                                       int dimensions)
{
    return dimensions == 2 ? simplex_at2(o, p) : simplex_at3(o, p);
}

#endif
