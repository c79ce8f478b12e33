/* SPDX-License-Identifier: MIT
 *
 * The public functions. They check the arguments, make the plan and call the active kernel table.
 */
#include "scarp.h"

#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/kept.h"
#include "../plan/plan.h"

#define NOINLINE __attribute__((noinline))
#define ALWAYS_INLINE inline __attribute__((always_inline))
#define TEXT(x) #x
#define VERSION_TEXT(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)
#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

/* These fix layouts, as check.c does for struct scarp_noise. Whether a 32-bit processor aligns
   doubles and int64_t to 4 or 8 bytes, a grid has the same layout. */
_Static_assert(sizeof(struct scarp_samples) == 16 * sizeof(float *) &&
                   offsetof(struct scarp_samples, dphase) == 10 * sizeof(float *),
               "struct scarp_samples has 16 pointers");
_Static_assert(sizeof(struct scarp_grid) == 192 && offsetof(struct scarp_grid, count) == 72 &&
                   offsetof(struct scarp_grid, spare) == 72 + 5 * sizeof(size_t),
               "struct scarp_grid has 192 bytes without padding");

/* Looks at the bits, since this file also runs in the caller's floating-point mode. */
static int is_finite(float value)
{
    const union {
        float value;
        uint32_t bits;
    } u = {value};
    return (u.bits & 0x7f800000u) != 0x7f800000u;
}

static int is_finite_f64(double value)
{
    const union {
        double value;
        uint64_t bits;
    } u = {value};
    const uint64_t exponent = UINT64_C(0x7ff0000000000000);
    return (u.bits & exponent) != exponent;
}

/* The arrays of `out` as a list. No other place knows them by name. */
static const struct scarp_outputs *outputs_of(const struct scarp_samples *out)
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

#define UNSUPPORTED_ORDER 3
#define MEMBERS (int)(sizeof(struct scarp_samples) / sizeof(float *))

/* What calls ask for that ask for more than values. */
static NOINLINE struct scarp_kind kind_of_more(int dimensions, const struct scarp_samples *out)
{
    struct scarp_kind kind = {dimensions, UNSUPPORTED_ORDER, out->dphase != NULL};
    if (!any_asked(out, OUTPUTS, MEMBERS) &&
        (dimensions == 3 ||
         (out->dz == NULL && out->dxz == NULL && !any_asked(out, DYZ, DPHASE)))) {
        kind.order = any_asked(out, DXX, DPHASE) ? 2 : any_asked(out, DX, DXX) ? 1 : 0;
    }
    return kind;
}

/* What is asked for; its order is UNSUPPORTED_ORDER if something does not exist. In 2D derivatives
   along z do not; reserved members never do. Most calls are decided by the first question. */
static ALWAYS_INLINE struct scarp_kind kind_of(int dimensions, const struct scarp_samples *out)
{
    const struct scarp_kind values = {.dimensions = dimensions};
    return any_asked(out, DX, MEMBERS) ? kind_of_more(dimensions, out) : values;
}

/* Makes the plan, whose octaves need some KiB of stack, and runs the kernel. */
static NOINLINE enum scarp_status run_planned(scarp_points_fn *kernel, struct scarp_kind kind,
                                              const struct scarp_noise *noise, size_t count,
                                              const void *const position[3],
                                              const struct scarp_samples *out)
{
    struct scarp_call_plan plan;
    struct scarp_octave space[SCARP_MAX_OCTAVES];
    const enum scarp_status status = scarp_plan_call(&plan, space, noise, kind);
    if (status == SCARP_OK) {
        kernel(&plan, count, position, outputs_of(out));
    }
    return status;
}

/*
 * Finds the plan and runs the kernel. It is out of line, so that none of its arithmetic
 * (comparisons trap too) can be moved across the change of floating-point mode in `sample`.
 */
