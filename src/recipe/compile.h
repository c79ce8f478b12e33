/* SPDX-License-Identifier: MIT
 *
 * From expressions to nodes. An expression is compiled once for each place at which it is needed:
 * warp(f, n), turn(f, 30) and their like compile f at another place.
 *
 * Only values.c and functions.c call each other: the value of a call needs its arguments, which are
 * expressions. Files below them get nodes, noises and numbers, and compile nothing.
 */
#ifndef SCARP_RECIPE_COMPILE_H
#define SCARP_RECIPE_COMPILE_H

#include "text.h"
#include "words.h"

/* In place of the index of a node, a noise or a place. */
enum {
    RECIPE_NONE = -1,
    RECIPE_BAD = -2,    /* there was an error, which is reported */
    RECIPE_UNKNOWN = -3 /* not compiled yet */
};

/* What an expression is at a place. */
struct recipe_value {
    int kind; /* SCARP_RECIPE_BAD, _NUMBER or _FIELD */
    int node; /* of a field; RECIPE_NONE of a number, RECIPE_BAD after an error */
    double number;
};

/* A coordinate that is written as an expression: m x + t, where x are the coordinates of the frame,
   plus a node. The linear part stays in double. */
struct recipe_linear {
    double m[3], t;
    int rest; /* a node, RECIPE_NONE or RECIPE_BAD */
};

struct recipe_compiler {
    struct recipe *recipe;
    struct recipe_errors *errors; /* NULL: none are reported */
    int depth;
    int root; /* the place at which statements are compiled */
    /* By statement, and place: the node, RECIPE_BAD or RECIPE_UNKNOWN, which numbers are, too */
    int16_t node[RECIPE_STATEMENTS][RECIPE_PLACES];
    int16_t noise[RECIPE_STATEMENTS]; /* or RECIPE_NONE, RECIPE_BAD, RECIPE_UNKNOWN */
};

/* Arguments of noise(), in their order; words come first. */
enum {
    NOISE_BASIS,
    NOISE_FRACTAL,
    NOISE_FADE,
    NOISE_ROTATE,
    NOISE_SIZE,
    NOISE_FREQUENCY,
    NOISE_SEED,
    NOISE_OCTAVES,
    NOISE_OF_OCTAVES,
    NOISE_PHASE = 13,
    NOISE_PERIOD = 16,
    NOISE_PERIOD_X,
    NOISE_END = NOISE_PERIOD_X + 3
};

/* Arguments of gullies() and displacement(). */
enum {
    GULLIES_BASE,
    GULLIES_SIZE,
    GULLIES_FREQUENCY,
    GULLIES_SEED,
    GULLIES_AMPLITUDE,
    GULLIES_ROTATE = 20
};

/* compile.c: all statements, and the schedule of the outputs if there is no error. */
void scarpi_recipe_compile(struct recipe *recipe, struct recipe_errors *errors);

/* nodes.c: errors at expressions. Functions below that return a bool return false after one. */
struct recipe_value scarpi_recipe_bad(struct recipe_compiler *c, int expression, const char *text,
                                      const char *member);
/* A limit of recipes was passed. */
struct recipe_value scarpi_recipe_full(struct recipe_compiler *c, int expression);
/* The value of an expression after an error that is reported already. */
struct recipe_value scarpi_recipe_bad_already(void);

/* nodes.c: values and nodes. */
struct recipe_value scarpi_recipe_number(double number);
struct recipe_value scarpi_recipe_node(struct recipe_compiler *c, int expression,
                                       struct recipe_node node);
/* Adds a place; RECIPE_BAD if there is no room. */
int scarpi_recipe_place(struct recipe_compiler *c, int expression,
                        const struct recipe_place *place);
/* A node of a value, which may be a number; RECIPE_BAD if it is bad. */
int scarpi_recipe_field(struct recipe_compiler *c, int expression, struct recipe_value value);
/* A node that reads up to two others, without anything else. */
struct recipe_node scarpi_recipe_operation(int operation, int a, int b);
/* scale a + offset */
struct recipe_value scarpi_recipe_affine(struct recipe_compiler *c, int expression, int a,
                                         double scale, double offset);
