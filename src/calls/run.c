/* SPDX-License-Identifier: MIT
 *
 * Gives calls their plans, and makes calls at points that differ only in what they give.
 */
#include "run.h"

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/plan.h"

static enum scarp_status run_in(struct scarp_octave *octave, struct scarp_levels *levels,
                                const struct scarp_noise *noise, struct scarp_request request,
                                scarpi_run_fn *compute, const void *call)
{
    struct scarp_call_plan plan;
    const enum scarp_status status = scarpi_plan_call(&plan, octave, levels, noise, request);
    if (status == SCARP_OK) {
        compute(&plan, call);
    }
    return status;
}

static NOINLINE enum scarp_status run_few(const struct scarp_noise *noise,
                                          struct scarp_request request, scarpi_run_fn *compute,
                                          const void *call)
{
    struct scarp_octave octave[SCARP_FEW_OCTAVES];
    return run_in(octave, NULL, noise, request, compute, call);
}

static NOINLINE enum scarp_status run_many(const struct scarp_noise *noise,
                                           struct scarp_request request, scarpi_run_fn *compute,
                                           const void *call)
{
    struct scarp_octave octave[SCARP_MAX_OCTAVES];
    return run_in(octave, NULL, noise, request, compute, call);
}

static NOINLINE enum scarp_status run_with_levels(const struct scarp_noise *noise,
                                                  struct scarp_request request,
                                                  scarpi_run_fn *compute, const void *call)
{
    struct scarp_levels levels;
    struct scarp_octave octave[SCARP_MAX_OCTAVES];
    return run_in(octave, &levels, noise, request, compute, call);
}

/* Each kind of plan has a frame of its own size: what they compute takes much stack as it is. */
enum scarp_status scarpi_run(const struct scarp_noise *noise, struct scarp_request request,
                             scarpi_run_fn *compute, const void *call)
{
    return scarpi_has_levels(noise, request)     ? run_with_levels(noise, request, compute, call)
           : noise->octaves <= SCARP_FEW_OCTAVES ? run_few(noise, request, compute, call)
                                                 : run_many(noise, request, compute, call);
}

enum scarp_status scarpi_run_at_points(const struct scarp_computation *computation,
                                       const struct scarp_noise *noise, const struct scarp_at *at,
                                       const void *out)
{
    if (at->count == 0) {
        return SCARP_OK;
    }
    if (noise == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    const enum scarp_status status = scarpi_check_points(
        at->count, at->position, at->dimensions, at->doubles ? sizeof(double) : sizeof(float));
    if (status != SCARP_OK) {
        return status;
    }
    const struct scarp_arguments arguments = {scarpi_dispatch_for(at->count), noise, at, out};
    if (arguments.kernels == NULL || computation->refuses(out, at->dimensions)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status result = scarpi_run(noise, computation->request(out, at->dimensions),
                                                computation->compute, &arguments);
    fpmode_leave(caller);
    return result;
}
