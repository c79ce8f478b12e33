/* SPDX-License-Identifier: MIT
 *
 * Shaders: noise with warps, as scalar/warp.h, and the self-test of scarp_gpu_answers.
 */
#ifndef SCARP_GPU_NOISE_H
#define SCARP_GPU_NOISE_H

#include "octaves.h"

/* The coordinates of displaced positions, with their derivatives: how far they are displaced. */
struct displaced {
    struct sample x;
    struct sample y;
    struct sample z;
};

/* A sample at y with its derivatives by y becomes one with its derivatives by x: with the Jacobian
   J of y, the gradient is J^T g, the Hessian J^T (H J) + sum_m g_m (Hessian of y_m). */
static inline struct sample composed(struct sample s, struct displaced y, int dimensions)
{
    const struct rows j = transposed(rows_of(y.x.gradient, y.y.gradient, y.z.gradient));
    const vec3 diagonal =
        transposed_times(rows_of(y.x.diagonal, y.y.diagonal, y.z.diagonal), s.gradient, dimensions);
    const vec3 mixed =
        transposed_times(rows_of(y.x.mixed, y.y.mixed, y.z.mixed), s.gradient, dimensions);
    struct sample r = with_hessian(s, j, j, hessian_of(s), dimensions);
    r.gradient = times(j, s.gradient, dimensions);
    r.diagonal = add3(r.diagonal, diagonal);
    r.mixed = add3(r.mixed, mixed);
    return r;
}

/* The components of a level, each at `at`, by x; `y` says how that depends on x, unless the level
   is the deepest. */
static inline struct displaced level_at(uint plan, int i, bool deepest, vec3 at, struct displaced y,
                                        int dimensions)
{
    const struct level l = level_of(plan, i);
    const int components = i > 0 ? dimensions : 1;
    struct displaced d = y;
    for (int c = 0; c < components; c++) {
        struct sample s = octaves_at(plan, l, (uint)c, at, dimensions);
        if (!deepest) {
            s = composed(s, y, dimensions);
        }
        if (c == 0) {
            d.x = s;
        } else if (c == 1) {
            d.y = s;
        } else {
            d.z = s;
        }
    }
    return d;
}

static inline struct sample noise_at(uint plan, vec3 x, int dimensions)
{
    const int depth = (int)only_depth(scarp_plan[plan].depth);
    vec3 at = x;
    struct displaced y;
    y.x = constant(0.0f);
    y.y = y.x;
    y.z = y.x;
    for (int i = depth; i >= 0; i--) {
        y = level_at(plan, i, i == depth, at, y, dimensions);
        if (i > 0) {
            y.x.gradient.x += 1.0f;
            y.y.gradient.y += 1.0f;
            y.z.gradient.z += 1.0f;
            at = add3(x, vec3_of(y.x.value, y.y.value, y.z.value));
        }
    }
    return y.x;
}

/* What scarp_sample2 gives at (x, y); outputs along z mean nothing. */
static inline struct sample sample2(uint plan, float x, float y)
{
    return noise_at(plan, vec3_of(x, y, 0.0f), 2);
}

/* What scarp_sample3 gives at (x, y, z). */
static inline struct sample sample3(uint plan, float x, float y, float z)
{
    return noise_at(plan, vec3_of(x, y, z), 3);
}

/* A coordinate of test point i. */
static inline float test_coordinate(uint plan, uint i, uint axis)
{
    uvec3 key;
    key.x = 0u;
    key.y = 0u;
    key.z = 0u;
    const int cells = (int)(hash2(key, i, axis) >> 12u) - 524288;
    return (float)cells * scarp_plan[plan].unit;
}

/* The hash h with an output; what is below 2^-120 counts as 0. */
static inline uint hash_with(uint h, float a)
{
    const uint magnitude_bits = bits_of(a) & 0x7fffffffu;
    const uint bits = magnitude_bits < 0x03800000u ? 0u : bits_of(a);
    return (((h << 5u) | (h >> 27u)) ^ bits) * HASH_K;
}

/* The self-test: a hash of the outputs at test point i up to an order, which is answer i of
   scarp_gpu_answers where the shader has the bits of the library. */
static inline uint answer2(uint plan, uint order, uint i)
{
    const struct sample s =
        sample2(plan, test_coordinate(plan, i, 0u), test_coordinate(plan, i, 1u));
    uint h = hash_with(0u, s.value);
    if (order > 0u) {
        h = hash_with(hash_with(h, s.gradient.x), s.gradient.y);
    }
    if (order > 1u) {
        h = hash_with(hash_with(hash_with(h, s.diagonal.x), s.mixed.x), s.diagonal.y);
    }
    return h;
}

static inline uint answer3(uint plan, uint order, uint i)
{
    const struct sample s = sample3(plan, test_coordinate(plan, i, 0u),
                                    test_coordinate(plan, i, 1u), test_coordinate(plan, i, 2u));
    uint h = hash_with(0u, s.value);
    if (order > 0u) {
        h = hash_with(hash_with(hash_with(h, s.gradient.x), s.gradient.y), s.gradient.z);
    }
    if (order > 1u) {
        h = hash_with(hash_with(hash_with(h, s.diagonal.x), s.mixed.x), s.mixed.y);
        h = hash_with(hash_with(hash_with(h, s.diagonal.y), s.mixed.z), s.diagonal.z);
    }
    return h;
}

#endif
