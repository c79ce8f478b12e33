/* SPDX-License-Identifier: MIT
 *
 * The fades and their derivatives; the reference is formulas/corners.h.
 */
#ifndef SCARP_KERNEL_BASIS_FADE_H
#define SCARP_KERNEL_BASIS_FADE_H

#include "../../plan/call.h"

/* s is t - 1, which the caller needs too. */
struct fade {
    vf s, u, du, ddu;
};

/* quintic: u = 6t^5 - 15t^4 + 10t^3   u' = 30 t^2 (t-1)^2   u'' = 60 t (t-1) (2t-1)
 * cubic:   u = 3t^2 - 2t^3            u' = 6 t (1-t)        u'' = 6 - 12t
 * The quintic in a form where nothing cancels: see formulas/corners.h. In the cubic 2t is exact. */
VEC_INLINE struct fade fade(enum scarp_fade kind, vf t)
{
    const vf s = t - 1.0f;
    const vf ts = t * s;
    struct fade f;
    f.s = s;
    if (kind == SCARP_QUINTIC) {
        f.u = t * t * t * (s * (t * 6.0f - 9.0f) + 1.0f);
        f.du = 30.0f * (ts * ts);
        f.ddu = 60.0f * ts * (t + s);
    } else {
        f.u = t * t * vf_exact_fma(vf_set(-2.0f), t, vf_set(3.0f));
        f.du = -6.0f * ts;
        f.ddu = 6.0f - 12.0f * t;
    }
    return f;
}

VEC_INLINE vf mix(vf a, vf b, vf u)
{
    return a + u * (b - a);
}

#endif
