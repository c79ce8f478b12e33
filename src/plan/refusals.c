/* SPDX-License-Identifier: MIT
 *
 * Gives what is in the table of refusals, and the path of a member in a warp.
 */
#include "refusals.h"

#include <stddef.h>

#include "call.h"

/* Each member as it is called in the deepest warp. Elsewhere it is called as the end of that. */
#define PATH "warp.warp.warp.warp."
#define STEP (sizeof "warp." - 1)
_Static_assert(sizeof PATH - 1 == SCARP_MAX_WARPS * STEP, "a path leads through all warps");

struct row {
    enum scarp_status status;
    const char *path, *text;
};

#define ROW(name, status, member, text)                                                            \
    [REFUSED_##name] = {SCARP_ERROR_##status, PATH member, text},
static const struct row rows[REFUSALS] = {[REFUSED_NOT] = {SCARP_OK, PATH, NULL},
                                          SCARP_REFUSALS(ROW)};
#undef ROW

const char *scarpi_fault_told(struct scarp_fault fault, const char **member)
{
    const char *const name = rows[fault.why].path + SCARP_MAX_WARPS * STEP;
    if (member != NULL) {
        *member = *name == '\0' ? NULL : name - (size_t)fault.warp * STEP;
    }
    return rows[fault.why].text;
}

enum scarp_status scarpi_fault_status(struct scarp_fault fault, const char **member)
{
    (void)scarpi_fault_told(fault, member);
    return rows[fault.why].status;
}
