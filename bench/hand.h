/* SPDX-License-Identifier: MIT
 *
 * The peer "by hand": the recipes as programs write them that know no recipes, by the same calls of
 * scarp. hand_recipes.c has the recipes, peer_hand.c the ways of taking points through them.
 */
#ifndef SCARP_BENCH_HAND_H
#define SCARP_BENCH_HAND_H

#include "work.h"

enum { HAND_NOISES = 8, HAND_REGISTERS = 6, HAND_PLANES = 3 };

struct hand;

struct hand_recipe {
    const char *title;
    const struct scarp_noise *noises; /* with the numbers of seeds; warps point into this array */
    int noise_count;
    int plane_noises; /* so many of them, the first ones, are of the plane */
    int warps;        /* so many, the last ones, only bend others */
    int registers;    /* so many are used; the result is in number 0 */
    /* In space: computes what depends on x and y alone, in registers of the plane. Or NULL. */
    void (*compute_plane)(struct hand *hand);
    void (*compute)(struct hand *hand);
};

extern const struct hand_recipe hand_recipes[]; /* ends with a title NULL */

struct hand {
    const struct hand_recipe *recipe;
    struct scarp_noise noise[HAND_NOISES]; /* by which calls are made */
    struct scarp_plan *plans;              /* of the noises, for few points; else NULL */
    int way;
    char way_name[24];
    float *memory;
    size_t floats;                                                /* of it */
    struct scarp_samples own[HAND_REGISTERS], plane[HAND_PLANES]; /* arrays in it */
    size_t plane_width;                                           /* of the whole grid */
    int is_double, has_gradient;
    /* The points that go through the recipe now: */
    int dimensions;
    size_t count;
    const void *x[3];
    const struct scarp_grid *grid; /* NULL: points */
    struct scarp_samples at[HAND_REGISTERS];
};

/* Writes the name of way number `way`, counted from 0, of doing a workload: all at once, bands of
   rows as wide as the grid, or pieces of it. Returns 0 if there are no more. */
int bench_hand_way(const struct bench_work *work, int way, char *name, size_t size);

/* Goes that way. Returns 0 if there is none, or no memory. */
int bench_hand_run(struct hand *hand, int way, const struct bench_work *work,
                   const void *const x[3], const struct scarp_samples *out);

#endif
