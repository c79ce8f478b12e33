/* SPDX-License-Identifier: MIT
 *
 * Value noise with gradient and Hessian: see columns.h for the order of operations. The reference
 * is formulas/value.h. Lattice values are in units of 2^-31; the plan's amplitudes carry the
 * factor. Nothing of a column depends on x, so the slopes stay unset.
 */
#ifndef SCARP_KERNEL_BASIS_VALUE_H
#define SCARP_KERNEL_BASIS_VALUE_H

#include "columns.h"

/* The hash as a signed number, rounded to float. (Taking its top 24 bits first, so that nothing
   needs rounding, costs 7 to 10 % of value noise.) */
VEC_INLINE vf lattice_value(vu hash)
{
    return vf_from_vi((vi)hash);
}

VEC_INLINE struct column value_column2(const struct corners *h, const struct across *p,
                                       struct variant v)
{
    const vf c0 = lattice_value(h->h[0][0]);
    const vf c1 = lattice_value(h->h[1][0]);
    const vf d = c1 - c0;
    struct column c;
    c.value.b = c0 + p->v.u * d;
    if (v.order >= 1) {
        c.y.b = p->v.du * d;
    }
    if (v.order >= 2) {
        c.yy.b = p->v.ddu * d;
    }
    return c;
}

VEC_INLINE struct column value_column3(const struct corners *h, const struct across *p,
                                       struct variant variant)
{
    const struct fade v = p->v, w = p->w;
    const vf c00 = lattice_value(h->h[0][0]);
    const vf c01 = lattice_value(h->h[0][1]);
    const vf c10 = lattice_value(h->h[1][0]);
    const vf c11 = lattice_value(h->h[1][1]);
    const vf dz0 = c01 - c00;
    const vf dz1 = c11 - c10;
    const vf e0 = c00 + w.u * dz0;
    const vf e1 = c10 + w.u * dz1;
    const vf dy = e1 - e0;
    struct column c;
    c.value.b = e0 + v.u * dy;
    if (variant.order >= 1) {
        const vf ddz = dz1 - dz0;
        const vf dz = dz0 + v.u * ddz;
        c.y.b = v.du * dy;
        c.z.b = w.du * dz;
        if (variant.order >= 2) {
            c.yy.b = v.ddu * dy;
            c.yz.b = v.du * (w.du * ddz);
            c.zz.b = w.ddu * dz;
        }
    }
    return c;
}

VEC_INLINE struct column value_column(const struct corners *h, const struct across *p,
                                      struct variant v)
{
    return v.dimensions == 2 ? value_column2(h, p, v) : value_column3(h, p, v);
}

#endif
