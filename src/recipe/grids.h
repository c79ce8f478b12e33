/* SPDX-License-Identifier: MIT
 *
 * Runs the steps of a recipe over a grid.
 */
#ifndef SCARP_RECIPE_GRIDS_H
#define SCARP_RECIPE_GRIDS_H

#include "evaluate.h"
#include "machine.h"

/* Finds the outputs of a call that are one noise. Returns whether all are. */
bool scarpi_recipe_find_wholes(struct recipe_machine *m, const struct recipe_evaluation *call);

/* Computes these outputs. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_wholes(struct recipe_machine *m,
                                                       const struct recipe_evaluation *call);

/* Computes the other outputs. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_grid(struct recipe_machine *m,
                                                     const struct recipe_evaluation *call);

/* Whether all coordinates are finite. Others may be NaN along axes on which nothing depends. */
bool scarpi_recipe_is_finite(const struct scarp_grid *grid, int dimensions);

/* Whether rows of the grid of a call lie one behind the other: slices may have gaps. */
bool scarpi_recipe_has_no_gaps(const struct recipe_evaluation *call);

#endif
