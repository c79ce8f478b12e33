/* SPDX-License-Identifier: MIT */
#ifndef SCARP_RECIPE_OPERATIONS_H
#define SCARP_RECIPE_OPERATIONS_H

#include <stddef.h>

#include "recipe.h"
#include "statuses.h"

/* Values of an OP_CURVE. */
KEEP_STATUS enum scarp_status scarpi_recipe_curve(const struct recipe *recipe,
                                                  const struct recipe_node *node, size_t count,
                                                  const float *a, float *value);

#endif
