/* SPDX-License-Identifier: MIT
 *
 * What runs a recipe: registers for a chunk of points, and where these points are.
 */
#ifndef SCARP_RECIPE_MACHINE_H
#define SCARP_RECIPE_MACHINE_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "recipe.h"
#include "skips.h"
#include "statuses.h"

/* Members of samples, from the value to dzz, in the order of struct scarp_samples */
#define RECIPE_MEMBERS 10

static inline float *recipe_member(const struct scarp_samples *samples, int i)
{
    float *array;
    memcpy(&array, (const char *)samples + (size_t)i * sizeof array, sizeof array);
    return array;
}

/* Points that go through the steps together: of arrays, or of a grid. */
struct recipe_chunk {
    size_t count;
    const void *at[3];             /* of floats or doubles; not read if there is a grid */
    const struct scarp_grid *grid; /* without gaps between rows and slices; NULL: arrays */
};

struct recipe_machine {
    const struct recipe *recipe;
    const struct recipe_schedule *schedule;
    const struct recipe_plan *plan; /* constants of noises; NULL: there are none */
    bool has_doubles;
    size_t room;   /* points of a register */
    size_t floats; /* of a register, for each point */
    float *registers;
    void *position[3];                /* arrays of `room` doubles */
    uint8_t order_of[RECIPE_NODES];   /* of the derivatives that are computed */
    uint8_t state[RECIPE_GUARDS + 1]; /* of guards: see skips.h */
    const struct recipe_chunk *chunk;
    struct scarp_noise noise[5];     /* of the step that runs, with its warps */
    const struct scarp_samples *out; /* the caller's arrays */
    const int16_t *root;             /* their nodes */
    unsigned directs;                /* a bit for each output that is computed there, */
    size_t direct_from;              /* from this element on */
};

/* machine.c: where a node is, the members that are computed of it; others are NULL. */
void scarpi_recipe_find_samples(const struct recipe_machine *m, int node, struct scarp_samples *to);

/* The same as a result, which compilers copy: that takes some 10 ns if it happens at once. */
static inline struct scarp_samples scarpi_recipe_samples(const struct recipe_machine *m, int node)
{
    struct scarp_samples s;
    scarpi_recipe_find_samples(m, node, &s);
    return s;
}

/* positions.c: nodes that have a place. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_placed(struct recipe_machine *m, int node);

/* operations.c: nodes that combine others. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_operation(struct recipe_machine *m, int node);

/* operations.c: whether a guard's nodes are left out. */
bool scarpi_recipe_is_left_out(struct recipe_machine *m, int guard);

#endif
