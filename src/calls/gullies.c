/* SPDX-License-Identifier: MIT
 *
 * The public functions that draw gullies.
 */
#include "../plan/gully.h"

#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "grid.h"
#include "run.h"
#include "scarp.h"

#define AT(output, member) (offsetof(struct scarp_eroded, member) == (output) * sizeof(float *))
_Static_assert(AT(ERODED_VALUE, value) && AT(ERODED_DX, dx) && AT(ERODED_DY, dy) &&
                   AT(ERODED_DISPLACEMENT, displacement) &&
                   AT(ERODED_DISPLACEMENT_DX, displacement_dx) &&
                   AT(ERODED_DISPLACEMENT_DY, displacement_dy) &&
                   sizeof(struct scarp_eroded) == 16 * sizeof(float *),
               "struct scarp_eroded has 16 pointers in the order of gullies.h");
#undef AT

/* A call, once its arguments are checked. */
struct gully_run {
    const struct scarp_kernels *kernels;
    const struct scarp_gullies *gullies;
    struct scarp_gully_call call;
};

static int asks_for_something(const struct scarp_gully_call *call)
{
    int asked = 0;
    for (int i = 0; i < ERODED_OUTPUTS; i++) {
        asked |= call->out[i] != NULL;
    }
    return asked;
}

static void run(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct gully_run *const run = opaque;
    if (!asks_for_something(&run->call)) { /* a grid may have any number of samples */
        return;
    }
    struct scarp_gully_call call = run->call;
    struct scarp_gully_plan gullies;
    scarpi_gullies_plan(&gullies, run->gullies, plan);
    call.gullies = &gullies;
    run->kernels->gullies(&call, plan);
}

static NOINLINE enum scarp_status run_checked(const struct gully_run *call)
{
    const struct scarp_request request = {.dimensions = 2};
    const struct scarp_fault fault = scarpi_gullies_verify(call->gullies);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    const struct scarp_noise lattice = scarpi_gullies_lattice(call->gullies);
    return scarpi_run(&lattice, request, run, call);
}

static int reserved_in_use(const struct scarp_samples *base, const struct scarp_eroded *out)
{
    int used = 0;
    for (size_t i = 0; i < sizeof base->spare / sizeof base->spare[0]; i++) {
        used |= base->spare[i] != NULL;
    }
    for (size_t i = 0; i < sizeof out->spare / sizeof out->spare[0]; i++) {
        used |= out->spare[i] != NULL;
    }
    return used;
}

/* Fills in the arrays of a call. Returns 0 if one that is needed is not there. */
static int take_arrays(struct scarp_gully_call *call, const struct scarp_samples *base,
                       const struct scarp_eroded *out)
{
    float *const arrays[ERODED_OUTPUTS] = {
        out->value,          out->dx, out->dy, out->displacement, out->displacement_dx,
        out->displacement_dy};
    const int slopes = out->dx != NULL || out->dy != NULL || out->displacement_dx != NULL ||
                       out->displacement_dy != NULL;
    memcpy(call->out, arrays, sizeof arrays);
    call->base[BASE_VALUE] = base->value;
    call->base[BASE_DX] = base->dx;
    call->base[BASE_DY] = base->dy;
    call->base[BASE_DXX] = slopes ? base->dxx : NULL;
    call->base[BASE_DXY] = slopes ? base->dxy : NULL;
    call->base[BASE_DYY] = slopes ? base->dyy : NULL;
    return base->value != NULL && base->dx != NULL && base->dy != NULL &&
           (!slopes || (base->dxx != NULL && base->dxy != NULL && base->dyy != NULL));
}

