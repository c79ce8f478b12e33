/* SPDX-License-Identifier: MIT
 *
 * From a text to statements and expressions, and what is wrong with it.
 */
#ifndef SCARP_RECIPE_PARSE_H
#define SCARP_RECIPE_PARSE_H

#include <stddef.h>

#include "recipe.h"

/* Where errors go: the first `capacity` of the text to `list`. */
struct recipe_errors {
    struct scarp_recipe_error *list;
    size_t capacity, found;
    int is_size;    /* a limit of recipes was passed */
    double nearest; /* for the next error: a number that would do, or 0 */
};

/* Adds an error at bytes of the text. */
void scarpi_recipe_fail(struct recipe_errors *errors, const struct recipe *recipe,
                        struct recipe_span span, const char *text, const char *member);

/* Reads the text in recipe->text. Statements with an error have the expression -1. */
void scarpi_recipe_read(struct recipe *recipe, struct recipe_errors *errors);

/* Reads the number that a text begins with: digits, a point, an exponent; no sign. Returns how many
   bytes it has; 0 if there is none, if it has more than 38 digits, or if it is not 0 and outside
   [10^-60, 10^60]. */
size_t scarpi_read_number(const char *text, size_t length, double *value);

/* Whether bytes of the text are a word. */
int scarpi_recipe_is(const struct recipe *recipe, struct recipe_span span, const char *word);

/* The statement of a name among the first `count`, or -1. */
int scarpi_recipe_find(const struct recipe *recipe, struct recipe_span name, int count);

#endif
