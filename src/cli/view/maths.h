/* SPDX-License-Identifier: MIT
 *
 * Small functions of numbers and colours that are the same on every machine: nothing but + - * /,
 * roots and comparisons.
 */
#ifndef SCARP_CLI_VIEW_MATHS_H
#define SCARP_CLI_VIEW_MATHS_H

#include <math.h>

#include "look/palette.h" /* struct colour: here, linear light */

struct vector {
    float x, y, z;
};

/* `lowest` of what is no number */
static inline float clamp(float value, float lowest, float highest)
{
    return value > lowest ? value < highest ? value : highest : lowest;
}

/* 0 at `from`, 1 at `to`, smooth between them; `from` may be the larger one. */
static inline float ramp(float from, float to, float value)
{
    const float t = clamp((value - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

static inline float mix(float a, float b, float t)
{
    return a + (b - a) * t;
}

/* e^x within 0.2 % for x in [-20, 20], outside of which x is taken into that interval: Taylor's
   series of x / 64, squared six times */
static inline float exponential(float x)
{
    const float part = clamp(x, -20.0f, 20.0f) * 0.015625f;
    float e = 1.0f + part * (1.0f + part * (0.5f + part * (0.16666667f + part * 0.041666668f)));
    for (int i = 0; i < 6; i++) {
        e *= e;
    }
    return e;
}

static inline float dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vector scaled(struct vector a, float factor)
{
    return (struct vector){a.x * factor, a.y * factor, a.z * factor};
}

static inline struct vector unit(struct vector a)
{
    return scaled(a, 1.0f / sqrtf(dot(a, a)));
}

static inline struct colour colour_mix(struct colour a, struct colour b, float t)
{
    return (struct colour){mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)};
}

static inline struct colour colour_scaled(struct colour a, float factor)
{
    return (struct colour){a.r * factor, a.g * factor, a.b * factor};
}

static inline struct colour colour_product(struct colour a, struct colour b)
{
    return (struct colour){a.r * b.r, a.g * b.g, a.b * b.b};
}

static inline struct colour colour_sum(struct colour a, struct colour b)
{
    return (struct colour){a.r + b.r, a.g + b.g, a.b + b.b};
}

#endif
