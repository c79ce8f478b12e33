/* SPDX-License-Identifier: MIT
 *
 * Shaders: the sine, as calls/partials.c has it in double.
 *
 * Shaders have no doubles, so this computes with 64-bit integers, whose two halves stand for a
 * fraction. Its error is below 2^-58 before the one rounding to float, that of the library below
 * 2^-51; so the two round apart at one of some 10^8 numbers.
 */
#ifndef SCARP_GPU_SINE_H
#define SCARP_GPU_SINE_H

#include "chain.h"

/* (2^32 high + low) / 2^64, or / 2^63 where that is said. */
struct wide {
    uint high, low;
};

static inline struct wide wide_of(uint high, uint low)
{
    const struct wide w = {high, low};
    return w;
}

/* The product of two uints. */
static inline struct wide product_of_words(uint a, uint b)
{
    const uint al = a & 0xffffu;
    const uint ah = a >> 16u;
    const uint bl = b & 0xffffu;
    const uint bh = b >> 16u;
    const uint low = al * bl;
    const uint left = ah * bl;
    const uint right = al * bh;
    const uint middle = (low >> 16u) + (left & 0xffffu) + (right & 0xffffu);
    return wide_of(ah * bh + (left >> 16u) + (right >> 16u) + (middle >> 16u),
                   (low & 0xffffu) | (middle << 16u));
}

static inline struct wide sum_of_wides(struct wide a, struct wide b)
{
    const uint low = a.low + b.low;
    const uint carry = low < a.low ? 1u : 0u;
    return wide_of(a.high + b.high + carry, low);
}

/* a - b, which is not below 0 */
static inline struct wide difference_of_wides(struct wide a, struct wide b)
{
    const uint borrow = a.low < b.low ? 1u : 0u;
    return wide_of(a.high - b.high - borrow, a.low - b.low);
}

/* a b, up to 2 units too small: without the product of the lower halves. */
static inline struct wide product_of_wides(struct wide a, struct wide b)
{
    const struct wide left = product_of_words(a.high, b.low);
    const struct wide right = product_of_words(a.low, b.high);
    const struct wide sum = sum_of_wides(product_of_words(a.high, b.high), wide_of(0u, left.high));
    return sum_of_wides(sum, wide_of(0u, right.high));
}

/* c - z rest: a step of a series. `is_cosine` chooses the coefficient. */
static inline struct wide step_of_series(struct wide z, struct wide rest, bool is_cosine,
                                         struct wide of_sine, struct wide of_cosine)
{
    struct wide c = of_sine;
    if (is_cosine) {
        c = of_cosine;
    }
    return difference_of_wides(c, product_of_wides(z, rest));
}

/* The Taylor series of the cosine of x, or of the sine over x, times 2^63, of z = x^2 2^64. */
static inline struct wide series_of(struct wide z, bool is_cosine)
{
    struct wide s = wide_of(0u, is_cosine ? 0x0006b9fdu : 0x0000654bu);
    s = step_of_series(z, s, is_cosine, wide_of(0x00000000u, 0x006b9fd0u),
                       wide_of(0x00000000u, 0x064e5d2au));
    s = step_of_series(z, s, is_cosine, wide_of(0x00000000u, 0x5849184fu),
                       wide_of(0x00000004u, 0x7bb63bfeu));
    s = step_of_series(z, s, is_cosine, wide_of(0x00000035u, 0xcc8acfebu),
                       wide_of(0x0000024fu, 0xc9f6ef14u));
    s = step_of_series(z, s, is_cosine, wide_of(0x0000171du, 0xe3a556c7u),
                       wide_of(0x0000d00du, 0x00d00d01u));
    s = step_of_series(z, s, is_cosine, wide_of(0x00068068u, 0x06806807u),
                       wide_of(0x002d82d8u, 0x2d82d82eu));
    s = step_of_series(z, s, is_cosine, wide_of(0x01111111u, 0x11111111u),
                       wide_of(0x05555555u, 0x55555555u));
    s = step_of_series(z, s, is_cosine, wide_of(0x15555555u, 0x55555555u),
                       wide_of(0x40000000u, 0x00000000u));
    s = step_of_series(z, s, is_cosine, wide_of(0x80000000u, 0x00000000u),
                       wide_of(0x80000000u, 0x00000000u));
    return s;
}

