/* SPDX-License-Identifier: MIT
 *
 * Adds nodes, places, noises and gullies: equal ones stand there once. What a node promises follows
 * from those that it reads.
 */
#include "graph.h"

#include <string.h>

#include "../plan/traits.h"
#include "interval.h"

/* The axes on which coordinate i of a place depends. */
static int axes_of_coordinate(const struct recipe *recipe, int place, int i)
{
    const struct recipe_place *const p = &recipe->place[place];
    int axes = p->rest[i] >= 0 ? recipe->node[p->rest[i]].axes : 0;
    for (int j = 0; j < 3; j++) {
        if (p->m[i][j] != 0.0) {
            axes |= p->frame < 0 ? 1 << j : axes_of_coordinate(recipe, p->frame, j);
        }
    }
    return axes;
}

static int order_of_noise(const struct recipe *recipe, int index)
{
    int order = 2;
    for (; index >= 0; index = recipe->noise[index].warp) {
        struct scarp_noise noise = {0};
        memcpy(&noise, recipe->noise[index].noise, sizeof recipe->noise[index].noise);
        if (fractal_has(noise.fractal, FRACTAL_SLOPES)) {
            order = 1;
        }
    }
    return order;
}

static int needs_slopes(const struct recipe_node *n)
{
    return (scarpi_recipe_traits(n->operation) & NEEDS_SLOPES) != 0;
}

/* What the operation says of the order of its derivatives. */
static int order_of_operation(const struct recipe *recipe, const struct recipe_node *n)
{
    switch (n->operation) {
    case OP_NOISE:
    case OP_VECTOR: return order_of_noise(recipe, n->index);
    case OP_CELL: return n->detail == 0 ? 2 : 1;
    default: break;
    }
    return needs_slopes(n) ? recipe->node[n->in[0]].order - 1 : 2;
}

static void fill_in(const struct recipe *recipe, struct recipe_node *n)
{
    int order = order_of_operation(recipe, n), axes = 0, dimensions = recipe->dimensions;
    for (int i = 0; i < 3; i++) {
        if (n->in[i] >= 0) {
            const struct recipe_node *const in = &recipe->node[n->in[i]];
            const int most = needs_slopes(n) ? 2 : in->order;
            order = most < order ? most : order;
            axes |= in->axes;
            dimensions = in->dimensions < dimensions ? in->dimensions : dimensions;
        }
    }
    if (n->place >= 0) {
        const struct recipe_place *const p = &recipe->place[n->place];
        dimensions = scarpi_recipe_frame_dimensions(recipe, p->frame);
        for (int i = 0; i < p->dimensions; i++) {
            if (has_slopes_of(n, i)) {
                axes |= axes_of_coordinate(recipe, n->place, i);
                const int rest = p->rest[i];
                order = rest >= 0 && recipe->node[rest].order < order ? recipe->node[rest].order
                                                                      : order;
            }
        }
    }
    for (int p = n->place; p >= 0;
         p = recipe->place[p].frame) { /* all that is read, needed or not */
        for (int i = 0; i < recipe->place[p].dimensions; i++) {
            const int rest = recipe->place[p].rest[i];
            axes |= rest >= 0 ? recipe->node[rest].axes : 0;
        }
    }
    n->order = (uint8_t)order;
    n->axes = (uint8_t)axes;
    n->dimensions = (uint8_t)dimensions;
    n->interval = scarpi_recipe_interval_of(recipe, n, NULL, NULL);
}

static int is_same(const struct recipe_node *a, const struct recipe_node *b)
{
    return a->operation == b->operation && a->detail == b->detail && a->place == b->place &&
           a->index == b->index && a->knots == b->knots &&
           memcmp(a->in, b->in, sizeof a->in) == 0 && memcmp(a->k, b->k, sizeof a->k) == 0;
}

int scarpi_recipe_add_node(struct recipe *recipe, struct recipe_node node)
{
    for (int i = 0; i < recipe->nodes; i++) {
        if (is_same(&recipe->node[i], &node)) {
            return i;
        }
    }
    if (recipe->nodes == RECIPE_NODES) {
        return -1;
    }
    fill_in(recipe, &node);
    recipe->node[recipe->nodes] = node;
    return recipe->nodes++;
}

int scarpi_recipe_add_place(struct recipe *recipe, struct recipe_place place)
{
    for (int i = 0; i < recipe->places; i++) {
        const struct recipe_place *const p = &recipe->place[i];
        if (memcmp(p->m, place.m, sizeof p->m) == 0 && memcmp(p->t, place.t, sizeof p->t) == 0 &&
            memcmp(p->rest, place.rest, sizeof p->rest) == 0 && p->warp == place.warp &&
            p->before == place.before && p->frame == place.frame &&
            p->dimensions == place.dimensions) {
            return i;
        }
    }
    if (recipe->places == RECIPE_PLACES) {
        return -1;
    }
    recipe->place[recipe->places] = place;
    return recipe->places++;
}

int scarpi_recipe_add_noise(struct recipe *recipe, const struct scarp_noise *noise, int warp)
{
    struct recipe_noise made = {.warp = (int16_t)warp};
    memcpy(made.noise, noise, sizeof made.noise);
    for (int i = 0; i < recipe->noises; i++) {
        if (recipe->noise[i].warp == made.warp &&
            memcmp(recipe->noise[i].noise, made.noise, sizeof made.noise) == 0) {
            return i;
        }
    }
    if (recipe->noises == RECIPE_NOISES) {
        return -1;
    }
    recipe->noise[recipe->noises] = made;
    return recipe->noises++;
}

int scarpi_recipe_add_gullies(struct recipe *recipe, const struct scarp_gullies *gullies)
{
    for (int i = 0; i < recipe->gullies; i++) {
        if (memcmp(&recipe->gully[i], gullies, sizeof *gullies) == 0) {
            return i;
        }
    }
    if (recipe->gullies == RECIPE_GULLIES) {
        return -1;
    }
    recipe->gully[recipe->gullies] = *gullies;
    return recipe->gullies++;
}

int scarpi_recipe_add_knots(struct recipe *recipe, int count, float (*knots)[2])
{
    for (int i = 0; i + count <= recipe->knots; i++) {
        if (memcmp(recipe->knot[i], knots, (size_t)count * sizeof *knots) == 0) {
            return i;
        }
    }
    if (recipe->knots + count > RECIPE_KNOTS) {
        return -1;
    }
    memcpy(recipe->knot[recipe->knots], knots, (size_t)count * sizeof *knots);
    recipe->knots = (int16_t)(recipe->knots + count);
    return recipe->knots - count;
}
