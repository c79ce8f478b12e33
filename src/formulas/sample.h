/* SPDX-License-Identifier: MIT
 *
 * Formulas: vectors, and noise at a point.
 */
#ifndef SCARP_FORMULAS_SAMPLE_H
#define SCARP_FORMULAS_SAMPLE_H

#include "c.h"

static inline vec3 add3(vec3 a, vec3 b)
{
    return vec3_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec3 sub3(vec3 a, vec3 b)
{
    return vec3_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec3 mul3(float a, vec3 b)
{
    return vec3_of(a * b.x, a * b.y, a * b.z);
}

/* Noise at a point. diagonal: the derivatives xx, yy, zz; mixed: xy, xz, yz. In 2D outputs along z
   mean nothing. */
struct sample {
    float value;
    vec3 gradient;
    vec3 diagonal;
    vec3 mixed;
};

static inline struct sample sample_of(float value, vec3 gradient, vec3 diagonal, vec3 mixed)
{
    const struct sample s = {value, gradient, diagonal, mixed};
    return s;
}

static inline struct sample constant(float value)
{
    const vec3 none = {0.0f, 0.0f, 0.0f};
    return sample_of(value, none, none, none);
}

static inline struct sample sum_of(struct sample a, struct sample b)
{
    return sample_of(a.value + b.value, add3(a.gradient, b.gradient), add3(a.diagonal, b.diagonal),
                     add3(a.mixed, b.mixed));
}

static inline struct sample difference_of(struct sample a, struct sample b)
{
    return sample_of(a.value - b.value, sub3(a.gradient, b.gradient), sub3(a.diagonal, b.diagonal),
                     sub3(a.mixed, b.mixed));
}

#endif
