/* SPDX-License-Identifier: MIT
 *
 * Shaders: steps of recipes, which scarp_recipe_shader calls; as recipe/positions.c has them.
 */
#ifndef SCARP_GPU_RECIPE_H
#define SCARP_GPU_RECIPE_H

#include "chain.h"
#include "flow.h"

#include "../formulas/gullies.h"

/* The place of a noise: m x + t, of rows that have t as their last element. */
static inline vec3 placed(vec3 x, vec4 a, vec4 b, vec4 c, int dimensions)
{
    const struct rows m =
        rows_of(vec3_of(a.x, a.y, a.z), vec3_of(b.x, b.y, b.z), vec3_of(c.x, c.y, c.z));
    return add3(times(m, x, dimensions), vec3_of(a.w, b.w, c.w));
}

/* The rows m of a place, with the gradients of what displaces it. */
static inline struct rows jacobian_with(vec4 a, vec4 b, vec4 c, struct displaced rest)
{
    return rows_of(add3(vec3_of(a.x, a.y, a.z), rest.x.gradient),
                   add3(vec3_of(b.x, b.y, b.z), rest.y.gradient),
                   add3(vec3_of(c.x, c.y, c.z), rest.z.gradient));
}

/* j_a (h j_b), and what the curvature of u adds along the gradient: over the axes of u. */
static inline float pulled_second(vec3 ja, vec3 jb, struct rows h, vec3 bends, int dimensions)
{
    float sum = ja.x * (h.x.x * jb.x) + ja.x * (h.x.y * jb.y);
    if (dimensions == 3) {
        sum += ja.x * (h.x.z * jb.z);
    }
    sum += bends.x;
    sum += ja.y * (h.y.x * jb.x);
    sum += ja.y * (h.y.y * jb.y);
    if (dimensions == 3) {
        sum += ja.y * (h.y.z * jb.z);
    }
    sum += bends.y;
    if (dimensions == 3) {
        sum += ja.z * (h.z.x * jb.x);
        sum += ja.z * (h.z.y * jb.y);
        sum += ja.z * (h.z.z * jb.z);
        sum += bends.z;
    }
    return sum;
}

static inline vec3 times_each(vec3 a, vec3 b)
{
    return vec3_of(a.x * b.x, a.y * b.y, a.z * b.z);
}

/* A sample with derivatives with respect to u, of so many dimensions, becomes one with derivatives
   with respect to x: j are the gradients of u with respect to x, `rest` what displaces u. */
static inline struct sample pulled(struct sample s, struct rows j, struct displaced rest,
                                   int dimensions)
{
    const struct rows h = hessian_of(s);
    const struct rows by = transposed(j);
    const vec3 g = s.gradient;
    const struct displaced r = rest;
    const vec3 xx = vec3_of(r.x.diagonal.x, r.y.diagonal.x, r.z.diagonal.x);
    const vec3 yy = vec3_of(r.x.diagonal.y, r.y.diagonal.y, r.z.diagonal.y);
    const vec3 zz = vec3_of(r.x.diagonal.z, r.y.diagonal.z, r.z.diagonal.z);
    const vec3 xy = vec3_of(r.x.mixed.x, r.y.mixed.x, r.z.mixed.x);
    const vec3 xz = vec3_of(r.x.mixed.y, r.y.mixed.y, r.z.mixed.y);
    const vec3 yz = vec3_of(r.x.mixed.z, r.y.mixed.z, r.z.mixed.z);
    return sample_of(s.value, times(by, g, dimensions),
                     vec3_of(pulled_second(by.x, by.x, h, times_each(g, xx), dimensions),
                             pulled_second(by.y, by.y, h, times_each(g, yy), dimensions),
                             pulled_second(by.z, by.z, h, times_each(g, zz), dimensions)),
                     vec3_of(pulled_second(by.x, by.y, h, times_each(g, xy), dimensions),
                             pulled_second(by.x, by.z, h, times_each(g, xz), dimensions),
                             pulled_second(by.y, by.z, h, times_each(g, yz), dimensions)));
}

