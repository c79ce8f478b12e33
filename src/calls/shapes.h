/* SPDX-License-Identifier: MIT
 *
 * The sine that every platform has.
 */
#ifndef SCARP_SHAPES_H
#define SCARP_SHAPES_H

/* sin(2 pi turns), within 2^-51, and exact at multiples of a quarter. |turns| is below 2^62. */
double scarp_sine_of_turns(double turns);

#endif
