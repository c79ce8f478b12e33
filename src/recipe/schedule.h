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

/* The next guard around a guard, or itself, that a mask decides: points have no bounds; 0: none. */
int scarpi_recipe_mask_guard(const struct recipe_schedule *schedule, int guard);

#endif
