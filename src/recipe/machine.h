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

/* A part of a grid: samples from `from` on along each axis. */
struct recipe_box {
    size_t from[3], count[3];
};

struct recipe_machine {
    const struct recipe *recipe;
    const struct recipe_schedule *schedule;
    const struct recipe_plan *plan; /* constants of noises; NULL: there are none */
    bool has_doubles;
    bool is_narrow; /* pieces of grids are narrow, in registers */
    bool has_parts; /* steps run once along axes on which they do not depend */
    uint8_t axes;   /* then: those of the steps that run */
    size_t room;    /* points of a register */
    size_t floats;  /* of a register, for each point */
    float *registers;
    void *position[3];                /* arrays of `room` doubles */
    uint8_t order_of[RECIPE_NODES];   /* of the derivatives that are computed */
    uint8_t state[RECIPE_GUARDS + 1]; /* of guards: see skips.h */
    const struct recipe_chunk *chunk;
    struct scarp_noise noise[5];     /* of the step that runs, with its warps */
    const struct scarp_samples *out; /* the caller's arrays */
    const int16_t *root;             /* their nodes */
    unsigned wholes;                 /* a bit for each output that is computed already */
    unsigned directs;                /* for each that is computed in the caller's arrays, */
    size_t direct_from;              /* from this element on */
    /* Of grids, by axes: for which box the steps ran, if they did */
    struct recipe_box box[RECIPE_ALL_AXES + 1];
    bool has_box[RECIPE_ALL_AXES + 1];
    unsigned at_once; /* a bit for each set of axes whose box is all of the grid */
};

/* machine.c: where a node is for the steps that run, the members that are computed of it; others
   are NULL. */
void scarpi_recipe_find_samples(const struct recipe_machine *m, int node, struct scarp_samples *to);

/* The same as a result, which compilers copy: that takes some 10 ns if it happens at once. */
static inline struct scarp_samples scarpi_recipe_samples(const struct recipe_machine *m, int node)
{
    struct scarp_samples s;
    scarpi_recipe_find_samples(m, node, &s);
    return s;
}

/* machine.c: the samples of an output, in its arrays from an element on. */
void scarpi_recipe_find_output(const struct scarp_samples *out, size_t from,
                               struct scarp_samples *to);

/* machine.c: the members of a node in a register. */
void scarpi_recipe_find_in_register(const struct recipe_machine *m, int node, int k,
                                    struct scarp_samples *to);

/* evaluate.c: runs steps over a chunk, and stops at the first one that fails. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_steps(struct recipe_machine *m,
                                                      const struct recipe_chunk *chunk, int from,
                                                      int to);

/* coordinates.c: the coordinates of a place, in arrays of the machine. */
void scarpi_recipe_find_positions(const struct recipe_machine *m, int place);

/* coordinates.c: one coordinate, in double, of a place that has no frame and no rest there. */
void scarpi_recipe_set_coordinate(const struct recipe_machine *m, int place, int axis, float *to);

/* positions.c: whether a node needs arrays for the coordinates of its place. */
bool scarpi_recipe_needs_positions(const struct recipe_machine *m, int node, bool is_grid);

/* positions.c: nodes that have a place. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_placed(struct recipe_machine *m, int node);

/* positions.c: a noise whose derivatives are those of the points, or of u. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_noise(struct recipe_machine *m, int node,
                                                      const struct scarp_samples *out);

/* operations.c: nodes that combine others. */
KEEP_STATUS enum scarp_status scarpi_recipe_run_operation(struct recipe_machine *m, int node);

/* operations.c: whether a guard's nodes are left out. */
bool scarpi_recipe_is_left_out(struct recipe_machine *m, int guard);

#endif
