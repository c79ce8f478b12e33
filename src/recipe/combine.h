/* SPDX-License-Identifier: MIT
 *
 * The calls of functions that combine fields, of any samples.
 */
#ifndef SCARP_RECIPE_COMBINE_H
#define SCARP_RECIPE_COMBINE_H

#include <stddef.h>

#include "recipe.h"
#include "statuses.h"

/* Calls the function of a node, which is OP_ADD or one behind it. `in` has as many samples as the
   function takes. */
KEEP_STATUS enum scarp_status scarpi_recipe_combine(const struct recipe *recipe,
                                                    const struct recipe_node *node, size_t count,
                                                    const struct scarp_samples in[3],
                                                    const struct scarp_samples *out);

/* Whether the function takes the numbers of a node. */
KEEP_STATUS enum scarp_status scarpi_recipe_try_numbers(const struct recipe_node *node);

#endif
