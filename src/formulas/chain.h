/* SPDX-License-Identifier: MIT
 *
 * Formulas: the chain rule over samples. What depends on numbers alone, as 1 / (hi - lo), comes
 * with the call. Where a value is NaN, so are the outputs that depend on it.
 */
#ifndef SCARP_FORMULAS_CHAIN_H
#define SCARP_FORMULAS_CHAIN_H

#include "corners.h"
#include "matrices.h"

/* a b, but 0 where a or b is 0, whatever the other one is. */
static inline float term(float a, float b)
{
    return either(a == 0.0f || b == 0.0f, 0.0f, a * b);
}

static inline vec3 terms(float a, vec3 b)
{
    return vec3_of(term(a, b.x), term(a, b.y), term(a, b.z));
}

/* a_i b_j + a_j b_i */
static inline float crossed(float ai, float aj, float bi, float bj)
{
    return term(ai, bj) + term(aj, bi);
}

/* a b, as scarp_multiply */
static inline struct sample chain_multiply(struct sample a, struct sample b)
{
    const vec3 g = a.gradient;
    const vec3 h = b.gradient;
    const vec3 diagonal = add3(terms(b.value, a.diagonal), terms(a.value, b.diagonal));
    const vec3 mixed = add3(terms(b.value, a.mixed), terms(a.value, b.mixed));
    return sample_of(
        term(a.value, b.value), add3(terms(b.value, g), terms(a.value, h)),
        add3(diagonal, vec3_of(crossed(g.x, g.x, h.x, h.x), crossed(g.y, g.y, h.y, h.y),
                               crossed(g.z, g.z, h.z, h.z))),
        add3(mixed, vec3_of(crossed(g.x, g.y, h.x, h.y), crossed(g.x, g.z, h.x, h.z),
                            crossed(g.y, g.z, h.y, h.z))));
}

/* a + m (b - a), as scarp_mix */
static inline struct sample chain_mix(struct sample a, struct sample b, struct sample m)
{
    struct sample nearer = a;
    struct sample share = m;
    if (m.value > 0.5f) {
        nearer = b;
        share.value = m.value - 1.0f;
    }
    return difference_of(nearer, chain_multiply(difference_of(a, b), share));
}

/* scale a + offset */
static inline struct sample chain_affine(struct sample a, float scale, float offset)
{
    struct sample s = scaled(a, scale, scale, scale);
    s.value += offset;
    return s;
}

/* Where b is NaN, so is the lesser, or the greater, of a and b. */
static inline struct sample chain_min(struct sample a, struct sample b)
{
    struct sample s = a;
    if (b.value < a.value || b.value != b.value) {
        s = b;
    }
    return s;
}

static inline struct sample chain_max(struct sample a, struct sample b)
{
    struct sample s = a;
    if (a.value < b.value || b.value != b.value) {
        s = b;
    }
    return s;
}

/* f_aa a_i a_j of a gradient a */
static inline vec3 squares_of(float faa, vec3 a)
{
    return vec3_of(faa * a.x * a.x, faa * a.y * a.y, faa * a.z * a.z);
}

static inline vec3 products_of(float faa, vec3 a)
{
    return vec3_of(faa * a.x * a.y, faa * a.x * a.z, faa * a.y * a.z);
}

/* f(a), of which f_a and f_aa are the derivatives; as scarp_apply1 */
static inline struct sample chain_apply1(struct sample a, float f, float fa, float faa)
{
    const struct sample first = scaled(a, 0.0f, fa, fa);
    return sample_of(f, first.gradient, add3(first.diagonal, squares_of(faa, a.gradient)),
                     add3(first.mixed, products_of(faa, a.gradient)));
}

/* A function of two samples, and its partial derivatives. */
struct partials {
    float f, a, b, aa, ab, bb;
};

/* f(a, b), as scarp_apply2 */
static inline struct sample chain_apply2(struct sample a, struct sample b, struct partials p)
{
    const vec3 g = a.gradient;
    const vec3 h = b.gradient;
    const vec3 diagonal = add3(mul3(p.a, a.diagonal), mul3(p.b, b.diagonal));
    const vec3 mixed = add3(mul3(p.a, a.mixed), mul3(p.b, b.mixed));
    return sample_of(p.f, add3(mul3(p.a, g), mul3(p.b, h)),
                     add3(add3(diagonal, add3(squares_of(p.aa, g), squares_of(p.bb, h))),
                          mul3(p.ab, crossed_diagonal(g, h))),
                     add3(add3(mixed, add3(products_of(p.aa, g), products_of(p.bb, h))),
                          mul3(p.ab, crossed_mixed(g, h))));
}

