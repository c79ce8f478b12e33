/* SPDX-License-Identifier: MIT
 *
 * Tells what this processor and operating system can run. dispatch.c decides which set is
 * preferred.
 */
#ifndef SCARP_CPU_H
#define SCARP_CPU_H

#include "scarp.h"

/* Whether kernels compiled for `isa`, which this build has, can run here. */
int scarpi_cpu_has(enum scarp_isa isa);

#endif
