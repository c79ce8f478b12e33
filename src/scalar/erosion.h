/* SPDX-License-Identifier: MIT
 *
 * Reference: erosion-like noise, q n with q = 1 / (1 + erosion d.d), and its gradient
 *
 *     q J^T g - 2 erosion n q^2 D^T d
 *
 * where d is the sum of the gradients g of the octaves so far, each in its own axes, and D its
 * Jacobian with respect to the input.
 */
#ifndef SCARP_SCALAR_EROSION_H
#define SCARP_SCALAR_EROSION_H

#include "hybrid.h"

/* The sum of the gradients, and jacobian[i][j] = d d_i / d x_j. */
struct slopes {
    float d[3], jacobian[3][3];
};

static inline float dot_of(const float a[3], const float b[3], int dimensions)
{
    const float d = a[0] * b[0] + a[1] * b[1];
    return dimensions == 3 ? d + a[2] * b[2] : d;
}

/* n has its gradient and its Hessian in the octave's own axes, but not DPHASE. */
static inline struct outputs erode(struct slopes *slopes, float erosion,
                                   const struct scarp_octave *o, int turned,
                                   const struct outputs *n, int dimensions)
{
    float *const d = slopes->d;
    for (int i = 0; i < dimensions; i++) {
        d[i] += n->of[DX + i];
    }
    const float q = 1.0f / (1.0f + erosion * dot_of(d, d, dimensions));
    const float damping = 2.0f * erosion * n->of[VALUE] * (q * q);
    struct outputs s = {{[VALUE] = q * n->of[VALUE]}};
    for (int j = 0; j < dimensions; j++) {
        float column[3] = {0.0f, 0.0f, 0.0f}; /* column j of D */
        for (int i = 0; i < dimensions; i++) {
            const float row[3] = {n->of[second(i, 0)], n->of[second(i, 1)], n->of[second(i, 2)]};
            slopes->jacobian[i][j] += to_input(o, turned, j, row, dimensions);
            column[i] = slopes->jacobian[i][j];
        }
        s.of[DX + j] = q * to_input(o, turned, j, &n->of[DX], dimensions) -
                       damping * dot_of(column, d, dimensions);
    }
    return s;
}

/* The derivative of q n by the phase, with that of n, and of its gradient, in `turning`; `slopes`
   have this octave. `by_phase` is the derivative of d, which moves on. */
static inline float erode_turning(const struct slopes *slopes, float by_phase[3], float erosion,
                                  float n, const struct outputs *turning, int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        by_phase[i] += turning->of[DX + i];
    }
    const float q = 1.0f / (1.0f + erosion * dot_of(slopes->d, slopes->d, dimensions));
    const float damping = 2.0f * erosion * n * (q * q);
    return q * turning->of[VALUE] - damping * dot_of(by_phase, slopes->d, dimensions);
}

#endif
