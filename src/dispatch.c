/* SPDX-License-Identifier: MIT
 *
 * There is one table per instruction set, and one pointer to the table in use. The pointer is the
 * only mutable global of the library. It is resolved at first use. Every thread that resolves it
 * finds the same table, and tables are constants, so relaxed atomics suffice.
 */
#include "dispatch.h"

#include <stdatomic.h>

#include "cpu.h"

/* Best first. */
#define TABLE(ISA, table, name, here) SCARP_WHERE(here, &scarp_kernels_##table, )
static const struct scarp_kernels *const tables[] = {SCARP_ISA_LIST(TABLE)};
#undef TABLE

static _Atomic(const struct scarp_kernels *) active;

static const struct scarp_kernels *best(void)
{
    const struct scarp_kernels *const *table = tables;
    while (!scarp_cpu_has((*table)->isa)) { /* ends: scalar is last and always there */
        table++;
    }
    return *table;
}

/* Resolves the pointer. It is out of line, since only the first call comes here. */
static __attribute__((noinline)) const struct scarp_kernels *resolve(void)
{
    /* Only an unresolved pointer is replaced: a selection made meanwhile stays. */
    const struct scarp_kernels *table = NULL;
    const struct scarp_kernels *const found = best();
    return atomic_compare_exchange_strong_explicit(&active, &table, found, memory_order_relaxed,
                                                   memory_order_relaxed)
               ? found
               : table;
}

const struct scarp_kernels *scarp_dispatch_active(void)
{
    const struct scarp_kernels *const table = atomic_load_explicit(&active, memory_order_relaxed);
    return table != NULL ? table : resolve();
}

/* What can run a set can run the narrower one, too. */
const struct scarp_kernels *scarp_dispatch_for(size_t count)
{
    const struct scarp_kernels *table = scarp_dispatch_active();
    while (count <= table->narrower_most) {
        table = table->narrower;
    }
    return table;
}

const struct scarp_kernels *scarp_dispatch_find(enum scarp_isa isa)
{
    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        if (tables[i]->isa == isa) {
            return scarp_cpu_has(isa) ? tables[i] : NULL;
        }
    }
    return NULL;
}

void scarp_dispatch_use(const struct scarp_kernels *table)
{
    atomic_store_explicit(&active, table != NULL ? table : best(), memory_order_relaxed);
}
