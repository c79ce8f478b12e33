/* SPDX-License-Identifier: MIT
 *
 * From nodes to steps: which, in which order, in which registers, and which may be left out.
 */
#ifndef SCARP_RECIPE_SCHEDULE_H
#define SCARP_RECIPE_SCHEDULE_H

#include "recipe.h"

/* Plans how to compute some nodes. */
void scarpi_recipe_schedule(const struct recipe *recipe, const int16_t *roots, int count,
                            struct recipe_schedule *schedule);

#endif