/* w / 2^64 times 2^e, rounded to a float. */
static inline float float_of_wide(struct wide w, int e)
{
    struct wide m = w;
    int exponent = e;
    for (int i = 0; i < 4 && m.high < 0x80000000u; i++) {
        m = wide_of((m.high << 1u) | (m.low >> 31u), m.low << 1u);
        exponent = exponent - 1;
    }
    const uint q = (m.high >> 8u) + ((m.high >> 7u) & 1u);
    const float rounded = float_of_bits(((uint)(exponent + 125) << 23u) + q);
    return exponent < -120 ? 0.0f : rounded;
}

/* a / 2^steps, steps below 64; or 4 a where they are -2. */
static inline struct wide shifted(struct wide a, int steps)
{
    const uint by = (uint)steps & 31u;
    const uint crossing = by == 0u ? 0u : a.high << (32u - by);
    struct wide w = wide_of(a.high >> by, (a.low >> by) | crossing);
    if (steps >= 32) {
        w = wide_of(0u, a.high >> by);
    }
    if (steps < 0) {
        w = wide_of((a.high << 2u) | (a.low >> 30u), a.low << 2u);
    }
    return w;
}

/* (pi / 2)^2 is this times 4 / 2^64. */
#define PI2_HIGH 0x9de9e64du
#define PI2_LOW 0xf22ef2d2u

/* c 2^e times the cosine of r quarters, or the sine of them, for which c is given times pi / 2;
   -1/2 <= r <= 1/2. */
static inline float quarter_wave(float r, bool is_cosine, struct wide c, int e)
{
    const uint bits = bits_of(r) & 0x7fffffffu;
    const int exponent = (int)(bits >> 23u) - 126; /* r is its mantissa / 2^24, times 2^exponent */
    const struct wide m = wide_of((bits << 8u) | 0x80000000u, 0u);
    struct wide z = wide_of(0u, 0u);
    if (exponent > -32) {
        z = product_of_wides(product_of_wides(m, m), wide_of(PI2_HIGH, PI2_LOW));
        z = shifted(z, -2 * exponent - 2);
    }
    const struct wide wave = product_of_wides(series_of(z, is_cosine), c);
    float value = float_of_wide(wave, e + 1);
    if (!is_cosine) {
        value =
            with_bit(float_of_wide(product_of_wides(wave, m), e + 1 + exponent), bits_of(r) >> 31u);
    }
    return value;
}

/* A sine of so many whole quarters and r of one, times 1, 2 pi or 4 pi^2: by `power` of 2 pi. */
static inline float sine_of_quarters(int whole, float r, int power)
{
    const bool is_cosine = (whole & 1) != 0;
    struct wide c = wide_of(0x80000000u, 0u); /* 1 */
    int e = 1;
    if (power == 0 && !is_cosine) {
        c = wide_of(0xc90fdaa2u, 0x2168c235u);
        e = 1;
    }
    if (power == 1 && is_cosine) {
        c = wide_of(0xc90fdaa2u, 0x2168c235u);
        e = 3;
    }
    if (power == 1 && !is_cosine) {
        c = wide_of(0x9de9e64du, 0xf22ef2d2u);
        e = 4;
    }
    if (power == 2 && is_cosine) {
        c = wide_of(0x9de9e64du, 0xf22ef2d2u);
        e = 6;
    }
    if (power == 2 && !is_cosine) {
        c = wide_of(0xf80cdac9u, 0xc4ebe0f0u);
        e = 6;
    }
    return with_bit(quarter_wave(r, is_cosine, c, e), ((uint)whole >> 1u) & 1u);
}

/* The sine of a turns. All floats of 2^24 and more are whole numbers of turns. */
static inline struct sample chain_sine(struct sample a)
{
    const float v = either(magnitude(a.value) < 16777216.0f, a.value, 0.0f);
    const float quarters = 4.0f * v;
    const int below = (int)quarters;
    const float rest = quarters - (float)below;
    int whole = below;
    float r = rest;
    if (rest >= 0.5f) {
        whole = below + 1;
        r = rest - 1.0f;
    }
    if (rest <= -0.5f) {
        whole = below - 1;
        r = rest + 1.0f;
    }
    return chain_apply1(a, sine_of_quarters(whole, r, 0), sine_of_quarters(whole + 1, r, 1),
                        -sine_of_quarters(whole, r, 2));
}

#endif
