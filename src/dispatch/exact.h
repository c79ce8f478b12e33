/* SPDX-License-Identifier: MIT
 *
 * Whether a compiler kept to the operations of the source. No macro shows -ffp-contract=fast,
 * which makes one operation of a product and a sum, nor clang's of what -ffast-math is made of. So
 * numbers are computed that such options change, from memory that a compiler may not look into.
 * kernel/exact.h does so with vectors, for each set.
 */
#ifndef SCARP_EXACT_H
#define SCARP_EXACT_H

#include <math.h>

/* A square has more bits than fit, and a sum that takes the others away. */
#define EXACT_ROOT 0x1.0008p0f   /* 1 + 2^-13 */
#define EXACT_SQUARE -0x1.001p0f /* -(1 + 2^-12); the square has 2^-26 more */
#define EXACT_ROOT64 0x1.0000001p0
#define EXACT_SQUARE64 -0x1.0000002p0 /* the square has 2^-56 more */
/* 2^24 + 1 is not a float, so it is rounded to 2^24; 5 / 3 rounds to another float than 5 times
   the float 1 / 3; and -0 + 0 is +0. */
#define EXACT_LARGE 0x1p24f
#define EXACT_THIRD 0x1.aaaaaap0f

static inline int scarpi_is_exact(void)
{
    static const volatile float number[] = {EXACT_ROOT, EXACT_SQUARE, EXACT_LARGE,
                                            1.0f,       5.0f,         -0.0f};
    static const volatile double number64[] = {EXACT_ROOT64, EXACT_SQUARE64};
    const float root = number[0], square = number[1], large = number[2];
    const double root64 = number64[0], square64 = number64[1];
    const volatile float fused = root * root + square;
    const volatile double fused64 = root64 * root64 + square64;
    const volatile float reordered = (large + number[3]) - large;
    const volatile float divided = number[4] / 3.0f;
    const volatile float zero = number[5] + 0.0f;
    return fused == 0.0f && fused64 == 0.0 && reordered == 0.0f && divided == EXACT_THIRD &&
           !signbit(zero);
}

#endif
