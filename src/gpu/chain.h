/* SPDX-License-Identifier: MIT
 *
 * Shaders: more functions over samples; calls/partials.c computes the partial derivatives of each.
 */
#ifndef SCARP_GPU_CHAIN_H
#define SCARP_GPU_CHAIN_H

#include "numbers.h"

#include "../formulas/chain.h"

/* The root of a, 0 where that is negative. */
static inline struct sample chain_sqrt(struct sample a)
{
    const float v = either(a.value < 0.0f, 0.0f, a.value);
    const float f = root(v);
    const bool is_flat = f == 0.0f;
    const float slope = 0.5f * inverse(either(is_flat, 1.0f, f));
    const float bend = slope * (0.5f * inverse(either(is_flat, 1.0f, v)));
    return chain_apply1(a, f, either(is_flat, 0.0f, slope), either(is_flat, 0.0f, -bend));
}

/* a / b, where b is not 0. */
static inline struct sample chain_divide(struct sample a, struct sample b)
{
    const float by = with_bit(inverse(magnitude(b.value)), bits_of(b.value) >> 31u);
    const float f = quotient(a.value, b.value);
    const struct partials p = {
        .f = f, .a = by, .b = -(f * by), .ab = -(by * by), .bb = 2.0f * (f * by) * by};
    return chain_apply2(a, b, p);
}

/* a folded to and fro: -1 at even numbers, 1 at odd ones. All floats of 2^24 and more are even. */
static inline struct sample chain_pulse(struct sample a)
{
    const float v = either(magnitude(a.value) < 16777216.0f, a.value, 0.0f);
    const float lower = floor_of(v);
    const float fraction = v - lower;
    const float up = 2.0f * fraction - 1.0f;
    const bool is_odd = ((int)lower & 1) != 0;
    const float slope = either(is_odd, -2.0f, 2.0f);
    return chain_straight(a, either(is_odd, -up, up), either(fraction == 0.0f, 0.0f, slope));
}

/* The length of the gradient; no Hessian. */
static inline struct sample chain_slope(struct sample a, int dimensions)
{
    const struct rows h = hessian_of(a);
    const float length = root(dot(a.gradient, a.gradient, dimensions));
    const float by = either(length == 0.0f, 1.0f, length);
    const vec3 sums = times(h, a.gradient, dimensions);
    struct sample s = constant(length);
    if (length != 0.0f) {
        s.gradient = vec3_of(quotient(sums.x, by), quotient(sums.y, by), quotient(sums.z, by));
    }
    return s;
}

/* A piece of a curve at a. k and l are the knots around it, `first` and `last` those at the ends:
   x, value, slope, 1 / (the next x - x). */
static inline struct sample chain_curve(struct sample a, vec4 k, vec4 l, vec4 first, vec4 last)
{
    const float width = l.x - k.x;
    const float t = (a.value - k.x) * k.w;
    const float rise = l.y - k.y;
    const float s0 = k.z * width;
    const float s1 = l.z * width;
    const float c2 = 3.0f * rise - 2.0f * s0 - s1;
    const float c3 = s0 + s1 - 2.0f * rise;
    const float lowest = either(k.y < l.y, k.y, l.y);
    const float highest = either(k.y < l.y, l.y, k.y);
    const float v = k.y + t * (s0 + t * (c2 + t * c3));
    const float held = either(v < lowest, lowest, either(v > highest, highest, v));
    const bool is_before = a.value <= first.x;
    const bool is_behind = a.value >= last.x;
    const bool is_level = is_before || is_behind;
    const float slope = (s0 + t * (2.0f * c2 + t * (3.0f * c3))) * k.w;
    const float bend = (2.0f * c2 + t * (6.0f * c3)) * k.w * k.w;
    return chain_apply1(a, either(is_before, first.y, either(is_behind, last.y, held)),
                        either(is_level, 0.0f, slope), either(is_level, 0.0f, bend));
}

#endif
