/* SPDX-License-Identifier: MIT
 *
 * Unit normals from gradients: (-s dx, -s dy, 1) / length, in double. The reference is `normals` in
 * scalar/table.c.
 */
#ifndef SCARP_KERNEL_NORMALS_H
#define SCARP_KERNEL_NORMALS_H

#include <string.h>

#include "../dispatch/kernels.h"

struct normal {
    vd x, y, z;
};

/* The products of floats are exact in double and their squares do not overflow. 1 / length is
   length / length^2, so that infinite inputs give NaN. */
VEC_INLINE struct normal normal_of(vd dx, vd dy, vd s)
{
    const vd x = s * dx;
    const vd y = s * dy;
    const vd squares = x * x + y * y + 1.0;
    const vd inverse = vd_sqrt(squares) / squares;
    const struct normal n = {x * inverse, y * inverse, inverse};
    return n;
}

/* `count` is a multiple of VEC_LANES. */
static void normals_run(size_t count, const float *const slope[2], float height_scale,
                        float *const normal[3])
{
    const float *const dx = slope[0], *const dy = slope[1];
    float *const nx = normal[0], *const ny = normal[1], *const nz = normal[2];
    const vd s = vd_set(-(double)height_scale);
    for (size_t i = 0; i < count; i += VEC_LANES) {
        const vf x = vf_load(dx + i);
        const vf y = vf_load(dy + i);
        const struct normal low = normal_of(vd_from_low(x), vd_from_low(y), s);
        const struct normal high = normal_of(vd_from_high(x), vd_from_high(y), s);
        if (nx != NULL) {
            vf_store(nx + i, vf_from_vd(low.x, high.x));
        }
        if (ny != NULL) {
            vf_store(ny + i, vf_from_vd(low.y, high.y));
        }
        if (nz != NULL) {
            vf_store(nz + i, vf_from_vd(low.z, high.z));
        }
    }
}

static void normals(size_t count, const float *const slope[2], float height_scale,
                    float *const normal[3])
{
    const size_t tail = count % VEC_LANES;
    const size_t done = count - tail;
    normals_run(done, slope, height_scale, normal);
    if (tail == 0) {
        return;
    }
    float in[2][VEC_LANES] = {{0}};
    float results[3][VEC_LANES];
    const float *const padded[2] = {in[0], in[1]};
    float *const to[3] = {results[0], results[1], results[2]};
    memcpy(in[0], slope[0] + done, tail * sizeof(float));
    memcpy(in[1], slope[1] + done, tail * sizeof(float));
    normals_run(VEC_LANES, padded, height_scale, to);
    for (int i = 0; i < 3; i++) {
        if (normal[i] != NULL) {
            memcpy(normal[i] + done, results[i], tail * sizeof(float));
        }
    }
}

#endif
