/* SPDX-License-Identifier: MIT
 *
 * Ridged noise: the sum of a_k s_k with s_k = v_k (1 - |n_k|)^2, v_0 = 1, v_{k+1} = min(1, 2 s_k).
 * Its state is the weight v_k with its derivatives, a stored sample. Included by erosion.h; the
 * reference is scalar/ridged.h.
 */
#ifndef SCARP_KERNEL_SHAPE_RIDGED_H
#define SCARP_KERNEL_SHAPE_RIDGED_H

#include "turbulence.h"

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

VEC_INLINE void ridged_run(const struct shaping *shaping, const struct outputs *outputs,
                           enum put put, struct variant v)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    vf *state = shaping->state;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const float weight = shaping->octave->weight;
    const struct weights weights = {{weight, weight, weight}};
    const size_t size = sample_size(v.dimensions, v.order);
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            const struct sample n = sample_load(noise, v);
            const struct sample w = sample_load(state, v);
            const struct sample m = magnitude(&n, v);
            const struct sample s = ridge(&w, &m, v);
            const struct sample next = ridge_weight(&s, v);
            sample_store(state, &next, v);
            add_sample(&to, to_at, &weights, &s, v, put);
            to_at += to.block;
            noise += size;
            state += size;
        }
        outputs_next_row(&to, v);
    }
}

#define RIDGED_PASS(name, dimensions, order)                                                       \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        ridged_run(shaping, to, put, v);                                                           \
    }

RIDGED_PASS(ridged2_order0, 2, 0)
RIDGED_PASS(ridged2_order1, 2, 1)
RIDGED_PASS(ridged2_order2, 2, 2)
RIDGED_PASS(ridged3_order0, 3, 0)
RIDGED_PASS(ridged3_order1, 3, 1)
RIDGED_PASS(ridged3_order2, 3, 2)

#undef RIDGED_PASS

#endif
