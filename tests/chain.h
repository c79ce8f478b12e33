/* SPDX-License-Identifier: MIT
 *
 * The functions of the chain rule that kernels compute, by the cases of functions.def: what all
 * tests that call them have in common.
 */
#ifndef SCARP_TESTS_CHAIN_H
#define SCARP_TESTS_CHAIN_H

#include "../src/plan/functions.h"
#include "outputs.h"

#define CHAIN_INPUTS 3
#define CHAIN_PARTIALS 6

/* The cases of functions.def, and those that take partial derivatives, which are in two forms. */
#define CHAIN_TABLE "functions.def"
#define CHAIN_PARTIAL_CASES(CASE) CASE(apply1, 1) CASE(apply2, 2)

#define CASE(name, ...) CHAIN_##name,
#define PARTIAL_CASE(name, inputs) CHAIN_##name,
enum chain {
#include CHAIN_TABLE
    CHAIN_PARTIAL_CASES(PARTIAL_CASE) CHAINS
};
#undef PARTIAL_CASE

/* A case: how many inputs it has, and whether it takes partial derivatives; its numbers, and what
   kinds of numbers these are. */
#define NUMBERS_OF(...) __VA_ARGS__
#define CASE(name, function, COMPUTED, FORM, kinds, numbers, ...)                                  \
    {#name, INPUTS_OF_##FORM, 0, kinds, {NUMBERS_OF numbers}},
#define PARTIAL_CASE(name, inputs) {#name, inputs, 1, "", {0.0f}},
static const struct {
    const char *name;
    int inputs, partials;
    const char *kinds;
    float number[3];
} chain_kinds[CHAINS] = {
#include CHAIN_TABLE
    CHAIN_PARTIAL_CASES(PARTIAL_CASE)};
#undef PARTIAL_CASE

/* Samples whose members are arrays of `points` numbers, one after the other; 0: one array */
static inline struct scarp_samples chain_samples(float *m, size_t points)
{
    const struct scarp_samples s = {m,
                                    m + points,
                                    m + 2 * points,
                                    m + 3 * points,
                                    m + 4 * points,
                                    m + 5 * points,
                                    m + 6 * points,
                                    m + 7 * points,
                                    m + 8 * points,
                                    m + 9 * points,
                                    m + 10 * points,
                                    {NULL}};
    return s;
}

/* Calls f with any numbers, of inputs of which some may be NULL. */
static inline enum scarp_status chain_call_with(enum chain f, const float k[3], size_t count,
                                                const struct scarp_samples *const in[CHAIN_INPUTS],
                                                const struct scarp_partials *partials,
                                                const struct scarp_samples *out)
{
#define CASE(name, function, COMPUTED, FORM, ...)                                                  \
    case CHAIN_##name: return FORM_##FORM(scarp_##function, count, in, k, out);
    switch (f) {
#include CHAIN_TABLE
    case CHAIN_apply1: return scarp_apply1(count, in[0], partials, out);
    default: return scarp_apply2(count, in[0], in[1], partials, out);
    }
}

static inline enum scarp_status chain_call(enum chain f, size_t count,
                                           const struct scarp_samples in[CHAIN_INPUTS],
                                           const struct scarp_partials *partials,
                                           const struct scarp_samples *out)
{
    const struct scarp_samples *const at[CHAIN_INPUTS] = {&in[0], &in[1], &in[2]};
    return chain_call_with(f, chain_kinds[f].number, count, at, partials, out);
}

/* Partial derivatives for calls where only bits matter: members of the inputs. */
static inline struct scarp_partials chain_any_partials(const struct scarp_samples in[CHAIN_INPUTS])
{
    const struct scarp_partials p = {in[1].value,  in[2].value, in[2].dx, in[2].dxy,
                                     in[1].dphase, in[0].dyy,   {NULL}};
    return p;
}

/* Calls f with three arrays as the members of its inputs: in turn, so that they differ. */
static inline enum scarp_status chain_call_arrays(enum chain f, size_t count, float *const x[3],
                                                  const struct scarp_samples *out)
{
    struct scarp_samples in[CHAIN_INPUTS];
    for (int k = 0; k < CHAIN_INPUTS; k++) {
        in[k] = chain_samples(x[k], 0);
        in[k].dx = in[k].dyz = x[(k + 1) % 3];
        in[k].dy = in[k].dzz = x[(k + 2) % 3];
    }
    const struct scarp_partials partials = chain_any_partials(in);
    return chain_call(f, count, in, &partials, out);
}

#endif
