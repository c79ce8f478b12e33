/* SPDX-License-Identifier: MIT
 *
 * What the values of a noise can be.
 */
#ifndef SCARP_RANGE_H
#define SCARP_RANGE_H

#include "hybrid.h"
#include "scarp.h"

/* The interval of scarp_range of a valid noise. */
struct scarp_interval scarpi_plan_range(const struct scarp_noise *noise, int dimensions);

#endif
