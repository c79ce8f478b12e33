/* SPDX-License-Identifier: MIT
 *
 * Reference: the chain rule over samples, one point at a time.
 *
 * The order of operations is that of the expressions here. What depends on the numbers of a call
 * alone (1 / k and the like) is computed once, in calls/chain.c.
 */
#ifndef SCARP_SCALAR_CHAIN_H
#define SCARP_SCALAR_CHAIN_H

#include <math.h>

#include "../formulas/corners.h"
#include "../plan/chain.h"

/* The value of a function and its partial derivatives, as far as it has them. */
struct partials {
    float f, a, b, aa, ab, bb;
};

/* The samples of the inputs at a point. Members that the call does not have are 0. */
struct chain_point {
    float of[CHAIN_INPUTS][OUTPUTS];
    struct partials given; /* to apply1 and apply2 */
};

/* The number, but NaN where v is NaN. */
static inline float nan_of(float v, float number)
{
    return v != v ? v : number;
}

static inline float within_unit(float t)
{
    return t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
}

/* The quintic fade may exceed 1 by 2^-23. */
static inline struct fade step_fade(float t)
{
    struct fade s = fade(SCARP_QUINTIC, t);
    s.u = s.u > 1.0f ? 1.0f : s.u;
    return s;
}

static inline int takes_b(enum scarp_chain_function function, float a, float b)
{
    return (function == CHAIN_MIN || function == CHAIN_SMOOTH_MIN ? b < a : a < b) || b != b;
}

static inline struct partials smooth_at(const struct scarp_chain *call, float a, float b)
{
    const int second = takes_b(call->function, a, b);
    const float left = 1.0f - fabsf(a - b) * call->number[CHAIN_INVERSE];
    const float h = left < 0.0f ? 0.0f : left;
    const float half = 0.5f * (h * h);
    const float near = 1.0f - half;
    const struct partials p = {.f = (second ? b : a) - h * h * h * call->number[CHAIN_DEPTH],
                               .a = second ? half : near,
                               .b = second ? near : half,
                               .aa = h * call->number[CHAIN_BEND]};
    return p;
}

static inline struct partials clamp_at(const struct scarp_chain *call, float v)
{
    const float lo = call->number[CHAIN_LO], hi = call->number[CHAIN_HI];
    const struct partials p = {.f = v < lo   ? lo
                                    : v > hi ? hi
                                             : v,
                               .a = nan_of(v, v < lo || v > hi ? 0.0f : 1.0f)};
    return p;
}

static inline struct partials smooth_abs_at(const struct scarp_chain *call, float v)
{
    const float f = sqrtf(v * v + call->number[CHAIN_ROUND2]);
    const float inverse_f = 1.0f / f;
    const float share = call->number[CHAIN_ROUND] * inverse_f;
    const struct partials p = {.f = f, .a = v * inverse_f, .aa = share * share * inverse_f};
    return p;
}

static inline struct partials smoothstep_at(const struct scarp_chain *call, float v)
{
    const float inverse = call->number[CHAIN_INVERSE];
    const struct fade s = step_fade(within_unit((v - call->number[CHAIN_LO]) * inverse));
    const struct partials p = {.f = s.u, .a = s.du * inverse, .aa = s.ddu * inverse * inverse};
    return p;
}

static inline struct partials terrace_at(const struct scarp_chain *call, float v)
{
    const float steps = call->number[CHAIN_STEPS], steep = call->number[CHAIN_STEEP];
    const float strength = call->number[CHAIN_STRENGTH];
    const float t = v * steps;
    const float whole = floorf(t);
    const float u = t - whole;
    const struct fade s = step_fade(within_unit((u - 0.5f) * steep + 0.5f));
    const float rise = u + strength * (s.u - u);
    const struct partials p = {.f = (whole + rise) * call->number[CHAIN_HEIGHT],
                               .a = 1.0f + strength * (s.du * steep - 1.0f),
                               .aa = s.ddu * steep * steep * steps * strength};
    return p;
}

/* What the outputs are computed from, of functions that are given by partial derivatives. */
static inline struct partials partials_at(const struct scarp_chain *call,
                                          const struct chain_point *point)
{
    const float a = point->of[CHAIN_A][VALUE];
    const struct partials sign = {.f = fabsf(a),
                                  .a = nan_of(a, a > 0.0f   ? 1.0f
                                                 : a < 0.0f ? -1.0f
                                                            : 0.0f)};
    switch (call->function) {
    case CHAIN_SMOOTH_MIN:
    case CHAIN_SMOOTH_MAX: return smooth_at(call, a, point->of[CHAIN_B][VALUE]);
    case CHAIN_CLAMP: return clamp_at(call, a);
    case CHAIN_ABS: return sign;
    case CHAIN_SMOOTH_ABS: return smooth_abs_at(call, a);
    case CHAIN_SMOOTHSTEP: return smoothstep_at(call, a);
    case CHAIN_TERRACE: return terrace_at(call, a);
    default: return point->given;
    }
}

