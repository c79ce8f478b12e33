/* SPDX-License-Identifier: MIT
 *
 * Numbers and characters held against bounds.
 */
#ifndef SCARP_CLI_BOUNDS_H
#define SCARP_CLI_BOUNDS_H

#include <stdbool.h>
#include <stddef.h>

static inline bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static inline size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* a / b, rounded up */
static inline size_t quotient_up(size_t a, size_t b)
{
    return (a + b - 1) / b;
}

/* `value`, or the bound that it is beyond */
static inline float within(float value, float lowest, float highest)
{
    return value < lowest ? lowest : value > highest ? highest : value;
}

#endif
