/* SPDX-License-Identifier: MIT
 *
 * Gives calls their plans, and makes those calls that differ in what they give alone.
 */
#include "run.h"

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/plan.h"

static enum scarp_status run_in(struct scarp_octave *octave, struct scarp_levels *levels,
                                const struct scarp_noise *noise, struct scarp_kind kind,
                                scarpi_run_fn *compute, const void *call)
{
    struct scarp_call_plan plan;
    const enum scarp_status status = scarpi_plan_call(&plan, octave, levels, noise, kind);
    if (status == SCARP_OK) {
        compute(&plan, call);
    }
    return status;
}

static NOINLINE enum scarp_status run_few(const struct scarp_noise *noise, struct scarp_kind kind,
                                          scarpi_run_fn *compute, const void *call)
{
    struct scarp_octave octave[SCARP_FEW_OCTAVES];
    return run_in(octave, NULL, noise, kind, compute, call);
}

static NOINLINE enum scarp_status run_many(const struct scarp_noise *noise, struct scarp_kind kind,
                                           scarpi_run_fn *compute, const void *call)
{
    struct scarp_octave octave[SCARP_MAX_OCTAVES];
    return run_in(octave, NULL, noise, kind, compute, call);
}

static NOINLINE enum scarp_status run_with_levels(const struct scarp_noise *noise,
                                                  struct scarp_kind kind, scarpi_run_fn *compute,
                                                  const void *call)
{
    struct scarp_levels levels;
    struct scarp_octave octave[SCARP_MAX_OCTAVES];
    return run_in(octave, &levels, noise, kind, compute, call);
}

/* Each kind of plan has a frame of its own size: what they compute takes much stack as it is. */
enum scarp_status scarpi_run(const struct scarp_noise *noise, struct scarp_kind kind,
                             scarpi_run_fn *compute, const void *call)
{
    return scarpi_has_levels(noise, kind)        ? run_with_levels(noise, kind, compute, call)
           : noise->octaves <= SCARP_FEW_OCTAVES ? run_few(noise, kind, compute, call)
                                                 : run_many(noise, kind, compute, call);
}

enum scarp_status scarpi_find(const struct scarp_finder *how, const struct scarp_noise *noise,
                              const struct scarp_at *at, const void *out)
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
    const struct scarp_find find = {scarpi_dispatch_for(at->count), noise, at, out};
    if (find.kernels == NULL || how->refuses(out, at->dimensions)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status result =
        scarpi_run(noise, how->kind(out, at->dimensions), how->compute, &find);
    fpmode_leave(caller);
    return result;
}
