/* SPDX-License-Identifier: MIT
 *
 * Operands that cannot matter, since bounds say so; and sets of nodes.
 */
#ifndef SCARP_RECIPE_SKIPS_H
#define SCARP_RECIPE_SKIPS_H

#include <stdbool.h>

#include "recipe.h"

struct recipe_machine;

/* Sets of nodes */
struct node_set {
    uint64_t word[RECIPE_NODES / 64];
};

static inline int has(const struct node_set *set, int n)
{
    return (int)(set->word[(unsigned)n / 64] >> (unsigned)n % 64 & 1);
}

static inline void put_node(struct node_set *set, int n)
{
    set->word[(unsigned)n / 64] |= UINT64_C(1) << (unsigned)n % 64;
}

/* Whether what is left out of guards is decided, and how. Of an operand that is left out by its
   bounds: it is below, or above, all values that matter. */
enum { GUARD_UNKNOWN, GUARD_OPEN, GUARD_LEFT_OUT, GUARD_BELOW, GUARD_ABOVE };

/* How many operands an operation has that bounds may leave out. */
int scarpi_recipe_skips(int operation);

/* The nodes from whose bounds those of a node follow. Returns how many; 0: it has bounds of its
   own. */
int scarpi_recipe_bounded_by(const struct recipe *recipe, int node, int16_t by[2]);

/* Whether an operand of a gate cannot matter: GUARD_BELOW, GUARD_ABOVE or GUARD_OPEN. `kept` are the
   bounds of the other one, if there is one. */
int scarpi_recipe_side_of(const struct recipe *recipe, int gate, struct recipe_interval operand,
                          struct recipe_interval kept);

/* Finds the nodes that are finite numbers wherever coordinates are near: see is_near() there. */
void scarpi_recipe_find_safe(const struct recipe *recipe, struct node_set *safe);

/* What becomes of a guard that bounds decide, in front of its first step: a state. */
int scarpi_recipe_decide(struct recipe_machine *m, int guard);

#endif
