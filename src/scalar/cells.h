/* SPDX-License-Identifier: MIT
 *
 * Reference: cellular noise (Worley 1996). Each cell c of the lattice has one feature, in a box
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
 *
 * Included by basis.h, and by table.c for scarp_cells2 and its like.
 */
#ifndef SCARP_SCALAR_CELLS_H
#define SCARP_SCALAR_CELLS_H

#include <stdlib.h>

#include "columns.h"

/* What a cell draws beside v_0, which is its hash. */
#define FEATURE_Y 0xe41130e9u
#define FEATURE_Z 0x6ecea30du
#define FEATURE_ID 0xc603dc87u

/* Where a point lies from the feature of a cell, and the hash of that cell. */
struct feature {
    float d[3], s;
    uint32_t hash;
};

/* The feature of the cell that is `step` away from that of p. */
static inline struct feature feature_at(const struct scarp_octave *o, const struct place *p,
                                        const int step[3], int dimensions)
{
    uint32_t cell[3] = {0};
    for (int i = 0; i < dimensions; i++) {
        cell[i] = cell_beside(o, i, p->cell[i][0], step[i]);
    }
    struct feature f = {.hash = dimensions == 3 ? hash3(o->key, cell[0], cell[1], cell[2])
                                                : hash2(o->key, cell[0], cell[1])};
    const uint32_t v[3] = {f.hash, f.hash * FEATURE_Y, f.hash * FEATURE_Z};
    for (int i = 0; i < dimensions; i++) {
        const float middle = (float)step[i] + 0.5f;
        f.d[i] = p->t[i] - (middle + o->jitter * (float)(int32_t)v[i]);
    }
    const float *const d = f.d;
    f.s = d[0] * d[0] + (dimensions == 3 ? d[1] * d[1] + d[2] * d[2] : d[1] * d[1]);
    return f;
}

/* 0, or NaN where a place is NaN, which a search for the least would pass over. */
static inline float zero_at(const struct place *p, int dimensions)
{
    return 0.0f * (dimensions == 3 ? p->t[0] + (p->t[1] + p->t[2]) : p->t[0] + p->t[1]);
}

/* Further than any search ends. */
#define FAR_AWAY 64.0f

/* The features that are nearest. */
struct nearest {
    struct feature first, second;
};

/* Only what is strictly nearer takes a place. */
static inline void nearest_add(struct nearest *n, const struct feature *f)
{
    if (f->s < n->first.s) {
        n->second = n->first;
        n->first = *f;
    } else if (f->s < n->second.s) {
        n->second = *f;
    }
}

/* Whether a cell, and so its feature, is further away than s, by more than rounding. */
static inline int is_beyond(const struct place *p, const int step[3], float s, int dimensions)
{
    float nearest = 0.0f;
    for (int i = 0; i < dimensions; i++) {
        const float t = p->t[i];
        const float gap = step[i] > 0 ? (float)step[i] - t : t - (float)(step[i] + 1);
        nearest += step[i] == 0 ? 0.0f : gap * gap;
    }
    return nearest > 1.001f * s;
}

/*
 * Searches the cells around that of p, then those two steps away, of which few are near enough. No
 * feature beyond can be one of the two: it is at least 2 away from p, and both are nearer. (3^n
 * cells do not suffice: the nearest feature of these may be sqrt(n) away, and features two cells
 * off a little more than 1.)
 */
static inline struct nearest nearest_at(const struct scarp_octave *o, const struct place *p,
                                        int dimensions)
{
    const float far = FAR_AWAY + zero_at(p, dimensions); /* nothing is nearer than NaN */
    const struct feature none = {{far, far, far}, far, 0};
    struct nearest n = {none, none};
    for (int ring = 1; ring <= 2; ring++) {
        const int depth = dimensions == 3 ? ring : 0;
        for (int z = -depth; z <= depth; z++) {
            for (int y = -ring; y <= ring; y++) {
                for (int x = -ring; x <= ring; x++) {
                    const int step[3] = {x, y, z};
                    const int is_inside = abs(x) < 2 && abs(y) < 2 && abs(z) < 2;
                    if (ring == 2 && (is_inside || is_beyond(p, step, n.second.s, dimensions))) {
                        continue;
                    }
                    const struct feature f = feature_at(o, p, step, dimensions);
                    nearest_add(&n, &f);
                }
            }
        }
    }
    return n;
}

/* Below this, a point lies on the feature. */
#define NO_DISTANCE 0x1p-80f

