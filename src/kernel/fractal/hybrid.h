/* SPDX-License-Identifier: MIT
 *
 * Octaves weighted by those before: ridged noise, and hybrid multifractal noise, the sum of a_k u_k
 * with u_k = v_k (n_k + sharpness), v_0 = 1, v_(k+1) = gain^k u_k, clamped to [-1, 1]. One pass
 * serves both. The state is the weight v_k with its derivatives, a stored sample. The references
 * are in formulas/fractal.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_HYBRID_H
#define SCARP_KERNEL_FRACTAL_HYBRID_H

#include "ridged.h"

/* First and second derivative of v r, r = n + sharpness, along i and along i and j. */
VEC_INLINE vf hybrid_first(vf v, vf r, vf wi, vf ni)
{
    return r * wi + v * ni;
}

VEC_INLINE vf hybrid_second(vf v, vf r, struct slopes i, struct slopes j, struct slopes ij)
{
    return (r * ij.w + v * ij.m) + (i.w * j.m + j.w * i.m);
}

VEC_INLINE struct sample hybrid(const struct sample *w, const struct sample *n, float sharpness,
                                struct variant v)
{
    const vf r = n->value + vf_set(sharpness);
    struct sample u;
    u.value = w->value * r;
    if (v.order >= 1) {
        u.dx = hybrid_first(w->value, r, w->dx, n->dx);
        u.dy = hybrid_first(w->value, r, w->dy, n->dy);
        if (v.dimensions == 3) {
            u.dz = hybrid_first(w->value, r, w->dz, n->dz);
        }
    }
    if (v.order >= 2) {
#define BOTH(member) ((struct slopes){w->member, n->member})
        u.dxx = hybrid_second(w->value, r, BOTH(dx), BOTH(dx), BOTH(dxx));
        u.dxy = hybrid_second(w->value, r, BOTH(dx), BOTH(dy), BOTH(dxy));
        u.dyy = hybrid_second(w->value, r, BOTH(dy), BOTH(dy), BOTH(dyy));
        if (v.dimensions == 3) {
            u.dxz = hybrid_second(w->value, r, BOTH(dx), BOTH(dz), BOTH(dxz));
            u.dyz = hybrid_second(w->value, r, BOTH(dy), BOTH(dz), BOTH(dyz));
            u.dzz = hybrid_second(w->value, r, BOTH(dz), BOTH(dz), BOTH(dzz));
        }
#undef BOTH
    }
    return u;
}

/* The next weight: `share` times u, but 1 or -1 where that is beyond. */
VEC_INLINE struct sample hybrid_weight(const struct sample *u, float share, struct variant v)
{
    const vf t = vf_set(share) * u->value;
    const vu less = (vu)(absolute(t) < vf_set(1.0f));
    const vf end = (vf)((vu)vf_set(1.0f) | ((vu)t & vu_set(0x80000000u)));
    struct sample w;
#define DO(i, member, rank)                                                                        \
    w.member = rank == 0 ? either(less, t, end) : (vf)((vu)(vf_set(share) * u->member) & less)
    EACH_OUTPUT(v, DO);
#undef DO
    return w;
}

/* What an octave adds, of the noise and of the weight, which becomes the next one. */
VEC_INLINE struct sample weighted(const struct scarp_octave *o, const struct sample *n,
                                  struct sample *weight, float sharpness, int is_hybrid,
                                  struct variant v)
{
    struct sample s;
    if (is_hybrid) {
        s = hybrid(weight, n, sharpness, v);
        *weight = hybrid_weight(&s, o->share, v);
    } else {
        const struct sample m = magnitude(n, v);
        s = ridge(weight, &m, v);
        *weight = ridge_weight(&s, v);
    }
    return s;
}

VEC_INLINE void weighted_run(const struct shaping *shaping, const struct outputs *outputs,
                             enum put put, struct variant v, int is_hybrid)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    vf *state = shaping->state;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const float sharpness = shaping->plan->sharpness;
    const struct scarp_octave octave = {.share = shaping->octave->share};
    const float weight = shaping->octave->weight;
    const struct weights weights = {{weight, weight, weight}};
    const size_t size = sample_size(v.dimensions, v.order);
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            const struct sample n = sample_load(noise, v);
            struct sample w = sample_load(state, v);
            const struct sample s = weighted(&octave, &n, &w, sharpness, is_hybrid, v);
            sample_store(state, &w, v);
            add_sample(&to, to_at, &weights, &s, v, put);
            to_at += to.block;
            noise += size;
            state += size;
        }
        outputs_next_row(&to, v);
    }
}

#define WEIGHTED_PASS(name, dimensions, order)                                                     \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        const int is_hybrid = shaping->plan->fractal == SCARP_HYBRID;                              \
        if (order == 2) {                                                                          \
            weighted_run(shaping, to, put, v, is_hybrid);                                          \
        } else if (is_hybrid) { /* a loop of its own takes 5 % less of both */                     \
            weighted_run(shaping, to, put, v, 1);                                                  \
        } else {                                                                                   \
            weighted_run(shaping, to, put, v, 0);                                                  \
        }                                                                                          \
    }

WEIGHTED_PASS(weighted2_order0, 2, 0)
WEIGHTED_PASS(weighted2_order1, 2, 1)
WEIGHTED_PASS(weighted2_order2, 2, 2)
WEIGHTED_PASS(weighted3_order0, 3, 0)
WEIGHTED_PASS(weighted3_order1, 3, 1)
WEIGHTED_PASS(weighted3_order2, 3, 2)

#undef WEIGHTED_PASS

#endif
