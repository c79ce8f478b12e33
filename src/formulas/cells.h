/* SPDX-License-Identifier: MIT
 *
 * Formulas: cellular noise (Worley 1996). Each cell c of the lattice has one feature, in a box
 * around its middle:
 *
 *     feature_i = c_i + 1/2 + jitter v_i / 2^32,   v_i drawn, from -2^31 to 2^31
 *
 * With d = p - feature and s = d.d, s1 and s2 are the least two s, and the noise is made of
 *
 *     F = sqrt(s):   gradient g = d / F,   Hessian (I - g g^T) / F;   both are 0 at the feature
 *
 * Soft noise is -V, where a = max(0, 1 - s) and V^2 is the sum of all a^8:
 *
 *     grad V = -8 sum(a^7 d) / V
 *     H_V = (sum(112 a^6 d d^T - 8 a^7 I) - grad V grad V^T) / V;   both are 0 where V is 0
 */
#ifndef SCARP_FORMULAS_CELLS_H
#define SCARP_FORMULAS_CELLS_H

#include "lattice.h"
#include "sample.h"

/* What a cell draws beside v_0, which is its hash. */
#define FEATURE_Y 0xe41130e9u
#define FEATURE_Z 0x6ecea30du
#define FEATURE_ID 0xc603dc87u

/* Where a point lies from the feature of a cell, and the hash of that cell. */
struct feature {
    vec3 d;
    float s;
    uint hash;
};

/* How far t is from the feature of the cell `step` away, along an axis on which it drew v. */
static inline float feature_distance(float t, int step, float jitter, uint v)
{
    const float middle = (float)step + 0.5f;
    return t - (middle + jitter * lattice_value(v));
}

/* The feature of the cell that is (x, y, z) away from that of p. */
static inline struct feature feature_at(struct lattice l, struct location p, int x, int y, int z,
                                        int dimensions)
{
    const uint cx = cell_beside(l.last.x, p.cell.x, x);
    const uint cy = cell_beside(l.last.y, p.cell.y, y);
    struct feature f = {.hash = hash2(l.key, cx, cy)};
    if (dimensions == 3) {
        f.hash = hash3(l.key, cx, cy, cell_beside(l.last.z, p.cell.z, z));
    }
    f.d.x = feature_distance(p.t.x, x, l.jitter, f.hash);
    f.d.y = feature_distance(p.t.y, y, l.jitter, f.hash * FEATURE_Y);
    float across2 = f.d.y * f.d.y;
    if (dimensions == 3) {
        f.d.z = feature_distance(p.t.z, z, l.jitter, f.hash * FEATURE_Z);
        across2 += f.d.z * f.d.z;
    }
    f.s = f.d.x * f.d.x + across2;
    return f;
}

/* 0, or NaN where a fraction is NaN, which a search for the least would pass over. */
static inline float zero_at(struct location p)
{
    return 0.0f * (p.t.x + (p.t.y + p.t.z));
}

/* Further than any search ends. */
#define FAR_AWAY 64.0f

/* The features that are nearest. */
struct nearest {
    struct feature first, second;
};

/* Only a strictly nearer feature replaces one. */
static inline struct nearest nearest_with(struct nearest n, struct feature f)
{
    struct nearest m = n;
    if (f.s < n.first.s) {
        m.second = n.first;
        m.first = f;
    } else if (f.s < n.second.s) {
        m.second = f;
    }
    return m;
}

/* The square of the gap to the cell `step` away along an axis. */
static inline float gap2(float t, int step)
{
    const float gap = step > 0 ? (float)step - t : t - (float)(step + 1);
    return step == 0 ? 0.0f : gap * gap;
}

/* Whether a cell, and so its feature, is further away than s, by more than rounding. */
static inline bool is_beyond(struct location p, int x, int y, int z, float s)
{
    return gap2(p.t.x, x) + gap2(p.t.y, y) + gap2(p.t.z, z) > 1.001f * s;
}

/* Whether the search looks at a cell. */
static inline bool is_searched(struct location p, int ring, int x, int y, int z, float s)
{
    const bool is_inside = x > -2 && x < 2 && y > -2 && y < 2 && z > -2 && z < 2;
    return ring == 1 || !(is_inside || is_beyond(p, x, y, z, s));
}

/*
 * Searches the cells around that of p, then those two steps away, of which few are near enough. No
 * feature beyond can be one of the two: it is at least 2 away from p, and both are nearer. (3^n
 * cells do not suffice: the nearest feature of these may be sqrt(n) away, and features two cells
 * off a little more than 1.)
 */