/* The distance from a feature. */
static inline struct sample distance_to(const struct feature *f)
{
    const float distance = sqrtf(f->s);
    const float r = f->s <= NO_DISTANCE ? 0.0f : 1.0f / distance;
    const float x = f->d[0] * r, y = f->d[1] * r, z = f->d[2] * r;
    const struct sample s = {{
        [VALUE] = distance,
        [DX] = x,
        [DY] = y,
        [DZ] = z,
        [DXX] = r * (1.0f - x * x),
        [DXY] = -(r * (x * y)),
        [DXZ] = -(r * (x * z)),
        [DYY] = r * (1.0f - y * y),
        [DYZ] = -(r * (y * z)),
        [DZZ] = r * (1.0f - z * z),
    }};
    return s;
}

/* What soft noise adds up before the root; the gradient without the factor 8, the Hessian too. */
static inline void soft_add(struct sample *sum, const struct feature *f)
{
    const float a = f->s < 1.0f ? 1.0f - f->s : 0.0f;
    const float a2 = a * a, a4 = a2 * a2, a6 = a4 * a2, a7 = a6 * a;
    const float bend = 14.0f * a6;
    const float x = f->d[0], y = f->d[1], z = f->d[2];
    const struct sample term = {{
        [VALUE] = a4 * a4,
        [DX] = a7 * x,
        [DY] = a7 * y,
        [DZ] = a7 * z,
        [DXX] = bend * x * x - a7,
        [DXY] = bend * x * y,
        [DXZ] = bend * x * z,
        [DYY] = bend * y * y - a7,
        [DYZ] = bend * y * z,
        [DZZ] = bend * z * z - a7,
    }};
    for (int i = 0; i < OUTPUTS; i++) {
        sum->of[i] += term.of[i];
    }
}

/* Below this, V^2 counts as 0: derivatives are no more than its rounding there. */
#define NO_SUM 0x1p-120f

static inline struct sample soft_root(const struct sample *sum)
{
    const float v = sqrtf(sum->of[VALUE]);
    const float r = sum->of[VALUE] <= NO_SUM ? 0.0f : 8.0f / v;
    const float q = 0.125f * r; /* 1 / V */
    const float x = r * sum->of[DX], y = r * sum->of[DY], z = r * sum->of[DZ];
    const struct sample s = {{
        [VALUE] = -v,
        [DX] = x,
        [DY] = y,
        [DZ] = z,
        [DXX] = q * (x * x) - r * sum->of[DXX],
        [DXY] = q * (x * y) - r * sum->of[DXY],
        [DXZ] = q * (x * z) - r * sum->of[DXZ],
        [DYY] = q * (y * y) - r * sum->of[DYY],
        [DYZ] = q * (y * z) - r * sum->of[DYZ],
        [DZZ] = q * (z * z) - r * sum->of[DZZ],
    }};
    return s;
}

static inline struct sample soft_at(const struct scarp_octave *o, const struct place *p,
                                    int dimensions)
{
    const int depth = dimensions == 3 ? 1 : 0;
    struct sample sum;
    for (int i = 0; i < OUTPUTS; i++) {
        sum.of[i] = zero_at(p, dimensions);
    }
    for (int z = -depth; z <= depth; z++) {
        for (int y = -1; y <= 1; y++) {
            for (int x = -1; x <= 1; x++) {
                const int step[3] = {x, y, z};
                const struct feature f = feature_at(o, p, step, dimensions);
                soft_add(&sum, &f);
            }
        }
    }
    return soft_root(&sum);
}

/* Each cell's own value, in units of 2^-31; all derivatives are 0. */
static inline struct sample cell_value(const struct feature *f)
{
    const float zero = 0.0f * f->s; /* or NaN */
    struct sample s;
    for (int i = 0; i < OUTPUTS; i++) {
        s.of[i] = zero;
    }
    s.of[VALUE] = (float)(int32_t)(f->hash * FEATURE_ID) + zero;
    return s;
}

static inline struct sample cells_at(enum scarp_basis basis, const struct scarp_octave *o,
                                     const struct place *p, int dimensions)
{
    struct sample s;
    if (basis == SCARP_CELL_SOFT) {
        s = soft_at(o, p, dimensions);
    } else {
        const struct nearest n = nearest_at(o, p, dimensions);
        const struct sample first = distance_to(&n.first), second = distance_to(&n.second);
        if (basis == SCARP_CELL_VALUE) {
            return cell_value(&n.first);
        }
        s = basis == SCARP_CELL_F1 ? first : second;
        for (int i = 0; i < OUTPUTS && basis == SCARP_CELL_EDGE; i++) {
            s.of[i] -= first.of[i];
        }
    }
    s.of[VALUE] += basis == SCARP_CELL_SOFT ? o->middle : -o->middle;
    return s;
}

#endif
