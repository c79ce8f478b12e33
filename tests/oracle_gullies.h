/* SPDX-License-Identifier: MIT
 *
 * Gullies again, in double precision, from the definition in scarp.h. It shares no code with src/.
 */
#ifndef SCARP_TESTS_ORACLE_GULLIES_H
#define SCARP_TESTS_ORACLE_GULLIES_H

#include "oracle.h"

struct oracle_gullies {
    struct oracle lattice;
    double amplitude, frequency, low, high, slope, slope_low, floor, stripes, branch, round, keep;
};

void oracle_gullies_make(struct oracle_gullies *oracle, const struct scarp_gullies *gullies);

/* The displacement at x of a base that has this height and this gradient there. */
double oracle_gullies_at(const struct oracle_gullies *oracle, const double x[2], double height,
                         const double gradient[2]);

#endif
