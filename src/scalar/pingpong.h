/* SPDX-License-Identifier: MIT
 *
 * Reference: ping-pong, t = (n + 1) sharpness folded to [-1, 1] with period 2.
 */
#ifndef SCARP_SCALAR_PINGPONG_H
#define SCARP_SCALAR_PINGPONG_H

#include "turbulence.h"

/* 1 - 2 |e|, where e = 1 - (t mod 2) rises where t falls. The derivatives lack their factor
   2 sharpness, which comes with the weight, and are 0 on creases, where the value is 1 or -1. */
static inline struct outputs pingpong(const struct outputs *n, float sharpness)
{
    const float t = (n->of[VALUE] + 1.0f) * sharpness;
    const float e = 1.0f - (t - 2.0f * floorf(t * 0.5f));
    const float value = 1.0f - 2.0f * fabsf(e);
    struct outputs s;
    for (int i = 0; i < OUTPUTS; i++) {
        s.of[i] = fabsf(value) == 1.0f ? 0.0f : signbit(e) ? -n->of[i] : n->of[i];
    }
    s.of[VALUE] = value;
    return s;
}

#endif
