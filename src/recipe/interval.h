/* SPDX-License-Identifier: MIT
 *
 * Interval arithmetic: what the values of nodes never leave.
 *
 * Intervals are computed in float, by the operations that compute values. These keep order,
 * rounding included, so the ends bound what floats give. Operations that do not have a little room.
 */
#ifndef SCARP_RECIPE_INTERVAL_H
#define SCARP_RECIPE_INTERVAL_H

#include "recipe.h"

/* The interval of a node, of those of the nodes that it reads: in `of`, or if that is NULL, in the
   nodes themselves. Coordinates of points are in the box, or if that is NULL, any. With `of`, noise
   has the interval that its node has. */
struct recipe_interval scarpi_recipe_interval_of(const struct recipe *recipe,
                                                 const struct recipe_node *node,
                                                 const struct recipe_interval *of,
                                                 const struct scarp_box *box);

/* That of coordinate i of a place, in double. */
void scarpi_recipe_coordinate(const struct recipe *recipe, int place, int i,
                              const struct recipe_interval *of, const struct scarp_box *box,
                              double *lowest, double *highest);

/* The interval of a node for points in a box. */
struct recipe_interval scarpi_recipe_interval_in(const struct recipe *recipe, int node,
                                                 const struct scarp_box *box);

#endif
