/* SPDX-License-Identifier: MIT
 *
 * What other files ask about the text of a recipe: words, names, and where errors are.
 */
#ifndef SCARP_RECIPE_TEXT_H
#define SCARP_RECIPE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "recipe.h"

/* Where errors go: the first `capacity` of the text to `list`. */
struct recipe_errors {
    struct scarp_recipe_error *list;
    size_t capacity, found;
    bool is_size;   /* a limit of recipes was passed */
    double nearest; /* for the next error: a number that would do, or 0 */
};

/* Adds an error at bytes of the text. The list stays in the order of the text. */
void scarpi_recipe_fail(struct recipe_errors *errors, const struct recipe *recipe,
                        struct recipe_span span, const char *text, const char *member);

/* Whether bytes of the text are a word. */
bool scarpi_recipe_is(const struct recipe *recipe, struct recipe_span span, const char *word);

/* The statement with a name among the first `count`, or -1. */
int scarpi_recipe_find(const struct recipe *recipe, struct recipe_span name, int count);

#endif
