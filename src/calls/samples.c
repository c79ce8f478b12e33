/* SPDX-License-Identifier: MIT
 *
 * The public functions that give samples of a noise, at points and on grids. They check the
 * arguments, find the plan and call the active kernel table.
 */

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/kept.h"
#include "grid.h"
#include "run.h"
#include "scarp.h"

/* This fixes the layout, as check.c does for struct scarp_noise. */
_Static_assert(sizeof(struct scarp_samples) == 16 * sizeof(float *) &&
                   offsetof(struct scarp_samples, dphase) == 10 * sizeof(float *),
               "struct scarp_samples has 16 pointers");

/* The structure is that list. */
const struct scarp_outputs *scarpi_outputs_of(const struct scarp_samples *out)
{
#define AT(output, member) (offsetof(struct scarp_samples, member) == (output) * sizeof(float *))
    _Static_assert(AT(VALUE, value) && AT(DX, dx) && AT(DY, dy) && AT(DZ, dz) && AT(DXX, dxx) &&
                       AT(DXY, dxy) && AT(DXZ, dxz) && AT(DYY, dyy) && AT(DYZ, dyz) &&
                       AT(DZZ, dzz) && AT(DPHASE, dphase),
                   "the enumerators of outputs.h are in the order of struct scarp_samples");
#undef AT
    return (const struct scarp_outputs *)out;
}

/* A member of struct scarp_samples, as a number. */
typedef uintptr_t __attribute__((may_alias)) array_word;

/* Whether members of `out` from one to before another are asked for. They are volatile, so that
   they are read one by one: to read in wide loads what a caller has just written in other pieces
   takes a call of one point 8 cycles longer (Zen 5). */
static int any_asked(const struct scarp_samples *out, int from, int end)
{
    const volatile array_word *const members = (const volatile array_word *)out;
    uintptr_t bits = 0;
    for (int i = from; i < end; i++) {
        bits |= members[i];
    }
    return bits != 0;
}

#define MEMBERS (int)(sizeof(struct scarp_samples) / sizeof(float *))

/* What calls ask for that ask for more than values. */
static NOINLINE struct scarp_request request_of_more(int dimensions,
                                                     const struct scarp_samples *out)
{
    struct scarp_request request = {
        .dimensions = dimensions, .order = SCARP_UNSUPPORTED_ORDER, .dphase = out->dphase != NULL};
    if (!any_asked(out, OUTPUTS, MEMBERS) &&
        (dimensions == 3 ||
         (out->dz == NULL && out->dxz == NULL && !any_asked(out, DYZ, DPHASE)))) {
        request.order = any_asked(out, DXX, DPHASE) ? 2 : any_asked(out, DX, DXX) ? 1 : 0;
    }
    return request;
}

/* What is asked for; its order is SCARP_UNSUPPORTED_ORDER if something does not exist. In 2D
   derivatives along z do not; reserved members never do. Most calls are decided by the first
   question. */
static ALWAYS_INLINE struct scarp_request request_of(int dimensions,
                                                     const struct scarp_samples *out)
{
    const struct scarp_request values = {.dimensions = dimensions};
    return any_asked(out, DX, MEMBERS) ? request_of_more(dimensions, out) : values;
}

struct scarp_request scarpi_request_of_samples(int dimensions, const struct scarp_samples *out)
{
    return request_of(dimensions, out);
}

/* A call at points, once its arguments are checked. */
struct points_call {
    scarpi_points_fn *kernel;
    size_t count;
    const void *const *position;
    const struct scarp_samples *out;
};

static void run_points(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct points_call *const call = opaque;
    call->kernel(plan, call->count, call->position, scarpi_outputs_of(call->out));
}

static NOINLINE enum scarp_status
run_planned(scarpi_points_fn *kernel, struct scarp_request request, const struct scarp_noise *noise,
            size_t count, const void *const position[3], const struct scarp_samples *out)
{
    const struct points_call call = {kernel, count, position, out};
    return scarpi_run(noise, request, run_points, &call);
}

