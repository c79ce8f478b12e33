/* SPDX-License-Identifier: MIT
 *
 * Checks the grids of calls.
 */
#include "grid.h"

#include <stddef.h>

/* This fixes the layout, as check.c does for struct scarp_noise. Whether a 32-bit processor aligns
   doubles and int64_t to 4 or 8 bytes, a grid has the same one. */
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

/* Largest magnitude of an index, so that it is exact in double. */
#define INDEX_MAX (INT64_C(1) << 53)

/* What is wrong with origin, step and indices along an axis; REFUSED_..._X stand for any axis. */
static enum scarp_refusal refused_axis(const struct scarp_grid *grid, int axis)
{
    const int64_t first = grid->first[axis];
    return !is_finite_f64(grid->origin[axis])                      ? REFUSED_ORIGIN_X
           : !is_finite_f64(grid->step[axis])                      ? REFUSED_STEP_X
           : first < -INDEX_MAX || first > INDEX_MAX               ? REFUSED_FIRST_X
           : grid->count[axis] - 1 > (uint64_t)(INDEX_MAX - first) ? REFUSED_COUNT_X
                                                                   : REFUSED_NOT;
}

/* Counts the elements from the first to the last of n rows of `row` elements that are `stride`
   apart. Returns 0 if they are more than an array can have. */
static size_t extent(size_t n, size_t row, size_t stride)
{
    const size_t limit = PTRDIFF_MAX / sizeof(float);
    return row > limit || (n > 1 && stride > (limit - row) / (n - 1)) ? 0 : (n - 1) * stride + row;
}

/* The strides of the 3D calls, of a grid whose slices have so many elements. */
static enum scarp_refusal refused_slices(struct scarp_grid *grid, size_t slice)
{
    if (grid->slice_stride == 0 && grid->count[2] == 1) {
        grid->slice_stride = slice;
    }
    if (grid->slice_stride == 0) {
        if (extent(grid->count[1] + 1, 0, grid->row_stride) == 0) {
            return REFUSED_SIZE;
        }
        grid->slice_stride = grid->count[1] * grid->row_stride;
    }
    return grid->slice_stride < slice                               ? REFUSED_SLICE_STRIDE
           : extent(grid->count[2], slice, grid->slice_stride) == 0 ? REFUSED_SIZE
                                                                    : REFUSED_NOT;
}

static enum scarp_refusal refused(struct scarp_grid *grid, int dimensions)
{
    for (int axis = 0; axis < dimensions; axis++) {
        const enum scarp_refusal why = refused_axis(grid, axis);
        if (why != REFUSED_NOT) {
            return (enum scarp_refusal)((int)why + axis);
        }
    }
    if (grid->row_stride == 0) {
        grid->row_stride = grid->count[0];
    }
    const size_t slice = extent(grid->count[1], grid->count[0], grid->row_stride);
    return grid->row_stride < grid->count[0] ? REFUSED_ROW_STRIDE
           : slice == 0                      ? REFUSED_SIZE
           : dimensions == 3                 ? refused_slices(grid, slice)
                                             : REFUSED_NOT;
}

struct scarp_fault scarpi_check_grid(struct scarp_grid *grid, int dimensions)
{
    return (struct scarp_fault){refused(grid, dimensions), 0};
}

int scarpi_grid_reserved_in_use(const struct scarp_grid *grid)
{
    uint32_t bits = 0;
    for (size_t i = 0; i < sizeof grid->spare / sizeof grid->spare[0]; i++) {
        bits |= grid->spare[i];
    }
    return bits != 0;
}

/* Makes the checks of a call on a grid, but for those of the other arguments. */
static struct scarp_fault check(const struct scarp_grid *described, int dimensions)
{
    struct scarp_grid grid = *described;
    struct scarp_fault fault = {REFUSED_NOT, 0};
    for (int axis = 0; axis < dimensions; axis++) {
        if (grid.count[axis] == 0) {
            return fault;
        }
    }
    fault = scarpi_check_grid(&grid, dimensions);
    if (fault.why == REFUSED_NOT && scarpi_grid_reserved_in_use(&grid)) {
        fault.why = REFUSED_SPARE;
    }
    return fault;
}

const char *scarp_grid_fault(const struct scarp_grid *grid, int dimensions, const char **member)
{
    struct scarp_fault fault = {REFUSED_POINTER, 0};
    if (grid != NULL) {
        fault.why = REFUSED_DIMENSIONS;
    }
    if (grid != NULL && (dimensions == 2 || dimensions == 3)) {
        fault = check(grid, dimensions);
    }
    return scarpi_fault_told(fault, member);
}