/* f(a) without second derivatives of f */
static inline struct sample chain_straight(struct sample a, float f, float fa)
{
    struct sample s = scaled(a, 0.0f, fa, fa);
    s.value = f;
    return s;
}

/* The lesser, or the greater, of a and b, rounded where they differ by less than a width; k is that
   of the two functions below. */
static inline struct sample smooth_of(struct sample a, struct sample b, bool takes_b, vec3 k)
{
    const float left = 1.0f - magnitude(a.value - b.value) * k.x;
    const float h = either(left < 0.0f, 0.0f, left);
    const float half_weight = 0.5f * (h * h);
    const float rest = 1.0f - half_weight;
    const float of_a = either(takes_b, half_weight, rest);
    const float of_b = either(takes_b, rest, half_weight);
    const vec3 d = sub3(a.gradient, b.gradient);
    const float bend = h * k.z;
    const vec3 diagonal = add3(mul3(of_a, a.diagonal), mul3(of_b, b.diagonal));
    const vec3 mixed = add3(mul3(of_a, a.mixed), mul3(of_b, b.mixed));
    return sample_of(either(takes_b, b.value, a.value) - h * h * h * k.y,
                     add3(mul3(of_a, a.gradient), mul3(of_b, b.gradient)),
                     add3(diagonal, squares_of(bend, d)), add3(mixed, products_of(bend, d)));
}

/* k: 1 / k, k / 6, -1 / k of the width k */
static inline struct sample chain_smooth_min(struct sample a, struct sample b, vec3 k)
{
    return smooth_of(a, b, b.value < a.value || b.value != b.value, k);
}

/* k: 1 / k, -k / 6, 1 / k of the width k */
static inline struct sample chain_smooth_max(struct sample a, struct sample b, vec3 k)
{
    return smooth_of(a, b, a.value < b.value || b.value != b.value, k);
}

static inline struct sample chain_clamp(struct sample a, float lo, float hi)
{
    const float v = a.value;
    const float f = either(v < lo, lo, either(v > hi, hi, v));
    return chain_straight(a, f, either(v < lo || v > hi, 0.0f, 1.0f + (v - v)));
}

static inline struct sample chain_abs(struct sample a)
{
    const float v = a.value;
    const float down = either(v < 0.0f, -1.0f, v - v); /* 0, or NaN */
    return chain_straight(a, magnitude(v), either(v > 0.0f, 1.0f, down));
}

static inline float within_unit(float t)
{
    return either(t < 0.0f, 0.0f, either(t > 1.0f, 1.0f, t));
}

/* The quintic fade may exceed 1 by 2^-23. */
static inline struct fade step_fade(float t)
{
    struct fade s = fade(SCARP_QUINTIC, t);
    s.u = either(s.u > 1.0f, 1.0f, s.u);
    return s;
}

/* The step from lo to hi; `by` is 1 / (hi - lo). */
static inline struct sample chain_smoothstep(struct sample a, float lo, float by)
{
    const struct fade s = step_fade(within_unit((a.value - lo) * by));
    return chain_apply1(a, s.u, s.du * by, s.ddu * by * by);
}

/* k: how many steps, 1 / steps, 1 / riser, strength */
static inline struct sample chain_terrace(struct sample a, vec4 k)
{
    const float t = a.value * k.x;
    const float whole = floor_of(t);
    const float u = t - whole;
    const struct fade s = step_fade(within_unit((u - 0.5f) * k.z + 0.5f));
    const float rise = u + k.w * (s.u - u);
    return chain_apply1(a, (whole + rise) * k.y, 1.0f + k.w * (s.du * k.z - 1.0f),
                        s.ddu * k.z * k.z * k.x * k.w);
}

/* sqrt(a^2 + round^2) */
static inline struct sample chain_smooth_abs(struct sample a, float round, float round2)
{
    const float f = root(a.value * a.value + round2);
    const float by = inverse(f);
    const float share = round * by;
    return chain_apply1(a, f, a.value * by, share * share * by);
}

#endif
