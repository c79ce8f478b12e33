/* SPDX-License-Identifier: MIT
 *
 * What this processor and operating system can run. Capability only: which set is preferred is
 * dispatch.c's business.
 */
#ifndef SCARP_CPU_H
#define SCARP_CPU_H

#include "scarp.h"

/* Whether kernels compiled for `isa` can run here. True for SCARP_ISA_SCALAR. */
int scarp_cpu_has(enum scarp_isa isa);

#endif
