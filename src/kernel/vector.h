/* SPDX-License-Identifier: MIT
 *
 * The components of vector noise, chunk by chunk. Outputs may be where coordinates are: those of a
 * chunk are copied before. The reference is component_at() of scalar/warp.h.
 */
#ifndef SCARP_KERNEL_VECTOR_H
#define SCARP_KERNEL_VECTOR_H

#include "../dispatch/kernels.h"
#include "warp.h"

static void components(const struct scarp_call_plan *plan, size_t count,
                       const void *const position[3], const struct scarp_outputs *const out[3],
                       int dimensions, int doubles)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    const struct frame f = {.layout = doubles ? DOUBLES : FLOATS, .dimensions = dimensions};
    struct warped w = {.chunked = {.source = {position, NULL}, .f = f, .copies = 1}};
    warped_begin(&w, plan, work);
    for (size_t first = 0; first < count; first += w.chunked.most) {
        const struct chunk chunk = {{first, 0, 0}, least(count - first, w.chunked.most), 1};
        warp_positions(&w, &chunk);
        for (int i = 0; i < dimensions && plan->dphase; i++) {
            w.moved[i].array[DPHASE] = w.dphase + (size_t)i * w.chunked.most;
        }
        warp_noise(&w, &chunk, w.moved);
        for (int i = 0; i < dimensions; i++) {
            give(&w.moved[i], out[i], &chunk, first, 0);
            w.moved[i].array[DPHASE] = NULL;
        }
    }
}

#endif
