/* SPDX-License-Identifier: MIT
 *
 * What a field is made of, found from its node: the sizes of its cells, and whether it jumps.
 */
#ifndef SCARP_RECIPE_SUMMARY_H
#define SCARP_RECIPE_SUMMARY_H

#include "recipe.h"

struct recipe_summary {
    double cell[2]; /* the largest and the smallest cell, in units of the points; 0: no noise */
    int jumps;
};

/* Looks at a node and at all that it depends on. */
void scarpi_recipe_summary(const struct recipe *recipe, int node, struct recipe_summary *to);

#endif