static NOINLINE enum scarp_status run(scarp_points_fn *kernel, struct scarp_kind kind,
                                      const struct scarp_noise *noise, size_t count,
                                      const void *const position[3],
                                      const struct scarp_samples *out)
{
    struct scarp_call_plan plan;
    if (!plan_kept(&plan, noise, kind)) {
        return run_planned(kernel, kind, noise, count, position, out);
    }
    kernel(&plan, count, position, outputs_of(out));
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
    for (int i = 0; i < sampler.dimensions; i++) {
        if (position[i] == NULL) {
            return SCARP_ERROR_NULL;
        }
    }
    if (count > PTRDIFF_MAX / sampler.bytes) {
        return SCARP_ERROR_SIZE;
    }
    const struct scarp_kind kind = kind_of(sampler.dimensions, out);
    if (kind.order == UNSUPPORTED_ORDER) {
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

static NOINLINE enum scarp_status run_grid(scarp_grid_fn *kernel, struct scarp_kind kind,
                                           const struct scarp_noise *noise,
                                           const struct scarp_grid *grid,
                                           const struct scarp_samples *out)
{
    struct scarp_call_plan plan;
    struct scarp_octave space[SCARP_MAX_OCTAVES];
    const enum scarp_status status = scarp_plan_call(&plan, space, noise, kind);
    if (status == SCARP_OK) {
        kernel(&plan, grid, outputs_of(out));
    }
    return status;
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
    if (kind.order == UNSUPPORTED_ORDER || grid_reserved_in_use(&grid)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status result = run_grid(kernel, kind, noise, &grid, out);
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

enum scarp_status scarp_normals(size_t count, const float *dx, const float *dy, float height_scale,
                                float *nx, float *ny, float *nz)
{
    if (count == 0) {
        return SCARP_OK;
    }
    if (dx == NULL || dy == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (!is_finite(height_scale)) {
        return SCARP_ERROR_PARAMETER;
    }
    if (count > PTRDIFF_MAX / sizeof *dx) {
        return SCARP_ERROR_SIZE;
    }
    const float *const slope[2] = {dx, dy};
    float *const normal[3] = {nx, ny, nz};
    const struct fpmode caller = fpmode_enter();
    scarp_dispatch_active()->normals(count, slope, height_scale, normal);
    fpmode_leave(caller);
    return SCARP_OK;
}

/* Out of line for the same reason as `run`. */
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

/* Out of line for the same reason as `run`. */
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

/* Out of line for the same reason as `run`. */
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

const char *scarp_status_text(enum scarp_status status)
{
    switch (status) {
    case SCARP_OK: return "success";
    case SCARP_ERROR_NULL: return "a required pointer is NULL";
    case SCARP_ERROR_ENUM: return "unknown basis, fade, fractal or instruction set";
    case SCARP_ERROR_PARAMETER: return "a number is not finite or outside its interval";
    case SCARP_ERROR_SIZE: return "the arrays would exceed the address space";
    case SCARP_ERROR_UNSUPPORTED: return "this version, call or processor cannot serve the request";
    }
    return "unknown status";
}

const char *scarp_version(void)
{
    return VERSION_TEXT(SCARP_VERSION_MAJOR, SCARP_VERSION_MINOR, SCARP_VERSION_PATCH);
}

enum scarp_isa scarp_isa_active(void)
{
    return scarp_dispatch_active()->isa;
}

int scarp_isa_supported(enum scarp_isa isa)
{
    return scarp_dispatch_find(isa) != NULL;
}

enum scarp_status scarp_isa_select(enum scarp_isa isa)
{
    if ((unsigned)isa >= SCARP_ISAS) {
        return SCARP_ERROR_ENUM;
    }
    const struct scarp_kernels *const table =
        isa == SCARP_ISA_NONE ? NULL : scarp_dispatch_find(isa);
    if (isa != SCARP_ISA_NONE && table == NULL) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    scarp_dispatch_use(table);
    return SCARP_OK;
}
