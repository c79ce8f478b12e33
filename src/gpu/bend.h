/* SPDX-License-Identifier: MIT
 *
 * Shaders: the fractals that bend; as scalar/bend.h. Included by octaves.h.
 */
#ifndef SCARP_GPU_BEND_H
#define SCARP_GPU_BEND_H

#include "shape.h"

/* What goes from octave to octave. `weight`: ridged and hybrid noise; `slopes`: erosion and those
   that bend; `left`: how much of the octaves Swiss noise leaves, with its gradient. */
struct state {
    struct sample sum;
    struct sample weight;
    struct slopes slopes;
    float left;
    vec3 left_by;
};

/* A gradient by bent positions becomes one by x: A^T g with A = I + reach (Jacobian of the slopes).
 */
static inline vec3 unbent(struct slopes slopes, float reach, vec3 g, int dimensions)
{
    return add3(g, mul3(reach, transposed_times(slopes.jacobian, g, dimensions)));
}

/* A row of the Jacobian with what a component of the slope adds; `row` is that of the Hessian. */
static inline vec3 bent_row(vec3 jacobian, vec3 by, float slope, float product, vec3 row)
{
    return add3(jacobian, add3(mul3(slope, by), mul3(product, row)));
}

/* The slopes with factor n times the slope g / f of an octave; `by` is the gradient of factor n. */
static inline struct slopes with_slope(struct slopes slopes, struct octave o, struct sample n,
                                       float product, vec3 by, int dimensions)
{
    const struct rows h = hessian_of(n);
    const vec3 slope = mul3(o.inverse, n.gradient);
    const vec3 x = mul3(o.inverse, unbent(slopes, o.reach, h.x, dimensions));
    const vec3 y = mul3(o.inverse, unbent(slopes, o.reach, h.y, dimensions));
    const vec3 z = mul3(o.inverse, unbent(slopes, o.reach, h.z, dimensions));
    struct slopes s;
    s.d = add3(slopes.d, mul3(product, slope));
    s.jacobian = rows_of(bent_row(slopes.jacobian.x, by, slope.x, product, x),
                         bent_row(slopes.jacobian.y, by, slope.y, product, y),
                         bent_row(slopes.jacobian.z, by, slope.z, product, z));
    return s;
}

static inline struct state swiss(struct state state, struct octave o, float inverse_weight,
                                 struct sample n, int dimensions)
{
    const float share = mul(o.weight, inverse_weight);
    const float u = state.left;
    const float rest = sub(1.0f, magnitude(n.value));
    const float v = pick(rest < 0.0f, 0.0f, rest);
    const vec3 nj = unbent(state.slopes, o.reach, n.gradient, dimensions);
    const vec3 none = vec3_of(0.0f, 0.0f, 0.0f);
    vec3 vj = with_sign3(nj, n.value);
    if (rest < 0.0f) {
        vj = none;
    }
    struct state s = state;
    const vec3 term = mul3(o.weight, sub3(mul3(v, state.left_by), mul3(u, vj)));
    s.sum.gradient = add3(state.sum.gradient, term);
    s.sum.value = add(state.sum.value, mul(o.weight, mul(u, v)));
    const vec3 by = mul3(-share, add3(mul3(n.value, state.left_by), mul3(u, nj)));
    s.slopes = with_slope(state.slopes, o, n, mul(-share, mul(u, n.value)), by, dimensions);
    const float sum = mul(s.sum.value, inverse_weight);
    if (sum < 1.0f) {
        s.left_by = add3(mul3(sum, state.left_by), mul3(u, mul3(inverse_weight, s.sum.gradient)));
        s.left = mul(u, sum);
    }
    return s;
}

static inline struct state jordan(struct state state, struct octave o, float erosion, bool first,
                                  struct sample n, int dimensions)
{
    const float square = mul(n.value, n.value);
    const float p = inverse(add(1.0f, dot(state.slopes.d, state.slopes.d, dimensions)));
    const float q = pick(first, 1.0f, sub(1.0f, mul(erosion, p)));
    const float damping = pick(first, 0.0f, mul(mul(mul(2.0f, erosion), mul(p, p)), square));
    const vec3 by = unbent(state.slopes, o.reach, n.gradient, dimensions);
    const vec3 steepening = transposed_times(state.slopes.jacobian, state.slopes.d, dimensions);
    const vec3 term = add3(mul3(damping, steepening), mul3(mul(2.0f, q), mul3(n.value, by)));
    struct state s = state;
    s.sum.gradient = add3(state.sum.gradient, mul3(o.weight, term));
    s.sum.value = add(state.sum.value, mul(o.weight, mul(q, square)));
    s.slopes = with_slope(state.slopes, o, n, n.value, by, dimensions);
    return s;
}

#endif
