/* SPDX-License-Identifier: MIT
 *
 * Shaders: value noise; as scalar/value.h. Included by simplex.h.
 */
#ifndef SCARP_GPU_VALUE_H
#define SCARP_GPU_VALUE_H

#include "gradient.h"

static inline struct slope flat_of(float value)
{
    return slope_of(0.0f, value);
}

static inline struct column value_column2(uvec3 key, uint x, struct place p, struct fade v)
{
    const float c0 = lattice_value(hash2(key, x, p.cell.y));
    const float c1 = lattice_value(hash2(key, x, p.next.y));
    const float d = sub(c1, c0);
    struct column c;
    c.value = flat_of(add(c0, mul(v.u, d)));
    c.y = flat_of(mul(v.du, d));
    c.yy = flat_of(mul(v.ddu, d));
    c.z = flat_of(0.0f);
    c.yz = flat_of(0.0f);
    c.zz = flat_of(0.0f);
    return c;
}

static inline struct column value_column3(uvec3 key, uint x, struct place p, struct fade v,
                                          struct fade w)
{
    const float c00 = lattice_value(hash3(key, x, p.cell.y, p.cell.z));
    const float c01 = lattice_value(hash3(key, x, p.cell.y, p.next.z));
    const float c10 = lattice_value(hash3(key, x, p.next.y, p.cell.z));
    const float c11 = lattice_value(hash3(key, x, p.next.y, p.next.z));
    const float dz0 = sub(c01, c00);
    const float dz1 = sub(c11, c10);
    const float e0 = add(c00, mul(w.u, dz0));
    const float e1 = add(c10, mul(w.u, dz1));
    const float dy = sub(e1, e0);
    const float ddz = sub(dz1, dz0);
    const float dz = add(dz0, mul(v.u, ddz));
    struct column c;
    c.value = flat_of(add(e0, mul(v.u, dy)));
    c.y = flat_of(mul(v.du, dy));
    c.z = flat_of(mul(w.du, dz));
    c.yy = flat_of(mul(v.ddu, dy));
    c.yz = flat_of(mul(v.du, mul(w.du, ddz)));
    c.zz = flat_of(mul(w.ddu, dz));
    return c;
}

static inline struct sample value_at(struct octave o, struct level l, struct place p,
                                     int dimensions)
{
    const struct fade f = fade(l.fade, p.t.x);
    const struct fade v = fade(l.fade, p.t.y);
    struct column left;
    struct column right;
    if (dimensions == 2) {
        left = value_column2(o.key, p.cell.x, p, v);
        right = value_column2(o.key, p.next.x, p, v);
    } else {
        const struct fade w = fade(l.fade, p.t.z);
        left = value_column3(o.key, p.cell.x, p, v, w);
        right = value_column3(o.key, p.next.x, p, v, w);
    }
    return join(left, right, p.t.x, f, true);
}

#endif
