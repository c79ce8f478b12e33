/* SPDX-License-Identifier: MIT
 *
 * Stage 2, the basis: one octave of noise at points of the lattice, times its weights, added to
 * sums. Included by ../rows/along.h and ../shape/turn.h; the reference is scalar/basis.h.
 *
 * A basis that reduces lattice columns to lines (columns.h) is a file with one function,
 * `struct column NAME_column(corners, across, variant)`, and a case in column_inline() and, for
 * small sets, a line of COLUMN_PASSES and a case in basis_column(). Any other is a function from a
 * block of positions on the lattice to a sample, and a case in basis_sample().
 *
 * Where a place inside the cell is NaN, every output must be. A place may be 1.
 */
#ifndef SCARP_KERNEL_BASIS_H
#define SCARP_KERNEL_BASIS_H

#include "gradient.h"
#include "value.h"

VEC_INLINE struct column column_inline(const struct corners *h, const struct across *p,
                                       struct variant v)
{
    return v.basis == SCARP_GRADIENT ? gradient_column(h, p, v) : value_column(h, p, v);
}

#if VEC_SMALL
/* One function for each basis and order computes its columns, for all passes. (Of one function for
   all orders gcc makes clones for each, as long as the unit has not grown too much by clones.) */
typedef void column_fn(struct column *c, const struct corners *h, const struct across *p);

#define COLUMN_PASS(name, basis, dimensions, order, flows)                                         \
    static __attribute__((noinline)) void name(struct column *c, const struct corners *h,          \
                                               const struct across *p)                             \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, flows};                                \
        *c = column_inline(h, p, v);                                                               \
    }
