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

enum scarp_status scarp_check_grid(struct scarp_grid *grid, int dimensions)
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

int scarp_grid_reserved_in_use(const struct scarp_grid *grid)
{
    uint32_t bits = 0;
    for (size_t i = 0; i < sizeof grid->spare / sizeof grid->spare[0]; i++) {
        bits |= grid->spare[i];
    }
    return bits != 0;
}
