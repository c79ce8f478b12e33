/* SPDX-License-Identifier: MIT
 *
 * Reference: turbulence, m = |n|.
 */
#ifndef SCARP_SCALAR_TURBULENCE_H
#define SCARP_SCALAR_TURBULENCE_H

#include "turn.h"

/* sign(n) a, and 0 where n is 0. */
static inline float with_sign(float a, float n)
{
    return n == 0.0f ? 0.0f : signbit(n) ? -a : a;
}

static inline struct outputs magnitude_of(const struct outputs *n)
{
    struct outputs m;
    for (int i = 0; i < OUTPUTS; i++) {
        m.of[i] = with_sign(n->of[i], n->of[VALUE]);
    }
    return m;
}

#endif
