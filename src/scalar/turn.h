/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 3 of all fractals: derivatives of an octave in the frame of the input.
 */
#ifndef SCARP_SCALAR_TURN_H
#define SCARP_SCALAR_TURN_H

#include "basis.h"

/* Column j of a matrix, transposed, times the vector (x, y, z). */
static inline float column_dot(const float m[3][3], int j, const float v[3], int dimensions)
{
    const float dot = m[0][j] * v[0] + m[1][j] * v[1];
    return dimensions == 3 ? dot + m[2][j] * v[2] : dot;
}

/* Component j of J^T v, v being a gradient in the octave's axes. */
static inline float to_input(const struct scarp_octave *o, int turned, int j, const float v[3],
                             int dimensions)
{
    return turned ? column_dot(o->jacobian, j, v, dimensions) : o->frequency * v[j];
}

/* The output that is element (i, j) of the Hessian. */
static inline int second(int i, int j)
{
    static const int output[3][3] = {{DXX, DXY, DXZ}, {DXY, DYY, DYZ}, {DXZ, DYZ, DZZ}};
    return output[i][j];
}

/* Multiplies the outputs of each order by a factor of their own, but for DPHASE. */
static inline struct outputs scaled_outputs(const struct outputs *n, float value, float gradient,
                                            float hessian)
{
    struct outputs s;
    for (int i = 0; i < OUTPUTS; i++) {
        s.of[i] = (i == VALUE ? value : i < DXX ? gradient : hessian) * n->of[i];
    }
    s.of[DPHASE] = n->of[DPHASE];
    return s;
}

/* a n with turned axes: the gradient is (a J)^T g, the Hessian (a J)^T (H J). */
static inline struct outputs turn(const struct scarp_octave *o, const struct outputs *n,
                                  int dimensions)
{
    struct outputs s = {{[VALUE] = o->amplitude * n->of[VALUE], [DPHASE] = n->of[DPHASE]}};
    for (int j = 0; j < dimensions; j++) {
        float hj[3] = {0.0f, 0.0f, 0.0f}; /* column j of H J */
        s.of[DX + j] = column_dot(o->gradient, j, &n->of[DX], dimensions);
        for (int i = 0; i < dimensions; i++) {
            const float row[3] = {n->of[second(i, 0)], n->of[second(i, 1)], n->of[second(i, 2)]};
            hj[i] = column_dot(o->jacobian, j, row, dimensions);
        }
        for (int i = 0; i <= j; i++) {
            s.of[second(i, j)] = column_dot(o->gradient, i, hj, dimensions);
        }
    }
    return s;
}

/* a n in the frame of the input; with J = f the gradient has the factor a f, the Hessian a f^2. */
static inline struct outputs in_input(const struct scarp_octave *o, int turned,
                                      const struct outputs *n, int dimensions)
{
    return turned ? turn(o, n, dimensions)
                  : scaled_outputs(n, o->amplitude, o->slope, o->curvature);
}

#endif
