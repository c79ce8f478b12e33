/* SPDX-License-Identifier: MIT
 *
 * Reference: the fractals beside fBm, an octave at a time. Included by fractal.h only. Each
 * function takes the noise n of an octave, shapes it as its fractal asks for, and moves on what
 * goes from octave to octave; the caller adds the result, times a_k, to the sum. scarp.h has the
 * formulas.
 */
#ifndef SCARP_SCALAR_SHAPE_H
#define SCARP_SCALAR_SHAPE_H

#include "axes.h"

/* sign(n) a, and 0 where n is 0. By its bits: signs are random, and branches on them cost more than
   the noise. */
SCALAR_INLINE float with_sign(float a, float n)
{
    uint32_t bits, sign;
    memcpy(&bits, &a, sizeof bits);
    memcpy(&sign, &n, sizeof sign);
    bits = (bits ^ (sign & 0x80000000u)) & (n != 0.0f ? 0xffffffffu : 0u);
    memcpy(&a, &bits, sizeof a);
    return a;
}

/* Turbulence: m = |n|. */
SCALAR_INLINE struct sample magnitude(const struct sample *n)
{
    const float v = n->value;
    const struct sample m = {
        .value = with_sign(v, v),
        .dx = with_sign(n->dx, v),
        .dy = with_sign(n->dy, v),
        .dz = with_sign(n->dz, v),
        .dxx = with_sign(n->dxx, v),
        .dxy = with_sign(n->dxy, v),
        .dxz = with_sign(n->dxz, v),
        .dyy = with_sign(n->dyy, v),
        .dyz = with_sign(n->dyz, v),
        .dzz = with_sign(n->dzz, v),
    };
    return m;
}

/* First and second derivative of v r^2, r = 1 - m, along i and along i and j:
       r^2 v_i - 2 v r m_i
       r^2 v_ij - 2 r (v_i m_j + v_j m_i) + 2 v m_i m_j - 2 v r m_ij */
SCALAR_INLINE float ridge_first(float v, float r, float wi, float mi)
{
    return r * r * wi - 2.0f * v * r * mi;
}

SCALAR_INLINE float ridge_second(float v, float r, float wi, float wj, float wij, float mi,
                                 float mj, float mij)
{
    return (r * r * wij - 2.0f * r * (wi * mj + wj * mi)) +
           (2.0f * v * (mi * mj) - 2.0f * v * r * mij);
}

/* 2 s, but 1 where that is more. */
SCALAR_INLINE struct sample next_weight(const struct sample *s)
{
    if (!(2.0f * s->value < 1.0f)) {
        return (struct sample){.value = 1.0f};
    }
    const struct sample v = {
        .value = 2.0f * s->value,
        .dx = 2.0f * s->dx,
        .dy = 2.0f * s->dy,
        .dz = 2.0f * s->dz,
        .dxx = 2.0f * s->dxx,
        .dxy = 2.0f * s->dxy,
        .dxz = 2.0f * s->dxz,
        .dyy = 2.0f * s->dyy,
        .dyz = 2.0f * s->dyz,
        .dzz = 2.0f * s->dzz,
    };
    return v;
}

/* Ridged: s = v (1 - |n|)^2. v is the weight of this octave, then that of the next. */
SCALAR_INLINE struct sample ridge(struct sample *weight, const struct sample *n)
{
    const struct sample v = *weight;
    const struct sample m = magnitude(n);
    const float r = 1.0f - m.value;
    const struct sample s = {
        .value = v.value * (r * r),
        .dx = ridge_first(v.value, r, v.dx, m.dx),
        .dy = ridge_first(v.value, r, v.dy, m.dy),
        .dz = ridge_first(v.value, r, v.dz, m.dz),
        .dxx = ridge_second(v.value, r, v.dx, v.dx, v.dxx, m.dx, m.dx, m.dxx),
        .dxy = ridge_second(v.value, r, v.dx, v.dy, v.dxy, m.dx, m.dy, m.dxy),
        .dxz = ridge_second(v.value, r, v.dx, v.dz, v.dxz, m.dx, m.dz, m.dxz),
        .dyy = ridge_second(v.value, r, v.dy, v.dy, v.dyy, m.dy, m.dy, m.dyy),
        .dyz = ridge_second(v.value, r, v.dy, v.dz, v.dyz, m.dy, m.dz, m.dyz),
        .dzz = ridge_second(v.value, r, v.dz, v.dz, v.dzz, m.dz, m.dz, m.dzz),
    };
    *weight = next_weight(&s);
    return s;
}

/* The sum of the gradients of the octaves so far, and its Jacobian with respect to the input:
   jacobian[i][j] = d d_i / d x_j. */
struct slopes {
    float d[3], jacobian[3][3];
};

/* Erosion: q n with q = 1 / (1 + erosion d.d), and its gradient
       q J^T g - 2 erosion n q^2 D^T d.
   n has its gradient g and its Hessian in the octave's own axes. */
SCALAR_INLINE struct sample erode(struct slopes *slopes, float erosion,
                                  const struct scarp_octave *o, enum axes axes,
                                  const struct sample *n, int dimensions, int order)
{
    const float g[3] = {n->dx, n->dy, n->dz};
    float *const d = slopes->d;
    float squares = 0.0f;
    for (int i = 0; i < dimensions; i++) {
        d[i] += g[i];
        squares = i == 0 ? d[i] * d[i] : squares + d[i] * d[i];
    }
    const float q = 1.0f / (1.0f + erosion * squares);
    struct sample s = {.value = q * n->value};
    if (order >= 1) {
        const float damping = 2.0f * erosion * n->value * (q * q);
        float(*const dj)[3] = slopes->jacobian;
        float gradient[3] = {0.0f, 0.0f, 0.0f};
        for (int j = 0; j < dimensions; j++) {
            dj[0][j] += to_input(o, axes, j, dimensions, n->dxx, n->dxy, n->dxz);
            dj[1][j] += to_input(o, axes, j, dimensions, n->dxy, n->dyy, n->dyz);
            dj[2][j] += dimensions == 3 ? to_input(o, axes, j, 3, n->dxz, n->dyz, n->dzz) : 0.0f;
            const float steeper = dimensions == 3
                                      ? dj[0][j] * d[0] + dj[1][j] * d[1] + dj[2][j] * d[2]
                                      : dj[0][j] * d[0] + dj[1][j] * d[1];
            gradient[j] =
                q * to_input(o, axes, j, dimensions, g[0], g[1], g[2]) - damping * steeper;
        }
        s.dx = gradient[0];
        s.dy = gradient[1];
        s.dz = gradient[2];
    }
    return s;
}

#endif
