/* SPDX-License-Identifier: MIT
 *
 * Stage 2 of bases that take places (../places.h) and find what they need from there. Such a basis
 * is a function from the place of a block to a sample, and a case in own_sample(). Where a place
 * inside the cell is NaN, every output must be. A place may be 1.
 */
#ifndef SCARP_KERNEL_BASIS_OWN_H
#define SCARP_KERNEL_BASIS_OWN_H

#include "basis.h"
#include "cells_points.h"
#include "simplex.h"

/* Does what is to be done for a row of blocks before they are sampled. */
VEC_INLINE void own_begin(vf *place, const struct scarp_octave *o, size_t blocks, struct variant v)
{
    simplex_hash_row(place, o, blocks, v.dimensions);
}

VEC_INLINE struct sample own_sample(const vf *place, const struct scarp_octave *o, struct variant v)
{
    (void)o;
    return v.dimensions == 2 ? simplex_sample2(place, v) : simplex_sample3(place, v);
}

VEC_INLINE void own_run(const struct placed *at, const struct weights *weights,
                        const struct outputs *outputs, enum put put, struct variant v)
{
    const struct weights w = *weights; /* copies: nothing that is stored can alias them */
    const struct scarp_octave o = *at->octave;
    const struct extent extent = at->extent;
    struct outputs to;
    vf *place = at->lattice;
    outputs_copy(&to, outputs, v);
    for (size_t r = 0; r < extent.rows; r++) {
        const vf *const end = place + extent.blocks * places_size(v.dimensions);
        size_t to_at = 0;
        own_begin(place, at->octave, extent.blocks, v);
        for (; place < end; place += places_size(v.dimensions)) {
            const struct sample n = own_sample(place, &o, v);
            add_sample(&to, to_at, &w, &n, v, put);
            to_at += to.block;
        }
        outputs_next_row(&to, v);
    }
}

#if VEC_SMALL
/* One function for each basis serves all orders. */
#define OWN_CALL own_any
static __attribute__((noinline)) void own_any(const struct placed *at,
                                              const struct weights *weights,
                                              const struct outputs *to, enum put put,
                                              struct variant any)
{
    if (any.dimensions == 2) {
        const struct variant v = {SCARP_SIMPLEX, 2, any.order, 0};
        own_run(at, weights, to, put, v);
    } else {
        const struct variant v = {SCARP_SIMPLEX, 3, any.order, 0};
        own_run(at, weights, to, put, v);
    }
}
#else
#define OWN_CALL own_run
#endif

#define OWN_PASS(name, basis, dimensions, order)                                                   \
    static void name(const struct placed *at, const struct weights *weights,                       \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, 0};                                    \
        OWN_CALL(at, weights, to, put, v);                                                         \
    }
#define OWN_PASSES(name, basis)                                                                    \
    OWN_PASS(name##2_points0, basis, 2, 0)                                                         \
    OWN_PASS(name##2_points1, basis, 2, 1)                                                         \
    OWN_PASS(name##2_points2, basis, 2, 2)                                                         \
    OWN_PASS(name##3_points0, basis, 3, 0)                                                         \
    OWN_PASS(name##3_points1, basis, 3, 1)                                                         \
    OWN_PASS(name##3_points2, basis, 3, 2)

OWN_PASSES(simplex, SCARP_SIMPLEX)

#undef OWN_CALL
#undef OWN_PASS
#undef OWN_PASSES

#endif
