/* SPDX-License-Identifier: MIT
 *
 * The public function that makes normals of slopes.
 */
#include <stddef.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "scarp.h"

/* Looks at the bits, since it runs in the caller's floating-point mode. */
static int is_finite(float value)
{
    const union {
        float value;
        uint32_t bits;
    } u = {value};
    return (u.bits & 0x7f800000u) != 0x7f800000u;
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
    const struct scarp_kernels *const kernels = scarpi_dispatch_active();
    if (kernels == NULL) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const float *const slope[2] = {dx, dy};
    float *const normal[3] = {nx, ny, nz};
    const struct fpmode caller = fpmode_enter();
    kernels->normals(count, slope, height_scale, normal);
    fpmode_leave(caller);
    return SCARP_OK;
}
