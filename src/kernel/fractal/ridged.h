/* SPDX-License-Identifier: MIT
 *
 * Ridged noise: the sum of a_k s_k with s_k = v_k (1 - |n_k|)^2, v_0 = 1, v_{k+1} = min(1, 2 s_k).
 * Its pass is in hybrid.h, which includes this file. The reference is in formulas/fractal.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_RIDGED_H
#define SCARP_KERNEL_FRACTAL_RIDGED_H

#include "pingpong.h"

/* a where mask is all ones, b where it is 0. */
VEC_INLINE vf either(vu mask, vf a, vf b)
{
    return (vf)(((vu)a & mask) | ((vu)b & ~mask));
}

/* First and second derivative of v r^2, r = 1 - m, along i and along i and j. */
VEC_INLINE vf ridge_first(vf v, vf r, vf wi, vf mi)
{
    return r * r * wi - 2.0f * v * r * mi;
}

/* A first derivative of the weight and of m. */
struct slopes {
    vf w, m;
};

VEC_INLINE vf ridge_second(vf v, vf r, struct slopes i, struct slopes j, struct slopes ij)
{
    return (r * r * ij.w - 2.0f * r * (i.w * j.m + j.w * i.m)) +
           (2.0f * v * (i.m * j.m) - 2.0f * v * r * ij.m);
}

VEC_INLINE struct sample ridge(const struct sample *w, const struct sample *m, struct variant v)
{
    const vf r = 1.0f - m->value;
    struct sample s;
    s.value = w->value * (r * r);
    if (v.order >= 1) {
        s.dx = ridge_first(w->value, r, w->dx, m->dx);
        s.dy = ridge_first(w->value, r, w->dy, m->dy);
        if (v.dimensions == 3) {
            s.dz = ridge_first(w->value, r, w->dz, m->dz);
        }
    }
    if (v.order >= 2) {
#define BOTH(member) ((struct slopes){w->member, m->member})
        s.dxx = ridge_second(w->value, r, BOTH(dx), BOTH(dx), BOTH(dxx));
        s.dxy = ridge_second(w->value, r, BOTH(dx), BOTH(dy), BOTH(dxy));
        s.dyy = ridge_second(w->value, r, BOTH(dy), BOTH(dy), BOTH(dyy));
        if (v.dimensions == 3) {
            s.dxz = ridge_second(w->value, r, BOTH(dx), BOTH(dz), BOTH(dxz));
            s.dyz = ridge_second(w->value, r, BOTH(dy), BOTH(dz), BOTH(dyz));
            s.dzz = ridge_second(w->value, r, BOTH(dz), BOTH(dz), BOTH(dzz));
        }
#undef BOTH
    }
    return s;
}

/* The next weight: 2 s, but 1 where that is more. */
VEC_INLINE struct sample ridge_weight(const struct sample *s, struct variant v)
{
    const vu less = (vu)(2.0f * s->value < vf_set(1.0f));
    struct sample w;
#define DO(i, member, rank)                                                                        \
    w.member = either(less, 2.0f * s->member, vf_set(rank == 0 ? 1.0f : 0.0f))
    EACH_OUTPUT(v, DO);
#undef DO
    return w;
}

#endif
