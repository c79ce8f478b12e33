/* SPDX-License-Identifier: MIT
 *
 * Velocity from potentials, chunk by chunk: the derivatives of one potential after the other are
 * added to the outputs or subtracted. Each output has at most two terms, so that their order makes
 * no difference. Outputs may be where coordinates are: those of a chunk are copied before. The
 * reference, and the formulas, are in scalar/curl.h.
 */
#ifndef SCARP_KERNEL_CURL_H
#define SCARP_KERNEL_CURL_H

#include "../dispatch/kernels.h"
#include "warp.h"

/* What is done with a derivative that an output has a term of. */
struct curl_term {
    int is_first;    /* whether the output has no other term yet */
    int is_negative; /* whether it is subtracted */
    size_t first, count;
};

/* Adds a term to an output, if that is asked for. Derivatives are padded to whole blocks. */
static __attribute__((noinline)) void curl_put(float *to, const float *d,
                                               const struct curl_term *described)
{
    const struct curl_term term = *described; /* which no store can change */
    const vu sign = vu_set(term.is_negative ? 0x80000000u : 0);
    const size_t end = to == NULL ? 0 : term.first + term.count;
    for (size_t at = term.first; at < end; at += VEC_LANES, d += VEC_LANES) {
        const size_t here = least(end - at, VEC_LANES);
        vf sum = (vf)((vu)vf_load(d) ^ sign);
        if (!term.is_first) {
            sum += here == VEC_LANES ? vf_load(to + at) : vf_load_partial(to + at, here);
        }
        if (here == VEC_LANES) {
            vf_store(to + at, sum);
        } else {
            vf_store_partial(to + at, sum, here);
        }
    }
}

/* Adds the derivative of psi along an axis to component i of the velocity, and the derivatives of
   that to the Jacobian. */
static __attribute__((noinline)) void curl_along(const struct warped *w,
                                                 const struct scarp_flow_arrays *out, int i,
                                                 int axis, const struct curl_term *term)
{
    static const unsigned char second[3][3] = {{DXX, DXY, DXZ}, {DXY, DYY, DYZ}, {DXZ, DYZ, DZZ}};
    const struct scarp_outputs *const psi = &w->moved[0];
    curl_put(out->array[FLOW_V + i], psi->array[DX + axis], term);
    VEC_ROLLED_LOOP
    for (int m = 0; m < w->chunked.f.dimensions; m++) {
        curl_put(out->array[FLOW_JACOBIAN + 3 * i + m], psi->array[second[axis][m]], term);
    }
}

/* Adds potential i to component i + 1 of the velocity and subtracts it from component i + 2,
   modulo 3. The terms of potentials with lower numbers are there already. In the plane there is
   potential 2 alone. */
static void curl_add(const struct warped *w, const struct scarp_flow_arrays *out,
                     const struct chunk *chunk, int potential)
{
    const int alone = w->chunked.f.dimensions == 2, c = alone ? 2 : potential;
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    const struct curl_term plus = {alone || c < j, 0, chunk->at[0], chunk->columns};
    const struct curl_term minus = {alone || c < i, 1, chunk->at[0], chunk->columns};
    curl_along(w, out, i, j, &plus);
    curl_along(w, out, j, i, &minus);
}

static void curl(const struct scarp_call_plan *plan, size_t count, const void *const position[3],
                 const struct scarp_flow_arrays *out, int dimensions, int doubles)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    const struct frame f = {.layout = doubles ? DOUBLES : FLOATS, .dimensions = dimensions};
    struct warped w = {.chunked = {.source = {position, NULL}, .f = f, .copies = 1}};
    warped_begin(&w, plan, work);
    for (size_t first = 0; first < count; first += w.chunked.most) {
        const struct chunk chunk = {{first, 0, 0}, least(count - first, w.chunked.most), 1};
        warp_positions(&w, &chunk);
        for (int c = 0; c < (dimensions == 3 ? 3 : 1); c++) {
            warp_noise(&w, &chunk, c, &w.moved[0]);
            curl_add(&w, out, &chunk, c);
        }
    }
}

#endif
