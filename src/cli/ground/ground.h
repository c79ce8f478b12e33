/* SPDX-License-Identifier: MIT
 *
 * The terrain: a height for every place, with its exact gradient.
 *
 *     value = terraces(base(p) + mask(p) crater(noise(p))), at least `floor` and at most `ceiling`
 *
 * with p in units of input, and height = height_scale * value. Positions of the noise are stretched
 * across the wind. The mask is 0 to 1. What is not asked for is left out.
 *
 * All of it is the same on every machine, to the bit.
 */
#ifndef SCARP_CLI_GROUND_H
#define SCARP_CLI_GROUND_H

#include <stdbool.h>
#include <stddef.h>

#include "ground/ground_options.h"
#include "scarp.h"

/* Points to itself: not to be copied by assignment, but by ground_limit. */
struct ground {
    struct scarp_noise noise[2]; /* of noise_make */
    struct scarp_noise base, mask;
    bool has_base, has_mask;
    float mask_from, mask_to;
    float rim; /* of craters: what is higher is turned down; no craters: infinity */
    float terraces, terrace_riser, terrace_strength; /* no terraces: 0 */
    bool is_stretched, is_aligned; /* aligned: the noise's axes are those of positions */
    double along[2], across[2];    /* the noise's coordinates are products with these */
    float lowest, highest;         /* values never leave this interval, sea and plateau aside */
    float floor, ceiling;          /* the sea and the plateau, taken into that interval */
    float height_scale;            /* units of x and y per 1 of value */
};

/* Makes the ground of complete options. False, with a line on stderr, if the numbers do not go
   together. */
bool ground_make(const struct ground_options *options, struct ground *ground);

/* Whether heights jump: the table of scarp.h under "Jumps" */
bool ground_jumps(const struct ground *ground);

/* Samples values, and gradients if out->dx and out->dy are there, as scarp_grid2 does. */
void ground_grid(const struct ground *ground, const struct scarp_grid *grid,
                 const struct scarp_samples *out);

/* Samples values, and gradients if they are asked for, as scarp_sample2_f64 does. */
void ground_points(const struct ground *ground, size_t count, const double *x, const double *y,
                   const struct scarp_samples *out);

/* Sample the ground as it is before the sea and the plateau cut it off. */
void ground_uncut_grid(const struct ground *ground, const struct scarp_grid *grid,
                       const struct scarp_samples *out);
void ground_uncut_points(const struct ground *ground, size_t count, const double *x,
                         const double *y, const struct scarp_samples *out);

/* Cuts off what the sea covers and what is above the plateau: it is flat there, so the gradient is
   0. */
void ground_cut(const struct ground *ground, size_t count, const struct scarp_samples *out);

/* Makes the same ground without the octaves whose cells are smaller than `finest` units; the last
   one that is left fades in. What is left is as it was: amplitudes do not change. */
void ground_limit(const struct ground *ground, double finest, struct ground *limited);

#endif
