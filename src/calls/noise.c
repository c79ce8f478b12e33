/* SPDX-License-Identifier: MIT
 *
 * The public functions that take only a noise: its checks, its range, and the plans that it keeps.
 */
#include <stddef.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/parameters.h"
#include "../plan/plan.h"
#include "../plan/range.h"
#include "../plan/refusals.h"
#include "run.h"
#include "scarp.h"

static NOINLINE enum scarp_status range(const struct scarp_noise *noise, int dimensions,
                                        float *lowest, float *highest)
{
    const struct scarp_fault fault = scarpi_plan_check(noise, dimensions);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    const struct scarp_interval interval = scarpi_plan_range(noise, dimensions);
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
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = range(noise, dimensions, lowest, highest);
    fpmode_leave(caller);
    return status;
}

static NOINLINE struct scarp_fault check(const struct scarp_noise *noise, int dimensions)
{
    return scarpi_plan_check(noise, dimensions);
}

static struct scarp_fault fault_of(const struct scarp_noise *noise, int dimensions)
{
    struct scarp_fault fault = {REFUSED_POINTER, 0};
    if (noise != NULL) {
        const struct fpmode caller = fpmode_enter();
        fault = check(noise, dimensions);
        fpmode_leave(caller);
    }
    return fault;
}

enum scarp_status scarp_noise_check(const struct scarp_noise *noise, int dimensions,
                                    const char **member)
{
    return scarpi_fault_status(fault_of(noise, dimensions), member);
}

const char *scarp_noise_fault(const struct scarp_noise *noise, int dimensions, int order,
                              int dphase, const char **member)
{
    struct scarp_fault fault = fault_of(noise, dimensions);
    if (fault.why == REFUSED_NOT && (order < 0 || order > 2)) {
        fault = (struct scarp_fault){REFUSED_ORDER, 0};
    }
    if (fault.why == REFUSED_NOT) {
        const struct scarp_request asked = {
            .dimensions = dimensions, .order = (short)order, .dphase = dphase != 0};
        fault = outputs_fault(noise, asked);
    }
    return scarpi_fault_told(fault, member);
}

static NOINLINE enum scarp_status keep(struct scarp_plan *plan, const struct scarp_noise *noise,
                                       int dimensions, int is_vector)
{
    return scarpi_plan_keep(plan, sizeof *plan, noise, dimensions, is_vector);
}

static enum scarp_status make(struct scarp_plan *plan, const struct scarp_noise *noise,
                              int dimensions, int is_vector)
{
    if (noise == NULL || plan == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = keep(plan, noise, dimensions, is_vector);
    fpmode_leave(caller);
    return status;
}

enum scarp_status scarp_plan_make(const struct scarp_noise *noise, int dimensions,
                                  struct scarp_plan *plan)
{
    return make(plan, noise, dimensions, 0);
}

enum scarp_status scarp_vector_plan_make(const struct scarp_noise *noise, int dimensions,
                                         struct scarp_plan *plan)
{
    return make(plan, noise, dimensions, 1);
}
