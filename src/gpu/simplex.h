/* SPDX-License-Identifier: MIT
 *
 * Shaders: simplex noise; as scalar/simplex.h. Included by cells.h.
 */
#ifndef SCARP_GPU_SIMPLEX_H
#define SCARP_GPU_SIMPLEX_H

#include "value.h"

/* Second derivative of a vertex: `bend` i j, and what w^3 has a share in. */
static inline float vertex_second(float bend, float w3, float di, float dj, float rest)
{
    return bend * di * dj - w3 * rest;
}

/* What a vertex adds; g is its gradient, r2 is r^2. */
static inline struct sample vertex_at(vec3 d, vec3 g, float r2, int dimensions)
{
    float across2 = d.y * d.y;
    if (dimensions == 3) {
        across2 += d.z * d.z;
    }
    const float left = r2 - across2 - d.x * d.x;
    const float w = left > 0.0f ? left : 0.0f;
    float q = g.x * d.x + g.y * d.y;
    if (dimensions == 3) {
        q += g.z * d.z;
    }
    const float w2 = w * w;
    const float w4 = w2 * w2;
    const float w3 = 8.0f * (w2 * w);
    const float bend = 48.0f * w2 * q;
    const vec3 twice = mul3(2.0f, g);
    const vec3 diagonal = vec3_of(vertex_second(bend, w3, d.x, d.x, twice.x * d.x + q),
                                  vertex_second(bend, w3, d.y, d.y, twice.y * d.y + q),
                                  vertex_second(bend, w3, d.z, d.z, twice.z * d.z + q));
    const vec3 mixed = vec3_of(vertex_second(bend, w3, d.x, d.y, g.x * d.y + g.y * d.x),
                               vertex_second(bend, w3, d.x, d.z, g.x * d.z + g.z * d.x),
                               vertex_second(bend, w3, d.y, d.z, g.y * d.z + g.z * d.y));
    return sample_of(w4 * q, sub3(mul3(w4, g), mul3(w3 * q, d)), diagonal, mixed);
}

#define ROW_HEIGHT 0.866025404f
#define TRIANGLE_R2 0.75f

/* The vertex `column` to the right of the cell, in row y. */
static inline struct sample vertex2(struct octave o, struct place p, int column, uint y, vec3 d)
{
    const uint x = cell_beside(o.last.x, p.cell.x, column);
    return vertex_at(d, direction2(hash2(o.key, x, y) >> 28u), TRIANGLE_R2, 2);
}

static inline struct sample simplex_at2(struct octave o, struct place p)
{
    const bool odd = (p.cell.y & 1u) != 0u;
    const float shift = 0.5f * p.t.y;
    const float start = p.t.x - (odd ? 0.5f : 0.0f);
    const bool before = start < shift;
    const int k = before ? -1 : 0;
    const int above = k + (odd ? 1 : 0);
    const float x = before ? start + 1.0f : start;
    const bool lower = x + shift < 1.0f;
    const float y = ROW_HEIGHT * p.t.y;
    const float y_above = y - ROW_HEIGHT;
    const struct sample a = vertex2(o, p, k + 1, p.cell.y, vec3_of(x - 1.0f, y, 0.0f));
    const struct sample b = vertex2(o, p, above, p.next.y, vec3_of(x - 0.5f, y_above, 0.0f));
    const struct sample c = vertex2(o, p, lower ? k : above + 1, lower ? p.cell.y : p.next.y,
                                    vec3_of(lower ? x : x - 1.5f, lower ? y : y_above, 0.0f));
    return sum_of(sum_of(a, b), c);
}

#define TETRAHEDRON_R2 0.49999952316284180f
#define HASH_CENTRE 0xbcfa3e4du

/* A vertex: how many cells from that of p along each axis, and where p lies from it. */
struct vertex {
    int x;
    int y;
    int z;
    vec3 d;
};

static inline struct sample vertex3(struct octave o, struct place p, struct vertex v, uint hash_k)
{
    const uint h =
        joined3(o.key, cell_beside(o.last.x, p.cell.x, v.x), cell_beside(o.last.y, p.cell.y, v.y),
                cell_beside(o.last.z, p.cell.z, v.z));
    return vertex_at(v.d, direction3(edge_of(h * (h + hash_k))), TETRAHEDRON_R2, 3);
}

/* A cube's two centres and two corners along an axis: what `t`, from the centre, makes of each. */
struct ends {
    int up;
    int centre;
    int corner;
    float d_centre;
    float d_up;
    float d_corner;
};

static inline struct ends ends_of(float t, bool is_furthest, bool is_nearest)
{
    const bool up = !(t < 0.0f);
    struct ends e;
    e.up = up ? 1 : 0;
    e.d_up = t - (up ? 0.5f : -0.5f);
    e.centre = is_furthest ? (up ? 1 : -1) : 0;
    e.d_centre = is_furthest ? t - (up ? 1.0f : -1.0f) : t;
    e.corner = is_nearest ? 1 - e.up : e.up;
    e.d_corner = is_nearest ? t + (up ? 0.5f : -0.5f) : e.d_up;
    return e;
}

static inline struct vertex vertex_of(int x, int y, int z, vec3 d)
{
    struct vertex v;
    v.x = x;
    v.y = y;
    v.z = z;
    v.d = d;
    return v;
}

static inline struct sample simplex_at3(struct octave o, struct place p)
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
    const struct vertex centre0 = vertex_of(0, 0, 0, t);
    const struct vertex centre1 =
        vertex_of(x.centre, y.centre, z.centre, vec3_of(x.d_centre, y.d_centre, z.d_centre));
    const struct vertex corner0 = vertex_of(x.up, y.up, z.up, vec3_of(x.d_up, y.d_up, z.d_up));
    const struct vertex corner1 =
        vertex_of(x.corner, y.corner, z.corner, vec3_of(x.d_corner, y.d_corner, z.d_corner));
    const struct sample centres =
        sum_of(vertex3(o, p, centre0, HASH_CENTRE), vertex3(o, p, centre1, HASH_CENTRE));
    const struct sample corners =
        sum_of(vertex3(o, p, corner0, HASH_K), vertex3(o, p, corner1, HASH_K));
    return sum_of(corners, centres);
}

#endif
