/* SPDX-License-Identifier: MIT
 *
 * Stage 2 of simplex noise: a pass over the unhashed locations of a tile (../unhashed.h), which
 * draws the hashes of a row first. Where a fraction is NaN, every output must be. A fraction may
 * be 1.
 */
#ifndef SCARP_KERNEL_BASIS_SIMPLEX_POINTS_H
#define SCARP_KERNEL_BASIS_SIMPLEX_POINTS_H

#include "basis.h"
#include "cells_points.h"
#include "simplex.h"

VEC_INLINE struct sample simplex_sample(const vf *location, struct variant v)
{
    return v.dimensions == 2 ? simplex_sample2(location, v) : simplex_sample3(location, v);
}

VEC_INLINE void simplex_run(const struct locations *at, const struct weights *weights,
                            const struct outputs *outputs, enum put put, struct variant v)
{
    const struct weights w = *weights; /* a copy: nothing that is stored can alias it */
    const struct extent extent = at->extent;
    struct outputs to;
    vf *location = at->lattice;
    outputs_copy(&to, outputs, v);
    for (size_t r = 0; r < extent.rows; r++) {
        const vf *const end = location + extent.blocks * unhashed_size(v.dimensions);
        size_t to_at = 0;
        simplex_hash_row(location, at->octave, extent.blocks, v.dimensions);
        for (; location < end; location += unhashed_size(v.dimensions)) {
            const struct sample n = simplex_sample(location, v);
            add_sample(&to, to_at, &w, &n, v, put);
            to_at += to.block;
        }
        outputs_next_row(&to, v);
    }
}

#if VEC_SMALL
/* One function serves all orders. */
#define SIMPLEX_CALL simplex_any
static __attribute__((noinline)) void simplex_any(const struct locations *at,
                                                  const struct weights *weights,
                                                  const struct outputs *to, enum put put,
                                                  struct variant any)
{
    if (any.dimensions == 2) {
        const struct variant v = {SCARP_SIMPLEX, 2, any.order, 0};
        simplex_run(at, weights, to, put, v);
    } else {
        const struct variant v = {SCARP_SIMPLEX, 3, any.order, 0};
        simplex_run(at, weights, to, put, v);
    }
}
#else
#define SIMPLEX_CALL simplex_run
#endif

#define SIMPLEX_PASS(name, basis, dimensions, order)                                               \
    static void name(const struct locations *at, const struct weights *weights,                    \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, 0};                                    \
        SIMPLEX_CALL(at, weights, to, put, v);                                                     \
    }
#define SIMPLEX_PASSES(name, basis)                                                                \
    SIMPLEX_PASS(name##2_points0, basis, 2, 0)                                                     \
    SIMPLEX_PASS(name##2_points1, basis, 2, 1)                                                     \
    SIMPLEX_PASS(name##2_points2, basis, 2, 2)                                                     \
    SIMPLEX_PASS(name##3_points0, basis, 3, 0)                                                     \
    SIMPLEX_PASS(name##3_points1, basis, 3, 1)                                                     \
    SIMPLEX_PASS(name##3_points2, basis, 3, 2)

SIMPLEX_PASSES(simplex, SCARP_SIMPLEX)

#undef SIMPLEX_CALL
#undef SIMPLEX_PASS
#undef SIMPLEX_PASSES

#endif
