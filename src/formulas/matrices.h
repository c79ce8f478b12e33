/* SPDX-License-Identifier: MIT
 *
 * Formulas: arithmetic with vectors and symmetric matrices.
 */
#ifndef SCARP_FORMULAS_MATRICES_H
#define SCARP_FORMULAS_MATRICES_H

#include "sample.h"

static inline float dot(vec3 a, vec3 b, int dimensions)
{
    float d = a.x * b.x + a.y * b.y;
    if (dimensions == 3) {
        d += a.z * b.z;
    }
    return d;
}

/* A matrix of 3 rows. */
struct rows {
    vec3 x;
    vec3 y;
    vec3 z;
};

static inline struct rows rows_of(vec3 x, vec3 y, vec3 z)
{
    struct rows m;
    m.x = x;
    m.y = y;
    m.z = z;
    return m;
}

static inline struct rows transposed(struct rows m)
{
    return rows_of(vec3_of(m.x.x, m.y.x, m.z.x), vec3_of(m.x.y, m.y.y, m.z.y),
                   vec3_of(m.x.z, m.y.z, m.z.z));
}

/* m v */
static inline vec3 times(struct rows m, vec3 v, int dimensions)
{
    return vec3_of(dot(m.x, v, dimensions), dot(m.y, v, dimensions), dot(m.z, v, dimensions));
}

/* The transpose of m, times v. */
static inline vec3 transposed_times(struct rows m, vec3 v, int dimensions)
{
    return times(transposed(m), v, dimensions);
}

/* The Hessian. */
static inline struct rows hessian_of(struct sample s)
{
    return rows_of(vec3_of(s.diagonal.x, s.mixed.x, s.mixed.y),
                   vec3_of(s.mixed.x, s.diagonal.y, s.mixed.z),
                   vec3_of(s.mixed.y, s.mixed.z, s.diagonal.z));
}

/* Multiplies the outputs of each order by a factor of their own. */
static inline struct sample scaled(struct sample n, float value, float gradient, float hessian)
{
    return sample_of(value * n.value, mul3(gradient, n.gradient), mul3(hessian, n.diagonal),
                     mul3(hessian, n.mixed));
}

/* v_i m_j + v_j m_i: the elements of a diagonal, and the others. */
static inline vec3 crossed_diagonal(vec3 v, vec3 m)
{
    return vec3_of(v.x * m.x + v.x * m.x, v.y * m.y + v.y * m.y, v.z * m.z + v.z * m.z);
}

static inline vec3 crossed_mixed(vec3 v, vec3 m)
{
    return vec3_of(v.x * m.y + v.y * m.x, v.x * m.z + v.z * m.x, v.y * m.z + v.z * m.y);
}

#endif
