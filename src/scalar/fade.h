/* SPDX-License-Identifier: MIT
 *
 * Reference: the fades and their derivatives. Included by columns.h.
 */
#ifndef SCARP_SCALAR_FADE_H
#define SCARP_SCALAR_FADE_H

#include "../plan/call.h"

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
static inline struct fade fade(enum scarp_fade kind, float t)
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

#endif
