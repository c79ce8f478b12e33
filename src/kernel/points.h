/* SPDX-License-Identifier: MIT
 *
 * Evaluates points of a noise that neither bends nor has warps, in tiles of at most TILE_BLOCKS
 * blocks.
 */
#ifndef SCARP_KERNEL_POINTS_H
#define SCARP_KERNEL_POINTS_H

#include "few.h"

/* The most blocks of a tile whose last block may be incomplete. */
#define PADDED_BLOCKS 8

/* Vectors of scratch space that each block of a tile takes; sums are there where octaves are added
   up. */
static size_t points_block_size(const struct passes *passes)
{
    return passes->lattice_size + passes->noise_size + passes->state_size + passes->turning_size +
           passes->moving_size + 1 + (passes->plan->octaves > 1 ? passes->sums_size : 0);
}

/* Gives the tile its share of the scratch space, for as many blocks as fit, and returns their
   number. Padded tiles have sums, too. */
static size_t divide_for_points(const struct passes *passes, struct tile *tile,
                                struct workspace work, int padded)
{
    const size_t each = points_block_size(passes);
    const int adds_sums = padded && passes->plan->octaves == 1;
    const size_t room = work.vectors - (adds_sums ? PADDED_BLOCKS * passes->sums_size : 0);
    const size_t blocks = TILE_BLOCKS * each <= room ? TILE_BLOCKS : room / each;
    tile->locations.lattice = work.space;
    tile->noise = tile->locations.lattice + blocks * passes->lattice_size;
    tile->state = tile->noise + blocks * passes->noise_size;
    tile->turning = tile->state + blocks * passes->state_size;
    tile->moving = tile->turning + blocks * passes->turning_size;
    tile->spare = tile->moving + blocks * passes->moving_size;
    tile->sums_stored = tile->spare + blocks;
    return blocks;
}

/* Computes whole blocks of points. Several octaves are added up in `sums`, since outputs may be
   where coordinates are. */
static void points_whole(const struct passes *passes, struct tile *tile, struct outputs *sums,
                         size_t count, const struct scarp_outputs *out, size_t first)
{
    struct outputs to;
    tile->locations.extent.blocks = count / VEC_LANES;
    if (passes->plan->octaves > 1) {
        tile->to = sums;
        sum_octaves(passes, tile, 1);
        copy_out(out, first, sums, 0, count);
        return;
    }
    outputs_of(&to, out, passes->plan->order, first, 0, tile->spare);
    tile->to = &to;
    sum_octaves(passes, tile, 1);
}

/* Computes at most PADDED_BLOCKS blocks, of which the last one may be incomplete. Padded copies
   make sure that nothing beyond an array is touched. The padding is 0, which raises no
   floating-point exception. */
static void points_padded(const struct passes *passes, struct tile *tile, struct outputs *sums,
                          size_t count, const struct scarp_outputs *out, size_t first)
{
    const size_t bytes = passes->layout == DOUBLES ? sizeof(double) : sizeof(float);
    const size_t blocks = (count + VEC_LANES - 1) / VEC_LANES;
    double padded[3][PADDED_BLOCKS * VEC_LANES];
    for (int d = 0; d < passes->dimensions; d++) {
        char *const copy = (char *)padded[d];
        memcpy(copy, tile->at.array[d], count * bytes);
        memset(copy + count * bytes, 0, (blocks * VEC_LANES - count) * bytes);
        tile->at.array[d] = copy;
    }
    tile->locations.extent.blocks = blocks;
    tile->to = sums;
    sum_octaves(passes, tile, 1);
    copy_out(out, first, sums, 0, count);
}

/* Begins a tile `first` points from where the call begins. */
static void tile_at(struct tile *tile, const void *const position[3], size_t first, struct frame f)
{
    const size_t bytes = f.layout == DOUBLES ? sizeof(double) : sizeof(float);
    tile->first = first / VEC_LANES;
    for (int d = 0; d < f.dimensions; d++) {
        tile->at.array[d] = (const char *)position[d] + (f.layout == MOVED ? 0 : first * bytes);
    }
}

