/* SPDX-License-Identifier: MIT
 *
 * The functions of the chain rule that are given by partial derivatives: their values, and these, of
 * a vector of points.
 */
#ifndef SCARP_KERNEL_CHAIN_PARTIALS_H
#define SCARP_KERNEL_CHAIN_PARTIALS_H

#include "../plan/chain.h"
#include "basis/fade.h"

struct chain_partials {
    vf f, a, b, aa;
};

/* The number, but NaN where v is NaN. */
VEC_INLINE vf chain_nan_of(vf v, vf number)
{
    return (vf)vu_choose((vu)(v != v), (vu)v, (vu)number);
}

VEC_INLINE vf chain_within_unit(vf t)
{
    const vf zero = vf_set(0.0f), one = vf_set(1.0f);
    return vm_choose(vm_less(t, zero), zero, vm_choose(vm_less(one, t), one, t));
}

VEC_INLINE struct fade chain_fade(vf t)
{
    const vf one = vf_set(1.0f);
    struct fade s = fade(SCARP_QUINTIC, t);
    s.u = vm_choose(vm_less(one, s.u), one, s.u);
    return s;
}

/* All ones where min (of two) takes b, or max does. */
VEC_INLINE vu chain_takes_b(vf a, vf b, int greater)
{
    return (vu)(greater ? a < b : b < a) | (vu)(b != b);
}

VEC_INLINE struct chain_partials chain_smooth(const struct scarp_chain *call, vf a, vf b,
                                              int greater)
{
    const vu second = chain_takes_b(a, b, greater);
    const vf zero = vf_set(0.0f);
    const vf distance = (vf)((vu)(a - b) & 0x7fffffffu);
    const vf left = 1.0f - distance * call->number[CHAIN_INVERSE];
    const vf h = vm_choose(vm_less(left, zero), zero, left);
    const vf half = 0.5f * (h * h);
    const vf near = 1.0f - half;
    const struct chain_partials p = {.f = (vf)vu_choose(second, (vu)b, (vu)a) -
                                          h * h * h * call->number[CHAIN_DEPTH],
                                     .a = (vf)vu_choose(second, (vu)half, (vu)near),
                                     .b = (vf)vu_choose(second, (vu)near, (vu)half),
                                     .aa = h * call->number[CHAIN_BEND]};
    return p;
}

VEC_INLINE struct chain_partials chain_clamp(const struct scarp_chain *call, vf v)
{
    const vf lo = vf_set(call->number[CHAIN_LO]), hi = vf_set(call->number[CHAIN_HI]);
    const vm below = vm_less(v, lo), above = vm_less(hi, v);
    const vf slope = vm_choose(vm_or(below, above), vf_set(0.0f), vf_set(1.0f));
    const struct chain_partials p = {.f = vm_choose(below, lo, vm_choose(above, hi, v)),
                                     .a = chain_nan_of(v, slope)};
    return p;
}

VEC_INLINE struct chain_partials chain_abs(const struct scarp_chain *call, vf v)
{
    (void)call;
    const vf one = (vf)(((vu)v & 0x80000000u) | (vu)vf_set(1.0f));
    const vf sign = (vf)((vu)one & (vu)(v != vf_set(0.0f)));
    const struct chain_partials p = {.f = (vf)((vu)v & 0x7fffffffu), .a = chain_nan_of(v, sign)};
    return p;
}

VEC_INLINE struct chain_partials chain_smooth_abs(const struct scarp_chain *call, vf v)
{
    const vf f = vf_sqrt(v * v + call->number[CHAIN_ROUND2]);
    const vf inverse_f = 1.0f / f;
    const vf share = call->number[CHAIN_ROUND] * inverse_f;
    const struct chain_partials p = {.f = f, .a = v * inverse_f, .aa = share * share * inverse_f};
    return p;
}

VEC_INLINE struct chain_partials chain_smoothstep(const struct scarp_chain *call, vf v)
{
    const vf inverse = vf_set(call->number[CHAIN_INVERSE]);
    const struct fade s = chain_fade(chain_within_unit((v - call->number[CHAIN_LO]) * inverse));
    const struct chain_partials p = {
        .f = s.u, .a = s.du * inverse, .aa = s.ddu * inverse * inverse};
    return p;
}

VEC_INLINE struct chain_partials chain_terrace(const struct scarp_chain *call, vf v)
{
    const vf steps = vf_set(call->number[CHAIN_STEPS]), steep = vf_set(call->number[CHAIN_STEEP]);
    const vf strength = vf_set(call->number[CHAIN_STRENGTH]);
    const vf t = v * steps;
    const vf whole = vf_floor(t);
    const vf u = t - whole;
    const struct fade s = chain_fade(chain_within_unit((u - 0.5f) * steep + 0.5f));
    const vf rise = u + strength * (s.u - u);
    const struct chain_partials p = {.f = (whole + rise) * call->number[CHAIN_HEIGHT],
                                     .a = 1.0f + strength * (s.du * steep - 1.0f),
                                     .aa = s.ddu * steep * steep * steps * strength};
    return p;
}

VEC_INLINE struct chain_partials chain_smooth_min(const struct scarp_chain *call, vf a, vf b)
{
    return chain_smooth(call, a, b, 0);
}

VEC_INLINE struct chain_partials chain_smooth_max(const struct scarp_chain *call, vf a, vf b)
{
    return chain_smooth(call, a, b, 1);
}

VEC_INLINE struct chain_partials chain_partials_of(const struct scarp_chain *call,
                                                   enum scarp_chain_function function, vf a, vf b)
{
#define OPERATOR(NAME, name, FORM, COMPUTED, ...)                                                  \
    IF_ONE_##COMPUTED(case CHAIN_##NAME                                                            \
                      : return chain_##name(call, a);)                                             \
        IF_SMOOTH_##COMPUTED(case CHAIN_##NAME                                                     \
                             : return chain_##name(call, a, b);)
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (function) {
#include "../plan/functions.def"
    default: return (struct chain_partials){.f = a, .b = b}; /* there is no other */
    }
}

#endif
