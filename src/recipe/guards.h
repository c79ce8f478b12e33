/* SPDX-License-Identifier: MIT
 *
 * What is known of nodes while they are put into an order; and what may be left out of them.
 */
#ifndef SCARP_RECIPE_GUARDS_H
#define SCARP_RECIPE_GUARDS_H

#include "skips.h"

struct scheduler {
    const struct recipe *recipe;
    struct recipe_schedule *to;
    struct node_set live, done;
    struct node_set kept;           /* read by steps of other axes, or a root of fewer axes */
    struct node_set safe;           /* see skips.h */
    int is_full;                    /* there was no room for copies */
    uint8_t need[RECIPE_NODES];     /* registers */
    uint8_t position[RECIPE_NODES]; /* of the step */
    uint8_t cost[RECIPE_NODES];     /* octaves, of all that is needed */
};

/* Finds what all nodes cost. */
void scarpi_recipe_find_costs(struct scheduler *s);

/* Finds the nodes that bounds may leave out, if there is a gate that asks for it. */
void scarpi_recipe_find_safe_nodes(struct scheduler *s);

/* The operand of a node that is a mask, or -1. */
int scarpi_recipe_mask_of(const struct recipe *recipe, int n);

/* Whether bounds may leave an operand of a node out. */
int scarpi_recipe_is_bounded_gate(const struct scheduler *s, int n);

/* The nodes that come first, since they cost next to nothing and say what the bounds are that such a
   gate looks at. Returns how many. */
enum { FREE_NODES = 8 };
int scarpi_recipe_find_free(const struct scheduler *s, int gate, int16_t free[FREE_NODES]);

/* Adds what a node reads to a set, but for one operand. */
void scarpi_recipe_put_reads(const struct recipe *recipe, struct node_set *set, int n, int but);

/* Finds the guards of all steps. */
void scarpi_recipe_add_guards(struct scheduler *s, const int16_t *roots, int count);

#endif
