/* SPDX-License-Identifier: MIT
 *
 * Shaders: bases that blend what is drawn at the corners of cells; as scalar/fade.h and
 * scalar/columns.h. Included by gradient.h.
 */
#ifndef SCARP_GPU_CORNERS_H
#define SCARP_GPU_CORNERS_H

#include "lattice.h"

struct fade {
    float u;
    float du;
    float ddu;
};

static inline struct fade fade(uint kind, float t)
{
    const float s = sub(t, 1.0f);
    const float ts = mul(t, s);
    struct fade f;
    if (kind == QUINTIC) {
        const float inner = add(mul(s, sub(mul(t, 6.0f), 9.0f)), 1.0f);
        f.u = mul(mul(mul(t, t), t), inner);
        f.du = mul(30.0f, mul(ts, ts));
        f.ddu = mul(mul(60.0f, ts), add(t, s));
    } else {
        f.u = mul(mul(t, t), sub(3.0f, mul(2.0f, t)));
        f.du = mul(-6.0f, ts);
        f.ddu = sub(6.0f, mul(12.0f, t));
    }
    return f;
}

static inline float mix(float a, float b, float u)
{
    return add(a, mul(u, sub(b, a)));
}

/* a x + b */
struct slope {
    float a;
    float b;
};

static inline struct slope slope_of(float a, float b)
{
    struct slope s;
    s.a = a;
    s.b = b;
    return s;
}

/* What a lattice column contributes. Those of value noise are flat: all a are 0. */
struct column {
    struct slope value;
    struct slope y;
    struct slope z;
    struct slope yy;
    struct slope yz;
    struct slope zz;
};

/* Two columns, and the point between them. */
struct between {
    float x;
    float before;
    struct fade f;
    bool is_flat;
};

static inline float at(struct slope s, float x, bool is_flat)
{
    float value = s.b;
    if (!is_flat) {
        value = add(mul(s.a, x), s.b);
    }
    return value;
}

static inline float across(struct slope l, struct slope r, struct between p)
{
    return mix(at(l, p.x, p.is_flat), at(r, p.before, p.is_flat), p.f.u);
}

static inline float across_dx(struct slope l, struct slope r, struct between p)
{
    float step = mul(p.f.du, sub(at(r, p.before, p.is_flat), at(l, p.x, p.is_flat)));
    if (!p.is_flat) {
        step = add(mix(l.a, r.a, p.f.u), step);
    }
    return step;
}

static inline float across_dxx(struct slope l, struct slope r, struct between p)
{
    float bend = mul(p.f.ddu, sub(at(r, p.before, p.is_flat), at(l, p.x, p.is_flat)));
    if (!p.is_flat) {
        bend = add(mul(mul(2.0f, p.f.du), sub(r.a, l.a)), bend);
    }
    return bend;
}

static inline struct sample join(struct column l, struct column r, float x, struct fade f,
                                 bool is_flat)
{
    struct between p;
    p.x = x;
    p.before = sub(x, 1.0f);
    p.f = f;
    p.is_flat = is_flat;
    return sample_of(
        across(l.value, r.value, p),
        vec3_of(across_dx(l.value, r.value, p), across(l.y, r.y, p), across(l.z, r.z, p)),
        vec3_of(across_dxx(l.value, r.value, p), across(l.yy, r.yy, p), across(l.zz, r.zz, p)),
        vec3_of(across_dx(l.y, r.y, p), across_dx(l.z, r.z, p), across(l.yz, r.yz, p)));
}

#endif
