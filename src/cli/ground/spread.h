/* SPDX-License-Identifier: MIT
 *
 * Which heights a terrain usually has. Colours by height need them: the interval that heights never
 * leave is hardly ever filled, and what occurs in a raster is not the same for all tiles.
 */
#ifndef SCARP_CLI_SPREAD_H
#define SCARP_CLI_SPREAD_H

#include "ground/ground.h"

/* Heights that are 0 and 1 for colours */
struct spread {
    float low;    /* 2 % of places are lower; the sea, if there is one */
    float middle; /* half of the places are higher, of those above the sea */
    float high;   /* 2 % of these are higher */
    float sea;    /* the sea's level */
    float deep;   /* 10 % of the places in the sea are deeper */
};

/* Looks at places that depend on the largest cells alone: the same for every raster, tile and
   `param phase`. low < middle < high, and not close to each other. */
void ground_spread(const struct ground *ground, struct spread *spread);

#endif
