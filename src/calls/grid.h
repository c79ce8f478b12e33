/* SPDX-License-Identifier: MIT
 *
 * The checks of grids. They run in the caller's floating-point mode.
 */
#ifndef SCARP_GRID_H
#define SCARP_GRID_H

#include "../plan/refusals.h"

/* Fills in the strides of a grid without empty axes, and checks all but its reserved members. */
struct scarp_fault scarpi_check_grid(struct scarp_grid *grid, int dimensions);

int scarpi_grid_reserved_in_use(const struct scarp_grid *grid);

#endif
