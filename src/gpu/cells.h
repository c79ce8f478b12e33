/* SPDX-License-Identifier: MIT
 *
 * Shaders: cellular noise; as scalar/cells.h. Included by basis.h.
 */
#ifndef SCARP_GPU_CELLS_H
#define SCARP_GPU_CELLS_H

#include "simplex.h"

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
static inline struct feature feature_at(struct octave o, struct place p, int x, int y, int z,
                                        int dimensions)
{
    const uint cx = cell_beside(o.last.x, p.cell.x, x);
    const uint cy = cell_beside(o.last.y, p.cell.y, y);
    struct feature f;
    f.hash = hash2(o.key, cx, cy);
    if (dimensions == 3) {
        f.hash = hash3(o.key, cx, cy, cell_beside(o.last.z, p.cell.z, z));
    }
    f.d = vec3_of(feature_distance(p.t.x, x, o.turn.x, f.hash),
                  feature_distance(p.t.y, y, o.turn.x, f.hash * FEATURE_Y), 0.0f);
    float across2 = f.d.y * f.d.y;
    if (dimensions == 3) {
        f.d.z = feature_distance(p.t.z, z, o.turn.x, f.hash * FEATURE_Z);
        across2 += f.d.z * f.d.z;
    }
    f.s = f.d.x * f.d.x + across2;
    return f;
}

#define FAR_AWAY 64.0f

struct nearest {
    struct feature first;
    struct feature second;
};

/* Only what is strictly nearer takes a place. */
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

/* The square of the gap to a cell along an axis. */
static inline float gap2(float t, int step)
{
    const float ahead = (float)step - t;
    const float behind = t - (float)(step + 1);
    const float gap = step > 0 ? ahead : behind;
    return step == 0 ? 0.0f : gap * gap;
}

/* Whether a cell, and so its feature, is further away than s, by more than rounding. */
static inline bool is_beyond(struct place p, int x, int y, int z, float s)
{
    const float gap = gap2(p.t.x, x) + gap2(p.t.y, y) + gap2(p.t.z, z);
    return gap > 1.001f * s;
}

/* Whether the search around a point looks at a cell: first at those around, then at those two steps
   away that are not too far. */
static inline bool is_searched(struct place p, int ring, int x, int y, int z, float s)
{
    const bool inside = x > -2 && x < 2 && y > -2 && y < 2 && z > -2 && z < 2;
    return ring == 1 || (!inside && !is_beyond(p, x, y, z, s));
}

static inline struct nearest nearest_at(struct octave o, struct place p, int dimensions)
{
    struct nearest n;
    n.first.d = vec3_of(FAR_AWAY, FAR_AWAY, FAR_AWAY);
    n.first.s = FAR_AWAY;
    n.first.hash = 0u;
    n.second = n.first;
    for (int ring = 1; ring <= 2; ring++) {
        const int depth = dimensions == 3 ? ring : 0;
        for (int z = -depth; z <= depth; z++) {
            for (int y = -ring; y <= ring; y++) {
                for (int x = -ring; x <= ring; x++) {
                    if (is_searched(p, ring, x, y, z, n.second.s)) {
                        n = nearest_with(n, feature_at(o, p, x, y, z, dimensions));
                    }
                }
            }
        }
    }
    return n;
}

/* 2^-80: below this, a point lies on the feature. */
#define NO_DISTANCE 8.27180613e-25f

/* The distance from a feature. */
static inline struct sample distance_to(struct feature f)
{
    const float distance = root(f.s);
    const float r = f.s <= NO_DISTANCE ? 0.0f : inverse(distance);
    const vec3 g = vec3_of(f.d.x * r, f.d.y * r, f.d.z * r);
    return sample_of(
        distance, g,
        vec3_of(r * (1.0f - g.x * g.x), r * (1.0f - g.y * g.y), r * (1.0f - g.z * g.z)),
        vec3_of(-(r * (g.x * g.y)), -(r * (g.x * g.z)), -(r * (g.y * g.z))));
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
    return sample_of(a4 * a4, mul3(a7, f.d),
                     vec3_of(b.x * f.d.x - a7, b.y * f.d.y - a7, b.z * f.d.z - a7),
                     vec3_of(b.x * f.d.y, b.x * f.d.z, b.y * f.d.z));
}

/* 2^-120: below this, V^2 counts as 0. */
#define NO_SUM 7.52316385e-37f

static inline float soft_second(float q, float r, float gi, float gj, float sum)
{
    return q * (gi * gj) - r * sum;
}

static inline struct sample soft_root(struct sample sum)
{
    const float v = root(sum.value);
    const float r = sum.value <= NO_SUM ? 0.0f : 8.0f * inverse(v);
    const float q = 0.125f * r;
    const vec3 g = mul3(r, sum.gradient);
    return sample_of(-v, g,
                     vec3_of(soft_second(q, r, g.x, g.x, sum.diagonal.x),
                             soft_second(q, r, g.y, g.y, sum.diagonal.y),
                             soft_second(q, r, g.z, g.z, sum.diagonal.z)),
                     vec3_of(soft_second(q, r, g.x, g.y, sum.mixed.x),
                             soft_second(q, r, g.x, g.z, sum.mixed.y),
                             soft_second(q, r, g.y, g.z, sum.mixed.z)));
}

static inline struct sample soft_at(struct octave o, struct place p, int dimensions)
{
    const int depth = dimensions == 3 ? 1 : 0;
    struct sample sum = constant(0.0f);
    for (int z = -depth; z <= depth; z++) {
        for (int y = -1; y <= 1; y++) {
            for (int x = -1; x <= 1; x++) {
                sum = sum_of(sum, soft_term(feature_at(o, p, x, y, z, dimensions)));
            }
        }
    }
    return soft_root(sum);
}

static inline struct sample negated(struct sample n)
{
    return sample_of(-n.value, vec3_of(-n.gradient.x, -n.gradient.y, -n.gradient.z),
                     vec3_of(-n.diagonal.x, -n.diagonal.y, -n.diagonal.z),
                     vec3_of(-n.mixed.x, -n.mixed.y, -n.mixed.z));
}

/* The middle of the interval, o.turn.y, becomes 0. */
static inline struct sample cells_at(struct octave o, uint basis, struct place p, int dimensions)
{
    struct sample s;
    if (basis == CELL_SOFT) {
        s = soft_at(o, p, dimensions);
        s.value += o.turn.y;
    } else {
        const struct nearest n = nearest_at(o, p, dimensions);
        if (basis == CELL_VALUE) {
            s = constant(lattice_value(n.first.hash * FEATURE_ID));
        } else {
            const struct sample first = distance_to(n.first);
            s = distance_to(n.second);
            if (basis == CELL_F1) {
                s = first;
            }
            if (basis == CELL_EDGE) {
                s = sum_of(s, negated(first));
            }
            s.value -= o.turn.y;
        }
    }
    return s;
}

#endif
