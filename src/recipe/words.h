/* SPDX-License-Identifier: MIT
 *
 * The functions of recipes, their arguments and their defaults, for the compiler and for editors:
 * those of plan/functions.def.
 */
#ifndef SCARP_RECIPE_WORDS_H
#define SCARP_RECIPE_WORDS_H

#include "recipe.h"

/* In the order of the list. */
#define FUNCTION(NAME, ...) FUNCTION_##NAME,
#define WORD(NAME, ...) FUNCTION_##NAME,
enum recipe_function {
#include "../plan/functions.def"
    FUNCTION_COUNT
};

enum { RECIPE_ARGUMENTS = 24 }; /* of a function */

/* What the list has; NULL past its end. */
const struct scarp_recipe_function *scarpi_recipe_function_number(int function);

/* The function of a name, or -1. */
int scarpi_recipe_function_of(const struct recipe *recipe, struct recipe_span name);

/* The word of an argument that a name is, counted from 0, or -1. Words of the library have dashes
   where recipes have underscores. */
int scarpi_recipe_word_of(const struct recipe *recipe, struct recipe_span name,
                          const struct scarp_recipe_argument *argument);

#endif
