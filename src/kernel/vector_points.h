/* SPDX-License-Identifier: MIT
 *
 * Computes all components of vector noise at points, from one pass over the lattice for each
 * octave. basis/components.h says what components draw.
 */
#ifndef SCARP_KERNEL_VECTOR_POINTS_H
#define SCARP_KERNEL_VECTOR_POINTS_H

#include "points.h"

/* Whether components are computed at once. Octaves that bend look at other positions for each
   component. The derivative with respect to the phase is rare. */
static int shares_lattice_pass(const struct scarp_call_plan *plan)
{
    return components_share_lattice(plan->basis) && !fractal_bends(plan->fractal) && !plan->dphase;
}

/* A tile of all components. What a fractal keeps between octaves is apart for each, `state` vectors
   of it. */
struct vector_tile {
    struct tile tile;
    struct outputs to[3];
    size_t state;
    basis_pass *pass; /* of all components; NULL: none */
};

/* Gives the tile its share of the scratch space, for as many blocks as fit, and returns their
   number. */
static size_t divide_for_vector(const struct passes *passes, struct vector_tile *vector,
                                struct workspace work)
{
    struct tile *const tile = &vector->tile;
    const size_t states = (size_t)passes->dimensions * passes->state_size;
    const size_t each = passes->lattice_size + passes->noise_size + states + 1;
    const size_t blocks = least(TILE_BLOCKS, work.vectors / each);
    tile->locations.lattice = work.space;
    tile->noise = tile->locations.lattice + blocks * passes->lattice_size;
    tile->state = tile->noise + blocks * passes->noise_size;
    tile->spare = tile->state + blocks * states;
    return blocks;
}

/* Adds octave k of all components. */
static void add_vector_octave(const struct passes *passes, struct vector_tile *vector, int k)
{
    struct tile *const tile = &vector->tile;
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const int n = passes->dimensions, is_gradient = passes->plan->basis == SCARP_GRADIENT;
    vf *const state = tile->state;
    tile->locations.octave = o;
    tile->locations.turn = o->turn;
    tile->locations.component = 0;
    tile->locations.component_end = n;
    locate_tile(passes, tile, k);
    if (vector->pass != NULL && !is_stored(passes, k)) {
        const struct weights weights = {{o->amplitude, o->slope, o->curvature}};
        vector->pass(&tile->locations, &weights, vector->to, k > 0 ? PUT_ADD : PUT_FIRST);
        return;
    }
    for (int i = 0; i < n; i++) {
        if (i > 0 && is_gradient) {
            tile_next_component(passes, tile);
        }
        tile->locations.component = i;
        tile->locations.component_end = i + 1;
        tile->state = state + (size_t)i * vector->state;
        add_octave(passes, tile, k, &vector->to[i]);
    }
    tile->state = state;
}

/* Computes whole blocks of points. `out` has the outputs of each component, which are not where
   coordinates are. */
static __attribute__((noinline)) void vector_points(const struct scarp_call_plan *plan,
                                                    size_t count, const void *const position[3],
                                                    const struct scarp_outputs *out, struct frame f,
                                                    struct workspace work)
{
    const int n = f.dimensions;
    struct passes passes;
    struct vector_tile vector; /* the members that only grids need stay unset */
    struct tile *const tile = &vector.tile;
    struct outputs stored;
    passes_choose(&passes, plan, n, f.layout);
    if (f.layout == MOVED) {
        work.vectors -= moved_size(position[0]);
        tile->along = work.space + work.vectors;
    }
    vector.pass = plan->flows ? NULL : components_passes[plan->basis][n - 2][passes.basis_order];
    if (plan->basis == SCARP_VALUE) {
        passes.basis_pass = vector.pass;
    }
    tile->locations.extent.rows = 1;
    tile->locations.fade = plan->fade;
    tile->locations.basis = plan->basis;
    tile->locations.order = passes.basis_order;
    tile->put = PUT_FIRST;
    tile->is_located = 1;
    tile->stored = &stored;
    const size_t most = divide_for_vector(&passes, &vector, work) * VEC_LANES;
    const int may_be_far = f.layout == DOUBLES && turns_axes(plan);
    const double highest = highest_frequency(plan);
    if (passes.noise_size > 0) {
        outputs_stored(&stored, tile->noise, passes.noise_size, n, passes.basis_order, 0);
    }
    for (size_t first = 0, here; first < count; first += here) {
        here = least(count - first, most);
        tile->locations.extent.blocks = here / VEC_LANES;
        vector.state = tile->locations.extent.blocks * passes.state_size;
        tile_at(tile, position, first, f);
        for (int i = 0; i < n; i++) {
            outputs_of(&vector.to[i], &out[i], plan->order, first, 0, tile->spare);
        }
        tile->is_far = may_be_far && is_far(highest, here, tile->at.array, n);
        if (passes.state_size > 0) {
            state_begin(plan, tile->state, passes.state_size,
                        (size_t)n * tile->locations.extent.blocks);
        }
        for (int k = 0; k < plan->octaves; k++) {
            add_vector_octave(&passes, &vector, k);
        }
    }
}

#endif
