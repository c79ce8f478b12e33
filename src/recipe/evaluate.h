/* SPDX-License-Identifier: MIT
 *
 * Runs the steps of a recipe over points or a grid, chunk by chunk.
 */
#ifndef SCARP_RECIPE_EVALUATE_H
#define SCARP_RECIPE_EVALUATE_H

#include <stddef.h>

#include "machine.h"

/* A call, once its arguments are checked. */
struct recipe_evaluation {
    const struct recipe *recipe;
    const struct recipe_schedule *schedule;
    int outputs;
    int16_t root[RECIPE_OUTPUTS]; /* nodes */
    const struct scarp_samples *out;
    int has_doubles;
    size_t count;
    const void *at[3];
    const struct scarp_grid *grid; /* with strides; NULL: points */
    void *memory;
    size_t size;
    const void *plan; /* that the caller gives; NULL: none */
};

/* Checks what is asked for, and the scratch memory, and evaluates. */
enum scarp_status scarpi_recipe_evaluate(const struct recipe_evaluation *call);

struct recipe_machine;

/* The outputs that can be computed where the caller wants them, a bit for each; the others are
   copied there. */
unsigned scarpi_recipe_find_directs(const struct recipe_machine *m,
                                    const struct recipe_evaluation *call);

/* The order of what a call asks for; -1: something that does not exist. */
int scarpi_recipe_order_of(const struct scarp_samples *out, int dimensions);

/* Raises the orders of what nodes read to what these need of it. */
void scarpi_recipe_raise_orders(const struct recipe *recipe, const struct recipe_schedule *schedule,
                                uint8_t order_of[RECIPE_NODES]);

/* Bytes that registers for so many points take, with derivatives up to an order; for 0 points, those
   that are best for large calls. */
size_t scarpi_recipe_bytes(const struct recipe *recipe, const struct recipe_schedule *schedule,
                           int order, size_t points);

/*
 * grids.c
 */

/* Finds the outputs of a call that are one noise. Returns whether all are. */
bool scarpi_recipe_find_wholes(struct recipe_machine *m, const struct recipe_evaluation *call);

/* Computes these outputs. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_wholes(struct recipe_machine *m,
                                                       const struct recipe_evaluation *call);

/* Computes the other outputs. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_grid(struct recipe_machine *m,
                                                     const struct recipe_evaluation *call);

/* Whether all coordinates are finite. Others may be NaN along axes on which nothing depends. */
bool scarpi_recipe_is_finite(const struct scarp_grid *grid, int dimensions);

/* Whether rows of the grid of a call lie one behind the other: slices may have gaps. */
bool scarpi_recipe_has_no_gaps(const struct recipe_evaluation *call);

#endif