/* The sum of two nodes, each of which may be RECIPE_NONE or RECIPE_BAD. */
int scarpi_recipe_sum(struct recipe_compiler *c, int expression, int a, int b);
/* The sum, difference, product or quotient of two values; `type` is that of the expression. */
struct recipe_value scarpi_recipe_combined(struct recipe_compiler *c, int expression, int type,
                                           struct recipe_value a, struct recipe_value b);

/* values.c: what an expression is at a place. */
struct recipe_value scarpi_recipe_value(struct recipe_compiler *c, int expression, int place);
/* The value of an expression that has to be a number. */
bool scarpi_recipe_take_number(struct recipe_compiler *c, int expression, double *number);
/* The noise that an expression is; RECIPE_NONE: it is something else. */
int scarpi_recipe_noise_of(struct recipe_compiler *c, int expression);
/* The place of the first argument inside a call that transforms; RECIPE_BAD after an error. */
int scarpi_recipe_place_inside(struct recipe_compiler *c, int call, int function, int place,
                               const int16_t argument[RECIPE_ARGUMENTS]);

/* functions.c: the arguments of a call; those that are not given are RECIPE_NONE. */
bool scarpi_recipe_bind(struct recipe_compiler *c, int call, int function,
                        int16_t argument[RECIPE_ARGUMENTS], int *knots);
/* The value of a call. */
struct recipe_value scarpi_recipe_call(struct recipe_compiler *c, int call, int place);

/* members.c: noises and gullies, from the arguments of their calls. */
/* A noise with the words of a call, and all else as it is without arguments. */
void scarpi_recipe_start_noise(const struct recipe_compiler *c,
                               const int16_t argument[RECIPE_ARGUMENTS], struct scarp_noise *noise);
void scarpi_recipe_start_gullies(const struct recipe_compiler *c,
                                 const int16_t argument[RECIPE_ARGUMENTS],
                                 struct scarp_gullies *gullies);
/* Sets a member to the number that an argument is. */
bool scarpi_recipe_set_noise(struct recipe_compiler *c, int expression, int argument, double number,
                             struct scarp_noise *noise);
bool scarpi_recipe_set_gullies(struct recipe_compiler *c, int expression, int argument,
                               double number, struct scarp_gullies *gullies);
/* Whether not both of two arguments, `size` and `frequency`, are given. */
bool scarpi_recipe_one_length(struct recipe_compiler *c, int size, int frequency);
/* Whether the library takes what a call describes; else the error is at the argument. */
bool scarpi_recipe_check_noise(struct recipe_compiler *c, int call,
                               const int16_t argument[RECIPE_ARGUMENTS],
                               const struct scarp_noise *noise);
bool scarpi_recipe_check_gullies(struct recipe_compiler *c, int call,
                                 const int16_t argument[RECIPE_ARGUMENTS],
                                 const struct scarp_gullies *gullies);

/* noises.c: nodes that sample noises and gullies at a place. */
struct recipe_value scarpi_recipe_sampled(struct recipe_compiler *c, int expression, int noise,
                                          int place);
struct recipe_value scarpi_recipe_cell(struct recipe_compiler *c, int call, int noise, int what,
                                       int place);
/* What gullies add to a base. */
struct recipe_value scarpi_recipe_displacement(struct recipe_compiler *c, int call, int base,
                                               int place, struct scarp_gullies *gullies);
/* The same place, with displacements as fields; RECIPE_BAD after an error. */
int scarpi_recipe_spelled_out(struct recipe_compiler *c, int expression, int place);

/* places.c: places made of others; RECIPE_BAD after an error. */
int scarpi_recipe_warped(struct recipe_compiler *c, int expression, int place, int noise);
/* The plane across an axis. */
int scarpi_recipe_flattened(struct recipe_compiler *c, int call, int place, int axis);
int scarpi_recipe_looking_at(struct recipe_compiler *c, int call, int place,
                             const struct recipe_linear *coordinate);
/* turn(), move(), scale(), stretch() and wind() with their numbers, and the axis of turn(). */
int scarpi_recipe_transformed(struct recipe_compiler *c, int call, int function, int place,
                              const double number[3], int axis);
/* A place whose derivatives are with respect to its own coordinates: the same one where these are
   the points'. */
int scarpi_recipe_framed(struct recipe_compiler *c, int expression, int place);
/* What was compiled at the framed place of a place, with derivatives as others have them there. */
struct recipe_value scarpi_recipe_pulled(struct recipe_compiler *c, int expression, int place,
                                         struct recipe_value value);

#endif
