/* SPDX-License-Identifier: MIT
 *
 * Shaders: what fractals make of an octave, but for those that bend; as scalar/turn.h,
 * turbulence.h, pingpong.h, ridged.h, hybrid.h and erosion.h. Included by bend.h.
 */
#ifndef SCARP_GPU_SHAPE_H
#define SCARP_GPU_SHAPE_H

#include "basis.h"

static inline struct rows jacobian_of(struct octave o)
{
    return transposed(rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z));
}

/* The vector v, in the octave's axes, in those of the input: J^T v, or f v. */
static inline vec3 to_input(struct octave o, bool turned, vec3 v, int dimensions)
{
    vec3 r = mul3(o.frequency, v);
    if (turned) {
        r = times(jacobian_of(o), v, dimensions);
    }
    return r;
}

/* `n` with the Hessian A^T (H B); `a` and `b` are the transposes of A and B. */
static inline struct sample with_hessian(struct sample n, struct rows a, struct rows b,
                                         struct rows h, int dimensions)
{
    const struct rows hb = transposed(
        rows_of(times(b, h.x, dimensions), times(b, h.y, dimensions), times(b, h.z, dimensions)));
    struct sample s = n;
    s.diagonal =
        vec3_of(dot(a.x, hb.x, dimensions), dot(a.y, hb.y, dimensions), dot(a.z, hb.z, dimensions));
    s.mixed =
        vec3_of(dot(a.x, hb.y, dimensions), dot(a.x, hb.z, dimensions), dot(a.y, hb.z, dimensions));
    return s;
}

/* The octave times its amplitude, in the axes of the input. */
static inline struct sample in_input(struct octave o, bool turned, struct sample n, int dimensions)
{
    struct sample s = scaled(n, o.amplitude, o.slope, o.curvature);
    if (turned) {
        const struct rows scaled_jacobian =
            transposed(rows_of(o.gradient_x, o.gradient_y, o.gradient_z));
        s.gradient = times(scaled_jacobian, n.gradient, dimensions);
        s = with_hessian(s, scaled_jacobian, jacobian_of(o), hessian_of(n), dimensions);
    }
    return s;
}

/* sign(n) a, and 0 where n is 0. */
static inline float with_sign(float a, float n)
{
    return pick(n == 0.0f, 0.0f, with_bit(a, bits_of(n) >> 31u));
}

static inline vec3 with_sign3(vec3 a, float n)
{
    return vec3_of(with_sign(a.x, n), with_sign(a.y, n), with_sign(a.z, n));
}

/* |n|: turbulence */
static inline struct sample magnitude_of(struct sample n)
{
    return sample_of(with_sign(n.value, n.value), with_sign3(n.gradient, n.value),
                     with_sign3(n.diagonal, n.value), with_sign3(n.mixed, n.value));
}

/* Ping-pong. The derivatives lack their factor 2 sharpness, which comes with the weight. */
static inline struct sample pingpong(struct sample n, float sharpness)
{
    const float t = mul(add(n.value, 1.0f), sharpness);
    const float e = sub(1.0f, sub(t, mul(2.0f, floor_of(mul(t, 0.5f)))));
    const float value = sub(1.0f, mul(2.0f, magnitude(e)));
    const float falling = pick(is_negative(e), -1.0f, 1.0f);
    const float slope = pick(magnitude(value) == 1.0f, 0.0f, falling);
    return sample_of(value, with_sign3(n.gradient, slope), with_sign3(n.diagonal, slope),
                     with_sign3(n.mixed, slope));
}

/* Ridged noise: v r^2 with v = weight and r = 1 - m. */
static inline float ridge_first(float v, float vi, float r, float mi)
{
    return sub(mul(mul(r, r), vi), mul(mul(mul(2.0f, v), r), mi));
}

static inline vec3 ridge_first3(float v, vec3 vi, float r, vec3 mi)
{
    return vec3_of(ridge_first(v, vi.x, r, mi.x), ridge_first(v, vi.y, r, mi.y),
                   ridge_first(v, vi.z, r, mi.z));
}

/* vi mj + vj mi, for the elements of the diagonal and the others. */
static inline vec3 crossed_diagonal(vec3 v, vec3 m)
{
    return vec3_of(add(mul(v.x, m.x), mul(v.x, m.x)), add(mul(v.y, m.y), mul(v.y, m.y)),
                   add(mul(v.z, m.z), mul(v.z, m.z)));
}

static inline vec3 crossed_mixed(vec3 v, vec3 m)
{
    return vec3_of(add(mul(v.x, m.y), mul(v.y, m.x)), add(mul(v.x, m.z), mul(v.z, m.x)),
                   add(mul(v.y, m.z), mul(v.z, m.y)));
}

