/* SPDX-License-Identifier: MIT
 *
 * Shaders: the operations that shading languages only approximate, and others of numbers.
 */
#ifndef SCARP_GPU_NUMBERS_H
#define SCARP_GPU_NUMBERS_H

#include "c.h"

#include "../formulas/signs.h"

static inline float magnitude(float a)
{
    return float_of_bits(bits_of(a) & 0x7fffffffu);
}

/* One of two numbers. */
static inline float either(bool condition, float yes, float no)
{
    return condition ? yes : no;
}

/* The hash as a signed number, rounded to float, in two parts: only the addition rounds. */
static inline float lattice_value(uint hash)
{
    return (float)((int)hash >> 16) * 65536.0f + (float)(hash & 0xffff);
}

/*
 * 1 / x, rounded to nearest, of positive x; 0 of 2^126 and more. With x = m 2^(e - 150), the result
 * is q 2^(103 - e), q being 2^47 / m, rounded. The estimate's q may be off by a few; the remainder
 * 2^47 - q m is small, so the low 32 bits of both numbers give it.
 */
static inline float inverse(float x)
{
    const uint bits = bits_of(x);
    const uint m = (bits & 0x7fffffu) | 0x800000u;
    const uint e = (bits >> 23u) & 255u;
    const float estimate = rough_inverse(float_of_bits(0x3f800000u | (bits & 0x7fffffu)));
    uint q = (uint)(int)(estimate * 16777216.0f);
    int r = (int)(0u - q * m);
    for (int i = 0; i < 16 && (r < 0 || r >= (int)m); i++) {
        q = r < 0 ? q - 1u : q + 1u;
        r = (int)(0u - q * m);
    }
    q = 2 * r > (int)m ? q + 1u : q;
    const float rounded = float_of_bits(((252u - e) << 23u) + q);
    return e > 252u ? 0.0f : rounded;
}

/*
 * The root of x, rounded to nearest, of normal x and 0. With x = m 2^(e - 150) and m doubled where
 * e is even, q is the root of 2^23 m, rounded.
 */
static inline float root(float x)
{
    const uint bits = bits_of(x);
    const uint e = bits >> 23u;
    const uint even = 1u - (e & 1u);
    const uint m = ((bits & 0x7fffffu) | 0x800000u) << even;
    const float estimate = rough_root(float_of_bits((bits & 0x7fffffu) + ((127u + even) << 23u)));
    uint q = (uint)(int)(estimate * 8388608.0f);
    int r = (int)((m << 23u) - q * q);
    for (int i = 0; i < 16 && (r < 0 || r > (int)(2u * q)); i++) {
        q = r < 0 ? q - 1u : q + 1u;
        r = (int)((m << 23u) - q * q);
    }
    q = r > (int)q ? q + 1u : q;
    const float rounded = float_of_bits((((e + 127u) >> 1u) << 23u) + (q - 0x800000u));
    return e == 0u ? 0.0f : rounded;
}

/*
 * a / b, rounded to nearest, of b that is neither 0 nor below 2^-126; 0 where that is below 2^-126.
 * With mantissas m of a and n of b, the quotient's is q: 2^23 m / n, or 2^24 m / n where m is less
 * than n, rounded.
 */
static inline float quotient(float a, float b)
{
    const uint m = (bits_of(a) & 0x7fffffu) | 0x800000u;
    const uint n = (bits_of(b) & 0x7fffffu) | 0x800000u;
    const uint less = m < n ? 1u : 0u;
    const int of_a = (int)((bits_of(a) >> 23u) & 255u);
    const int of_b = (int)((bits_of(b) >> 23u) & 255u);
    const int e = of_a - of_b + 126 - (int)less;
    const float left = float_of_bits(0x3f800000u | (m & 0x7fffffu));
    const float estimate = left * rough_inverse(float_of_bits(0x3f800000u | (n & 0x7fffffu)));
    uint q = (uint)(int)(estimate * either(m < n, 16777216.0f, 8388608.0f));
    int r = (int)((m << (23u + less)) - q * n);
    for (int i = 0; i < 16 && (r < 0 || r >= (int)n); i++) {
        q = r < 0 ? q - 1u : q + 1u;
        r = (int)((m << (23u + less)) - q * n);
    }
    q = 2 * r > (int)n ? q + 1u : q;
    const uint size = ((uint)e << 23u) + q;
    const uint sign = (bits_of(a) ^ bits_of(b)) & SIGN;
    return of_a == 0 || e < 0 ? 0.0f : float_of_bits(size | sign);
}

#endif
