/* SPDX-License-Identifier: MIT
 *
 * Formulas: gullies, which run down the slope of a base (scarp.h, "Gullies").
 *
 * Heights are in units of the base's amplitude, lengths in cells of the base. What goes from octave
 * to octave is
 *
 *     s      the slope that the next octave runs down, |s| < 1, and its derivatives
 *     M      |s|^2 of the base: how steep it is, in [0, 1)
 *     v      how exposed the ground is: 1 on crests, -1 on floors
 *     sum    of w_k v_k, which displaces the base
 *
 * An octave draws stripes along the slope. A corner c of the cell of a point p has a wave with
 * stripes across t, the direction across the slope, and a phase that the lattice draws; Z is the
 * blend of these waves with the weights of value noise, as a complex number:
 *
 *     t = (-s_y, s_x) / sqrt(s.s + tau^2)
 *     Z = sum of W_c(p) e^(2 pi i (psi_c + stripes (R t).(p - c)))
 *     (C, S) = Z / sqrt(|Z|^2 + eps^2)
 *
 * The profile P(C) of a stripe has a sharp crest and a round floor. Then
 *
 *     m = M (1 - keep v^2),   v := v + m (P - v),   s := s - branch m S t
 *
 * where R turns the axes. All that is returned is smooth where the base is.
 */
#ifndef SCARP_FORMULAS_GULLIES_H
#define SCARP_FORMULAS_GULLIES_H

#include "corners.h"

#define GULLY_TAU2 0.0025f /* of tau = 0.05, where the direction of flat ground is soft */
#define GULLY_EPS2 0.25f   /* of eps = 0.5, where waves of corners cancel */

/* Two numbers along x and y, or the parts of a complex number. */
struct pair2 {
    float x, y;
};

/* A number with its derivatives along x and y. */
struct jet {
    float value;
    struct pair2 d;
};

/* A pair with its derivatives. */
struct pair_jet {
    struct pair2 value, dx, dy;
};

static inline struct pair2 pair_of(float x, float y)
{
    const struct pair2 p = {x, y};
    return p;
}

static inline struct pair2 sum2(struct pair2 a, struct pair2 b)
{
    return pair_of(a.x + b.x, a.y + b.y);
}

static inline struct pair2 difference2(struct pair2 a, struct pair2 b)
{
    return pair_of(a.x - b.x, a.y - b.y);
}

static inline struct pair2 scaled2(float a, struct pair2 b)
{
    return pair_of(a * b.x, a * b.y);
}

static inline float dot2(struct pair2 a, struct pair2 b)
{
    return a.x * b.x + a.y * b.y;
}

/* a + u (b - a) */
static inline struct pair2 mix2(struct pair2 a, struct pair2 b, float u)
{
    return sum2(a, scaled2(u, difference2(b, a)));
}

/* a p + b q */
static inline struct pair2 combined2(float a, struct pair2 p, float b, struct pair2 q)
{
    return sum2(scaled2(a, p), scaled2(b, q));
}

