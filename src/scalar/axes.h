/* SPDX-License-Identifier: MIT
 *
 * Reference: how the axes of octaves lie. Included by the other files of src/scalar only.
 * `dimensions` and `axes` are constants wherever these are inlined.
 */
#ifndef SCARP_SCALAR_AXES_H
#define SCARP_SCALAR_AXES_H

#include "basis.h"

/* How the axes of an octave lie: p = f x, p = f x + o, p = J x + o. */
enum axes { AXES_FIRST, AXES_STRAIGHT, AXES_TURNED };

/* p_k = J_k x + o_k, split into cell and fraction. (The offset of octave 0 is 0, and turns -0 into
   0.) */
SCALAR_INLINE struct place place_f32(const struct scarp_octave *o, enum axes axes, const float x[3],
                                     int dimensions)
{
    struct place place;
    for (int i = 0; i < dimensions; i++) {
        const float *const j = o->jacobian[i];
        float p = axes == AXES_TURNED ? j[0] * x[0] + j[1] * x[1] : o->frequency * x[i];
        if (axes == AXES_TURNED && dimensions == 3) {
            p += j[2] * x[2];
        }
        split_f32(p + (axes == AXES_FIRST ? 0.0f : o->offset[i]), &place.cell[i], &place.t[i]);
    }
    return place;
}

SCALAR_INLINE struct place place_f64(const struct scarp_octave *o, enum axes axes,
                                     const double x[3], int dimensions)
{
    struct place place;
    for (int i = 0; i < dimensions; i++) {
        const double *const j = o->jacobian64[i];
        double p = axes == AXES_TURNED ? j[0] * x[0] + j[1] * x[1] : o->frequency64 * x[i];
        if (axes == AXES_TURNED && dimensions == 3) {
            p += j[2] * x[2];
        }
        split_f64(p + (axes == AXES_FIRST ? 0.0 : o->offset64[i]), &place.cell[i], &place.t[i]);
    }
    return place;
}

/* Column j of a matrix, transposed, times the vector (x, y, z). */
SCALAR_INLINE float column_dot(const float m[3][3], int j, int dimensions, float x, float y,
                               float z)
{
    const float dot = m[0][j] * x + m[1][j] * y;
    return dimensions == 3 ? dot + m[2][j] * z : dot;
}

/* Component j of J^T v, v = (x, y, z) being a gradient in the octave's axes. */
SCALAR_INLINE float to_input(const struct scarp_octave *o, enum axes axes, int j, int dimensions,
                             float x, float y, float z)
{
    const float v[3] = {x, y, z};
    return axes == AXES_TURNED ? column_dot(o->jacobian, j, dimensions, x, y, z)
                               : o->frequency * v[j];
}

#endif