/* Where positions are displaced, `count` is a multiple of VEC_LANES. */
static void points_many(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out,
                        struct frame f, struct workspace work)
{
    const int dimensions = f.dimensions, padded = count % VEC_LANES != 0;
    const int may_be_far = f.layout == DOUBLES && turns_axes(plan);
    const double highest = highest_frequency(plan);
    struct passes passes;
    passes_choose(&passes, plan, dimensions, f.layout);
    struct tile tile; /* the members that only grids need stay unset */
    struct outputs sums, stored, turning;
    if (f.layout == MOVED) {
        work.vectors -= moved_size(position[0]);
        tile.along = work.space + work.vectors;
    }
    tile.locations.extent.rows = 1;
    tile.locations.fade = plan->fade;
    tile.put = PUT_FIRST;
    tile.is_located = 0;
    tile.stored = &stored;
    tile.turning_stored = &turning;
    const size_t most = divide_for_points(&passes, &tile, work, padded) * VEC_LANES;
    if (plan->octaves > 1 || padded) {
        outputs_stored(&sums, tile.sums_stored, passes.sums_size, dimensions, plan->order, 0);
    }
    if (passes.noise_size > 0) {
        outputs_stored(&stored, tile.noise, passes.noise_size, dimensions, passes.basis_order, 0);
    }
    if (passes.turning_size > 0) {
        outputs_stored(&turning, tile.turning, passes.turning_size, dimensions,
                       passes.fractal->extra_order, 0);
    }
    for (size_t first = 0, here; first < count; first += here) {
        here = least(count - first, most);
        tile_at(&tile, position, first, f);
        tile.is_far = may_be_far && is_far(highest, here, tile.at.array, dimensions);
        if (here % VEC_LANES == 0 || here > PADDED_BLOCKS * VEC_LANES) {
            here -= here % VEC_LANES;
            points_whole(&passes, &tile, &sums, here, out, first);
        } else {
            points_padded(&passes, &tile, &sums, here, out, first);
        }
    }
}

/* What a block of points_values needs: its lattice, then its sum. */
#define VALUES_VECTORS (LATTICE_SIZE3 + 1)

/* Computes whole blocks of values of plain fBm with straight axes. There is little to prepare, so
   64 points take a tenth less time than with points_many(). */
static void points_values(const struct scarp_call_plan *plan, size_t count,
                          const void *const position[3], const struct scarp_outputs *out,
                          struct frame f, struct workspace work)
{
    const int dimensions = f.dimensions;
    lattice_pass *const *const passes =
        lattice_passes[corner_form_of(plan->basis)][dimensions - 2][f.layout];
    basis_pass *const pass = bases[plan->basis].points[dimensions - 2][0];
    const size_t bytes = f.layout == DOUBLES ? sizeof(double) : sizeof(float);
    const size_t most = least(TILE_BLOCKS, work.vectors / VALUES_VECTORS);
    vf *const stored = work.space + most * (VALUES_VECTORS - 1);
    struct outputs sums, to;
    struct locations locations;
    locations.lattice = work.space;
    locations.fade = plan->fade;
    locations.extent.rows = 1;
    outputs_stored(&sums, stored, 1, dimensions, 0, 0);
    for (size_t first = 0, here; first < count; first += here) {
        here = least(count - first, most * VEC_LANES);
        locations.extent.blocks = here / VEC_LANES;
        outputs_of(&to, out, 0, first, 0, stored);
        struct positions at;
        for (int d = 0; d < dimensions; d++) {
            at.array[d] = (const char *)position[d] + first * bytes;
        }
        for (int k = 0; k < plan->octaves; k++) {
            const struct scarp_octave *const o = &plan->octave[k];
            const struct weights weights = {{o->amplitude}};
            passes[axes_of(plan, k)](locations.lattice, o, locations.extent.blocks, &at);
            pass(&locations, &weights, plan->octaves > 1 ? &sums : &to,
                 k > 0 ? PUT_ADD : PUT_FIRST);
        }
        if (plan->octaves > 1) {
            copy_out(out, first, &sums, 0, here);
        }
    }
}

/* Computes points of a call that few.h does not serve as a whole: there are more, or they are warped
   or bent, octave by octave, and then few.h serves floats if they are few. It takes the remainder of
   plain fBm with straight axes, too; for all other noise, it is faster to pad the last block. */
static __attribute__((noinline)) void points_within(const struct scarp_call_plan *plan,
                                                    size_t count, const void *const position[3],
                                                    const struct scarp_outputs *out, struct frame f,
                                                    struct workspace work)
{
    few_pass *const all = f.layout == FLOATS ? few_pass_of(plan, count, f.dimensions) : NULL;
    if (all != NULL) {
        all(plan, count, position, out, 0, FLOATS);
        return;
    }
    const int is_straight = plan->fractal == SCARP_FBM && !plan->rotate;
    const int has_few = is_straight && plan->plain;
    const size_t rest = has_few && plan->order <= FEW_ORDER ? count % VEC_LANES : 0;
    if (rest > 0) {
        few_pass *const few = few_pass_of(plan, rest, f.dimensions);
        few(plan, count, position, out, count - rest, f.layout);
    }
    if (plan->order == 0 && out->array[VALUE] == NULL && !plan->dphase) {
        return;
    }
    if (is_value_sum(plan) && f.layout != MOVED) {
        points_values(plan, count - rest, position, out, f, work);
    } else {
        points_many(plan, count - rest, position, out, f, work);
    }
}

#endif
