/* SPDX-License-Identifier: MIT
 *
 * The suprema of the bases, by which octaves are divided.
 */
#ifndef SCARP_SUPREMA_H
#define SCARP_SUPREMA_H

#include "call.h"

/* Rows of the triangles of 2D simplex noise per unit: 2 / sqrt(3). */
#define SCARP_TRIANGLE_ROWS 1.1547005383792515

/* How far features stray, in units of 2^-32 cells. */
float scarpi_stray(const struct scarp_noise *noise);

/* The supremum of |basis - middle|, as the kernels evaluate it, of a valid noise without a phase.
 */
double scarpi_supremum(const struct scarp_noise *noise, int dimensions);

/* What is subtracted from the basis: half of the supremum of distances, and 0 for others. */
double scarpi_middle(const struct scarp_noise *noise, int dimensions);

#endif
