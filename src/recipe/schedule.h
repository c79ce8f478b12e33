/* SPDX-License-Identifier: MIT
 *
 * From nodes to steps: which, in which order, in which registers, and which may be left out, which
 * guards.c finds.
 */
#ifndef SCARP_RECIPE_SCHEDULE_H
#define SCARP_RECIPE_SCHEDULE_H

#include "recipe.h"

/* Plans how to compute some nodes. With `has_parts`, grids compute what does not depend on all axes
   once along each of the others, if there is room for its copies. Without, fewer registers do. */
void scarpi_recipe_schedule(const struct recipe *recipe, const int16_t *roots, int count,
                            int has_parts, struct recipe_schedule *schedule);

/* The next guard around a guard, or itself, that a mask decides: points have no bounds; 0: none. */
int scarpi_recipe_mask_guard(const struct recipe_schedule *schedule, int guard);

#endif
