/* SPDX-License-Identifier: MIT
 *
 * The text of a recipe as its oracle reads it; between oracle_recipe.c and oracle_recipe_text.c.
 */
#ifndef SCARP_TESTS_ORACLE_RECIPE_TEXT_H
#define SCARP_TESTS_ORACLE_RECIPE_TEXT_H

#include "oracle_recipe.h"

#define PARTS 512
#define STATEMENTS 96

struct oracle_recipe {
    const char *text;
    uint64_t seed;
    int dimensions, parts, statements, output;
    double tile[3];
    struct scarp_recipe_part part[PARTS];
    struct scarp_recipe_entry entry[STATEMENTS];
    double (*number)(const struct oracle_recipe *o, int part); /* the value of a constant */
    struct oracle *made[PARTS]; /* of noise(...), made when it is first met */
};

int oracle_is(const struct oracle_recipe *o, const uint32_t span[2], const char *word);
/* The parts of a part, in the order of the text. */
int oracle_parts(const struct oracle_recipe *o, int parent, int child[64]);
/* The argument of a name, or that at a position; -1: not there. */
int oracle_argument(const struct oracle_recipe *o, int call, const char *name, int position);
double oracle_number_or(const struct oracle_recipe *o, int call, const char *name, int position,
                        double otherwise);
int oracle_has_word(const struct oracle_recipe *o, int call, const char *word);
struct scarp_noise oracle_noise_of(const struct oracle_recipe *o, int call);
/* The call noise(...) behind names; -1: the part is something else. */
int oracle_call_of(const struct oracle_recipe *o, int part);
struct scarp_gullies oracle_gullies_of(const struct oracle_recipe *o, int call);

#endif
