/* SPDX-License-Identifier: MIT
 *
 * Reference: hybrid multifractal noise, u = v (n + sharpness), with the weights v_0 = 1 and
 * v_(k+1) = gain^k u_k, clamped to [-1, 1]. The head-room of n is in its amplitude
 * (plan/octaves.c).
 */
#ifndef SCARP_SCALAR_HYBRID_H
#define SCARP_SCALAR_HYBRID_H

#include "ridged.h"

/* First and second derivative of v r, r = n + sharpness, along i and along i and j:
       r v_i + v n_i
       r v_ij + v n_ij + v_i n_j + v_j n_i */
static inline float hybrid_first(const struct outputs *v, const struct outputs *n, float r, int i)
{
    return r * v->of[DX + i] + v->of[VALUE] * n->of[DX + i];
}

static inline float hybrid_second(const struct outputs *v, const struct outputs *n, float r, int i,
                                  int j)
{
    return (r * v->of[second(i, j)] + v->of[VALUE] * n->of[second(i, j)]) +
           (v->of[DX + i] * n->of[DX + j] + v->of[DX + j] * n->of[DX + i]);
}

/* share u, but 1 or -1 where that is beyond. */
static inline struct outputs hybrid_weight(const struct outputs *u, float share)
{
    const float t = share * u->of[VALUE];
    if (!(fabsf(t) < 1.0f)) {
        return (struct outputs){{[VALUE] = t < 0.0f ? -1.0f : 1.0f}};
    }
    struct outputs weight = scaled_outputs(u, share, share, share);
    weight.of[DPHASE] *= share;
    return weight;
}

/* `weight` is that of this octave on entry, that of the next on return. */
static inline struct outputs hybrid(struct outputs *weight, const struct outputs *n,
                                    float sharpness, float share)
{
    const float r = n->of[VALUE] + sharpness;
    struct outputs u = {{[VALUE] = weight->of[VALUE] * r}};
    u.of[DPHASE] = hybrid_first(weight, n, r, DPHASE - DX);
    for (int i = 0; i < 3; i++) {
        u.of[DX + i] = hybrid_first(weight, n, r, i);
        for (int j = i; j < 3; j++) {
            u.of[second(i, j)] = hybrid_second(weight, n, r, i, j);
        }
    }
    *weight = hybrid_weight(&u, share);
    return u;
}

#endif
