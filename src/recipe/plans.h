/* SPDX-License-Identifier: MIT
 *
 * The plan of a recipe: the constants of its noises, in memory of the caller. Each is a plan of a
 * noise (plan/kept.h) that the noise brings to the calls of the library, which compare it with the
 * noise that they are for. So a plan of another recipe, or of this one before it was changed, does
 * no harm.
 */
#ifndef SCARP_RECIPE_PLANS_H
#define SCARP_RECIPE_PLANS_H

#include <stddef.h>

#include "recipe.h"

struct recipe_plan {
    uint64_t mark;
    uint32_t slots;
    uint32_t at[]; /* bytes from the start to the constants of each; 0: there are none */
};

/* The memory that the plan of a recipe without errors takes. */
size_t scarpi_recipe_plan_bytes(const struct recipe *recipe);

/* Makes it there, in memory that is large enough. */
enum scarp_status scarpi_recipe_plan_write(const struct recipe *recipe, void *memory);

/* What the caller gives as a plan, or NULL if it is none. */
const struct recipe_plan *scarpi_recipe_plan_of(const void *plan);

/* Gives a noise, and its warps, the plans that there are for number `index` of the recipe. `plan`
   may be NULL. */
void scarpi_recipe_bring_plans(const struct recipe_plan *plan, const struct recipe *recipe,
                               int index, int dimensions, int is_vector, struct scarp_noise *noise);

#endif
