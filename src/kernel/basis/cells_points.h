/* SPDX-License-Identifier: MIT
 *
 * The points passes of cellular noise. Passes that search alike are one function, which looks at
 * the basis and at the order once per block; few copies keep the library small.
 */
#ifndef SCARP_KERNEL_BASIS_CELLS_POINTS_H
#define SCARP_KERNEL_BASIS_CELLS_POINTS_H

#include "basis.h"
#include "cells.h"

/* What a pass does that is no constant. It is read anew for each block: gcc and clang would make
   copies of a loop for all that stays the same in it. */
struct cells_kind {
    enum scarp_basis basis;
    int order;
    enum put put;
};

/* Where the samples of a block go: `at` floats from the beginning of a row. */
struct cells_target {
    const struct outputs *outputs;
    const struct weights *weights;
    const volatile struct cells_kind *kind;
    size_t row, at;
};

VEC_INLINE void cells_put(const struct cells_target *to, const struct sample *n, struct variant v)
{
    const struct outputs *const out = to->outputs;
    const enum put put = to->kind->put;
#define PUT(i, member, rank)                                                                       \
    do {                                                                                           \
        float *const array = out->array[i] + to->row * out->row[i] + to->at;                       \
        const vf term = vf_set(to->weights->factor[rank]) * n->member;                             \
        if (put == PUT_STREAM) {                                                                   \
            vf_stream(array, term);                                                                \
        } else {                                                                                   \
            vf_store(array, put == PUT_FIRST ? term : vf_load(array) + term);                      \
        }                                                                                          \
    } while (0)
    EACH_OUTPUT(v, PUT);
#undef PUT
}

/* What is made of the features found, with derivatives up to the order of v. */
VEC_INLINE void cells_make(const struct found *found, const struct cells_target *to, float middle,
                           struct variant v)
{
    const struct sample n = v.basis == SCARP_CELL_VALUE
                                ? cell_value(found, v)
                                : distance_of(found, to->kind->basis, vf_set(middle), v);
    cells_put(to, &n, v);
}

/* Makes a sample of the features found, at any order up to that of v. */
VEC_INLINE void cells_make_any(const struct found *found, const struct cells_target *to,
                               float middle, struct variant v)
{
    const int order = to->kind->order;
    const struct variant v0 = {v.basis, v.dimensions, 0, 0}, v1 = {v.basis, v.dimensions, 1, 0};
    if (v.order == 0 || (v.basis == SCARP_CELL_VALUE && order == 0)) {
        cells_make(found, to, middle, v0);
    } else if (order == 1) {
        cells_make(found, to, middle, v1);
    } else {
        cells_make(found, to, middle, v);
    }
}

VEC_INLINE struct search search_of(struct variant v)
{
    const struct search search = {.dimensions = v.dimensions,
                                  .second = v.basis == SCARP_CELL_F2,
                                  .steps = v.order > 0 && v.basis != SCARP_CELL_VALUE,
                                  .cells = v.basis == SCARP_CELL_VALUE};
    return search;
}

VEC_INLINE void cells_run(const struct locations *at, const struct weights *weights,
                          const struct outputs *outputs, enum put put, struct variant v)
{
    const volatile struct cells_kind kind = {at->basis, at->order, put};
    const struct scarp_octave *const o = at->octave;
    const struct extent extent = at->extent;
    const vf *location = at->lattice;
    for (size_t r = 0; r < extent.rows; r++) {
        const vf *const end = location + extent.blocks * unhashed_size(v.dimensions);
        struct cells_target to = {outputs, weights, &kind, r, 0};
        for (; location < end; location += unhashed_size(v.dimensions)) {
            if (v.basis == SCARP_CELL_SOFT) {
                const struct sample n = soft_sample(location, o, v);
                cells_put(&to, &n, v);
            } else {
                const struct found found = cells_search(location, o, search_of(v));
                cells_make_any(&found, &to, o->middle, v);
            }
            to.at += outputs->block;
        }
    }
}

/* `search` is the basis that stands for all that search alike. */
#define CELLS_PASS(name, search, dimensions, order)                                                \
    static void name(const struct locations *at, const struct weights *weights,                    \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {search, dimensions, order, 0};                                   \
        cells_run(at, weights, to, put, v);                                                        \
    }
#define CELLS_PASSES(d)                                                                            \
    CELLS_PASS(nearest##d##_points0, SCARP_CELL_F1, d, 0)                                          \
    CELLS_PASS(nearest##d##_points, SCARP_CELL_F1, d, 2)                                           \
    CELLS_PASS(second##d##_points0, SCARP_CELL_F2, d, 0)                                           \
    CELLS_PASS(second##d##_points, SCARP_CELL_F2, d, 2)                                            \
    CELLS_PASS(cell##d##_points, SCARP_CELL_VALUE, d, 2)                                           \
    CELLS_PASS(soft##d##_points0, SCARP_CELL_SOFT, d, 0)                                           \
    CELLS_PASS(soft##d##_points1, SCARP_CELL_SOFT, d, 1)                                           \
    CELLS_PASS(soft##d##_points2, SCARP_CELL_SOFT, d, 2)

CELLS_PASSES(2)
CELLS_PASSES(3)

#undef CELLS_PASS
#undef CELLS_PASSES

#endif
