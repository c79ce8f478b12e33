/* SPDX-License-Identifier: MIT
 *
 * Formulas: simplex noise (Perlin 2001, Gustavson 2005).
 *
 *     n(p) = sum over vertices v of w^4 q,   w = max(0, r^2 - d.d),   q = g_v . d,   d = p - v
 *
 *     gradient = sum of w^4 g - 8 w^3 q d
 *     Hessian  = sum of 48 w^2 q d d^T - 8 w^3 (g d^T + d g^T + q I)
 *
 * The lattice is made of triangles or tetrahedra. r is so small that the vertices of the one around
 * p are all that count: a vertex is further than r from what it is no corner of.
 */
#ifndef SCARP_FORMULAS_SIMPLEX_H
#define SCARP_FORMULAS_SIMPLEX_H

#include "gradient.h"

/* What a vertex adds; `g` is its gradient, `r2` is r^2. */
static inline struct sample vertex_at(vec3 d, vec3 g, float r2, int dimensions)
{
    float across2 = d.y * d.y;
    float across = g.y * d.y;
    if (dimensions == 3) {
        across2 += d.z * d.z;
        across += g.z * d.z;
    }
    const float left = (r2 - across2) - d.x * d.x;
    const float w = left > 0.0f ? left : 0.0f;
    const float q = g.x * d.x + across;
    const float w2 = w * w;
    const float w3 = 8.0f * (w2 * w);
    const float w4 = w2 * w2;
    const float wq = w3 * q;
    const float bend = 48.0f * w2 * q;
    struct sample s = constant(w4 * q);
    s.gradient.x = w4 * g.x - wq * d.x;
    s.gradient.y = w4 * g.y - wq * d.y;
    s.diagonal.x = bend * d.x * d.x - w3 * (2.0f * g.x * d.x + q);
    s.diagonal.y = bend * d.y * d.y - w3 * (2.0f * g.y * d.y + q);
    s.mixed.x = bend * d.x * d.y - w3 * (g.x * d.y + g.y * d.x);
    if (dimensions == 3) {
        s.gradient.z = w4 * g.z - wq * d.z;
        s.diagonal.z = bend * d.z * d.z - w3 * (2.0f * g.z * d.z + q);
        s.mixed.y = bend * d.x * d.z - w3 * (g.x * d.z + g.z * d.x);
        s.mixed.z = bend * d.y * d.z - w3 * (g.y * d.z + g.z * d.y);
    }
    return s;
}

/*
 * 2D: triangles of edge 1 in rows along x, sqrt(3) / 2 apart: p.t.y and the cells along y count
 * rows. In odd rows vertex i stands at x = i + 1/2. The triangle's lower side lies in the row below
 * p or its upper side in the row above; two of its corners are the same for both.
 */
#define ROW_HEIGHT 0.866025404f /* sqrt(3) / 2 */
#define TRIANGLE_R2 0.75f

/* The vertex `column` to the right of the cell, in row y, at d from p. */
static inline struct sample vertex2(struct lattice l, struct location p, int column, uint y, vec3 d)
{
    const uint x = cell_beside(l.last.x, p.cell.x, column);
    return vertex_at(d, direction2(direction_index2(hash2(l.key, x, y))), TRIANGLE_R2, 2);
}

static inline struct sample simplex_at2(struct lattice l, struct location p)
{
    const bool is_odd = (p.cell.y & 1) != 0;
    const float shift = 0.5f * p.t.y;
    const float start = p.t.x - (is_odd ? 0.5f : 0.0f);
    const bool is_before = start < shift; /* p is left of the line that vertex 0 begins */
    const int k = is_before ? -1 : 0;
    const int above = is_odd ? k + 1 : k;
    const float x = is_before ? start + 1.0f : start; /* from vertex k of the row below */
    const float y = ROW_HEIGHT * p.t.y;
    const float y_above = y - ROW_HEIGHT;
    const bool is_lower = x + shift < 1.0f;
    const struct sample a = vertex2(l, p, k + 1, p.cell.y, vec3_of(x - 1.0f, y, 0.0f));
    const struct sample b = vertex2(l, p, above, p.next.y, vec3_of(x - 0.5f, y_above, 0.0f));
    const struct sample c = vertex2(l, p, is_lower ? k : above + 1, is_lower ? p.cell.y : p.next.y,
                                    vec3_of(is_lower ? x : x - 1.5f, is_lower ? y : y_above, 0.0f));
    return sum_of(sum_of(a, b), c);
}

