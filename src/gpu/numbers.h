/* SPDX-License-Identifier: MIT
 *
 * Shaders: arithmetic with vectors and symmetric matrices, and the two operations that shading
 * languages only approximate. Included by lattice.h.
 */
#ifndef SCARP_GPU_NUMBERS_H
#define SCARP_GPU_NUMBERS_H

#define SIGN 0x80000000u

static inline float magnitude(float a)
{
    return float_of_bits(bits_of(a) & 0x7fffffffu);
}

/* Whether the sign bit is set. */
static inline bool is_negative(float a)
{
    return bits_of(a) >= SIGN;
}

/* -a where `bit` is 1, a where it is 0. */
static inline float with_bit(float a, uint bit)
{
    return float_of_bits(bits_of(a) ^ (bit << 31u));
}

static inline vec3 add3(vec3 a, vec3 b)
{
    return vec3_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec3 sub3(vec3 a, vec3 b)
{
    return vec3_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec3 mul3(float a, vec3 b)
{
    return vec3_of(a * b.x, a * b.y, a * b.z);
}

static inline float dot(vec3 a, vec3 b, int dimensions)
{
    float d = a.x * b.x + a.y * b.y;
    if (dimensions == 3) {
        d += a.z * b.z;
    }
    return d;
}

/* A matrix of 3 rows. */
struct rows {
    vec3 x;
    vec3 y;
    vec3 z;
};

static inline struct rows rows_of(vec3 x, vec3 y, vec3 z)
{
    struct rows m;
    m.x = x;
    m.y = y;
    m.z = z;
    return m;
}

static inline struct rows transposed(struct rows m)
{
    return rows_of(vec3_of(m.x.x, m.y.x, m.z.x), vec3_of(m.x.y, m.y.y, m.z.y),
                   vec3_of(m.x.z, m.y.z, m.z.z));
}

/* m v */
static inline vec3 times(struct rows m, vec3 v, int dimensions)
{
    return vec3_of(dot(m.x, v, dimensions), dot(m.y, v, dimensions), dot(m.z, v, dimensions));
}

/* The transpose of m, times v. */
static inline vec3 transposed_times(struct rows m, vec3 v, int dimensions)
{
    return times(transposed(m), v, dimensions);
}

/* Noise at a point. diagonal: the derivatives xx, yy, zz; mixed: xy, xz, yz. */
struct sample {
    float value;
    vec3 gradient;
    vec3 diagonal;
    vec3 mixed;
};

static inline struct sample sample_of(float value, vec3 gradient, vec3 diagonal, vec3 mixed)
{
    struct sample s;
    s.value = value;
    s.gradient = gradient;
    s.diagonal = diagonal;
    s.mixed = mixed;
    return s;
}

static inline struct sample constant(float value)
{
    const vec3 none = vec3_of(0.0f, 0.0f, 0.0f);
    return sample_of(value, none, none, none);
}

/* The Hessian. */
static inline struct rows hessian_of(struct sample s)
{
    return rows_of(vec3_of(s.diagonal.x, s.mixed.x, s.mixed.y),
                   vec3_of(s.mixed.x, s.diagonal.y, s.mixed.z),
                   vec3_of(s.mixed.y, s.mixed.z, s.diagonal.z));
}

static inline struct sample sum_of(struct sample a, struct sample b)
{
    return sample_of(a.value + b.value, add3(a.gradient, b.gradient), add3(a.diagonal, b.diagonal),
                     add3(a.mixed, b.mixed));
}

/* Multiplies the outputs of each order by a factor of their own. */
static inline struct sample scaled(struct sample n, float value, float gradient, float hessian)
{
    return sample_of(value * n.value, mul3(gradient, n.gradient), mul3(hessian, n.diagonal),
                     mul3(hessian, n.mixed));
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

#endif
