/* SPDX-License-Identifier: MIT
 *
 * The sine of an angle in degrees, the same on every machine, which the C library's is not.
 */
#ifndef SCARP_CLI_SINE_H
#define SCARP_CLI_SINE_H

/* sin(degrees), of 0 to 540, within 2^-52 of the exact one; exact for multiples of 90 */
double sine(double degrees);

#endif