/* `cross` is vi mj + vj mi, `mm` is mi mj. */
static inline float ridge_second(float v, float r, float vij, float mij, float cross, float mm)
{
    return add(sub(mul(mul(r, r), vij), mul(mul(2.0f, r), cross)),
               sub(mul(mul(2.0f, v), mm), mul(mul(mul(2.0f, v), r), mij)));
}

static inline struct sample ridge(struct sample weight, struct sample n)
{
    const struct sample m = magnitude_of(n);
    const vec3 a = crossed_diagonal(weight.gradient, m.gradient);
    const vec3 b = crossed_mixed(weight.gradient, m.gradient);
    const vec3 g = m.gradient;
    const vec3 vd = weight.diagonal;
    const vec3 vm = weight.mixed;
    const float v = weight.value;
    const float r = sub(1.0f, m.value);
    return sample_of(mul(v, mul(r, r)), ridge_first3(v, weight.gradient, r, g),
                     vec3_of(ridge_second(v, r, vd.x, m.diagonal.x, a.x, mul(g.x, g.x)),
                             ridge_second(v, r, vd.y, m.diagonal.y, a.y, mul(g.y, g.y)),
                             ridge_second(v, r, vd.z, m.diagonal.z, a.z, mul(g.z, g.z))),
                     vec3_of(ridge_second(v, r, vm.x, m.mixed.x, b.x, mul(g.x, g.y)),
                             ridge_second(v, r, vm.y, m.mixed.y, b.y, mul(g.x, g.z)),
                             ridge_second(v, r, vm.z, m.mixed.z, b.z, mul(g.y, g.z))));
}

/* The weight of the octave after one of ridged noise: 2 s, but 1 where that is more. */
static inline struct sample ridge_weight(struct sample s)
{
    struct sample weight = constant(1.0f);
    if (mul(2.0f, s.value) < 1.0f) {
        weight = scaled(s, 2.0f, 2.0f, 2.0f);
    }
    return weight;
}

/* Hybrid noise: v r with v = weight and r = n + sharpness. */
static inline struct sample hybrid(struct sample weight, struct sample n, float sharpness)
{
    const float v = weight.value;
    const float r = add(n.value, sharpness);
    const vec3 diagonal = add3(mul3(r, weight.diagonal), mul3(v, n.diagonal));
    const vec3 mixed = add3(mul3(r, weight.mixed), mul3(v, n.mixed));
    return sample_of(mul(v, r), add3(mul3(r, weight.gradient), mul3(v, n.gradient)),
                     add3(diagonal, crossed_diagonal(weight.gradient, n.gradient)),
                     add3(mixed, crossed_mixed(weight.gradient, n.gradient)));
}

/* The weight of the octave after one of hybrid noise: share u, but 1 or -1 where that is beyond. */
static inline struct sample hybrid_weight(struct sample u, float share)
{
    const float t = mul(share, u.value);
    struct sample weight = constant(pick(t < 0.0f, -1.0f, 1.0f));
    if (magnitude(t) < 1.0f) {
        weight = scaled(u, share, share, share);
    }
    return weight;
}

/* What slopes add up to, with the rows of the Jacobian. */
struct slopes {
    vec3 d;
    struct rows jacobian;
};

static inline struct rows sum_of_rows(struct rows a, struct rows b)
{
    return rows_of(add3(a.x, b.x), add3(a.y, b.y), add3(a.z, b.z));
}

/* The slopes, to which those of an octave n, in its own axes, are added. */
static inline struct slopes steeper(struct slopes slopes, struct octave o, bool turned,
                                    struct sample n, int dimensions)
{
    const struct rows h = hessian_of(n);
    struct slopes s;
    s.d = add3(slopes.d, n.gradient);
    s.jacobian = sum_of_rows(slopes.jacobian, rows_of(to_input(o, turned, h.x, dimensions),
                                                      to_input(o, turned, h.y, dimensions),
                                                      to_input(o, turned, h.z, dimensions)));
    return s;
}

/* An octave n of erosion; `slopes` have it, and `gradient` is its own in the axes of the input. */
static inline struct sample eroded(struct slopes slopes, float erosion, float n, vec3 gradient,
                                   int dimensions)
{
    const float q = inverse(add(1.0f, mul(erosion, dot(slopes.d, slopes.d, dimensions))));
    const float damping = mul(mul(mul(2.0f, erosion), n), mul(q, q));
    const vec3 steepening = transposed_times(slopes.jacobian, slopes.d, dimensions);
    struct sample s = constant(mul(q, n));
    s.gradient = sub3(mul3(q, gradient), mul3(damping, steepening));
    return s;
}

#endif
