/* SPDX-License-Identifier: MIT
 *
 * The public functions that name and choose the instruction set.
 */
#include <stddef.h>

#include "../dispatch/dispatch.h"
#include "scarp.h"

enum scarp_isa scarp_isa_active(void)
{
    const struct scarp_kernels *const table = scarpi_dispatch_active();
    return table != NULL ? table->isa : SCARP_ISA_NONE;
}

int scarp_isa_supported(enum scarp_isa isa)
{
    return scarpi_dispatch_find(isa) != NULL;
}

enum scarp_status scarp_isa_select(enum scarp_isa isa)
{
    if ((unsigned)isa >= SCARP_ISAS) {
        return SCARP_ERROR_ENUM;
    }
    const struct scarp_kernels *const table =
        isa == SCARP_ISA_NONE ? NULL : scarpi_dispatch_find(isa);
    if (isa != SCARP_ISA_NONE && table == NULL) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    return scarpi_dispatch_use(table) ? SCARP_OK : SCARP_ERROR_UNSUPPORTED;
}
