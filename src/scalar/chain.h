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

/* The numbers of a call, as its formula has them. */
union numbers {
    struct {
        float x, y, z, w;
    };
    vec3 xyz;
    vec4 xyzw;
};

/* Those that `which` has, a bit for each. */
static inline union numbers numbers_of(const struct scarp_chain *call, unsigned which)
{
    float k[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    int count = 0;
    for (int i = 0; i < CHAIN_NUMBERS; i++) {
        if ((which >> i & 1u) != 0) {
            k[count++] = call->number[i];
        }
    }
    return (union numbers){{k[0], k[1], k[2], k[3]}};
}

static inline float element(const float *array, size_t i)
{
    return array != NULL ? array[i] : 0.0f;
}

/* Element i of the partial derivatives. */
static inline struct partials partials_at(const float *const of[PARTIALS], size_t i)
{
    const struct partials p = {element(of[PARTIAL_F], i),  element(of[PARTIAL_A], i),
                               element(of[PARTIAL_B], i),  element(of[PARTIAL_AA], i),
                               element(of[PARTIAL_AB], i), element(of[PARTIAL_BB], i)};
    return p;
}

/* Each function is the call of its row of functions.def, which shaders have, too; i is the element
   of partial derivatives. */
WHOLE struct sample chained(const struct scarp_chain *call, const struct sample in[CHAIN_INPUTS],
                            size_t i)
{
    const struct sample a = in[CHAIN_A], b = in[CHAIN_B], m = in[CHAIN_M];
    union numbers k = {{0.0f, 0.0f, 0.0f, 0.0f}};
    struct sample s = a;
#define N(number) 1u << CHAIN_##number
#define TAKE(numbers) k = numbers_of(call, numbers);
#define CASE(NAME, FORM, formula, numbers)                                                         \
    case CHAIN_##NAME: {                                                                           \
        IF_NUMBERS_##FORM(TAKE(numbers)) s = formula;                                              \
        break;                                                                                     \
    }
#define OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, formula, which)                  \
    IF_KERNEL_##COMPUTED(CASE(NAME, FORM, formula, which))
#define FUNCTION(NAME, name, FORM, COMPUTED, take, traits, range, formula, which, ...)             \
    OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, formula, which)
    switch (call->function) {
#include "../plan/functions.def"
    case CHAIN_APPLY1: {
        const struct partials p = partials_at(call->partial, i);
        s = chain_apply1(a, p.f, p.a, p.aa);
        break;
    }
    case CHAIN_APPLY2: s = chain_apply2(a, b, partials_at(call->partial, i)); break;
    }
    return s;
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
    struct sample in[CHAIN_INPUTS];
    for (int input = 0; input < CHAIN_INPUTS; input++) {
        in[input] = input_at(call->in[input], i);
    }
    struct sampled of = {chained(call, in, i), 0.0f};
    if (call->out[DPHASE] != NULL) {
        for (int input = 0; input < CHAIN_INPUTS; input++) {
            in[input] = along_phase(in[input].value, element(call->in[input][DPHASE], i));
        }
        of.by_phase = chained(call, in, i).gradient.x;
    }
    put(call->out, i, &of);
}

#endif
