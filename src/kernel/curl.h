/* SPDX-License-Identifier: MIT
 *
 * Velocity from potentials, chunk by chunk: each output is a difference of two derivatives, in the
 * plane one derivative. Outputs may be where coordinates are: those of a chunk are copied before.
 * The reference is formulas/curl.h.
 */
#ifndef SCARP_KERNEL_CURL_H
#define SCARP_KERNEL_CURL_H

#include "../dispatch/kernels.h"
#include "warp.h"

/* What a component of the velocity is made of: the derivative of the potential `plus` along an
   axis, and that of `minus`, which is subtracted. -1: there is none. */
struct curl_terms {
    int plus, plus_along, minus, minus_along;
};

/* Puts plus - minus, either of which may be NULL. Derivatives are padded to whole blocks. */
static __attribute__((noinline)) void curl_put(float *to, const float *plus, const float *minus,
                                               size_t count)
{
    for (size_t at = 0; at < count; at += VEC_LANES) {
        vf v;
        if (minus == NULL) {
            v = vf_load(plus + at);
        } else if (plus == NULL) {
            v = -vf_load(minus + at);
        } else {
            v = vf_load(plus + at) - vf_load(minus + at);
        }
        if (count - at >= VEC_LANES) {
            vf_store(to + at, v);
        } else {
            vf_store_partial(to + at, v, count - at);
        }
    }
}

/* The array of an output of a potential, if there is a potential. */
static const float *curl_term(const struct warped *w, int potential, int output)
{
    return potential < 0 ? NULL : w->moved[potential].array[output];
}

/* Puts component i of the velocity, and its derivatives, of the points of a chunk. */
static void curl_component(const struct warped *w, const struct scarp_flow_arrays *out,
                           const struct chunk *chunk, int i, const struct curl_terms *terms)
{
    static const unsigned char second[3][3] = {{DXX, DXY, DXZ}, {DXY, DYY, DYZ}, {DXZ, DYZ, DZZ}};
    for (int m = -1; m < w->chunked.f.dimensions; m++) {
        float *const to = out->array[m < 0 ? FLOW_V + i : FLOW_JACOBIAN + 3 * i + m];
        const int plus = m < 0 ? DX + terms->plus_along : second[terms->plus_along][m];
        const int minus = m < 0 ? DX + terms->minus_along : second[terms->minus_along][m];
        if (to != NULL) {
            curl_put(to + chunk->at[0], curl_term(w, terms->plus, plus),
                     curl_term(w, terms->minus, minus), chunk->columns);
        }
    }
}

static void curl_components(const struct warped *w, const void *out, const struct chunk *chunk)
{
    static const struct curl_terms plane[2] = {{0, 1, -1, 0}, {-1, 0, 0, 0}};
    static const struct curl_terms solid[3] = {{2, 1, 1, 2}, {0, 2, 2, 0}, {1, 0, 0, 1}};
    const int n = w->chunked.f.dimensions;
    for (int i = 0; i < n; i++) {
        curl_component(w, out, chunk, i, n == 2 ? &plane[i] : &solid[i]);
    }
}

static void curl(const struct scarp_call_plan *plan, size_t count, const void *const position[3],
                 const struct scarp_flow_arrays *out, int dimensions, int doubles)
{
    const struct frame f = {.layout = doubles ? DOUBLES : FLOATS, .dimensions = dimensions};
    warp_components(plan, count, position, f, curl_components, out);
}

#endif
