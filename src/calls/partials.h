/* SPDX-License-Identifier: MIT
 *
 * What others need of the functions that are plain C.
 */
#ifndef SCARP_PARTIALS_H
#define SCARP_PARTIALS_H

#include <stddef.h>

/* sin(2 pi turns), within 2^-51, and exact at multiples of a quarter. |turns| is below 2^62. */
double scarpi_sine_of_turns(double turns);

/* The slopes of a curve at its knots. Returns 0 if knots are out of order or too large. */
int scarpi_curve_slopes(size_t knots, const float *x, const float *value, float *slope);

#endif
