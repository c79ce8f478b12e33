/* SPDX-License-Identifier: MIT
 *
 * Shaders: noise with warps, and the self-test of scarp_gpu_answers.
 */
#ifndef SCARP_GPU_NOISE_H
#define SCARP_GPU_NOISE_H

#include "octaves.h"

#include "../formulas/answers.h"
#include "../formulas/warp.h"

/* Components of a level, each at `at`, with derivatives with respect to x; `y` says how that
   depends on x, unless the level is the deepest. */
static inline struct displaced level_at(uint plan, int i, int components, bool deepest, vec3 at,
                                        struct displaced y, int dimensions)
{
    const struct level l = level_of(plan, i);
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

/* So many components of vector noise; one is the noise. */
static inline struct displaced components_at(uint plan, vec3 x, int components, int dimensions)
{
    const int depth = (int)only_depth(scarp_plan[plan].depth);
    vec3 at = x;
    struct displaced y = not_displaced();
    for (int i = depth; i >= 0; i--) {
        int count = dimensions;
        if (i == 0) {
            count = components;
        }
        y = level_at(plan, i, count, i == depth, at, y, dimensions);
        if (i > 0) {
            y = positions_of(y);
            at = add3(x, values_of(y));
        }
    }
    return y;
}

/* What scarp_sample2 gives at (x, y); outputs along z mean nothing. */
static inline struct sample sample2(uint plan, float x, float y)
{
    return components_at(plan, vec3_of(x, y, 0.0f), 1, 2).x;
}

/* What scarp_sample3 gives at (x, y, z). */
static inline struct sample sample3(uint plan, float x, float y, float z)
{
    return components_at(plan, vec3_of(x, y, z), 1, 3).x;
}

/* What scarp_vector2 gives, as x and y, of a plan by scarp_gpu_vector_plan_make. */
static inline struct displaced vector2(uint plan, float x, float y)
{
    return components_at(plan, vec3_of(x, y, 0.0f), 2, 2);
}

/* What scarp_vector3 gives. */
static inline struct displaced vector3(uint plan, float x, float y, float z)
{
    return components_at(plan, vec3_of(x, y, z), 3, 3);
}

/* The hash h with the outputs of a sample up to an order, in the order of struct scarp_samples. */
static inline uint hash_with_sample(uint h, struct sample s, uint order, int dimensions)
{
    const bool is_space = dimensions == 3;
    uint next = hash_with(h, s.value);
    if (order > 0u) {
        next = hash_with(hash_with(next, s.gradient.x), s.gradient.y);
        if (is_space) {
            next = hash_with(next, s.gradient.z);
        }
    }
    if (order > 1u) {
        next = hash_with(hash_with(next, s.diagonal.x), s.mixed.x);
        if (is_space) {
            next = hash_with(next, s.mixed.y);
        }
        next = hash_with(next, s.diagonal.y);
        if (is_space) {
            next = hash_with(hash_with(next, s.mixed.z), s.diagonal.z);
        }
    }
    return next;
}

/* The self-test: a hash of the outputs at test point i up to an order, which is answer i of
   scarp_gpu_answers where the shader has the bits of the library. */
static inline uint answer2(uint plan, uint order, uint i)
{
    const float unit = scarp_plan[plan].unit;
    const struct sample s =
        sample2(plan, test_coordinate(unit, i, 0u), test_coordinate(unit, i, 1u));
    return hash_with_sample(0u, s, order, 2);
}

static inline uint answer3(uint plan, uint order, uint i)
{
    const float unit = scarp_plan[plan].unit;
    const struct sample s = sample3(plan, test_coordinate(unit, i, 0u),
                                    test_coordinate(unit, i, 1u), test_coordinate(unit, i, 2u));
    return hash_with_sample(0u, s, order, 3);
}

#endif
