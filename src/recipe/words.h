/* SPDX-License-Identifier: MIT
 *
 * The functions of recipes, their arguments and their defaults: one list for the compiler and for
 * editors.
 */
#ifndef SCARP_RECIPE_WORDS_H
#define SCARP_RECIPE_WORDS_H

#include "recipe.h"

/* In the order of the list. */
enum recipe_function {
    FUNCTION_NOISE,
    FUNCTION_CELL,
    FUNCTION_FLAT,
    FUNCTION_MIN,
    FUNCTION_MAX,
    FUNCTION_ABS,
    FUNCTION_SMOOTH_ABS,
    FUNCTION_CLAMP,
    FUNCTION_SMOOTHSTEP,
    FUNCTION_TERRACE,
    FUNCTION_MIX,
    FUNCTION_CURVE,
    FUNCTION_BLEND,
    FUNCTION_SQRT,
    FUNCTION_SINE,
    FUNCTION_PULSE,
    FUNCTION_SLOPE,
    FUNCTION_WARP,
    FUNCTION_TURN,
    FUNCTION_MOVE,
    FUNCTION_SCALE,
    FUNCTION_STRETCH,
    FUNCTION_WIND,
    FUNCTION_AT,
    FUNCTION_GULLIES,
    FUNCTION_DISPLACEMENT,
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
