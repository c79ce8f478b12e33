/* SPDX-License-Identifier: MIT
 *
 * From expressions to nodes. An expression is compiled once for each place at which it is needed:
 * warp(f, n), turn(f, 30) and their like compile f at another place.
 */
#ifndef SCARP_RECIPE_COMPILE_H
#define SCARP_RECIPE_COMPILE_H

#include "text.h"
#include "words.h"

/* What an expression is at a place. */
struct recipe_value {
    int kind; /* SCARP_RECIPE_BAD, _NUMBER or _FIELD */
    int node;
    double number;
};

struct recipe_compiler {
    struct recipe *recipe;
    struct recipe_errors *errors; /* NULL: nothing is told */
    int depth;
    int16_t known[RECIPE_STATEMENTS][RECIPE_PLACES]; /* 1 + the node; 0: not known, -1: bad */
    int16_t noise[RECIPE_STATEMENTS];                /* 3 + what noise_of gives; 0: not known */
};

/* Compiles all statements, and the schedule of the outputs if there is no error. */
void scarpi_recipe_compile(struct recipe *recipe, struct recipe_errors *errors);

/* compile.c */
struct recipe_value scarpi_recipe_bad(struct recipe_compiler *c, int expression, const char *text,
                                      const char *member);
/* A limit of recipes was passed. */
struct recipe_value scarpi_recipe_full(struct recipe_compiler *c, int expression);
struct recipe_value scarpi_recipe_number(double number);
struct recipe_value scarpi_recipe_value(struct recipe_compiler *c, int expression, int place);
/* A node of a value, which may be a number; -1 if it is bad. */
int scarpi_recipe_field(struct recipe_compiler *c, int expression, struct recipe_value value);
/* The value of an expression that has to be a number. Returns 0 if it is none. */
int scarpi_recipe_take_number(struct recipe_compiler *c, int expression, double *number);
struct recipe_value scarpi_recipe_node(struct recipe_compiler *c, int expression,
                                       struct recipe_node node);
/* A node that reads up to three others, without anything else. */
struct recipe_node scarpi_recipe_operation(int operation, int a, int b);
struct recipe_value scarpi_recipe_affine(struct recipe_compiler *c, int expression, int a,
                                         double scale, double offset);

/* functions.c: the value of a call. Arguments that are not there are -1. */
bool scarpi_recipe_bind(struct recipe_compiler *c, int call, int function,
                        int16_t argument[RECIPE_ARGUMENTS], int *knots);
struct recipe_value scarpi_recipe_call(struct recipe_compiler *c, int call, int place);

/* noises.c: the noise that an expression is; -1: it is none; -2: it is bad. */
int scarpi_recipe_noise_of(struct recipe_compiler *c, int expression);
struct recipe_value scarpi_recipe_sampled(struct recipe_compiler *c, int expression, int noise,
                                          int place);
/* The components of the vector noise that a noise makes, at a place. Returns 0 on an error. */
int scarpi_recipe_components(struct recipe_compiler *c, int expression, int noise, int place,
                             int16_t component[3]);
struct recipe_value scarpi_recipe_cell(struct recipe_compiler *c, int call, int noise, int what,
                                       int place);
struct recipe_value scarpi_recipe_gullies(struct recipe_compiler *c, int call, int place,
                                          const int16_t argument[RECIPE_ARGUMENTS],
                                          int is_displacement);
uint64_t scarpi_recipe_seed_of(uint64_t world, double number);

/* places.c: the place of an expression inside a call that transforms; -1 on an error. */
int scarpi_recipe_place_inside(struct recipe_compiler *c, int call, int function, int place,
                               const int16_t argument[RECIPE_ARGUMENTS]);
/* The same place, with displacements as fields. */
int scarpi_recipe_spelled_out(struct recipe_compiler *c, int expression, int place);
/* A place whose derivatives are by its own coordinates: the same one where these are the points'.
 */
int scarpi_recipe_framed(struct recipe_compiler *c, int expression, int place);
/* What was compiled at the framed place of a place, with derivatives as others have them there. */
struct recipe_value scarpi_recipe_pulled(struct recipe_compiler *c, int expression, int place,
                                         struct recipe_value value);

#endif
