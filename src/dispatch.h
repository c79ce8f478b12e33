/* SPDX-License-Identifier: MIT
 *
 * Chooses the kernel table that serves the calls.
 */
#ifndef SCARP_DISPATCH_H
#define SCARP_DISPATCH_H

#include "kernels.h"

/* The table in use, for all threads. The first call chooses it. */
const struct scarp_kernels *scarp_dispatch_active(void);

/* The table that serves a call of `count` points: the one in use, or a narrower one that is faster
   for so few. All give the same bits. */
const struct scarp_kernels *scarp_dispatch_for(size_t count);

/* The table for `isa`, or NULL if this build lacks it or this processor cannot run it. */
const struct scarp_kernels *scarp_dispatch_find(enum scarp_isa isa);

/* Uses `table` from now on; NULL: the best one. */
void scarp_dispatch_use(const struct scarp_kernels *table);

#endif
