/* SPDX-License-Identifier: MIT
 *
 * There is one table per instruction set, and one pointer to the table in use. The pointer is the
 * only mutable global of the library. It is resolved at first use. Every thread that resolves it
 * finds the same table, and tables are constants, so relaxed atomics suffice.
 */
#include "dispatch.h"

#include "cpu.h"
#include "exact.h"
#include "fpmode.h"

/* Best first. */
#define TABLE(ISA, table, name, here) SCARP_WHERE(here, &scarpi_kernels_##table, )
static const struct scarp_kernels *const tables[] = {SCARP_ISA_LIST(TABLE)};
#undef TABLE

_Atomic(const struct scarp_kernels *) scarpi_dispatch_table;

/* Whether a table, and those that relieve it of few points, give the bits that they should. Plans
   are made by code like this file's. */
static int is_exact(const struct scarp_kernels *table)
{
    const struct fpmode caller = fpmode_enter();
    int exact = scarpi_is_exact();
    for (; table != NULL; table = table->narrower) {
        exact &= table->is_exact();
    }
    fpmode_leave(caller);
    return exact;
}

/* No other set takes the place of the best one: a build that is wrong, or slow, should be noticed.
 */
static const struct scarp_kernels *best(void)
{
    const struct scarp_kernels *const *table = tables;
    while (!scarpi_cpu_has((*table)->isa)) { /* ends: scalar is last and always there */
        table++;
    }
    return is_exact(*table) ? *table : NULL;
}

const struct scarp_kernels *scarpi_dispatch_resolve(void)
{
    /* Only an unresolved pointer is replaced: a selection made meanwhile stays. */
    const struct scarp_kernels *table = NULL;
    const struct scarp_kernels *const found = best();
    return atomic_compare_exchange_strong_explicit(&scarpi_dispatch_table, &table, found,
                                                   memory_order_relaxed, memory_order_relaxed)
               ? found
               : table;
}

const struct scarp_kernels *scarpi_dispatch_find(enum scarp_isa isa)
{
    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        if (tables[i]->isa == isa) {
            return scarpi_cpu_has(isa) && is_exact(tables[i]) ? tables[i] : NULL;
        }
    }
    return NULL;
}

int scarpi_dispatch_use(const struct scarp_kernels *table)
{
    table = table != NULL ? table : best();
    if (table != NULL) {
        atomic_store_explicit(&scarpi_dispatch_table, table, memory_order_relaxed);
    }
    return table != NULL;
}
