/* SPDX-License-Identifier: MIT
 *
 * The public functions that give samples of a noise, at points and on grids. They check the
 * arguments, find the plan and call the active kernel table.
 */
#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/kept.h"
#include "run.h"
#include "scarp.h"

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

/* These assertions fix layouts, as check.c does for struct scarp_noise. Whether a 32-bit processor
   aligns doubles and int64_t to 4 or 8 bytes, a grid has the same layout. */
_Static_assert(sizeof(struct scarp_samples) == 16 * sizeof(float *) &&
                   offsetof(struct scarp_samples, dphase) == 10 * sizeof(float *),
               "struct scarp_samples has 16 pointers");
_Static_assert(sizeof(struct scarp_grid) == 192 && offsetof(struct scarp_grid, count) == 72 &&
                   offsetof(struct scarp_grid, spare) == 72 + 5 * sizeof(size_t),
               "struct scarp_grid has 192 bytes without padding");

/* Looks at the bits, since it runs in the caller's floating-point mode. */
static int is_finite_f64(double value)
{
    const union {
        double value;
        uint64_t bits;
    } u = {value};
    const uint64_t exponent = UINT64_C(0x7ff0000000000000);
    return (u.bits & exponent) != exponent;
}

/* No other place knows the arrays by name. */
const struct scarp_outputs *scarp_outputs_of(const struct scarp_samples *out)
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
static NOINLINE struct scarp_kind kind_of_more(int dimensions, const struct scarp_samples *out)
{
    struct scarp_kind kind = {
        .dimensions = dimensions, .order = SCARP_UNSUPPORTED_ORDER, .dphase = out->dphase != NULL};
    if (!any_asked(out, OUTPUTS, MEMBERS) &&
        (dimensions == 3 ||
         (out->dz == NULL && out->dxz == NULL && !any_asked(out, DYZ, DPHASE)))) {
        kind.order = any_asked(out, DXX, DPHASE) ? 2 : any_asked(out, DX, DXX) ? 1 : 0;
    }
    return kind;
}

/* What is asked for; its order is SCARP_UNSUPPORTED_ORDER if something does not exist. In 2D
   derivatives along z do not; reserved members never do. Most calls are decided by the first
   question. */
static ALWAYS_INLINE struct scarp_kind kind_of(int dimensions, const struct scarp_samples *out)
{
    const struct scarp_kind values = {.dimensions = dimensions};
    return any_asked(out, DX, MEMBERS) ? kind_of_more(dimensions, out) : values;
}

struct scarp_kind scarp_kind_of_samples(int dimensions, const struct scarp_samples *out)
{
    return kind_of(dimensions, out);
}

/* A call at points, once its arguments are checked. */
struct points_call {
    scarp_points_fn *kernel;
    size_t count;
    const void *const *position;
    const struct scarp_samples *out;
};

static void run_points(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct points_call *const call = opaque;
    call->kernel(plan, call->count, call->position, scarp_outputs_of(call->out));
}

static NOINLINE enum scarp_status run_planned(scarp_points_fn *kernel, struct scarp_kind kind,
                                              const struct scarp_noise *noise, size_t count,
                                              const void *const position[3],
                                              const struct scarp_samples *out)
{
    const struct points_call call = {kernel, count, position, out};
    return scarp_run(noise, kind, run_points, &call);
}

/* Runs the kernel with the plan that the noise brings, or with one that is made. */
static NOINLINE enum scarp_status run(scarp_points_fn *kernel, struct scarp_kind kind,
                                      const struct scarp_noise *noise, size_t count,
                                      const void *const position[3],
                                      const struct scarp_samples *out)
{
    struct scarp_call_plan plan;
    if (!plan_kept(&plan, noise, kind)) {
        return run_planned(kernel, kind, noise, count, position, out);
    }
    kernel(&plan, count, position, scarp_outputs_of(out));
    return SCARP_OK;
}

/* What a sample function is: its kernel, and how its points are given. */
struct sampler {
    scarp_points_fn *points;
    int dimensions;
    size_t bytes; /* of a coordinate */
};

/* Makes the checks that all sample calls share, then the call. It is inlined, since a call of one
   point takes some 25 ns in all. */
static ALWAYS_INLINE enum scarp_status sample(struct sampler sampler,
                                              const struct scarp_noise *noise, size_t count,
                                              const void *const position[3],
                                              const struct scarp_samples *out)
{
    if (noise == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    const enum scarp_status checked =
        scarp_check_points(count, position, sampler.dimensions, sampler.bytes);
    if (checked != SCARP_OK) {
        return checked;
    }
    const struct scarp_kind kind = kind_of(sampler.dimensions, out);
    if (kind.order == SCARP_UNSUPPORTED_ORDER) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = run(sampler.points, kind, noise, count, position, out);
    fpmode_leave(caller);
    return status;
}

enum scarp_status scarp_sample2(const struct scarp_noise *noise, size_t count, const float *x,
                                const float *y, const struct scarp_samples *out)
{
    if (count == 0) {
        return SCARP_OK;
    }
    const void *const position[3] = {x, y, NULL};
    const struct sampler sampler = {scarp_dispatch_for(count)->points2_f32, 2, sizeof *x};
    return sample(sampler, noise, count, position, out);
}

enum scarp_status scarp_sample3(const struct scarp_noise *noise, size_t count, const float *x,
                                const float *y, const float *z, const struct scarp_samples *out)
{
    if (count == 0) {
        return SCARP_OK;
    }
    const void *const position[3] = {x, y, z};
    const struct sampler sampler = {scarp_dispatch_for(count)->points3_f32, 3, sizeof *x};
    return sample(sampler, noise, count, position, out);
}

enum scarp_status scarp_sample2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                    const double *y, const struct scarp_samples *out)
{
    if (count == 0) {
        return SCARP_OK;
    }
    const void *const position[3] = {x, y, NULL};
    const struct sampler sampler = {scarp_dispatch_for(count)->points2_f64, 2, sizeof *x};
    return sample(sampler, noise, count, position, out);
}

