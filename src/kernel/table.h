/* SPDX-License-Identifier: MIT
 *
 * The entries of all that is in kernel/, and the table that offers them. Each simd/kernels_<isa>.c
 * includes the vec_<isa>.h that gives the operations of simd/vec.h, and whether the set is to be
 * small (VEC_SMALL), and defines the parameters of this template, which are undefined at its end:
 *
 *     KERNELS           the name of the table
 *     KERNELS_ISA       the instruction set
 *     KERNELS_NARROWER  the table of the set with half as many lanes, if calls that fill no more
 *                       of a vector take less time there; may be left out
 *     FEW_ORDER         the highest derivative of which few points go block by block (few.h); 1
 *     ONE_BLOCKS        the most blocks of single octaves that go block by block (below); 4
 *     TILE_ROWS         the most rows of a tile of a grid (rows/along.h); 96
 *     SCRATCH_BYTES     of scratch space (driver.h); 26 KiB
 */
#include "cells.h"
#include "chain.h"
#include "curl.h"
#include "exact.h"
#include "gullies.h"
#include "normals.h"
#include "vector.h"

/* Computes points without warps, with scratch space of its own. This is out of line for the sake of
 * few points. */
static __attribute__((noinline)) void points_scratch(const struct scarp_call_plan *plan,
                                                     size_t count, const void *const position[3],
                                                     const struct scarp_outputs *out,
                                                     struct frame f)
{
    vf space[SCRATCH_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    points_unwarped(plan, count, position, out, f, work);
}

static void points_more(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out,
                        struct frame f)
{
    if (plan->warps.depth > 0) {
        warp_points(plan, count, position, out, f);
    } else {
        points_scratch(plan, count, position, out, f);
    }
}

/* The most blocks of floats for which single octaves take less time block by block than in passes.
 */
#ifndef ONE_BLOCKS
#define ONE_BLOCKS 4
#endif

VEC_INLINE void points(const struct scarp_call_plan *plan, size_t count,
                       const void *const position[3], const struct scarp_outputs *out,
                       int dimensions, enum layout layout)
{
    if (layout == FLOATS && is_value_sum(plan) && plan->octaves == 1 &&
        count <= ONE_BLOCKS * VEC_LANES) {
        few_pass *const one = few_passes[plan->basis][dimensions - 2][FEW_ONE];
        size_t first = 0;
        for (; count - first > VEC_LANES; first += VEC_LANES) {
            one(plan, first + VEC_LANES, position, out, first, layout);
        }
        one(plan, count, position, out, first, layout);
        return;
    }
    few_pass *const few = few_pass_of(plan, count, dimensions);
    if (few != NULL && !(layout == DOUBLES && turns_axes(plan) &&
                         is_far(highest_frequency(plan), count, position, dimensions))) {
        few(plan, count, position, out, 0, layout);
        return;
    }
    const struct frame f = {.layout = layout, .dimensions = dimensions};
    points_more(plan, count, position, out, f);
}

static void points2_f32(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 2, FLOATS);
}

static void points2_f64(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 2, DOUBLES);
}

static void points3_f32(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 3, FLOATS);
}

static void points3_f64(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 3, DOUBLES);
}

static __attribute__((noinline)) void grid_scratch(const struct scarp_call_plan *plan,
                                                   const struct scarp_grid *described,
                                                   const struct scarp_outputs *out, int dimensions)
{
    vf space[SCRATCH_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    grid_within(plan, described, out, dimensions, work);
}

static __attribute__((noinline)) void grid_many(const struct scarp_call_plan *plan,
                                                const struct scarp_grid *described,
                                                const struct scarp_outputs *out, int dimensions)
{
    vf space[GRID_BYTES_MANY / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    grid_within(plan, described, out, dimensions, work);
}

static void grid(const struct scarp_call_plan *plan, const struct scarp_grid *described,
                 const struct scarp_outputs *out, int dimensions)
{
    if (plan->warps.depth > 0) {
        warp_grid(plan, described, out, dimensions);
    } else if (is_flat(plan, described, dimensions)) {
        flat_grid(plan, described, out, dimensions);
    } else if (plan->octaves > SCARP_FEW_OCTAVES) {
        grid_many(plan, described, out, dimensions);
    } else {
        grid_scratch(plan, described, out, dimensions);
    }
}

static void grid2(const struct scarp_call_plan *plan, const struct scarp_grid *described,
                  const struct scarp_outputs *out)
{
    grid(plan, described, out, 2);
}

static void grid3(const struct scarp_call_plan *plan, const struct scarp_grid *described,
                  const struct scarp_outputs *out)
{
    grid(plan, described, out, 3);
}

const struct scarp_kernels KERNELS = {
    .isa = KERNELS_ISA,
    .is_exact = is_exact,
#ifdef KERNELS_NARROWER
    .narrower = &KERNELS_NARROWER,
    .narrower_most = VEC_LANES / 2,
#endif
    .points2_f32 = points2_f32,
    .points2_f64 = points2_f64,
    .points3_f32 = points3_f32,
    .points3_f64 = points3_f64,
    .grid2 = grid2,
    .grid3 = grid3,
    .normals = normals,
    .cells = cells,
    .chain = chain,
    .components = components,
    .curl = curl,
    .gullies = gullies,
};

#undef KERNELS
#undef KERNELS_ISA
#undef KERNELS_NARROWER
#undef FEW_ORDER
#undef ONE_BLOCKS
#undef TILE_ROWS
#undef SCRATCH_BYTES
