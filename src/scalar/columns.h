/* SPDX-License-Identifier: MIT
 *
 * Reference: the interpolation over x, the last step of bases that interpolate between lattice
 * points. Included by gradient.h and value.h.
 *
 * Such bases interpolate over z, then y, then x. On the lattice columns s = 0 and 1 at either side
 * of a point, what does not depend on x is reduced to lines a_s (x - s) + b_s in the fraction x:
 * one for the value (left and right), one for each derivative along y and z. Then
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
#ifndef SCARP_SCALAR_COLUMNS_H
#define SCARP_SCALAR_COLUMNS_H

#include "../plan/outputs.h"
#include "fade.h"
#include "lattice.h"
#include "positions.h"

/* A basis, or a sum of octaves, at one point. In 2D the outputs along z are not used. */
struct sample {
    float of[OUTPUTS];
};

struct line {
    float a, b;
};

/* What a lattice column contributes. `flat`: nothing depends on x, all a are 0. */
struct column {
    struct line value, y, z, yy, yz, zz;
    int flat;
};

static inline float at(struct line line, float x, int flat)
{
    return flat ? line.b : line.a * x + line.b;
}

/* The value and its derivatives along x, from the lines of both columns. */
static inline float across(struct line l, struct line r, float x, struct fade f, int flat)
{
    return mix(at(l, x, flat), at(r, x - 1.0f, flat), f.u);
}

static inline float across_dx(struct line l, struct line r, float x, struct fade f, int flat)
{
    const float step = f.du * (at(r, x - 1.0f, flat) - at(l, x, flat));
    return flat ? step : mix(l.a, r.a, f.u) + step;
}

static inline float across_dxx(struct line l, struct line r, float x, struct fade f, int flat)
{
    const float bend = f.ddu * (at(r, x - 1.0f, flat) - at(l, x, flat));
    return flat ? bend : 2.0f * f.du * (r.a - l.a) + bend;
}

static inline struct sample join(const struct column *l, const struct column *r, float x,
                                 struct fade f)
{
    const int flat = l->flat;
    const struct sample s = {{
        [VALUE] = across(l->value, r->value, x, f, flat),
        [DX] = across_dx(l->value, r->value, x, f, flat),
        [DY] = across(l->y, r->y, x, f, flat),
        [DZ] = across(l->z, r->z, x, f, flat),
        [DXX] = across_dxx(l->value, r->value, x, f, flat),
        [DXY] = across_dx(l->y, r->y, x, f, flat),
        [DXZ] = across_dx(l->z, r->z, x, f, flat),
        [DYY] = across(l->yy, r->yy, x, f, flat),
        [DYZ] = across(l->yz, r->yz, x, f, flat),
        [DZZ] = across(l->zz, r->zz, x, f, flat),
    }};
    return s;
}

#endif
