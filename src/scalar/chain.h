/* SPDX-License-Identifier: MIT
 *
 * Reference: the chain rule over samples, one point at a time.
 *
 * What depends on the numbers of a call alone (1 / k and the like) is computed once, in
 * calls/chain.c.
 */
#ifndef SCARP_SCALAR_CHAIN_H
#define SCARP_SCALAR_CHAIN_H

#include "../plan/chain.h"
#include "sample.h"

#include "../formulas/chain.h"

WHOLE struct sample chained(const struct scarp_chain *call, const struct sample in[CHAIN_INPUTS],
                            const struct partials *given)
{
    const struct sample a = in[CHAIN_A], b = in[CHAIN_B], m = in[CHAIN_M];
    const float *const k = call->number;
    const vec3 of_smooth = {k[CHAIN_INVERSE], k[CHAIN_DEPTH], k[CHAIN_BEND]};
    const vec4 of_terrace = {k[CHAIN_STEPS], k[CHAIN_HEIGHT], k[CHAIN_STEEP], k[CHAIN_STRENGTH]};
    struct sample s = a;
    switch (call->function) {
    case CHAIN_AFFINE: s = chain_affine(a, k[CHAIN_SCALE], k[CHAIN_OFFSET]); break;
    case CHAIN_ADD: s = sum_of(a, b); break;
    case CHAIN_MULTIPLY: s = chain_multiply(a, b); break;
    case CHAIN_MIX: s = chain_mix(a, b, m); break;
    case CHAIN_MIN: s = chain_min(a, b); break;
    case CHAIN_MAX: s = chain_max(a, b); break;
    case CHAIN_SMOOTH_MIN: s = chain_smooth_min(a, b, of_smooth); break;
    case CHAIN_SMOOTH_MAX: s = chain_smooth_max(a, b, of_smooth); break;
    case CHAIN_CLAMP: s = chain_clamp(a, k[CHAIN_LO], k[CHAIN_HI]); break;
    case CHAIN_ABS: s = chain_abs(a); break;
    case CHAIN_SMOOTH_ABS: s = chain_smooth_abs(a, k[CHAIN_ROUND], k[CHAIN_ROUND2]); break;
    case CHAIN_SMOOTHSTEP: s = chain_smoothstep(a, k[CHAIN_LO], k[CHAIN_INVERSE]); break;
    case CHAIN_TERRACE: s = chain_terrace(a, of_terrace); break;
    case CHAIN_APPLY1: s = chain_apply1(a, given->f, given->a, given->aa); break;
    case CHAIN_APPLY2: s = chain_apply2(a, b, *given); break;
    }
    return s;
}

static inline float element(const float *array, size_t i)
{
    return array != NULL ? array[i] : 0.0f;
}

/* Element i of an input. What the call does not have of it is 0. */
static inline struct sample input_at(const float *const of[OUTPUTS], size_t i)
{
    return sample_of(element(of[VALUE], i),
                     vec3_of(element(of[DX], i), element(of[DY], i), element(of[DZ], i)),
                     vec3_of(element(of[DXX], i), element(of[DYY], i), element(of[DZZ], i)),
                     vec3_of(element(of[DXY], i), element(of[DXZ], i), element(of[DYZ], i)));
}

/* Reads all that a point needs before anything is written: outputs may be where inputs are. */
static inline void chain_at(const struct scarp_chain *call, size_t i)
{
    const float *const *const given = call->partial;
    const struct partials partials = {element(given[PARTIAL_F], i),  element(given[PARTIAL_A], i),
                                      element(given[PARTIAL_B], i),  element(given[PARTIAL_AA], i),
                                      element(given[PARTIAL_AB], i), element(given[PARTIAL_BB], i)};
    struct sample in[CHAIN_INPUTS];
    for (int input = 0; input < CHAIN_INPUTS; input++) {
        in[input] = input_at(call->in[input], i);
    }
    struct sampled of = {chained(call, in, &partials), 0.0f};
    if (call->out[DPHASE] != NULL) {
        for (int input = 0; input < CHAIN_INPUTS; input++) {
            in[input] = along_phase(in[input].value, element(call->in[input][DPHASE], i));
        }
        of.by_phase = chained(call, in, &partials).gradient.x;
    }
    put(call->out, i, &of);
}

#endif
