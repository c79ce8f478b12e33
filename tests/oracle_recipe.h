/* SPDX-License-Identifier: MIT
 *
 * Recipes again, in double precision: an interpreter of the text, which walks through expressions
 * at each point, with dual numbers. It takes from the library what a text is made of, which
 * scarp_recipe_part_at says, and no more: it has no graph, no places and no intervals.
 */
#ifndef SCARP_TESTS_ORACLE_RECIPE_H
#define SCARP_TESTS_ORACLE_RECIPE_H

#include "oracle.h"

/* A value with its gradient and its Hessian, by up to three coordinates. */
struct oracle_jet {
    double value, first[3], second[3][3];
};

struct oracle_recipe;

/* An interpreter of a text, which has no error; it must stay. */
struct oracle_recipe *oracle_recipe_make(const char *text, const struct scarp_recipe *recipe,
                                         uint64_t seed);
void oracle_recipe_free(struct oracle_recipe *oracle);

/* The first output at a point. */
struct oracle_jet oracle_recipe_at(const struct oracle_recipe *oracle, const double x[3]);

#endif
