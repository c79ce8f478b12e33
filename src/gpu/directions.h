/* SPDX-License-Identifier: MIT
 *
 * Shaders: the directions of gradients, computed, since memory is slower; as scalar/directions.h,
 * which has tables.
 */
#ifndef SCARP_GPU_DIRECTIONS_H
#define SCARP_GPU_DIRECTIONS_H

#include "numbers.h"

/* The cosine of 11.25 degrees times 1, 3, 5, 7. */
static inline float cosine(uint i)
{
    const float first = i == 0u ? 0.980785280f : 0.831469612f;
    const float second = i == 2u ? 0.555570233f : 0.195090322f;
    return i < 2u ? first : second;
}

/* One of the 16 directions of the plane. */
static inline vec3 direction2(uint i)
{
    const uint k = (i >> 1u) & 3u;
    return vec3_of(with_bit(cosine(k), (i >> 3u) & 1u), with_bit(cosine(3u - k), i & 1u), 0.0f);
}

/* One of the 12 edges of a cube, twice as long: 0 along z, y or x. */
static inline vec3 direction3(uint i)
{
    const uint axes = i >> 2u;
    const float first = with_bit(2.0f, (i >> 1u) & 1u);
    const float second = with_bit(2.0f, i & 1u);
    return vec3_of(axes == 2u ? 0.0f : first, axes == 0u ? second : (axes == 1u ? 0.0f : first),
                   axes == 0u ? 0.0f : second);
}

/* A component of an edge after a quarter of a turn, times sqrt(3) / 2: 1, 2, -1 or -2, of which
   `axis` has two bits for each edge. */
static inline float quarter_along(uint axis, uint i)
{
    const uint bits = axis >> (2 * i);
    return with_bit((bits & 2) != 0 ? 2.0f : 1.0f, bits & 1);
}

#define QUARTERS_X 0xbe0550u
#define QUARTERS_Y 0x50be11u
#define QUARTERS_Z 0x1144beu
#define TWO_OVER_ROOT_3 1.15470054f

/* An edge after a quarter of a turn. */
static inline vec3 quarter3(uint i)
{
    return vec3_of(TWO_OVER_ROOT_3 * quarter_along(QUARTERS_X, i),
                   TWO_OVER_ROOT_3 * quarter_along(QUARTERS_Y, i),
                   TWO_OVER_ROOT_3 * quarter_along(QUARTERS_Z, i));
}

#endif
