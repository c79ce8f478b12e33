/* SPDX-License-Identifier: MIT
 *
 * Formulas: the sum of octaves.
 */
#ifndef SCARP_FORMULAS_OCTAVES_H
#define SCARP_FORMULAS_OCTAVES_H

#include "bend.h"

/* What octave 0 adds to. */
static inline struct state no_octaves(void)
{
    const vec3 none = vec3_of(0.0f, 0.0f, 0.0f);
    struct state state;
    state.sum = constant(0.0f);
    state.weight = constant(1.0f);
    state.slopes.d = none;
    state.slopes.jacobian = rows_of(none, none, none);
    state.left = 1.0f;
    state.left_by = none;
    return state;
}

/* Where octave k looks, which those before have bent if it is one of a fractal that bends. */
static inline vec3 bent(struct state state, struct octave o, uint k, vec3 x)
{
    vec3 y = x;
    if (k > 0u) {
        y = add3(x, mul3(o.reach, state.slopes.d));
    }
    return y;
}

/* Each fractal adds the octave n, in the axes of the input, to the sum; n is not bent. */
static inline struct state with_fbm(struct state state, struct sample n)
{
    struct state s = state;
    s.sum = sum_of(state.sum, n);
    return s;
}

static inline struct state with_turbulence(struct state state, struct octave o, struct sample n)
{
    return with_fbm(state, scaled(magnitude_of(n), o.weight, o.weight, o.weight));
}

static inline struct state with_ridged(struct state state, struct octave o, struct sample n)
{
    const struct sample term = ridge(state.weight, n);
    struct state s = with_fbm(state, scaled(term, o.weight, o.weight, o.weight));
    s.weight = ridge_weight(term);
    return s;
}

static inline struct state with_pingpong(struct state state, struct octave o, struct level l,
                                         struct sample n)
{
    const float slope = o.weight * (2.0f * l.sharpness);
    return with_fbm(state, scaled(pingpong(n, l.sharpness), o.weight, slope, slope));
}

static inline struct state with_hybrid(struct state state, struct octave o, struct level l,
                                       struct sample n)
{
    const struct sample term = hybrid(state.weight, n, l.sharpness);
    struct state s = with_fbm(state, scaled(term, o.weight, o.weight, o.weight));
    s.weight = hybrid_weight(term, o.share);
    return s;
}

/* Adds an octave of erosion; n is the basis in the axes of the octave. */
static inline struct state with_erosion(struct state state, struct octave o, struct level l,
                                        struct sample n, bool turned, int dimensions)
{
    const struct sample basis = scaled(n, o.amplitude, o.amplitude, o.amplitude);
    const vec3 gradient = to_input(o, turned, basis.gradient, dimensions);
    struct state s = state;
    s.slopes = steeper(state.slopes, o, turned, basis, dimensions);
    const struct sample term = eroded(s.slopes, l.erosion, basis.value, gradient, dimensions);
    s.sum = sum_of(state.sum, scaled(term, o.weight, o.weight, o.weight));
    return s;
}

/* Adds an octave n, in the axes of the input, of any fractal but erosion. */
static inline struct state with_noise(struct state state, struct octave o, struct level l,
                                      bool first, struct sample n, int dimensions)
{
    struct state s;
    if (l.fractal == SCARP_SWISS) {
        s = swiss(state, o, l.inverse_weight, n, dimensions);
    } else if (l.fractal == SCARP_JORDAN) {
        s = jordan(state, o, l.erosion, first, n, dimensions);
    } else if (l.fractal == SCARP_TURBULENCE) {
        s = with_turbulence(state, o, n);
    } else if (l.fractal == SCARP_RIDGED) {
        s = with_ridged(state, o, n);
    } else if (l.fractal == SCARP_PINGPONG) {
        s = with_pingpong(state, o, l, n);
    } else if (l.fractal == SCARP_HYBRID) {
        s = with_hybrid(state, o, l, n);
    } else {
        s = with_fbm(state, n);
    }
    return s;
}

/* Adds an octave of the basis, in its own axes. */
static inline struct state with_basis(struct state state, struct octave o, struct level l,
                                      bool first, bool turned, struct sample basis, int dimensions)
{
    struct state s;
    if (l.fractal == SCARP_EROSION) {
        s = with_erosion(state, o, l, basis, turned, dimensions);
    } else {
        s = with_noise(state, o, l, first, in_input(o, turned, basis, dimensions), dimensions);
    }
    return s;
}

#endif
