/* SPDX-License-Identifier: MIT
 *
 * Nodes, places, noises and gullies of a recipe. graph.c adds them, equal ones once, and what is
 * added to a full list is -1; queries.c says what they are.
 */
#ifndef SCARP_RECIPE_GRAPH_H
#define SCARP_RECIPE_GRAPH_H

#include "recipe.h"

/* What operations are like, added. */
enum {
    NEEDS_SLOPES = 1, /* derivatives are of one order less than those of in[0] */
    CAN_BE_LEVEL = 2, /* a mask that is made by it can be 0 or 1 everywhere, without slopes */
    IS_C0 = 4,        /* it has creases, where what it reads has none */
    IS_C1 = 8         /* its Hessian jumps, where that of what it reads does not */
};
int scarpi_recipe_traits(int operation);

/* Whether derivatives of a node depend on those of a rest of its place. */
static inline int has_slopes_of(const struct recipe_node *n, int axis)
{
    return n->operation != OP_COORDINATE || n->detail == axis;
}

/* Adds a node: its operation, what it reads, and its numbers. The rest follows from these. */
int scarpi_recipe_add_node(struct recipe *recipe, struct recipe_node node);

/* Adds a place. Its dimensions are there; m and t are 0 beyond them. */
int scarpi_recipe_add_place(struct recipe *recipe, struct recipe_place place);

/* Adds a noise with a warp, or -1. */
int scarpi_recipe_add_noise(struct recipe *recipe, const struct scarp_noise *noise, int warp);

int scarpi_recipe_add_gullies(struct recipe *recipe, const struct scarp_gullies *gullies);

/* Adds knots of a curve: the index of the first. */
int scarpi_recipe_add_knots(struct recipe *recipe, int count, float (*knots)[2]);

/* A noise with its warps, which are in noise[1] and on. */
void scarpi_recipe_spell_noise(const struct recipe *recipe, int index, struct scarp_noise noise[5]);

/* All nodes that a node reads: operands, and coordinates of its place. The first `slopes` of them
   are those whose derivatives it needs for its own; of others it reads values. */
enum { RECIPE_READS = 3 + 3 * (RECIPE_FRAMES + 1) };
int scarpi_recipe_reads(const struct recipe *recipe, int node, int16_t reads[RECIPE_READS],
                        int *slopes);

/* The node of an output. */
int scarpi_recipe_output_node(const struct recipe *recipe, int output);

/* Whether derivatives with respect to the coordinates of a place are those with respect to its
   frame's. */
int scarpi_recipe_is_frame(const struct recipe *recipe, int place);

/* The dimensions of a frame, which is a place, or -1 for the points. */
int scarpi_recipe_frame_dimensions(const struct recipe *recipe, int frame);

/* The matrix of a place by the coordinates of the points, without what fields displace. */
void scarpi_recipe_matrix(const struct recipe *recipe, int place, double matrix[3][3]);

#endif
