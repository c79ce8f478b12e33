/* SPDX-License-Identifier: MIT
 *
 * Value noise with gradient and Hessian: see noise.h for the order of operations. Included by
 * octave.h; the reference is scalar/basis.h. All in units of 2^-31 of the lattice values; the
 * plan's amplitudes carry the factor.
 */
#ifndef SCARP_KERNEL_VALUE_H
#define SCARP_KERNEL_VALUE_H

#include "noise.h"

/* A column: the value and its derivatives along y and z; nothing depends on x. */
struct value_column {
    vf value, y, z, yy, yz, zz;
};

/* The hash as a signed number, rounded to float. (Taking its top 24 bits first, so that nothing
   needs rounding, costs 7 to 10 % of value noise.) */
VEC_INLINE vf lattice_value(vu hash)
{
    return vf_from_vi((vi)hash);
}

VEC_INLINE struct value_column value_column2(vu h0, vu h1, struct fade v, int order)
{
    const vf c0 = lattice_value(h0);
    const vf c1 = lattice_value(h1);
    const vf d = c1 - c0;
    struct value_column c;
    c.value = c0 + v.u * d;
    if (order >= 1) {
        c.y = v.du * d;
    }
    if (order >= 2) {
        c.yy = v.ddu * d;
    }
    return c;
}

VEC_INLINE struct value_column value_column3(vu h00, vu h01, vu h10, vu h11, struct fade v,
                                             struct fade w, int order)
{
    const vf c00 = lattice_value(h00);
    const vf c01 = lattice_value(h01);
    const vf c10 = lattice_value(h10);
    const vf c11 = lattice_value(h11);
    const vf dz0 = c01 - c00;
    const vf dz1 = c11 - c10;
    const vf e0 = c00 + w.u * dz0;
    const vf e1 = c10 + w.u * dz1;
    const vf dy = e1 - e0;
    struct value_column c;
    c.value = e0 + v.u * dy;
    if (order >= 1) {
        const vf ddz = dz1 - dz0;
        const vf dz = dz0 + v.u * ddz;
        c.y = v.du * dy;
        c.z = w.du * dz;
        if (order >= 2) {
            c.yy = v.ddu * dy;
            c.yz = v.du * (w.du * ddz);
            c.zz = w.ddu * dz;
        }
    }
    return c;
}

VEC_INLINE struct sample value_join(const struct value_column *l, const struct value_column *r,
                                    struct fade u, int dimensions, int order)
{
    struct sample s;
    const vf d = r->value - l->value;
    s.value = l->value + u.u * d;
    if (order >= 1) {
        const vf dy = r->y - l->y;
        s.dx = u.du * d;
        s.dy = l->y + u.u * dy;
        if (order >= 2) {
            s.dxx = u.ddu * d;
            s.dxy = u.du * dy;
            s.dyy = mix(l->yy, r->yy, u.u);
        }
        if (dimensions == 3) {
            const vf dz = r->z - l->z;
            s.dz = l->z + u.u * dz;
            if (order >= 2) {
                s.dxz = u.du * dz;
                s.dyz = mix(l->yz, r->yz, u.u);
                s.dzz = mix(l->zz, r->zz, u.u);
            }
        }
    }
    return s;
}

VEC_INLINE struct sample value2(const struct lattice *lattice, size_t b, enum scarp_fade kind,
                                int order)
{
    const struct fade u = fade(kind, lattice->x[b]);
    const struct fade v = fade(kind, lattice->y[b]);
    const struct value_column l =
        value_column2(lattice->hash[0][0][0][b], lattice->hash[0][1][0][b], v, order);
    const struct value_column r =
        value_column2(lattice->hash[1][0][0][b], lattice->hash[1][1][0][b], v, order);
    return value_join(&l, &r, u, 2, order);
}

VEC_INLINE struct sample value3(const struct lattice *lattice, size_t b, enum scarp_fade kind,
                                int order)
{
    const struct fade u = fade(kind, lattice->x[b]);
    const struct fade v = fade(kind, lattice->y[b]);
    const struct fade w = fade(kind, lattice->z[b]);
    const struct value_column l =
        value_column3(lattice->hash[0][0][0][b], lattice->hash[0][0][1][b],
                      lattice->hash[0][1][0][b], lattice->hash[0][1][1][b], v, w, order);
    const struct value_column r =
        value_column3(lattice->hash[1][0][0][b], lattice->hash[1][0][1][b],
                      lattice->hash[1][1][0][b], lattice->hash[1][1][1][b], v, w, order);
    return value_join(&l, &r, u, 3, order);
}

#endif