#define COLUMN_PASSES(name, basis, d, flows)                                                       \
    COLUMN_PASS(name##d##_column0, basis, d, 0, flows)                                             \
    COLUMN_PASS(name##d##_column1, basis, d, 1, flows)                                             \
    COLUMN_PASS(name##d##_column2, basis, d, 2, flows)
#define COLUMN_OF(name, d, order)                                                                  \
    ((order) == 0 ? name##d##_column0 : (order) == 1 ? name##d##_column1 : name##d##_column2)

COLUMN_PASSES(gradient, SCARP_GRADIENT, 2, 0)
COLUMN_PASSES(gradient, SCARP_GRADIENT, 3, 0)
COLUMN_PASSES(flow, SCARP_GRADIENT, 2, 1)
COLUMN_PASSES(flow, SCARP_GRADIENT, 3, 1)
COLUMN_PASSES(value, SCARP_VALUE, 2, 0)
COLUMN_PASSES(value, SCARP_VALUE, 3, 0)

VEC_INLINE column_fn *column_of(struct variant v)
{
    const int plane = v.dimensions == 2;
    if (v.basis == SCARP_VALUE) {
        return plane ? COLUMN_OF(value, 2, v.order) : COLUMN_OF(value, 3, v.order);
    }
    if (v.flows) {
        return plane ? COLUMN_OF(flow, 2, v.order) : COLUMN_OF(flow, 3, v.order);
    }
    return plane ? COLUMN_OF(gradient, 2, v.order) : COLUMN_OF(gradient, 3, v.order);
}

#undef COLUMN_OF
#undef COLUMN_PASSES
#undef COLUMN_PASS

VEC_INLINE struct column basis_column(const struct corners *h, const struct across *p,
                                      struct variant v)
{
    struct column c;
    column_of(v)(&c, h, p);
    return c;
}
#else
VEC_INLINE struct column basis_column(const struct corners *h, const struct across *p,
                                      struct variant v)
{
    return column_inline(h, p, v);
}
#endif

VEC_INLINE struct corners corners2(const struct lattice2 *at, int side)
{
    const struct corners h = {{{(vu)at->hash[side][0]}, {(vu)at->hash[side][1]}}};
    return h;
}

VEC_INLINE struct corners corners3(const struct lattice3 *at, int side)
{
    const struct corners h = {{{(vu)at->hash[side][0][0], (vu)at->hash[side][0][1]},
                               {(vu)at->hash[side][1][0], (vu)at->hash[side][1][1]}}};
    return h;
}

/* The basis at a block of positions on the lattice. `directions` are for a variant that flows. */
VEC_INLINE struct sample basis_sample(const vf *lattice, enum scarp_fade kind,
                                      const struct directions *directions, struct variant v)
{
    struct across p;
    p.directions = directions;
    struct corners left, right;
    vf x;
    if (v.dimensions == 2) {
        const struct lattice2 *const at = (const struct lattice2 *)lattice;
        x = at->t[0];
        p.y = at->t[1];
        left = corners2(at, 0);
        right = corners2(at, 1);
    } else {
        const struct lattice3 *const at = (const struct lattice3 *)lattice;
        x = at->t[0];
        p.y = at->t[1];
        p.z = at->t[2];
        p.w = fade(kind, p.z);
        left = corners3(at, 0);
        right = corners3(at, 1);
    }
    p.v = fade(kind, p.y);
    struct column l, r;
    if (v.basis == SCARP_GRADIENT && v.dimensions == 2 && !VEC_SMALL) {
        struct gradients2 g[2];
        gradients2_of_both(g, &left, &right, &p, v);
        l = gradient_column2(g[0], &p, v);
        r = gradient_column2(g[1], &p, v);
    } else {
        l = basis_column(&left, &p, v);
        r = basis_column(&right, &p, v);
    }
    return join(&l, &r, x, fade(kind, x), v);
}

/* Positions on the lattice of an octave. */
struct placed {
    vf *lattice;
    struct extent extent;
    enum scarp_fade fade;
    const float *turn;                 /* of the octave, or its derivative; for passes that flow */
    const struct scarp_octave *octave; /* for passes that take places */
    enum scarp_basis basis;            /* for passes that serve several */
    int order;                         /* for passes that serve several: the highest derivative */
};

/* Adds weights * basis to `to`, or puts it there, for every output of the variant. */
typedef void points_pass(const struct placed *at, const struct weights *weights,
                         const struct outputs *to, enum put put);

/* `fade` is at->fade; a constant where the pass has a loop for each. */
VEC_INLINE void points_run(const struct placed *at, enum scarp_fade fade,
                           const struct weights *weights, const struct outputs *outputs,
                           enum put put, struct variant v)
{
    const struct weights w = *weights; /* copies: nothing that is stored can alias them */
    const struct extent extent = at->extent;
    struct outputs to;
    struct directions directions;
    const vf *lattice = at->lattice;
    outputs_copy(&to, outputs, v);
    if (v.flows) { /* nothing that is stored can alias a copy */
        struct directions made;
        turn_directions(&made, at->turn, v.dimensions);
        for (int axis = 0; axis < v.dimensions; axis++) {
            directions.of[axis] = made.of[axis];
        }
    }
    for (size_t r = 0; r < extent.rows; r++) {
        const vf *const end = lattice + extent.blocks * lattice_size(v.dimensions);
        size_t to_at = 0;
        for (; lattice < end; lattice += lattice_size(v.dimensions)) {
            const struct sample n = basis_sample(lattice, fade, &directions, v);
            add_sample(&to, to_at, &w, &n, v, put);
            to_at += to.block;
        }
        outputs_next_row(&to, v);
    }
}

/* Whether a pass has a loop for each fade. Where it has not, a branch at each block takes no time
   (gcc 12, all sets): for gradients in the plane, for derivatives of those that flow, and for
   Hessians of value noise in space. */
VEC_INLINE int loop_for_each_fade(struct variant v)
{
    if (VEC_SMALL) {
        return 0;
    }
    if (v.basis == SCARP_VALUE) {
        return v.dimensions == 2 || v.order < 2;
    }
    return v.dimensions == 3 && (v.order == 0 || !v.flows);
}

#define POINTS_PASS(name, basis, dimensions, order, flows)                                         \
    static void name(const struct placed *at, const struct weights *weights,                       \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, flows};                                \
        if (!loop_for_each_fade(v)) {                                                              \
            points_run(at, at->fade, weights, to, put, v);                                         \
        } else if (at->fade == SCARP_QUINTIC) {                                                    \
            points_run(at, SCARP_QUINTIC, weights, to, put, v);                                    \
        } else {                                                                                   \
            points_run(at, SCARP_CUBIC, weights, to, put, v);                                      \
        }                                                                                          \
    }
#define POINTS_PASSES(name, basis, flows)                                                          \
    POINTS_PASS(name##2_points0, basis, 2, 0, flows)                                               \
    POINTS_PASS(name##2_points1, basis, 2, 1, flows)                                               \
    POINTS_PASS(name##2_points2, basis, 2, 2, flows)                                               \
    POINTS_PASS(name##3_points0, basis, 3, 0, flows)                                               \
    POINTS_PASS(name##3_points1, basis, 3, 1, flows)                                               \
    POINTS_PASS(name##3_points2, basis, 3, 2, flows)

POINTS_PASSES(gradient, SCARP_GRADIENT, 0)
POINTS_PASSES(flow, SCARP_GRADIENT, 1)
POINTS_PASSES(value, SCARP_VALUE, 0)

#undef POINTS_PASS
#undef POINTS_PASSES

#endif
