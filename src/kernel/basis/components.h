/* SPDX-License-Identifier: MIT
 *
 * The components of vector noise, which draw from one hash of each corner. What a component draws
 * is what noise with one component draws of another hash, which is made here: so everything that
 * takes hashes serves components. The reference is formulas/lattice.h.
 *
 * One pass makes all components of an octave: cells, fractions, hashes and fades are theirs in
 * common. Passes are for noise that is added to the outputs as it is. Gradient noise that is shaped
 * or turned before, flows or has a Hessian takes the passes of one component, with the hashes on
 * the lattice moved on from one component to the next. Value noise makes its hashes in its passes,
 * so these serve single components, too.
 */
#ifndef SCARP_KERNEL_BASIS_COMPONENTS_H
#define SCARP_KERNEL_BASIS_COMPONENTS_H

#include "basis.h"

/* Moves the hashes on the lattice of gradient noise on to the next component. Gradients are chosen
   by the top of a hash, so that is the same step for each. */
VEC_INLINE void next_component(vf *lattice, size_t blocks, int dimensions)
{
    const struct variant v = {SCARP_GRADIENT, dimensions, 0, 0};
    const size_t size = lattice_size(dimensions);
    for (vf *const end = lattice + blocks * size; lattice < end; lattice += size) {
        for (size_t i = (size_t)dimensions; i < size; i++) {
            lattice[i] = (vf)component_hash((vu)lattice[i], 1, v);
        }
    }
}

static __attribute__((noinline)) void next_component2(vf *lattice, size_t blocks)
{
    next_component(lattice, blocks, 2);
}

static __attribute__((noinline)) void next_component3(vf *lattice, size_t blocks)
{
    next_component(lattice, blocks, 3);
}

/* A block, and what its components have in common besides a struct across. */
struct shared_block {
    struct corners side[2];
    vf x;
    struct fade u;
};

VEC_INLINE struct sample component_sample(const struct shared_block *block, const struct across *p,
                                          int i, struct variant v)
{
    const struct corners drawn[2] = {component_corners(&block->side[0], i, v),
                                     component_corners(&block->side[1], i, v)};
    struct column c[2];
    basis_columns(c, drawn, p, v);
    return join(&c[0], &c[1], block->x, block->u, v);
}

/* Whether the loop over components is spelled out: where that takes 2 to 6 % less time (Zen 4) and
   little more code. */
VEC_INLINE int spells_out_components(struct variant v)
{
    return !VEC_SMALL &&
           (v.dimensions == 2 ? v.order < 2 : v.basis == SCARP_GRADIENT && v.order == 0);
}

/* Adds weights * basis of the components at->component to before at->component_end to outputs[0]
   and so on, or puts it there, along one row. Of gradient noise these are all components. */
VEC_INLINE void components_run(const struct locations *at, const struct weights *weights,
                               const struct outputs *outputs, enum put put, struct variant v)
{
    const struct weights w = *weights; /* copies: nothing that is stored can alias them */
    const int first = at->component, end = at->component_end;
    const int is_whole = v.basis == SCARP_GRADIENT || end - first > 1;
    const enum scarp_fade kind = at->fade;
    const size_t size = lattice_size(v.dimensions), step = outputs->block;
    const vf *lattice = at->lattice, *const last = lattice + at->extent.blocks * size;
    for (size_t to = 0; lattice < last; lattice += size, to += step) {
        struct shared_block block;
        struct across p;
        block.x = lattice[0];
        block.u = fade(kind, block.x);
        across_of(&p, lattice, kind, NULL, v);
        corners_of(block.side, lattice, v);
        if (spells_out_components(v) && is_whole) {
            const struct sample x = component_sample(&block, &p, 0, v);
            add_sample(&outputs[0], to, &w, &x, v, put);
            const struct sample y = component_sample(&block, &p, 1, v);
            add_sample(&outputs[1], to, &w, &y, v, put);
            if (v.dimensions == 3) {
                const struct sample z = component_sample(&block, &p, 2, v);
                add_sample(&outputs[2], to, &w, &z, v, put);
            }
            continue;
        }
        for (int i = first; i < end; i++) {
            const struct sample n = component_sample(&block, &p, i, v);
            add_sample(&outputs[i - first], to, &w, &n, v, put);
        }
    }
}

#define COMPONENTS_PASS(name, basis, dimensions, order)                                            \
    static void name(const struct locations *at, const struct weights *weights,                    \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, 0};                                    \
        components_run(at, weights, to, put, v);                                                   \
    }
COMPONENTS_PASS(value2_components0, SCARP_VALUE, 2, 0)
COMPONENTS_PASS(value2_components1, SCARP_VALUE, 2, 1)
COMPONENTS_PASS(value2_components2, SCARP_VALUE, 2, 2)
COMPONENTS_PASS(value3_components0, SCARP_VALUE, 3, 0)
COMPONENTS_PASS(value3_components1, SCARP_VALUE, 3, 1)
COMPONENTS_PASS(value3_components2, SCARP_VALUE, 3, 2)
#if !VEC_SMALL
COMPONENTS_PASS(gradient2_components0, SCARP_GRADIENT, 2, 0)
COMPONENTS_PASS(gradient2_components1, SCARP_GRADIENT, 2, 1)
COMPONENTS_PASS(gradient3_components0, SCARP_GRADIENT, 3, 0)
COMPONENTS_PASS(gradient3_components1, SCARP_GRADIENT, 3, 1)
#endif
#undef COMPONENTS_PASS

/* By [basis][dimensions - 2][order]. NULL: components go through the passes of one. */
static basis_pass *const components_passes[][2][3] = {
#if VEC_SMALL
    [SCARP_GRADIENT] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}},
#else
    [SCARP_GRADIENT] = {{gradient2_components0, gradient2_components1, NULL},
                        {gradient3_components0, gradient3_components1, NULL}},
#endif
    [SCARP_VALUE] = {{value2_components0, value2_components1, value2_components2},
                     {value3_components0, value3_components1, value3_components2}},
};

_Static_assert(sizeof components_passes / sizeof components_passes[0] == SCARP_SIMPLEX,
               "each basis whose components share a lattice has its lines");

/* Computes a component of value noise along all rows of a tile, with lattices of `size` vectors. */
static __attribute__((noinline)) void component_rows(basis_pass *pass, const struct locations *at,
                                                     const struct weights *weights,
                                                     const struct outputs *outputs, enum put put,
                                                     size_t size)
{
    struct locations row = *at;
    struct outputs to = *outputs;
    row.extent.rows = 1;
    for (size_t r = 0; r < at->extent.rows; r++) {
        pass(&row, weights, &to, put);
        row.lattice += at->extent.blocks * size;
        outputs_move(&to, at->order, 1);
    }
}

#endif
