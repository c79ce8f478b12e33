/* SPDX-License-Identifier: MIT
 *
 * Stage 2, the basis: one octave of noise at points of the lattice, times its weights, added to
 * sums. The reference is formulas/basis.h.
 *
 * A basis that reduces lattice columns to lines (columns.h) is a file with one function,
 * `struct column NAME_column(corners, across, variant)`, and a case in column_inline() and, for
 * small sets, lines of COLUMN_PASSES and a case in basis_column(). Any other is a function from a
 * block of positions on the lattice to a sample, and a case in basis_sample().
 *
 * Where a fraction is NaN, every output must be. A fraction may be 1.
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
/* A function for each basis and order computes columns, for all passes. (If one served all orders,
   gcc would copy it for some of them, as far as the size of the file permits: which ones changes
   with anything else in the file.) */
#define COLUMN_PASS(name, basis, dimensions, order, flows)                                         \
    static __attribute__((noinline)) void name(struct column *c, const struct corners *h,          \
                                               const struct across *p)                             \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, flows};                                \
        *c = column_inline(h, p, v);                                                               \
    }
#define COLUMN_PASSES(name, basis, dimensions, flows)                                              \
    COLUMN_PASS(name##_column0, basis, dimensions, 0, flows)                                       \
    COLUMN_PASS(name##_column1, basis, dimensions, 1, flows)                                       \
    COLUMN_PASS(name##_column2, basis, dimensions, 2, flows)

COLUMN_PASSES(gradient2, SCARP_GRADIENT, 2, 0)
COLUMN_PASSES(gradient3, SCARP_GRADIENT, 3, 0)
COLUMN_PASSES(flow2, SCARP_GRADIENT, 2, 1)
COLUMN_PASSES(flow3, SCARP_GRADIENT, 3, 1)
COLUMN_PASSES(value2, SCARP_VALUE, 2, 0)
COLUMN_PASSES(value3, SCARP_VALUE, 3, 0)

#undef COLUMN_PASSES
#undef COLUMN_PASS

#define COLUMN_OF_ORDER(name)                                                                      \
    (v.order == 0 ? name##_column0 : v.order == 1 ? name##_column1 : name##_column2)

VEC_INLINE struct column basis_column(const struct corners *h, const struct across *p,
                                      struct variant v)
{
    struct column c;
    const int plane = v.dimensions == 2;
    if (v.basis == SCARP_VALUE) {
        (plane ? COLUMN_OF_ORDER(value2) : COLUMN_OF_ORDER(value3))(&c, h, p);
    } else if (v.flows) {
        (plane ? COLUMN_OF_ORDER(flow2) : COLUMN_OF_ORDER(flow3))(&c, h, p);
    } else {
        (plane ? COLUMN_OF_ORDER(gradient2) : COLUMN_OF_ORDER(gradient3))(&c, h, p);
    }
    return c;
}

#undef COLUMN_OF_ORDER
#else
VEC_INLINE struct column basis_column(const struct corners *h, const struct across *p,
                                      struct variant v)
{
    return column_inline(h, p, v);
}
#endif

/* The corners of both columns of a block that is on the lattice. */
VEC_INLINE void corners_of(struct corners side[2], const vf *lattice, struct variant v)
{
    if (corner_form_of(v.basis) == CORNERS_HASHED) {
        for (int i = 0; i < 2; i++) {
            const vf *const h = lattice + v.dimensions + (i << (v.dimensions - 1));
            if (v.dimensions == 2) {
                side[i].h[0][0] = (vu)h[0], side[i].h[1][0] = (vu)h[1];
            } else {
                side[i].h[0][0] = (vu)h[0], side[i].h[0][1] = (vu)h[1];
                side[i].h[1][0] = (vu)h[2], side[i].h[1][1] = (vu)h[3];
            }
        }
        return;
    }
    const struct axis x = axis_of(lattice, 0, v.dimensions);
    const struct axis y = axis_of(lattice, 1, v.dimensions);
    for (int i = 0; i < 2; i++) {
        const vu h = i == 0 ? x.h0 : x.h1;
        if (v.dimensions == 2) {
            side[i].h[0][0] = hash_corner(h, y.h0);
            side[i].h[1][0] = hash_corner(h, y.h1);
        } else {
            const struct axis z = axis_of(lattice, 2, 3);
            side[i].h[0][0] = hash_corner3(h, y.h0, z.h0);
            side[i].h[0][1] = hash_corner3(h, y.h0, z.h1);
            side[i].h[1][0] = hash_corner3(h, y.h1, z.h0);
            side[i].h[1][1] = hash_corner3(h, y.h1, z.h1);
        }
    }
}

/* The columns on both sides of a block. */
VEC_INLINE void basis_columns(struct column c[2], const struct corners side[2],
                              const struct across *p, struct variant v)
{
    if (v.basis == SCARP_GRADIENT && v.dimensions == 2 && !VEC_SMALL && !takes_dots(p, v)) {
        struct gradients2 g[2];
        gradients2_of_both(g, &side[0], &side[1], p, v);
        c[0] = gradient_column2(g[0], p->v, v);
        c[1] = gradient_column2(g[1], p->v, v);
    } else {
        c[0] = basis_column(&side[0], p, v);
        c[1] = basis_column(&side[1], p, v);
    }
}

/* Where a block that is on the lattice lies across its columns. */
VEC_INLINE void across_of(struct across *p, const vf *lattice, enum scarp_fade kind,
                          const struct directions *directions, struct variant v)
{
    p->directions = directions;
    p->has_dots = 0;
    p->y = lattice[1];
    if (v.dimensions == 3) {
        p->z = lattice[2];
        p->w = fade(kind, p->z);
    }
    p->v = fade(kind, p->y);
}

/* The basis at a block of positions on the lattice. `directions` are for a variant that flows. */
VEC_INLINE struct sample basis_sample(const vf *lattice, enum scarp_fade kind,
                                      const struct directions *directions, struct variant v)
{
    struct across p;
    struct corners side[2];
    corners_of(side, lattice, v);
    const vf x = lattice[0];
    across_of(&p, lattice, kind, directions, v);
    struct column c[2];
    basis_columns(c, side, &p, v);
    return join(&c[0], &c[1], x, fade(kind, x), v);
}

/* Where the samples of a tile lie on the lattice of an octave. */
struct locations {
    vf *lattice;
    struct extent extent;
    enum scarp_fade fade;
    const float *turn;                 /* of the octave, or its derivative; for passes that flow */
    const struct scarp_octave *octave; /* for passes that take unhashed locations */
    enum scarp_basis basis;            /* for passes that serve several */
    int order;                         /* for passes that serve several: the highest derivative */
    int component, component_end;      /* for passes of components: the first, and before which */
};

/* Adds weights * basis to `to`, or puts it there, for every output of the variant. */
typedef void basis_pass(const struct locations *at, const struct weights *weights,
                        const struct outputs *to, enum put put);

/* `fade` is at->fade; a constant where the pass has a loop for each. */
VEC_INLINE void basis_run(const struct locations *at, enum scarp_fade fade,
                          const struct weights *weights, const struct outputs *outputs,
                          enum put put, struct variant v)
{
    const struct weights w = *weights; /* copies: nothing that is stored can alias them */
    const struct extent extent = at->extent;
    struct outputs to;
    struct directions directions;
    const vf *lattice = at->lattice;
    const size_t size = lattice_size(v.dimensions);
    outputs_copy(&to, outputs, v);
    if (v.flows) { /* nothing that is stored can alias a copy */
        struct directions made;
        (v.dimensions == 2 ? turn_directions2 : turn_directions3)(&made, at->turn);
        for (int axis = 0; axis < v.dimensions; axis++) {
            directions.of[axis] = made.of[axis];
        }
    }
    for (size_t r = 0; r < extent.rows; r++) {
        const vf *const end = lattice + extent.blocks * size;
        size_t to_at = 0;
        for (; lattice < end; lattice += size) {
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

#define BASIS_PASS(name, basis, dimensions, order, flows)                                          \
    static void name(const struct locations *at, const struct weights *weights,                    \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, flows};                                \
        if (!loop_for_each_fade(v)) {                                                              \
            basis_run(at, at->fade, weights, to, put, v);                                          \
        } else if (at->fade == SCARP_QUINTIC) {                                                    \
            basis_run(at, SCARP_QUINTIC, weights, to, put, v);                                     \
        } else {                                                                                   \
            basis_run(at, SCARP_CUBIC, weights, to, put, v);                                       \
        }                                                                                          \
    }
#define BASIS_PASSES(name, basis, flows)                                                           \
    BASIS_PASS(name##2_points0, basis, 2, 0, flows)                                                \
    BASIS_PASS(name##2_points1, basis, 2, 1, flows)                                                \
    BASIS_PASS(name##2_points2, basis, 2, 2, flows)                                                \
    BASIS_PASS(name##3_points0, basis, 3, 0, flows)                                                \
    BASIS_PASS(name##3_points1, basis, 3, 1, flows)                                                \
    BASIS_PASS(name##3_points2, basis, 3, 2, flows)

BASIS_PASSES(gradient, SCARP_GRADIENT, 0)
BASIS_PASSES(flow, SCARP_GRADIENT, 1)
BASIS_PASSES(value, SCARP_VALUE, 0)

#undef BASIS_PASS
#undef BASIS_PASSES

#endif