/* Makes a call whose `kernels`, `gullies`, and points or grid are there. */
static enum scarp_status erode(struct gully_run *call, const struct scarp_samples *base,
                               const struct scarp_eroded *out)
{
    if (!take_arrays(&call->call, base, out)) {
        return SCARP_ERROR_NULL;
    }
    if (call->kernels == NULL || reserved_in_use(base, out)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = run_checked(call);
    fpmode_leave(caller);
    return status;
}

static enum scarp_status erode_points(const struct scarp_gullies *gullies,
                                      const struct scarp_at *at, const struct scarp_samples *base,
                                      const struct scarp_eroded *out)
{
    if (at->count == 0) {
        return SCARP_OK;
    }
    if (gullies == NULL || base == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    const enum scarp_status status = scarpi_check_points(
        at->count, at->position, 2, at->doubles ? sizeof(double) : sizeof(float));
    if (status != SCARP_OK) {
        return status;
    }
    struct gully_run call = {scarpi_dispatch_for(at->count),
                             gullies,
                             {.count = at->count,
                              .position = {at->position[0], at->position[1]},
                              .doubles = at->doubles}};
    return erode(&call, base, out);
}

enum scarp_status scarp_gullies2(const struct scarp_gullies *gullies, size_t count, const float *x,
                                 const float *y, const struct scarp_samples *base,
                                 const struct scarp_eroded *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 0};
    return erode_points(gullies, &at, base, out);
}

enum scarp_status scarp_gullies2_f64(const struct scarp_gullies *gullies, size_t count,
                                     const double *x, const double *y,
                                     const struct scarp_samples *base,
                                     const struct scarp_eroded *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 1};
    return erode_points(gullies, &at, base, out);
}

enum scarp_status scarp_gullies_grid2(const struct scarp_gullies *gullies,
                                      const struct scarp_grid *described,
                                      const struct scarp_samples *base,
                                      const struct scarp_eroded *out)
{
    if (gullies == NULL || described == NULL || base == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    struct scarp_grid grid = *described;
    if (grid.count[0] == 0 || grid.count[1] == 0) {
        return SCARP_OK;
    }
    const struct scarp_fault fault = scarpi_check_grid(&grid, 2);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    if (scarpi_grid_reserved_in_use(&grid)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    struct gully_run call = {scarpi_dispatch_active(), gullies, {.grid = &grid, .doubles = 1}};
    return erode(&call, base, out);
}

static NOINLINE struct scarp_fault check(const struct scarp_gullies *gullies)
{
    return scarpi_gullies_verify(gullies);
}

static struct scarp_fault fault_of(const struct scarp_gullies *gullies)
{
    struct scarp_fault fault = {REFUSED_POINTER, 0};
    if (gullies != NULL) {
        const struct fpmode caller = fpmode_enter();
        fault = check(gullies);
        fpmode_leave(caller);
    }
    return fault;
}

enum scarp_status scarp_gullies_check(const struct scarp_gullies *gullies, const char **member)
{
    return scarpi_fault_status(fault_of(gullies), member);
}

const char *scarp_gullies_fault(const struct scarp_gullies *gullies, const char **member)
{
    return scarpi_fault_told(fault_of(gullies), member);
}

/* The sums are rounded to floats as sums of samples are, so that none leaves the interval. */
static NOINLINE enum scarp_status range(const struct scarp_gullies *gullies, const float base[2],
                                        float *lowest, float *highest)
{
    const struct scarp_fault fault = scarpi_gullies_verify(gullies);
    if (!(base[0] <= base[1])) {
        return SCARP_ERROR_PARAMETER;
    }
    if (fault.why == REFUSED_NOT) {
        const float depth = (float)scarpi_gullies_depth(gullies);
        *lowest = base[0] - depth;
        *highest = base[1] + depth;
    }
    return scarpi_fault_status(fault, NULL);
}

enum scarp_status scarp_gullies_range(const struct scarp_gullies *gullies, float base_lowest,
                                      float base_highest, float *lowest, float *highest)
{
    if (gullies == NULL || lowest == NULL || highest == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const float base[2] = {base_lowest, base_highest};
    const enum scarp_status status = range(gullies, base, lowest, highest);
    fpmode_leave(caller);
    return status;
}
