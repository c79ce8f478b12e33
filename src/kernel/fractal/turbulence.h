/* SPDX-License-Identifier: MIT
 *
 * Turbulence: the sum of a_k |n_k|, whose pass is in pingpong.h, which includes this file. The
 * reference is in formulas/fractal.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_TURBULENCE_H
#define SCARP_KERNEL_FRACTAL_TURBULENCE_H

#include "turn.h"

/* The sign of n, and ones where it is not 0: see with_sign. */
struct sign {
    vu bit, mask;
};

VEC_INLINE struct sign sign_of(vf n)
{
    const struct sign s = {(vu)n & vu_set(0x80000000u), (vu)(n != vf_set(0.0f))};
    return s;
}

/* sign(n) a, and 0 where n is 0. */
VEC_INLINE vf with_sign(vf a, struct sign s)
{
    return (vf)(((vu)a ^ s.bit) & s.mask);
}

VEC_INLINE struct sample magnitude(const struct sample *n, struct variant v)
{
    const struct sign s = sign_of(n->value);
    struct sample m;
#define DO(i, member, rank) m.member = with_sign(n->member, s)
    EACH_OUTPUT(v, DO);
#undef DO
    return m;
}

#endif