static inline struct nearest nearest_at(struct lattice l, struct location p, int dimensions)
{
    const float far = FAR_AWAY + zero_at(p); /* nothing is nearer than NaN */
    const struct feature none = {{far, far, far}, far, 0};
    struct nearest n = {none, none};
    for (int ring = 1; ring <= 2; ring++) {
        const int depth = dimensions == 3 ? ring : 0;
        for (int z = -depth; z <= depth; z++) {
            for (int y = -ring; y <= ring; y++) {
                for (int x = -ring; x <= ring; x++) {
                    if (is_searched(p, ring, x, y, z, n.second.s)) {
                        n = nearest_with(n, feature_at(l, p, x, y, z, dimensions));
                    }
                }
            }
        }
    }
    return n;
}

/* Below this, a point lies on the feature. */
#define NO_DISTANCE 0x1p-80f

/* The distance from a feature. */
static inline struct sample distance_to(struct feature f)
{
    const float distance = root(f.s);
    const float r = f.s <= NO_DISTANCE ? 0.0f : inverse(distance);
    const vec3 g = mul3(r, f.d);
    const struct sample s = {
        .value = distance,
        .gradient = g,
        .diagonal = {r * (1.0f - g.x * g.x), r * (1.0f - g.y * g.y), r * (1.0f - g.z * g.z)},
        .mixed = {-(r * (g.x * g.y)), -(r * (g.x * g.z)), -(r * (g.y * g.z))},
    };
    return s;
}

/* What a feature adds before the root; the gradient without the factor 8, the Hessian too. */
static inline struct sample soft_term(struct feature f)
{
    const float a = f.s < 1.0f ? 1.0f - f.s : 0.0f;
    const float a2 = a * a;
    const float a4 = a2 * a2;
    const float a6 = a4 * a2;
    const float a7 = a6 * a;
    const vec3 b = mul3(14.0f * a6, f.d);
    const struct sample s = {
        .value = a4 * a4,
        .gradient = mul3(a7, f.d),
        .diagonal = {b.x * f.d.x - a7, b.y * f.d.y - a7, b.z * f.d.z - a7},
        .mixed = {b.x * f.d.y, b.x * f.d.z, b.y * f.d.z},
    };
    return s;
}

/* Below this, V^2 counts as 0: derivatives are no more than its rounding there. */
#define NO_SUM 0x1p-120f

static inline struct sample soft_root(struct sample sum)
{
    const float v = root(sum.value);
    const float r = sum.value <= NO_SUM ? 0.0f : 8.0f * inverse(v);
    const float q = 0.125f * r; /* 1 / V */
    const vec3 g = mul3(r, sum.gradient);
    const vec3 squares = vec3_of(g.x * g.x, g.y * g.y, g.z * g.z);
    const vec3 products = vec3_of(g.x * g.y, g.x * g.z, g.y * g.z);
    return sample_of(-v, g, sub3(mul3(q, squares), mul3(r, sum.diagonal)),
                     sub3(mul3(q, products), mul3(r, sum.mixed)));
}

static inline struct sample soft_at(struct lattice l, struct location p, int dimensions)
{
    const int depth = dimensions == 3 ? 1 : 0;
    const float zero = zero_at(p);
    const vec3 zeros = {zero, zero, zero};
    struct sample sum = {zero, zeros, zeros, zeros};
    for (int z = -depth; z <= depth; z++) {
        for (int y = -1; y <= 1; y++) {
            for (int x = -1; x <= 1; x++) {
                sum = sum_of(sum, soft_term(feature_at(l, p, x, y, z, dimensions)));
            }
        }
    }
    return soft_root(sum);
}

/* Each cell's own value, in units of 2^-31; all derivatives are 0. */
static inline struct sample cell_value(struct feature f)
{
    const float zero = 0.0f * f.s; /* or NaN */
    const vec3 zeros = {zero, zero, zero};
    return sample_of(lattice_value(f.hash * FEATURE_ID) + zero, zeros, zeros, zeros);
}

static inline struct sample cells_at(struct lattice l, uint basis, struct location p,
                                     int dimensions)
{
    if (basis == SCARP_CELL_SOFT) {
        struct sample soft = soft_at(l, p, dimensions);
        soft.value += l.middle;
        return soft;
    }
    const struct nearest n = nearest_at(l, p, dimensions);
    if (basis == SCARP_CELL_VALUE) {
        return cell_value(n.first);
    }
    const struct sample first = distance_to(n.first);
    struct sample s = distance_to(n.second);
    if (basis == SCARP_CELL_F1) {
        s = first;
    }
    if (basis == SCARP_CELL_EDGE) {
        s = difference_of(s, first);
    }
    s.value -= l.middle;
    return s;
}

#endif
