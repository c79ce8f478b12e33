/* SPDX-License-Identifier: MIT
 *
 * What occurs in a recipe, and what a sample costs.
 */
#ifndef SCARP_CLI_RECIPE_MEASURE_H
#define SCARP_CLI_RECIPE_MEASURE_H

#include "ground/ground.h"

/* Of many places */
struct measure {
    float lowest, middle, highest;
};

/* Looks at the statement of that number, in a square of 64 cells of that size; in space it is one
   cell high. */
void measure_values(const struct ground *ground, int32_t which, double cell,
                    struct measure *measure);

/* Nanoseconds per sample of the first output on a grid, in one thread; 0 for what cannot be
   sampled. */
double measure_cost(const struct ground *ground, bool has_gradient);

#endif
