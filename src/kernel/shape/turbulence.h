/* SPDX-License-Identifier: MIT
 *
 * Turbulence: the sum of a_k |n_k|. Included by ridged.h; the reference is scalar/turbulence.h.
 */
#ifndef SCARP_KERNEL_SHAPE_TURBULENCE_H
#define SCARP_KERNEL_SHAPE_TURBULENCE_H

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

VEC_INLINE void turbulence_run(const struct shaping *shaping, const struct outputs *outputs,
                               enum put put, struct variant v)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const float weight = shaping->octave->weight;
    const size_t size = sample_size(v.dimensions, v.order);
    const struct weights weights = {{weight, weight, weight}};
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            const struct sample n = sample_load(noise, v);
            const struct sample m = magnitude(&n, v);
            add_sample(&to, to_at, &weights, &m, v, put);
            to_at += to.block;
            noise += size;
        }
        outputs_next_row(&to, v);
    }
}

#define TURBULENCE_PASS(name, dimensions, order)                                                   \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        turbulence_run(shaping, to, put, v);                                                       \
    }

TURBULENCE_PASS(turbulence2_order0, 2, 0)
TURBULENCE_PASS(turbulence2_order1, 2, 1)
TURBULENCE_PASS(turbulence2_order2, 2, 2)
TURBULENCE_PASS(turbulence3_order0, 3, 0)
TURBULENCE_PASS(turbulence3_order1, 3, 1)
TURBULENCE_PASS(turbulence3_order2, 3, 2)

#undef TURBULENCE_PASS

#endif
