/* SPDX-License-Identifier: MIT
 *
 * Shaders: the sum of the octaves at one point; as scalar/driver.h. Included by noise.h.
 */
#ifndef SCARP_GPU_OCTAVES_H
#define SCARP_GPU_OCTAVES_H

#include "bend.h"

static inline struct octave octave_of(uint plan, uint k)
{
    return scarp_plan[plan].octave[k];
}

static inline struct level level_of(uint plan, int i)
{
    struct level l = scarp_plan[plan].level[i];
    l.basis = only_basis(l.basis);
    l.fractal = only_fractal(l.fractal);
    return l;
}

static inline bool bends(struct level l)
{
    return l.fractal == SWISS || l.fractal == JORDAN;
}

/* The octave n, in the axes of the input, as the fractal adds it to the sum; n is not bent. */
static inline struct state shaped(struct state state, struct octave o, struct level l,
                                  struct sample n)
{
    struct state s = state;
    struct sample term = n;
    float slope = o.weight;
    if (l.fractal == TURBULENCE) {
        term = magnitude_of(n);
    }
    if (l.fractal == RIDGED) {
        term = ridge(state.weight, n);
        s.weight = ridge_weight(term);
    }
    if (l.fractal == PINGPONG) {
        term = pingpong(n, l.sharpness);
        slope = mul(o.weight, mul(2.0f, l.sharpness));
    }
    if (l.fractal == HYBRID) {
        term = hybrid(state.weight, n, l.sharpness);
        s.weight = hybrid_weight(term, o.share);
    }
    if (l.fractal != FBM) {
        term = scaled(term, o.weight, slope, slope);
    }
    s.sum = sum_of(state.sum, term);
    return s;
}

/* The same of erosion; n is the octave of the basis, in its own axes. */
static inline struct state erosion(struct state state, struct octave o, float strength,
                                   struct sample n, bool turned, int dimensions)
{
    const struct sample own = scaled(n, o.amplitude, o.amplitude, o.amplitude);
    const vec3 gradient = to_input(o, turned, own.gradient, dimensions);
    struct state s = state;
    s.slopes = steeper(state.slopes, o, turned, own, dimensions);
    const struct sample term = eroded(s.slopes, strength, own.value, gradient, dimensions);
    s.sum = sum_of(state.sum, scaled(term, o.weight, o.weight, o.weight));
    return s;
}

/* Adds octave k of level l at x. */
static inline struct state with_octave(struct state state, struct octave o, struct level l, uint k,
                                       vec3 x, int dimensions)
{
    const bool turned = l.rotate != 0u && k > 0u;
    vec3 y = x;
    if (bends(l) && k > 0u) {
        y = add3(x, mul3(o.reach, state.slopes.d));
    }
    const struct place p = place_of(o, l.basis, turned, y, dimensions);
    const struct sample own = basis_at(o, l, p, dimensions);
    struct state s;
    if (l.fractal == EROSION) {
        s = erosion(state, o, l.erosion, own, turned, dimensions);
    } else {
        const struct sample n = in_input(o, turned, own, dimensions);
        if (l.fractal == SWISS) {
            s = swiss(state, o, l.inverse_weight, n, dimensions);
        } else if (l.fractal == JORDAN) {
            s = jordan(state, o, l.erosion, k == 0u, n, dimensions);
        } else {
            s = shaped(state, o, l, n);
        }
    }
    return s;
}

/* The noise of a level, or of a component of it, without warps. */
static inline struct sample octaves_at(uint plan, struct level l, int component, vec3 x,
                                       int dimensions)
{
    const vec3 none = vec3_of(0.0f, 0.0f, 0.0f);
    const uint first = l.first + uint_of(component) * l.octaves;
    struct state state;
    state.sum = constant(0.0f);
    state.weight = constant(1.0f);
    state.slopes.d = none;
    state.slopes.jacobian = rows_of(none, none, none);
    state.left = 1.0f;
    state.left_by = none;
    for (uint k = 0u; k < l.octaves; k++) {
        state = with_octave(state, octave_of(plan, first + k), l, k, x, dimensions);
    }
    return state.sum;
}

#endif
