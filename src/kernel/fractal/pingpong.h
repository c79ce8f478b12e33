/* SPDX-License-Identifier: MIT
 *
 * Folded octaves: turbulence, |n|, and ping-pong, t = (n + 1) sharpness folded to [-1, 1] with
 * period 2. One pass serves both. The references are in formulas/fractal.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_PINGPONG_H
#define SCARP_KERNEL_FRACTAL_PINGPONG_H

#include "turbulence.h"

VEC_INLINE vf absolute(vf x)
{
    return (vf)((vu)x & vu_set(0x7fffffffu));
}

/* What an octave's value becomes, and the sign of its derivatives. */
struct fold {
    vf value;
    struct sign sign;
};

VEC_INLINE struct fold fold_magnitude(vf n)
{
    const struct sign sign = sign_of(n);
    const struct fold fold = {with_sign(n, sign), sign};
    return fold;
}

/* The derivatives are 0 on creases, where the value is 1 or -1. */
VEC_INLINE struct fold fold_pingpong(vf n, float sharpness)
{
    const vf t = (n + 1.0f) * vf_set(sharpness);
    const vf e = 1.0f - (t - 2.0f * vf_floor(t * 0.5f));
    const vf value = 1.0f - 2.0f * absolute(e);
    const struct fold fold = {value,
                              {(vu)e & vu_set(0x80000000u), (vu)(absolute(value) != vf_set(1.0f))}};
    return fold;
}

VEC_INLINE struct fold fold_of(const struct scarp_call_plan *plan, vf n)
{
    return plan->fractal == SCARP_PINGPONG ? fold_pingpong(n, plan->sharpness) : fold_magnitude(n);
}

/* The weight of an octave's derivatives, with the factor of the fold. */
VEC_INLINE float fold_weight(const struct scarp_call_plan *plan, float weight)
{
    return plan->fractal == SCARP_PINGPONG ? weight * (2.0f * plan->sharpness) : weight;
}

VEC_INLINE struct sample folded(const struct sample *n, const struct fold *fold, struct variant v)
{
    struct sample m;
#define DO(i, member, rank) m.member = rank == 0 ? fold->value : with_sign(n->member, fold->sign)
    EACH_OUTPUT(v, DO);
#undef DO
    return m;
}

VEC_INLINE void fold_run(const struct shaping *shaping, const struct outputs *outputs, enum put put,
                         struct variant v)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const struct scarp_call_plan plan = {.fractal = shaping->plan->fractal,
                                         .sharpness = shaping->plan->sharpness};
    const float weight = shaping->octave->weight, slope = fold_weight(&plan, weight);
    const size_t size = sample_size(v.dimensions, v.order);
    const struct weights weights = {{weight, slope, slope}};
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            const struct sample n = sample_load(noise, v);
            const struct fold fold = fold_of(&plan, n.value);
            const struct sample m = folded(&n, &fold, v);
            add_sample(&to, to_at, &weights, &m, v, put);
            to_at += to.block;
            noise += size;
        }
        outputs_next_row(&to, v);
    }
}

#define FOLD_PASS(name, dimensions, order)                                                         \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        fold_run(shaping, to, put, v);                                                             \
    }

FOLD_PASS(fold2_order0, 2, 0)
FOLD_PASS(fold2_order1, 2, 1)
FOLD_PASS(fold2_order2, 2, 2)
FOLD_PASS(fold3_order0, 3, 0)
FOLD_PASS(fold3_order1, 3, 1)
FOLD_PASS(fold3_order2, 3, 2)

#undef FOLD_PASS

#endif
