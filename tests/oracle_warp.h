/* SPDX-License-Identifier: MIT
 *
 * Noise with warps in double precision, from the oracle's.
 */
#ifndef SCARP_TESTS_ORACLE_WARP_H
#define SCARP_TESTS_ORACLE_WARP_H

#include "oracle.h"

#define ORACLE_WARPS 4

/* A noise with its warps: level 0 is the noise, the others have a component per axis. */
struct oracle_warped {
    int depth, dimensions;
    struct oracle level[ORACLE_WARPS + 1][3];
};

void oracle_warped_make(struct oracle_warped *warped, const struct scarp_noise *noise,
                        int dimensions);

/* The noise at y(x), with its derivatives with respect to y: the value is that of the whole, the
   derivatives are not. */
void oracle_warped_at(const struct oracle_warped *warped, const double x[3],
                      struct oracle_sample *n);

#endif
