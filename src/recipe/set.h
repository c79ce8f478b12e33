/* SPDX-License-Identifier: MIT
 *
 * Sets of nodes.
 */
#ifndef SCARP_RECIPE_SET_H
#define SCARP_RECIPE_SET_H

#include "recipe.h"

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

#endif