/*
 * 3D: the corners and the centres of cubes. A tetrahedron has two centres, next to each other along
 * the axis on which p is furthest from the first; and two corners, next to each other along the
 * axis on which it is nearest. (r^2 is a little less than 1/2, so that the other vertices add
 * exactly 0 in float arithmetic, too: rows of grids may add any of them.)
 */
#define TETRAHEDRON_R2 0x1.ffffep-2f /* 1/2 - 2^-21 */

/* Centres draw with another number than corners. */
#define HASH_CENTRE 0xbcfa3e4du

/* A vertex: how many cells its own is from that of p along each axis, and where p lies from it. */
struct vertex {
    int x, y, z;
    vec3 d;
};

/* Draws with HASH_K or HASH_CENTRE. */
static inline struct sample vertex3(struct lattice l, struct location p, struct vertex v,
                                    uint hash_k)
{
    const uint h =
        joined3(l.key, cell_beside(l.last.x, p.cell.x, v.x), cell_beside(l.last.y, p.cell.y, v.y),
                cell_beside(l.last.z, p.cell.z, v.z));
    const vec3 g = direction3(direction_index3(h * (h + hash_k)));
    return vertex_at(v.d, g, TETRAHEDRON_R2, 3);
}

/* The second centre, the first corner and the second one along an axis: how many cells they are
   from that of p, and where p lies from them. */
struct ends {
    int centre, corner0, corner1;
    float d_centre, d_corner0, d_corner1;
};

/* p lies at t from the first centre. */
static inline struct ends ends_of(float t, bool is_furthest, bool is_nearest)
{
    const bool is_up = !(t < 0.0f);
    const float side = is_up ? 0.5f : -0.5f;
    struct ends e = {.d_centre = t, .d_corner0 = t - side, .d_corner1 = t - side};
    e.corner0 = is_up ? 1 : 0;
    e.corner1 = e.corner0;
    if (is_furthest) {
        e.centre = is_up ? 1 : -1;
        e.d_centre = t - (is_up ? 1.0f : -1.0f);
    }
    if (is_nearest) {
        e.corner1 = 1 - e.corner0;
        e.d_corner1 = t + side;
    }
    return e;
}

static inline struct sample simplex_at3(struct lattice l, struct location p)
{
    const vec3 t = sub3(p.t, vec3_of(0.5f, 0.5f, 0.5f));
    const vec3 m = vec3_of(magnitude(t.x), magnitude(t.y), magnitude(t.z));
    const bool far_x = m.x >= m.y && m.x >= m.z;
    const bool far_y = !far_x && m.y >= m.z;
    const bool near_z = m.z <= m.x && m.z <= m.y;
    const bool near_y = !near_z && m.y <= m.x;
    const struct ends x = ends_of(t.x, far_x, !near_z && !near_y);
    const struct ends y = ends_of(t.y, far_y, near_y);
    const struct ends z = ends_of(t.z, !far_x && !far_y, near_z);
    const struct vertex centre0 = {0, 0, 0, t};
    const struct vertex centre1 = {
        x.centre, y.centre, z.centre, {x.d_centre, y.d_centre, z.d_centre}};
    const struct vertex corner0 = {
        x.corner0, y.corner0, z.corner0, {x.d_corner0, y.d_corner0, z.d_corner0}};
    const struct vertex corner1 = {
        x.corner1, y.corner1, z.corner1, {x.d_corner1, y.d_corner1, z.d_corner1}};
    const struct sample centres =
        sum_of(vertex3(l, p, centre0, HASH_CENTRE), vertex3(l, p, centre1, HASH_CENTRE));
    const struct sample corners =
        sum_of(vertex3(l, p, corner0, HASH_K), vertex3(l, p, corner1, HASH_K));
    return sum_of(sum_of(corners, centres), constant(0.0f)); /* which turns a sum of -0 into 0 */
}

static inline struct sample simplex_at(struct lattice l, struct location p, int dimensions)
{
    if (dimensions == 2) {
        return simplex_at2(l, p);
    }
    return simplex_at3(l, p);
}

#endif
