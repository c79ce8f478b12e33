/* SPDX-License-Identifier: MIT
 *
 * The arithmetic of gullies at a block of points. The reference, which has the formulas, too, is
 * formulas/gullies.h. `order` is 1 where derivatives are asked for, or else 0.
 */
#ifndef SCARP_KERNEL_GULLIES_GULLY_H
#define SCARP_KERNEL_GULLIES_GULLY_H

#include "../../plan/gully.h"
#include "../basis/fade.h"

#define GULLY_TAU2 0.0025f
#define GULLY_EPS2 0.25f

/* Two numbers along x and y, or the parts of a complex number. */
struct pair2 {
    vf x, y;
};

/* A number, or a pair, with its derivatives along x and y. */
struct jet {
    vf value;
    struct pair2 d;
};
struct pair_jet {
    struct pair2 value, dx, dy;
};

/* What goes from octave to octave. Where no derivatives are asked for, these are unset. */
struct gully {
    struct pair_jet slope;
    struct jet steep, exposure, sum;
};

/* What goes from pass to pass: the direction t across the slope; the waves of the corners, then
   their blend. */
struct gully_wave {
    struct pair_jet t;
    union {
        struct pair2 corner[2][2]; /* by x and y */
        struct pair_jet blend;
    };
};

VEC_INLINE struct pair2 pair_of(vf x, vf y)
{
    const struct pair2 p = {x, y};
    return p;
}

VEC_INLINE struct pair2 sum2(struct pair2 a, struct pair2 b)
{
    return pair_of(a.x + b.x, a.y + b.y);
}

VEC_INLINE struct pair2 difference2(struct pair2 a, struct pair2 b)
{
    return pair_of(a.x - b.x, a.y - b.y);
}

VEC_INLINE struct pair2 scaled2(vf a, struct pair2 b)
{
    return pair_of(a * b.x, a * b.y);
}

VEC_INLINE vf dot2(struct pair2 a, struct pair2 b)
{
    return a.x * b.x + a.y * b.y;
}

/* a + u (b - a) */
VEC_INLINE struct pair2 mix2(struct pair2 a, struct pair2 b, vf u)
{
    return sum2(a, scaled2(u, difference2(b, a)));
}

/* a p + b q */
VEC_INLINE struct pair2 combined2(vf a, struct pair2 p, vf b, struct pair2 q)
{
    return sum2(scaled2(a, p), scaled2(b, q));
}

