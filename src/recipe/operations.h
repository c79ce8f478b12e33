/* SPDX-License-Identifier: MIT */
#ifndef SCARP_RECIPE_OPERATIONS_H
#define SCARP_RECIPE_OPERATIONS_H

#include <stddef.h>

#include "recipe.h"

/* Values of an OP_CURVE. */
void scarp_recipe_curve(const struct recipe *recipe, const struct recipe_node *node, size_t count,
                        const float *a, float *value);

#endif
