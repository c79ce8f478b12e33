/* SPDX-License-Identifier: MIT
 *
 * The intervals of parameters, and what cannot be served.
 */
#ifndef SCARP_CHECK_H
#define SCARP_CHECK_H

#include "refusals.h"

/* Makes the checks of scarp_noise_check, for all calls. */
struct scarp_fault scarpi_plan_check(const struct scarp_noise *noise, int dimensions);

/* A NaN is not within. */
static inline int within(double value, double lowest, double highest)
{
    return value >= lowest && value <= highest;
}

#endif
