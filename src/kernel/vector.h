/* SPDX-License-Identifier: MIT
 *
 * The components of vector noise. The reference is component_at() of scalar/warp.h.
 */
#ifndef SCARP_KERNEL_VECTOR_H
#define SCARP_KERNEL_VECTOR_H

#include "../dispatch/kernels.h"
#include "warp.h"

/* Copies them to the caller's arrays. */
static void give_components(const struct warped *w, const void *opaque, const struct chunk *chunk)
{
    const struct scarp_outputs *const *const out = opaque;
    for (int i = 0; i < w->chunked.f.dimensions; i++) {
        give(&w->moved[i], out[i], chunk, chunk->at[0], 0);
    }
}

static void components(const struct scarp_call_plan *plan, size_t count,
                       const void *const position[3], const struct scarp_outputs *const out[3],
                       int dimensions, int doubles)
{
    const struct frame f = {.layout = doubles ? DOUBLES : FLOATS, .dimensions = dimensions};
    warp_components(plan, count, position, f, give_components, out);
}

#endif
