/* SPDX-License-Identifier: MIT
 *
 * From a text to statements and expressions, and what is wrong with it.
 */
#ifndef SCARP_RECIPE_PARSE_H
#define SCARP_RECIPE_PARSE_H

#include "text.h"

/* Reads the text in recipe->text. Statements with an error have the expression -1. */
void scarpi_recipe_read(struct recipe *recipe, struct recipe_errors *errors);

#endif