enum scarp_status scarp_sample3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                    const double *y, const double *z,
                                    const struct scarp_samples *out)
{
    if (count == 0) {
        return SCARP_OK;
    }
    const void *const position[3] = {x, y, z};
    const struct sampler sampler = {scarp_dispatch_for(count)->points3_f64, 3, sizeof *x};
    return sample(sampler, noise, count, position, out);
}

/* Largest magnitude of an index, so that it is exact in double. */
#define INDEX_MAX (INT64_C(1) << 53)

/* Whether origin, step and indices are within the documented intervals along an axis. */
static int axis_valid(const struct scarp_grid *grid, int axis)
{
    const int64_t first = grid->first[axis];
    return is_finite_f64(grid->origin[axis]) && is_finite_f64(grid->step[axis]) &&
           first >= -INDEX_MAX && first <= INDEX_MAX &&
           grid->count[axis] - 1 <= (uint64_t)(INDEX_MAX - first);
}

/* Counts the elements from the first to the last of n rows of `row` elements that are `stride`
   apart. Returns 0 if they are more than an array can have. */
static size_t extent(size_t n, size_t row, size_t stride)
{
    const size_t limit = PTRDIFF_MAX / sizeof(float);
    return row > limit || (n > 1 && stride > (limit - row) / (n - 1)) ? 0 : (n - 1) * stride + row;
}

/* Fills in the strides of a grid without empty axes, and checks it. */
static enum scarp_status grid_check(struct scarp_grid *grid, int dimensions)
{
    for (int axis = 0; axis < dimensions; axis++) {
        if (!axis_valid(grid, axis)) {
            return SCARP_ERROR_PARAMETER;
        }
    }
    if (grid->row_stride == 0) {
        grid->row_stride = grid->count[0];
    }
    const size_t slice = extent(grid->count[1], grid->count[0], grid->row_stride);
    if (grid->row_stride < grid->count[0]) {
        return SCARP_ERROR_PARAMETER;
    }
    if (slice == 0) {
        return SCARP_ERROR_SIZE;
    }
    if (dimensions == 2) {
        return SCARP_OK;
    }
    if (grid->slice_stride == 0 && grid->count[2] == 1) {
        grid->slice_stride = slice;
    }
    if (grid->slice_stride == 0) {
        if (extent(grid->count[1] + 1, 0, grid->row_stride) == 0) {
            return SCARP_ERROR_SIZE;
        }
        grid->slice_stride = grid->count[1] * grid->row_stride;
    }
    if (grid->slice_stride < slice) {
        return SCARP_ERROR_PARAMETER;
    }
    return extent(grid->count[2], slice, grid->slice_stride) == 0 ? SCARP_ERROR_SIZE : SCARP_OK;
}

static int grid_reserved_in_use(const struct scarp_grid *grid)
{
    uint32_t bits = 0;
    for (size_t i = 0; i < COUNT_OF(grid->spare); i++) {
        bits |= grid->spare[i];
    }
    return bits != 0;
}

/* A call on a grid, once its arguments are checked. */
struct grid_call {
    scarp_grid_fn *kernel;
    const struct scarp_grid *grid;
    const struct scarp_samples *out;
};

static void run_grid(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct grid_call *const call = opaque;
    call->kernel(plan, call->grid, scarp_outputs_of(call->out));
}

static enum scarp_status sample_grid(scarp_grid_fn *kernel, const struct scarp_noise *noise,
                                     int dimensions, const struct scarp_grid *described,
                                     const struct scarp_samples *out)
{
    if (noise == NULL || described == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    struct scarp_grid grid = *described;
    for (int axis = 0; axis < dimensions; axis++) {
        if (grid.count[axis] == 0) {
            return SCARP_OK;
        }
    }
    const enum scarp_status status = grid_check(&grid, dimensions);
    if (status != SCARP_OK) {
        return status;
    }
    const struct scarp_kind kind = kind_of(dimensions, out);
    if (kind.order == SCARP_UNSUPPORTED_ORDER || grid_reserved_in_use(&grid)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const struct grid_call call = {kernel, &grid, out};
    const enum scarp_status result = scarp_run(noise, kind, run_grid, &call);
    fpmode_leave(caller);
    return result;
}

enum scarp_status scarp_grid2(const struct scarp_noise *noise, const struct scarp_grid *grid,
                              const struct scarp_samples *out)
{
    return sample_grid(scarp_dispatch_active()->grid2, noise, 2, grid, out);
}

enum scarp_status scarp_grid3(const struct scarp_noise *noise, const struct scarp_grid *grid,
                              const struct scarp_samples *out)
{
    return sample_grid(scarp_dispatch_active()->grid3, noise, 3, grid, out);
}
