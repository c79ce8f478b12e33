/* SPDX-License-Identifier: MIT
 *
 * The intervals of parameters, and what cannot be served.
 */
#ifndef SCARP_CHECK_H
#define SCARP_CHECK_H

#include "refusals.h"

/* Makes the checks of scarp_noise_check, for all calls. */
struct scarp_fault scarpi_plan_check(const struct scarp_noise *noise, int dimensions);

#endif
