/* SPDX-License-Identifier: MIT
 *
 * The functions of the chain rule in one list, each with numbers that put seams among values of
 * [-1, 1]: what all tests that call them have in common.
 */
#ifndef SCARP_TESTS_CHAIN_H
#define SCARP_TESTS_CHAIN_H

#include "outputs.h"

#define CHAIN_INPUTS 3
#define CHAIN_PARTIALS 6

/* Each function: its name, how many inputs it has, and whether it takes partial derivatives. */
#define CHAIN_LIST(FUNCTION)                                                                       \
    FUNCTION(affine, 1, 0)                                                                         \
    FUNCTION(add, 2, 0)                                                                            \
    FUNCTION(multiply, 2, 0)                                                                       \
    FUNCTION(mix, 3, 0)                                                                            \
    FUNCTION(min, 2, 0)                                                                            \
    FUNCTION(max, 2, 0)                                                                            \
    FUNCTION(smooth_min, 2, 0)                                                                     \
    FUNCTION(smooth_max, 2, 0)                                                                     \
    FUNCTION(clamp, 1, 0)                                                                          \
    FUNCTION(abs, 1, 0)                                                                            \
    FUNCTION(smooth_abs, 1, 0)                                                                     \
    FUNCTION(smoothstep, 1, 0)                                                                     \
    FUNCTION(smoothstep_falling, 1, 0)                                                             \
    FUNCTION(terrace, 1, 0)                                                                        \
    FUNCTION(terrace_weak, 1, 0)                                                                   \
    FUNCTION(apply1, 1, 1)                                                                         \
    FUNCTION(apply2, 2, 1)

#define CHAIN_ENUMERATOR(name, inputs, partials) CHAIN_##name,
#define CHAIN_NAME(name, inputs, partials) #name,
#define CHAIN_KIND(name, inputs, partials) {inputs, partials},

enum chain { CHAIN_LIST(CHAIN_ENUMERATOR) CHAINS };

static const char *const chain_names[CHAINS] = {CHAIN_LIST(CHAIN_NAME)};

static const struct {
    int inputs, partials;
} chain_kinds[CHAINS] = {CHAIN_LIST(CHAIN_KIND)};

#define CHAIN_SCALE 1.7f
#define CHAIN_OFFSET (-0.3f)
#define CHAIN_K 0.6f
#define CHAIN_ROUND 0.35f
#define CHAIN_LO (-0.4f)
#define CHAIN_HI 0.3f
#define CHAIN_STEPS 4.0f
#define CHAIN_RISER 0.4f
#define CHAIN_STEPS_WEAK 2.5f
#define CHAIN_STRENGTH_WEAK 0.6f

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

static inline enum scarp_status chain_call(enum chain f, size_t count,
                                           const struct scarp_samples in[CHAIN_INPUTS],
                                           const struct scarp_partials *partials,
                                           const struct scarp_samples *out)
{
    const struct scarp_samples *const a = &in[0], *const b = &in[1];
    switch (f) {
    case CHAIN_affine: return scarp_affine(count, a, CHAIN_SCALE, CHAIN_OFFSET, out);
    case CHAIN_add: return scarp_add(count, a, b, out);
    case CHAIN_multiply: return scarp_multiply(count, a, b, out);
    case CHAIN_mix: return scarp_mix(count, a, b, &in[2], out);
    case CHAIN_min: return scarp_min(count, a, b, out);
    case CHAIN_max: return scarp_max(count, a, b, out);
    case CHAIN_smooth_min: return scarp_smooth_min(count, a, b, CHAIN_K, out);
    case CHAIN_smooth_max: return scarp_smooth_max(count, a, b, CHAIN_K, out);
    case CHAIN_clamp: return scarp_clamp(count, a, CHAIN_LO, CHAIN_HI, out);
    case CHAIN_abs: return scarp_abs(count, a, out);
    case CHAIN_smooth_abs: return scarp_smooth_abs(count, a, CHAIN_ROUND, out);
    case CHAIN_smoothstep: return scarp_smoothstep(count, a, CHAIN_LO, CHAIN_HI, out);
    case CHAIN_smoothstep_falling: return scarp_smoothstep(count, a, CHAIN_HI, CHAIN_LO, out);
    case CHAIN_terrace: return scarp_terrace(count, a, CHAIN_STEPS, CHAIN_RISER, 1.0f, out);
    case CHAIN_terrace_weak:
        return scarp_terrace(count, a, CHAIN_STEPS_WEAK, 1.0f, CHAIN_STRENGTH_WEAK, out);
    case CHAIN_apply1: return scarp_apply1(count, a, partials, out);
    default: return scarp_apply2(count, a, b, partials, out);
    }
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
