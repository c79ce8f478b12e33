/* SPDX-License-Identifier: MIT
 *
 * Chooses the kernel table that serves the calls.
 */
#ifndef SCARP_DISPATCH_H
#define SCARP_DISPATCH_H

#include <stdatomic.h>

#include "kernels.h"

/* The table in use, for all threads, or NULL before the first call, and for ever if the best table
   does not give the bits that it should. Only the functions here and in dispatch.c use it. */
extern _Atomic(const struct scarp_kernels *) scarpi_dispatch_table;

/* Chooses the table at the first call, and returns it; NULL if a compiler did not keep to its
   operations (exact.h). */
const struct scarp_kernels *scarpi_dispatch_resolve(void);

/* The table in use, or NULL: then calls return SCARP_ERROR_UNSUPPORTED. Whether to do so costs a
   call nothing, since the pointer is compared with NULL anyway. Tables are constants, so relaxed
   atomics suffice. */
static inline const struct scarp_kernels *scarpi_dispatch_active(void)
{
    const struct scarp_kernels *const table =
        atomic_load_explicit(&scarpi_dispatch_table, memory_order_relaxed);
    return table != NULL ? table : scarpi_dispatch_resolve();
}

/* Whether calls return SCARP_ERROR_UNSUPPORTED, for those that need no kernel. */
static inline int scarpi_dispatch_refuses(void)
{
    return scarpi_dispatch_active() == NULL;
}

/* The table that serves a call of `count` points: the one in use, or NULL, or a narrower one that
   is faster for so few. All give the same bits, and what can run a set can run the narrower one,
   too. */
static inline const struct scarp_kernels *scarpi_dispatch_for(size_t count)
{
    const struct scarp_kernels *table = scarpi_dispatch_active();
    while (table != NULL && count <= table->narrower_most) {
        table = table->narrower;
    }
    return table;
}

/* The table for `isa`, or NULL if this build lacks it or does not give its bits, or this processor
   cannot run it. */
const struct scarp_kernels *scarpi_dispatch_find(enum scarp_isa isa);

/* Uses `table` from now on; NULL: the best one. Returns 0, and changes nothing, if that is none. */
int scarpi_dispatch_use(const struct scarp_kernels *table);

#endif