/* The product of complex numbers. */
VEC_INLINE struct pair2 product2(struct pair2 a, struct pair2 b)
{
    return pair_of(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

VEC_INLINE vf inverse(vf a)
{
    return vf_set(1.0f) / a;
}

/*
 * The base, in units of the call.
 */

VEC_INLINE struct jet gully_height(const struct scarp_gully_plan *g, const vf base[BASE_INPUTS])
{
    const vf zero = vf_set(0.0f), one = vf_set(1.0f);
    const vf from = (base[BASE_VALUE] - g->low) * g->steepness;
    const vf above = vm_choose(vm_less(from, zero), zero, from);
    const vf z = vm_choose(vm_less(one, above), one, above);
    const vf by = 6.0f * z * (1.0f - z) * g->steepness;
    const struct jet h = {z * z * (3.0f - 2.0f * z), {by * base[BASE_DX], by * base[BASE_DY]}};
    return h;
}

VEC_INLINE void gully_begin(struct gully *state, const struct scarp_gully_plan *g,
                            const vf base[BASE_INPUTS], int order)
{
    const vf dxx = base[BASE_DXX], dxy = base[BASE_DXY], dyy = base[BASE_DYY];
    const struct jet h = gully_height(g, base);
    const struct pair2 gradient = {base[BASE_DX], base[BASE_DY]};
    const vf rest = 1.0f - h.value;
    const vf slope2 = rest * g->slope2_low + h.value * g->slope2;
    const vf unit = inverse(vf_sqrt(dot2(gradient, gradient) + slope2));
    const struct pair2 s = scaled2(unit, gradient);
    state->slope.value = s;
    state->steep.value = dot2(s, s);
    state->exposure.value = 1.0f - rest * g->lowered;
    state->sum.value = vf_set(0.0f);
    if (order > 0) {
        const vf by = 0.5f * unit * (g->slope2 - g->slope2_low);
        const vf hx = s.x * dxx + s.y * dxy + by * h.d.x;
        const vf hy = s.x * dxy + s.y * dyy + by * h.d.y;
        const struct pair2 sx = scaled2(unit, pair_of(dxx - s.x * hx, dxy - s.y * hx));
        const struct pair2 sy = scaled2(unit, pair_of(dxy - s.x * hy, dyy - s.y * hy));
        state->slope.dx = sx;
        state->slope.dy = sy;
        state->steep.d = pair_of(2.0f * dot2(s, sx), 2.0f * dot2(s, sy));
        state->exposure.d = scaled2(vf_set(g->lowered), h.d);
        state->sum.d = pair_of(vf_set(0.0f), vf_set(0.0f));
    }
}

/*
 * Waves.
 */

VEC_INLINE vf sine_of_quarter(vf b)
{
    const vf z = b * b;
    const vf p = ((39.5367068f * z - 76.5497824f) * z + 81.6010040f) * z - 41.3416550f;
    return (p * z + 6.28318516f) * b;
}

/* u is no negative 0, so v has the sign that it is compared with 0 for. */
VEC_INLINE struct pair2 wave_of(vf u)
{
    const vf v = u - vf_floor(u + 0.5f);
    const vf a = (vf)((vu)v & 0x7fffffffu);
    const vf folded = vf_lesser(a, 0.5f - a);
    return pair_of(sine_of_quarter(0.25f - a),
                   sine_of_quarter((vf)((vu)folded | ((vu)v & 0x80000000u))));
}

VEC_INLINE struct pair_jet across_slope(const struct pair_jet *s, int order)
{
    const vf unit = inverse(vf_sqrt(dot2(s->value, s->value) + GULLY_TAU2));
    const struct pair2 t = {s->value.y * (0.0f - unit), s->value.x * unit};
    struct pair_jet across;
    across.value = t;
    if (order > 0) {
        const struct pair2 ex = scaled2(unit, s->dx), ey = scaled2(unit, s->dy);
        const vf bx = t.y * ex.x - t.x * ex.y, by = t.y * ey.x - t.x * ey.y;
        across.dx = pair_of(0.0f - (t.x * bx + ex.y), ex.x - t.y * bx);
        across.dy = pair_of(0.0f - (t.x * by + ey.y), ey.x - t.y * by);
    }
    return across;
}

/* The wave of a corner: `waves` is how many lie between the point and it. */
VEC_INLINE struct pair2 corner_wave(vf hash, vf waves)
{
    return wave_of(vf_from_vi((vi)hash) * 0x1p-32f + waves);
}

VEC_INLINE struct pair2 blend_slope(struct pair2 by_weights, vf t, struct pair2 d, struct pair2 z,
                                    const struct pair2 moment[2])
{
    const struct pair2 turn = sum2(scaled2(t, z), combined2(d.x, moment[0], d.y, moment[1]));
    return pair_of(by_weights.x - turn.y, by_weights.y + turn.x);
}

/* What derivatives of a blend are made of: those of its weights, and the sums of W (p - c). */
struct gully_moments {
    struct pair2 by_x, by_y, moment_x, moment_y;
};

VEC_INLINE void blend_slopes(struct pair_jet *blend, const struct gully_moments *m,
                             const struct scarp_gully_octave *o, const struct pair_jet *t)
{
    const vf ax = vf_set(o->angles[0]), ay = vf_set(o->angles[1]);
    const vf cx = vf_set(o->cells[0]), cy = vf_set(o->cells[1]);
    const vf less_ay = vf_set(0.0f - o->angles[1]), less_cy = vf_set(0.0f - o->cells[1]);
    const struct pair2 moment[2] = {combined2(ax, m->moment_x, ay, m->moment_y),
                                    combined2(ax, m->moment_y, less_ay, m->moment_x)};
    const struct pair2 wx = combined2(cx, m->by_x, cy, m->by_y);
    const struct pair2 wy = combined2(cx, m->by_y, less_cy, m->by_x);
    const struct pair2 z = blend->value;
    blend->dx = blend_slope(wx, o->stretch * t->value.x, t->dx, z, moment);
    blend->dy = blend_slope(wy, o->stretch * t->value.y, t->dy, z, moment);
}

/* Makes the waves of the corners; t is there. The hashes of a block of cells are as lattice.h puts
   them. */
VEC_INLINE void gully_corners(struct gully_wave *wave, const vf *lattice,
                              const struct scarp_gully_octave *o)
{
    const vf x = lattice[0], y = lattice[1];
    const struct pair2 turn = {vf_set(o->waves[0]), vf_set(o->waves[1])};
    const struct pair2 q = product2(turn, wave->t.value);
    const vf waves = q.x * x + q.y * y, waves_y = waves - q.y;
    wave->corner[0][0] = corner_wave(lattice[2], waves);
    wave->corner[1][0] = corner_wave(lattice[4], waves - q.x);
    wave->corner[0][1] = corner_wave(lattice[3], waves_y);
    wave->corner[1][1] = corner_wave(lattice[5], waves_y - q.x);
}

/* The blend Z of the waves. */
VEC_INLINE struct pair_jet blend_of(const struct gully_wave *wave, const vf *lattice,
                                    const struct scarp_gully_octave *o, int order)
{
    const vf x = lattice[0], y = lattice[1];
    const struct fade fx = fade(SCARP_QUINTIC, x), fy = fade(SCARP_QUINTIC, y);
    const struct pair2 c00 = wave->corner[0][0], c01 = wave->corner[0][1];
    const struct pair2 c10 = wave->corner[1][0], c11 = wave->corner[1][1];
    const struct pair2 left = mix2(c00, c01, fy.u), right = mix2(c10, c11, fy.u);
    const struct pair2 z = mix2(left, right, fx.u);
    struct pair_jet blend;
    blend.value = z;
    if (order > 0) {
        const struct pair2 top = mix2(c01, c11, fx.u);
        const struct pair2 step = mix2(difference2(c01, c00), difference2(c11, c10), fx.u);
        const struct gully_moments m = {
            scaled2(fx.du, difference2(right, left)),
            scaled2(fy.du, step),
            difference2(scaled2(x, z), scaled2(fx.u, right)),
            difference2(scaled2(y, z), scaled2(fy.u, top)),
        };
        blend_slopes(&blend, &m, o, &wave->t);
    }
    return blend;
}

VEC_INLINE struct pair2 quotient_slope(struct pair2 w, struct pair2 d, vf unit)
{
    const struct pair2 e = scaled2(unit, d);
    return difference2(e, scaled2(dot2(w, e), w));
}

VEC_INLINE struct pair_jet normalised(const struct pair_jet *z, int order)
{
    const vf unit = inverse(vf_sqrt(dot2(z->value, z->value) + GULLY_EPS2));
    struct pair_jet w;
    w.value = scaled2(unit, z->value);
    if (order > 0) {
        w.dx = quotient_slope(w.value, z->dx, unit);
        w.dy = quotient_slope(w.value, z->dy, unit);
    }
    return w;
}

/* The profile of a stripe, P(C). */
VEC_INLINE struct jet profile_of(const struct scarp_gully_plan *g, const struct pair_jet *w,
                                 int order)
{
    const vf r = vf_sqrt((1.0f - w->value.x) * 0.5f + g->round2);
    struct jet p;
    p.value = 1.0f - (r - g->round) * g->fall;
    if (order > 0) {
        const vf by = 0.25f * g->fall * inverse(r);
        p.d = pair_of(by * w->dx.x, by * w->dy.x);
    }
    return p;
}

/* Adds an octave, whose blend is normalised. */
VEC_INLINE void gully_add(struct gully *state, const struct gully_wave *wave,
                          const struct scarp_gully_plan *g, const struct scarp_gully_octave *o,
                          int order)
{
    const struct pair_jet t = wave->t, w = wave->blend;
    const struct jet height = profile_of(g, &w, order);
    const struct jet v = state->exposure;
    const vf kept = o->keep * v.value;
    const vf rest = 1.0f - kept * v.value;
    const vf m = state->steep.value * rest;
    const vf d = height.value - v.value;
    const vf by = 0.0f - g->branch * m * w.value.y;
    state->exposure.value = v.value + m * d;
    state->sum.value += o->weight * state->exposure.value;
    state->slope.value = sum2(state->slope.value, scaled2(by, t.value));
    if (order > 0) {
        const vf fall = 2.0f * state->steep.value * kept;
        const struct pair2 dm = combined2(rest, state->steep.d, 0.0f - fall, v.d);
        const vf by_x = 0.0f - g->branch * (dm.x * w.value.y + m * w.dx.y);
        const vf by_y = 0.0f - g->branch * (dm.y * w.value.y + m * w.dy.y);
        state->exposure.d = sum2(v.d, combined2(d, dm, m, difference2(height.d, v.d)));
        state->sum.d = sum2(state->sum.d, scaled2(vf_set(o->weight), state->exposure.d));
        state->slope.dx = sum2(state->slope.dx, combined2(by_x, t.value, by, t.dx));
        state->slope.dy = sum2(state->slope.dy, combined2(by_y, t.value, by, t.dy));
    }
}

#endif
