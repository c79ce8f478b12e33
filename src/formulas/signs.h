/* SPDX-License-Identifier: MIT
 *
 * Formulas: signs of floats.
 */
#ifndef SCARP_FORMULAS_SIGNS_H
#define SCARP_FORMULAS_SIGNS_H

#include "c.h"

#define SIGN 0x80000000u

/* Whether the sign bit is set. */
static inline bool is_negative(float a)
{
    return bits_of(a) >= SIGN;
}

/* -a where `bit` is 1, a where it is 0. */
static inline float with_bit(float a, uint bit)
{
    return float_of_bits(bits_of(a) ^ (bit << 31u));
}

/* sign(n) a, and 0 where n is 0. */
static inline float with_sign(float a, float n)
{
    return n == 0.0f ? 0.0f : with_bit(a, bits_of(n) >> 31u);
}

#endif