/* The product of complex numbers; of a turn and a vector: the vector, turned. */
static inline struct pair2 product2(struct pair2 a, struct pair2 b)
{
    return pair_of(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

/* The constants of a call. */
struct gully_shape {
    float low, steepness;     /* where the step from floors to crests begins; 1 / its width */
    float slope2, slope2_low; /* slopes where gullies have half their strength, squared */
    float lowered;            /* 1 + floor */
    float round, round2;      /* and its square */
    float fall;               /* 2 / (sqrt(1 + round^2) - round) */
    float branch;
};

/* The constants of an octave, whose axes are turned by R. */
struct gully_octave {
    float weight;        /* of v_k */
    float keep;          /* 0 of the first octave */
    struct pair2 waves;  /* stripes R */
    struct pair2 angles; /* 2 pi stripes R */
    struct pair2 cells;  /* f_k R */
    float stretch;       /* 2 pi stripes f_k */
};

/* What goes from octave to octave. */
struct gully {
    struct pair_jet slope;
    struct jet steep, exposure, sum;
};

/* The base at a point: its height, its gradient and its Hessian. */
struct gully_base {
    float value, dx, dy, dxx, dxy, dyy;
};

/* The smooth step of the height from floors, 0, to crests, 1. */
static inline struct jet height_of(struct gully_shape g, struct gully_base b)
{
    const float raw = (b.value - g.low) * g.steepness;
    const float above = either(raw < 0.0f, 0.0f, raw);
    const float z = either(above > 1.0f, 1.0f, above);
    const float by = 6.0f * z * (1.0f - z) * g.steepness;
    const struct jet h = {z * z * (3.0f - 2.0f * z), {by * b.dx, by * b.dy}};
    return h;
}

static inline struct gully gully_begin(struct gully_shape g, struct gully_base b)
{
    const struct jet h = height_of(g, b);
    const struct pair2 gradient = {b.dx, b.dy};
    const float rest = 1.0f - h.value;
    const float slope2 = rest * g.slope2_low + h.value * g.slope2;
    const float unit = inverse(root(dot2(gradient, gradient) + slope2));
    const struct pair2 s = scaled2(unit, gradient);
    const float by = 0.5f * unit * (g.slope2 - g.slope2_low);
    const float hx = s.x * b.dxx + s.y * b.dxy + by * h.d.x;
    const float hy = s.x * b.dxy + s.y * b.dyy + by * h.d.y;
    const struct pair2 sx = scaled2(unit, pair_of(b.dxx - s.x * hx, b.dxy - s.y * hx));
    const struct pair2 sy = scaled2(unit, pair_of(b.dxy - s.x * hy, b.dyy - s.y * hy));
    const struct gully state = {
        .slope = {s, sx, sy},
        .steep = {dot2(s, s), {2.0f * dot2(s, sx), 2.0f * dot2(s, sy)}},
        .exposure = {1.0f - rest * g.lowered, scaled2(g.lowered, h.d)},
        .sum = {0.0f, {0.0f, 0.0f}},
    };
    return state;
}

/* sin(2 pi b), |b| <= 1/4; the error is at most 3.4e-9 before rounding. */
static inline float sine_of_quarter(float b)
{
    const float z = b * b;
    const float p = ((39.5367068f * z - 76.5497824f) * z + 81.6010040f) * z - 41.3416550f;
    return (p * z + 6.28318516f) * b;
}

/* e^(2 pi i u), |u| < 2^22 */
static inline struct pair2 wave_of(float u)
{
    const float v = u - floor_of(u + 0.5f);
    const float a = magnitude(v);
    const float rest = 0.5f - a;
    const float folded = either(a < rest, a, rest);
    return pair_of(sine_of_quarter(0.25f - a),
                   sine_of_quarter(either(v < 0.0f, 0.0f - folded, folded)));
}

/* The direction across the slope. */
static inline struct pair_jet across_slope(struct pair_jet s)
{
    const float unit = inverse(root(dot2(s.value, s.value) + GULLY_TAU2));
    const struct pair2 t = {s.value.y * (0.0f - unit), s.value.x * unit};
    const struct pair2 ex = scaled2(unit, s.dx);
    const struct pair2 ey = scaled2(unit, s.dy);
    const float bx = t.y * ex.x - t.x * ex.y;
    const float by = t.y * ey.x - t.x * ey.y;
    const struct pair_jet across = {
        t,
        {0.0f - (t.x * bx + ex.y), ex.x - t.y * bx},
        {0.0f - (t.x * by + ey.y), ey.x - t.y * by},
    };
    return across;
}

/* The wave of a corner: `waves` is how many lie between the point and it. */
static inline struct pair2 corner_wave(uint hash, float waves)
{
    return wave_of(lattice_value(hash) * 0x1p-32f + waves);
}

/* The derivative of Z along an axis: of the weights, and of the waves, which turn with t and with
   its derivative d. */
static inline struct pair2 blend_slope(struct pair2 by_weights, float t, struct pair2 d,
                                       struct pair2 z, struct pair2 moment_x, struct pair2 moment_y)
{
    const struct pair2 turn = sum2(scaled2(t, z), combined2(d.x, moment_x, d.y, moment_y));
    return pair_of(by_weights.x - turn.y, by_weights.y + turn.x);
}

/* The blend Z of an octave. */
static inline struct pair_jet blend_of(struct lattice l, struct gully_octave o, struct location p,
                                       struct pair_jet t)
{
    const struct fade fx = fade(SCARP_QUINTIC, p.t.x);
    const struct fade fy = fade(SCARP_QUINTIC, p.t.y);
    const struct pair2 q = product2(o.waves, t.value);
    const float waves = q.x * p.t.x + q.y * p.t.y;
    const float waves_y = waves - q.y;
    const struct pair2 c00 = corner_wave(hash2(l.key, p.cell.x, p.cell.y), waves);
    const struct pair2 c10 = corner_wave(hash2(l.key, p.next.x, p.cell.y), waves - q.x);
    const struct pair2 c01 = corner_wave(hash2(l.key, p.cell.x, p.next.y), waves_y);
    const struct pair2 c11 = corner_wave(hash2(l.key, p.next.x, p.next.y), waves_y - q.x);
    const struct pair2 left = mix2(c00, c01, fy.u);
    const struct pair2 right = mix2(c10, c11, fy.u);
    const struct pair2 z = mix2(left, right, fx.u);
    const struct pair2 top = mix2(c01, c11, fx.u);
    const struct pair2 by_x = scaled2(fx.du, difference2(right, left));
    const struct pair2 by_y =
        scaled2(fy.du, mix2(difference2(c01, c00), difference2(c11, c10), fx.u));
    /* the sums of W (p - c) */
    const struct pair2 moment_x = difference2(scaled2(p.t.x, z), scaled2(fx.u, right));
    const struct pair2 moment_y = difference2(scaled2(p.t.y, z), scaled2(fy.u, top));
    /* in the axes of the input */
    const struct pair2 mx = combined2(o.angles.x, moment_x, o.angles.y, moment_y);
    const struct pair2 my = combined2(o.angles.x, moment_y, 0.0f - o.angles.y, moment_x);
    const struct pair2 wx = combined2(o.cells.x, by_x, o.cells.y, by_y);
    const struct pair2 wy = combined2(o.cells.x, by_y, 0.0f - o.cells.y, by_x);
    const struct pair_jet blend = {
        z,
        blend_slope(wx, o.stretch * t.value.x, t.dx, z, mx, my),
        blend_slope(wy, o.stretch * t.value.y, t.dy, z, mx, my),
    };
    return blend;
}

/* The derivative d of a blend, once this is divided by its length: `w` is the quotient. */
static inline struct pair2 quotient_slope(struct pair2 w, struct pair2 d, float unit)
{
    const struct pair2 e = scaled2(unit, d);
    return difference2(e, scaled2(dot2(w, e), w));
}

static inline struct pair_jet normalised(struct pair_jet z)
{
    const float unit = inverse(root(dot2(z.value, z.value) + GULLY_EPS2));
    const struct pair2 w = scaled2(unit, z.value);
    const struct pair_jet n = {w, quotient_slope(w, z.dx, unit), quotient_slope(w, z.dy, unit)};
    return n;
}

/* The profile of a stripe, P(C). */
static inline struct jet profile_of(struct gully_shape g, struct pair_jet w)
{
    const float r = root((1.0f - w.value.x) * 0.5f + g.round2);
    const float by = 0.25f * g.fall * inverse(r);
    const struct jet p = {1.0f - (r - g.round) * g.fall, {by * w.dx.x, by * w.dy.x}};
    return p;
}

/* Adds an octave at a point of its lattice. */
static inline struct gully gully_octave_at(struct gully_shape g, struct gully_octave o,
                                           struct lattice l, struct location p, struct gully state)
{
    const struct pair_jet t = across_slope(state.slope);
    const struct pair_jet w = normalised(blend_of(l, o, p, t));
    const struct jet height = profile_of(g, w);
    const struct jet v = state.exposure;
    const float kept = o.keep * v.value;
    const float rest = 1.0f - kept * v.value;
    const float m = state.steep.value * rest;
    const float fall = 2.0f * state.steep.value * kept;
    const struct pair2 dm = combined2(rest, state.steep.d, 0.0f - fall, v.d);
    const float d = height.value - v.value;
    const struct jet next = {
        v.value + m * d,
        sum2(v.d, combined2(d, dm, m, difference2(height.d, v.d))),
    };
    const float by = 0.0f - g.branch * m * w.value.y;
    const float by_x = 0.0f - g.branch * (dm.x * w.value.y + m * w.dx.y);
    const float by_y = 0.0f - g.branch * (dm.y * w.value.y + m * w.dy.y);
    const struct gully after = {
        .slope = {sum2(state.slope.value, scaled2(by, t.value)),
                  sum2(state.slope.dx, combined2(by_x, t.value, by, t.dx)),
                  sum2(state.slope.dy, combined2(by_y, t.value, by, t.dy))},
        .steep = state.steep,
        .exposure = next,
        .sum = {state.sum.value + o.weight * next.value,
                sum2(state.sum.d, scaled2(o.weight, next.d))},
    };
    return after;
}

#endif