/* Runs the kernel with the plan that the noise brings, or with one that is made. */
static NOINLINE enum scarp_status run(scarpi_points_fn *kernel, struct scarp_request request,
                                      const struct scarp_noise *noise, size_t count,
                                      const void *const position[3],
                                      const struct scarp_samples *out)
{
    struct scarp_call_plan plan;
    if (!plan_kept(&plan, noise, request)) {
        return run_planned(kernel, request, noise, count, position, out);
    }
    kernel(&plan, count, position, scarpi_outputs_of(out));
    return SCARP_OK;
}

/* The kernel for the points of a call */
static ALWAYS_INLINE scarpi_points_fn *kernel_of(const struct scarp_kernels *kernels,
                                                 const struct scarp_at *at)
{
    if (at->dimensions == 2) {
        return at->doubles ? kernels->points2_f64 : kernels->points2_f32;
    }
    return at->doubles ? kernels->points3_f64 : kernels->points3_f32;
}

/* Makes a call at points, with all checks. It is inlined, since a call of one point takes some 25
   ns in all. */
static ALWAYS_INLINE enum scarp_status
sample(const struct scarp_noise *noise, const struct scarp_at *at, const struct scarp_samples *out)
{
    if (at->count == 0) {
        return SCARP_OK;
    }
    const struct scarp_kernels *const kernels = scarpi_dispatch_for(at->count);
    if (kernels == NULL) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    const enum scarp_status checked = scarpi_check_points(
        at->count, at->position, at->dimensions, at->doubles ? sizeof(double) : sizeof(float));
    if (checked != SCARP_OK) {
        return checked;
    }
    const struct scarp_request request = request_of(at->dimensions, out);
    if (request.order == SCARP_UNSUPPORTED_ORDER) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status =
        run(kernel_of(kernels, at), request, noise, at->count, at->position, out);
    fpmode_leave(caller);
    return status;
}

enum scarp_status scarp_sample2(const struct scarp_noise *noise, size_t count, const float *x,
                                const float *y, const struct scarp_samples *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 0};
    return sample(noise, &at, out);
}

enum scarp_status scarp_sample3(const struct scarp_noise *noise, size_t count, const float *x,
                                const float *y, const float *z, const struct scarp_samples *out)
{
    const struct scarp_at at = {count, {x, y, z}, 3, 0};
    return sample(noise, &at, out);
}

enum scarp_status scarp_sample2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                    const double *y, const struct scarp_samples *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 1};
    return sample(noise, &at, out);
}

enum scarp_status scarp_sample3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                    const double *y, const double *z,
                                    const struct scarp_samples *out)
{
    const struct scarp_at at = {count, {x, y, z}, 3, 1};
    return sample(noise, &at, out);
}

/* A call on a grid, once its arguments are checked. */
struct grid_call {
    scarpi_grid_fn *kernel;
    const struct scarp_grid *grid;
    const struct scarp_samples *out;
};

static void run_grid(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct grid_call *const call = opaque;
    if (any_asked(call->out, 0, OUTPUTS)) { /* a grid may have any number of samples */
        call->kernel(plan, call->grid, scarpi_outputs_of(call->out));
    }
}

static enum scarp_status sample_grid(const struct scarp_noise *noise, int dimensions,
                                     const struct scarp_grid *described,
                                     const struct scarp_samples *out)
{
    const struct scarp_kernels *const kernels = scarpi_dispatch_active();
    if (noise == NULL || described == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    struct scarp_grid grid = *described;
    for (int axis = 0; axis < dimensions; axis++) {
        if (grid.count[axis] == 0) {
            return SCARP_OK;
        }
    }
    const struct scarp_fault fault = scarpi_check_grid(&grid, dimensions);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    const struct scarp_request request = request_of(dimensions, out);
    if (kernels == NULL || request.order == SCARP_UNSUPPORTED_ORDER ||
        scarpi_grid_reserved_in_use(&grid)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const struct grid_call call = {dimensions == 2 ? kernels->grid2 : kernels->grid3, &grid, out};
    const enum scarp_status result = scarpi_run(noise, request, run_grid, &call);
    fpmode_leave(caller);
    return result;
}

enum scarp_status scarp_grid2(const struct scarp_noise *noise, const struct scarp_grid *grid,
                              const struct scarp_samples *out)
{
    return sample_grid(noise, 2, grid, out);
}

enum scarp_status scarp_grid3(const struct scarp_noise *noise, const struct scarp_grid *grid,
                              const struct scarp_samples *out)
{
    return sample_grid(noise, 3, grid, out);
}