/* A coordinate u of a place: its row of m, and what displaces it. */
static inline struct sample coordinate_of(float u, vec4 row, struct sample rest)
{
    struct sample s = rest;
    s.value = u;
    s.gradient = add3(vec3_of(row.x, row.y, row.z), rest.gradient);
    return s;
}

/* Whether a mask is a number, 0 or 1, with all derivatives up to an order. */
static inline bool is_level(struct sample mask, float number, int order, int dimensions)
{
    const vec3 g = mask.gradient;
    const vec3 d = mask.diagonal;
    const vec3 m = mask.mixed;
    const bool is_plane = dimensions == 2;
    const bool is_flat = g.x == 0.0f && g.y == 0.0f && (is_plane || g.z == 0.0f);
    const bool is_straight = d.x == 0.0f && m.x == 0.0f && d.y == 0.0f;
    const bool is_straight_up = is_plane || (m.y == 0.0f && m.z == 0.0f && d.z == 0.0f);
    return mask.value == number && (order < 1 || is_flat) &&
           (order < 2 || (is_straight && is_straight_up));
}

/* Components of a warp at y become such at x. */
static inline struct displaced composed_each(struct displaced d, struct displaced y, int dimensions)
{
    struct displaced r = d;
    r.x = composed(d.x, y, dimensions);
    r.y = composed(d.y, y, dimensions);
    if (dimensions == 3) {
        r.z = composed(d.z, y, dimensions);
    }
    return r;
}

/* What cells say: 0 the number of the cell, 1 and 2 the distance to the nearest feature and to the
   second. */
static inline struct sample cell_sample(struct cells c, int what)
{
    struct sample s = constant(lattice_value(c.id) * 0x1p-31f);
    if (what == 1) {
        s.value = c.f1;
        s.gradient = c.d1;
    }
    if (what == 2) {
        s.value = c.f2;
        s.gradient = c.d2;
    }
    return s;
}

/* The constants of gullies: a is low, steepness, slope2, slope2_low; b is lowered, round, round2,
   fall; c is branch, and what brings the base to units of the call, value, gradient, Hessian. */
static inline struct gully_shape gully_shape_of(vec4 a, vec4 b, vec4 c)
{
    const struct gully_shape g = {a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, c.x};
    return g;
}

static inline struct gully gully_first(struct gully_shape g, vec4 c, struct sample base)
{
    const struct gully_base b = {base.value * c.y,      base.gradient.x * c.z,
                                 base.gradient.y * c.z, base.diagonal.x * c.w,
                                 base.mixed.x * c.w,    base.diagonal.y * c.w};
    return gully_begin(g, b);
}

/* Octaves of gullies keep their own constants where noise has others: keep, stretch, and the pairs
   of waves, angles and cells. */
static inline struct gully gully_with(struct gully state, struct gully_shape g, struct octave o,
                                      struct level l, bool turned, vec3 x)
{
    struct gully_octave own;
    own.weight = o.weight;
    own.keep = o.turn.x;
    own.stretch = o.turn.y;
    own.waves = pair_of(o.turn.z, o.turn.w);
    own.angles = pair_of(o.gradient_x.x, o.gradient_x.y);
    own.cells = pair_of(o.gradient_y.x, o.gradient_y.y);
    const struct location p = location_of(o, SCARP_GRADIENT, turned, x, 2);
    return gully_octave_at(g, own, lattice_of(o, l), p, state);
}

/* What gullies add to the base; a and b bring value and gradient back to its units. */
static inline struct sample gully_displacement(struct gully state, float a, float b)
{
    struct sample s = constant(a * state.sum.value);
    s.gradient = vec3_of(b * state.sum.d.x, b * state.sum.d.y, 0.0f);
    return s;
}

#endif