/* a b, but 0 where a or b is 0, whatever the other one is. */
static inline float term(float a, float b)
{
    return a == 0.0f || b == 0.0f ? 0.0f : a * b;
}

/* Output m of a b, m being a first derivative or the second one by i and j. */
static inline float product_of(const float a[OUTPUTS], const float b[OUTPUTS], int m)
{
    if (m == VALUE) {
        return term(a[VALUE], b[VALUE]);
    }
    const float linear = term(b[VALUE], a[m]) + term(a[VALUE], b[m]);
    if (m < DXX || m == DPHASE) {
        return linear;
    }
    const int i = scarp_chain_axes[m - DXX][0], j = scarp_chain_axes[m - DXX][1];
    return linear + (term(a[i], b[j]) + term(a[j], b[i]));
}

/* Output m of the blend. It starts from the input that is nearer, and subtracts a share of the
   difference: subtracting +0, as a share of 0 is, leaves the bits of every number as they are. The
   share beyond 1/2 is m - 1, which is exact up to 2. */
static inline float mix_of(const float a[OUTPUTS], const float b[OUTPUTS],
                           const float mask[OUTPUTS], int m)
{
    const int nearer_b = mask[VALUE] > 0.5f;
    float d[OUTPUTS], w[OUTPUTS];
    for (int k = 0; k < OUTPUTS; k++) {
        d[k] = a[k] - b[k];
        w[k] = mask[k];
    }
    w[VALUE] = nearer_b ? mask[VALUE] - 1.0f : mask[VALUE];
    return (nearer_b ? b[m] : a[m]) - product_of(d, w, m);
}

/* Output m of a function that is given by partial derivatives. */
static inline float derived_of(enum scarp_chain_function function, const struct partials *p,
                               const float a[OUTPUTS], const float b[OUTPUTS], int m)
{
    const int two =
        function == CHAIN_SMOOTH_MIN || function == CHAIN_SMOOTH_MAX || function == CHAIN_APPLY2;
    if (m == VALUE) {
        return p->f;
    }
    const float linear = two ? p->a * a[m] + p->b * b[m] : p->a * a[m];
    if (m < DXX || m == DPHASE || function == CHAIN_CLAMP || function == CHAIN_ABS) {
        return linear;
    }
    const int i = scarp_chain_axes[m - DXX][0], j = scarp_chain_axes[m - DXX][1];
    if (!two) {
        return linear + p->aa * a[i] * a[j];
    }
    if (function == CHAIN_APPLY2) {
        return linear + (p->aa * a[i] * a[j] + p->bb * b[i] * b[j]) +
               p->ab * (a[i] * b[j] + a[j] * b[i]);
    }
    return linear + p->aa * (a[i] - b[i]) * (a[j] - b[j]);
}

/* Output m at a point. */
static inline float chain_of(const struct scarp_chain *call, const struct partials *p,
                             const struct chain_point *point, int m)
{
    const float *const a = point->of[CHAIN_A], *const b = point->of[CHAIN_B];
    switch (call->function) {
    case CHAIN_AFFINE:
        return m == VALUE ? call->number[CHAIN_SCALE] * a[m] + call->number[CHAIN_OFFSET]
                          : call->number[CHAIN_SCALE] * a[m];
    case CHAIN_ADD: return a[m] + b[m];
    case CHAIN_MULTIPLY: return product_of(a, b, m);
    case CHAIN_MIX: return mix_of(a, b, point->of[CHAIN_M], m);
    case CHAIN_MIN:
    case CHAIN_MAX: return takes_b(call->function, a[VALUE], b[VALUE]) ? b[m] : a[m];
    default: return derived_of(call->function, p, a, b, m);
    }
}

static inline float element(const float *array, size_t i)
{
    return array != NULL ? array[i] : 0.0f;
}

/* Reads all that a point needs before anything is written: outputs may be where inputs are. */
static inline struct chain_point chain_point_at(const struct scarp_chain *call, size_t i)
{
    const float *const *const given = call->partial;
    struct chain_point point = {
        .given = {element(given[PARTIAL_F], i), element(given[PARTIAL_A], i),
                  element(given[PARTIAL_B], i), element(given[PARTIAL_AA], i),
                  element(given[PARTIAL_AB], i), element(given[PARTIAL_BB], i)}};
    for (int input = 0; input < CHAIN_INPUTS; input++) {
        for (int m = 0; m < OUTPUTS; m++) {
            point.of[input][m] = element(call->in[input][m], i);
        }
    }
    return point;
}

static inline void chain_at(const struct scarp_chain *call, size_t i)
{
    const struct chain_point point = chain_point_at(call, i);
    const struct partials p = partials_at(call, &point);
    for (int m = 0; m < OUTPUTS; m++) {
        if (call->out[m] != NULL) {
            call->out[m][i] = chain_of(call, &p, &point, m);
        }
    }
}

#endif
