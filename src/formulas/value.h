/* SPDX-License-Identifier: MIT
 *
 * Formulas: value noise. Its lattice values are in units of 2^-31; the plan's amplitudes carry the
 * factor.
 */
#ifndef SCARP_FORMULAS_VALUE_H
#define SCARP_FORMULAS_VALUE_H

#include "corners.h"

static inline float value2(struct lattice l, uint x, uint y)
{
    return lattice_value(component_hash_values(hash2(l.key, x, y), l.component));
}

static inline float value3(struct lattice l, uint x, uint y, uint z)
{
    return lattice_value(component_hash_values(hash3(l.key, x, y, z), l.component));
}

static inline struct column value_column2(struct lattice l, uint x, struct location p,
                                          struct fade v)
{
    const float c0 = value2(l, x, p.cell.y);
    const float c1 = value2(l, x, p.next.y);
    const float d = c1 - c0;
    const struct column c = {.value.b = c0 + v.u * d, .y.b = v.du * d, .yy.b = v.ddu * d};
    return c;
}

static inline struct column value_column3(struct lattice l, uint x, struct location p,
                                          struct fade v, struct fade w)
{
    const float c00 = value3(l, x, p.cell.y, p.cell.z);
    const float c01 = value3(l, x, p.cell.y, p.next.z);
    const float c10 = value3(l, x, p.next.y, p.cell.z);
    const float c11 = value3(l, x, p.next.y, p.next.z);
    const float dz0 = c01 - c00;
    const float dz1 = c11 - c10;
    const float e0 = c00 + w.u * dz0;
    const float e1 = c10 + w.u * dz1;
    const float dy = e1 - e0;
    const float ddz = dz1 - dz0;
    const float dz = dz0 + v.u * ddz; /* interpolated over y */
    const struct column c = {
        .value.b = e0 + v.u * dy,
        .y.b = v.du * dy,
        .z.b = w.du * dz,
        .yy.b = v.ddu * dy,
        .yz.b = v.du * (w.du * ddz),
        .zz.b = w.ddu * dz,
    };
    return c;
}

static inline struct sample value_at2(struct lattice l, uint kind, struct location p)
{
    const struct fade v = fade(kind, p.t.y);
    return join(value_column2(l, p.cell.x, p, v), value_column2(l, p.next.x, p, v), p.t.x,
                fade(kind, p.t.x), true);
}

static inline struct sample value_at3(struct lattice l, uint kind, struct location p)
{
    const struct fade v = fade(kind, p.t.y);
    const struct fade w = fade(kind, p.t.z);
    return join(value_column3(l, p.cell.x, p, v, w), value_column3(l, p.next.x, p, v, w), p.t.x,
                fade(kind, p.t.x), true);
}

static inline struct sample value_at(struct lattice l, uint kind, struct location p, int dimensions)
{
    if (dimensions == 2) {
        return value_at2(l, kind, p);
    }
    return value_at3(l, kind, p);
}

#endif
