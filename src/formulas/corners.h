/* SPDX-License-Identifier: MIT
 *
 * Formulas: bases that interpolate between lattice points.
 *
 * They interpolate over z, then y, then x. On the lattice columns s = 0 and 1 at either side of a
 * point, what does not depend on x is reduced to lines a_s (x - s) + b_s in the fraction x: one for
 * the value (left and right), one for each derivative along y and z. Then
 *
 *     value  = left + u(x) (right - left)
 *     d/dx   = a_0 + u (a_1 - a_0) + u' (right - left)
 *     d2/dx2 = 2 u' (a_1 - a_0) + u'' (right - left)
 *
 * and the derivatives along y and z follow from their lines in the same way. For value noise the
 * lines are constants (a = 0), and the terms with a are left out. These are the published closed
 * forms (Quilez' k0..k7; gradient noise interpolates the corner gradients, too) in another order of
 * operations; tests/oracle_basis.c has them as published.
 */
#ifndef SCARP_FORMULAS_CORNERS_H
#define SCARP_FORMULAS_CORNERS_H

#include "lattice.h"
#include "sample.h"

/* A fade with its derivatives. */
struct fade {
    float u, du, ddu;
};

/*
 * quintic: u = 6t^5 - 15t^4 + 10t^3   u' = 30 t^2 (t-1)^2   u'' = 60 t (t-1) (2t-1)
 * cubic:   u = 3t^2 - 2t^3            u' = 6 t (1-t)        u'' = 6 - 12t
 *
 * The quintic is evaluated as t^3 ((t-1) (6t-9) + 1), where nothing cancels. Over all floats in [0,
 * 1] that errs by at most 1.94e-7, never exceeds 1 + 2^-23, and is exact at 0 and 1. The usual
 * form, t^3 (t (6t-15) + 10), takes as many operations and errs by 1.1e-6.
 */
static inline struct fade fade(uint kind, float t)
{
    const float s = t - 1.0f;
    const float ts = t * s;
    struct fade f;
    if (kind == SCARP_QUINTIC) {
        f.u = t * t * t * (s * (t * 6.0f - 9.0f) + 1.0f);
        f.du = 30.0f * (ts * ts);
        f.ddu = 60.0f * ts * (t + s);
    } else {
        f.u = t * t * (3.0f - 2.0f * t);
        f.du = -6.0f * ts;
        f.ddu = 6.0f - 12.0f * t;
    }
    return f;
}

static inline float mix(float a, float b, float u)
{
    return a + u * (b - a);
}

/* a x + b */
struct line {
    float a, b;
};

/* What a lattice column contributes. */
struct column {
    struct line value, y, z, yy, yz, zz;
};

/* `is_flat`: nothing depends on x, all a are 0. */
static inline float at(struct line l, float x, bool is_flat)
{
    return is_flat ? l.b : l.a * x + l.b;
}

/* The value and its derivatives along x, from the lines of both columns. */
static inline float across(struct line l, struct line r, float x, struct fade f, bool is_flat)
{
    return mix(at(l, x, is_flat), at(r, x - 1.0f, is_flat), f.u);
}

static inline float across_dx(struct line l, struct line r, float x, struct fade f, bool is_flat)
{
    const float step = f.du * (at(r, x - 1.0f, is_flat) - at(l, x, is_flat));
    return is_flat ? step : mix(l.a, r.a, f.u) + step;
}

static inline float across_dxx(struct line l, struct line r, float x, struct fade f, bool is_flat)
{
    const float bend = f.ddu * (at(r, x - 1.0f, is_flat) - at(l, x, is_flat));
    return is_flat ? bend : 2.0f * f.du * (r.a - l.a) + bend;
}

static inline struct sample join(struct column l, struct column r, float x, struct fade f,
                                 bool is_flat)
{
    const struct sample s = {
        .value = across(l.value, r.value, x, f, is_flat),
        .gradient = {across_dx(l.value, r.value, x, f, is_flat), across(l.y, r.y, x, f, is_flat),
                     across(l.z, r.z, x, f, is_flat)},
        .diagonal = {across_dxx(l.value, r.value, x, f, is_flat), across(l.yy, r.yy, x, f, is_flat),
                     across(l.zz, r.zz, x, f, is_flat)},
        .mixed = {across_dx(l.y, r.y, x, f, is_flat), across_dx(l.z, r.z, x, f, is_flat),
                  across(l.yz, r.yz, x, f, is_flat)},
    };
    return s;
}

#endif
