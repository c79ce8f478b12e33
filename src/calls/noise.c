/* SPDX-License-Identifier: MIT
 *
 * The public functions that take a noise alone: its checks, its range, and the plan that it keeps.
 */
#include <stddef.h>

#include "../dispatch/fpmode.h"
#include "../plan/check.h"
#include "../plan/plan.h"
#include "../plan/range.h"
#include "run.h"
#include "scarp.h"

static NOINLINE enum scarp_status range(const struct scarp_noise *noise, int dimensions,
                                        float *lowest, float *highest)
{
    const char *member;
    const enum scarp_status status = scarp_plan_check(noise, dimensions, &member);
    if (status != SCARP_OK) {
        return status;
    }
    const struct scarp_interval interval = scarp_plan_range(noise, dimensions);
    *lowest = (float)interval.lowest;
    *highest = (float)interval.highest;
    return SCARP_OK;
}

enum scarp_status scarp_range(const struct scarp_noise *noise, int dimensions, float *lowest,
                              float *highest)
{
    if (noise == NULL || lowest == NULL || highest == NULL) {
        return SCARP_ERROR_NULL;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = range(noise, dimensions, lowest, highest);
    fpmode_leave(caller);
    return status;
}

static NOINLINE enum scarp_status check(const struct scarp_noise *noise, int dimensions,
                                        const char **member)
{
    return scarp_plan_check(noise, dimensions, member);
}

enum scarp_status scarp_noise_check(const struct scarp_noise *noise, int dimensions,
                                    const char **member)
{
    const char *found = NULL;
    enum scarp_status status = SCARP_ERROR_NULL;
    if (noise != NULL) {
        const struct fpmode caller = fpmode_enter();
        status = check(noise, dimensions, &found);
        fpmode_leave(caller);
    }
    if (member != NULL) {
        *member = found;
    }
    return status;
}

static NOINLINE enum scarp_status keep(struct scarp_plan *plan, const struct scarp_noise *noise,
                                       int dimensions)
{
    return scarp_plan_keep(plan, noise, dimensions);
}

enum scarp_status scarp_plan_make(const struct scarp_noise *noise, int dimensions,
                                  struct scarp_plan *plan)
{
    if (noise == NULL || plan == NULL) {
        return SCARP_ERROR_NULL;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = keep(plan, noise, dimensions);
    fpmode_leave(caller);
    return status;
}
