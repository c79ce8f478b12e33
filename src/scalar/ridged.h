/* SPDX-License-Identifier: MIT
 *
 * Reference: ridged noise, s = v (1 - |n|)^2, with the weights v_0 = 1, v_{k+1} = min(1, 2 s_k).
 */
#ifndef SCARP_SCALAR_RIDGED_H
#define SCARP_SCALAR_RIDGED_H

#include "pingpong.h"

/* First and second derivative of v r^2, r = 1 - m, along i and along i and j; output DX + i is the
   first one:
       r^2 v_i - 2 v r m_i
       r^2 v_ij - 2 r (v_i m_j + v_j m_i) + 2 v m_i m_j - 2 v r m_ij */
static inline float ridge_first(const struct outputs *v, const struct outputs *m, float r, int i)
{
    return r * r * v->of[DX + i] - 2.0f * v->of[VALUE] * r * m->of[DX + i];
}

static inline float ridge_second(const struct outputs *v, const struct outputs *m, float r, int i,
                                 int j)
{
    const float vi = v->of[DX + i], vj = v->of[DX + j], vij = v->of[second(i, j)];
    const float mi = m->of[DX + i], mj = m->of[DX + j], mij = m->of[second(i, j)];
    return (r * r * vij - 2.0f * r * (vi * mj + vj * mi)) +
           (2.0f * v->of[VALUE] * (mi * mj) - 2.0f * v->of[VALUE] * r * mij);
}

/* 2 s, but 1 where that is more. */
static inline struct outputs next_weight(const struct outputs *s)
{
    if (!(2.0f * s->of[VALUE] < 1.0f)) {
        return (struct outputs){{[VALUE] = 1.0f}};
    }
    struct outputs weight = scaled_outputs(s, 2.0f, 2.0f, 2.0f);
    weight.of[DPHASE] *= 2.0f;
    return weight;
}

/* `weight` is that of this octave on entry, that of the next on return. */
static inline struct outputs ridge(struct outputs *weight, const struct outputs *n)
{
    const struct outputs m = magnitude_of(n);
    const float r = 1.0f - m.of[VALUE];
    struct outputs s = {{[VALUE] = weight->of[VALUE] * (r * r)}};
    s.of[DPHASE] = ridge_first(weight, &m, r, DPHASE - DX);
    for (int i = 0; i < 3; i++) {
        s.of[DX + i] = ridge_first(weight, &m, r, i);
        for (int j = i; j < 3; j++) {
            s.of[second(i, j)] = ridge_second(weight, &m, r, i, j);
        }
    }
    *weight = next_weight(&s);
    return s;
}

#endif
