/* SPDX-License-Identifier: MIT
 *
 * Points, a chunk of CHUNK_POINTS at a time. Included by table.h.
 *
 * Per chunk and octave there are two passes: positions to fractions and corner hashes (lattice.h),
 * and those to noise that is added to the sums (octave.h); a third one where axes are turned
 * (turn.h), and one more for fractals other than fBm (shape.h). One pass that did all would be a
 * single chain of some 25 dependent operations per block, and out-of-order windows hold only two or
 * three blocks of it: two shorter chains overlap better. Measured on Zen 5 with gcc 12 and AVX2,
 * million points per second, gradient noise 2D and 3D: one pass 870 and 400, two passes 1120 and
 * 460. (A pass over two interleaved blocks in wider vector types spills: gcc 12 takes such types
 * apart through memory.)
 */
#ifndef SCARP_KERNEL_POINTS_H
#define SCARP_KERNEL_POINTS_H

#include <string.h>

#include "../kernels.h"
#include "fractal.h"

/* All octaves of a chunk of whole blocks. The last one writes to `out`, whose rows are all there.
 */
static void chunk(const struct passes *call, size_t blocks, const void *const position[3],
                  struct scratch *scratch, const struct scarp_samples *out)
{
    const struct scarp_plan *const plan = call->plan;
    const struct scarp_samples sums = samples_of(&scratch->sums);
    static const struct source lattice = {0};
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_samples *const from = k > 0 ? &sums : NULL;
        const struct scarp_samples *const to = k == plan->octaves - 1 ? out : &sums;
        const enum axes axes = axes_of(plan, k);
        lattice_passes[call->dimensions - 2][call->doubles][axes](
            &scratch->first.lattice, &plan->octave[k], blocks, position);
        add_any(call, k, axes, &lattice, blocks, scratch, from, to);
    }
}

/* A chunk whose last block is incomplete: through padded copies, so that nothing beyond an array is
   touched. The padding is 0, which raises no floating-point exception. */
static void chunk_padded(const struct passes *call, size_t count, const void *const position[3],
                         struct scratch *scratch, const struct scarp_samples *out)
{
    const size_t bytes = call->doubles ? sizeof(double) : sizeof(float);
    const size_t blocks = (count + VEC_LANES - 1) / VEC_LANES;
    double padded[3][CHUNK_POINTS];
    const void *inputs[3] = {NULL, NULL, NULL};
    for (int d = 0; d < call->dimensions; d++) {
        char *const copy = (char *)padded[d];
        memcpy(copy, position[d], count * bytes);
        memset(copy + count * bytes, 0, (blocks * VEC_LANES - count) * bytes);
        inputs[d] = copy;
    }
    const struct scarp_samples sums = samples_of(&scratch->sums);
    chunk(call, blocks, inputs, scratch, &sums);
    copy_rows(out, &scratch->sums, 0, count);
}

static void points(const struct scarp_plan *plan, size_t count, const void *const position[3],
                   const struct scarp_samples *out, int dimensions, int doubles)
{
    const struct passes call = passes_of(plan, dimensions, doubles);
    const size_t bytes = doubles ? sizeof(double) : sizeof(float);
    struct scratch scratch;
    const struct scarp_samples spare = samples_of(&scratch.sums);
    static const struct scarp_samples none; /* all NULL */
    for (size_t first = 0; first < count; first += CHUNK_POINTS) {
        const size_t here = count - first < CHUNK_POINTS ? count - first : CHUNK_POINTS;
        const void *inputs[3] = {NULL, NULL, NULL};
        for (int d = 0; d < dimensions; d++) {
            inputs[d] = (const char *)position[d] + first * bytes;
        }
        if (here % VEC_LANES == 0) {
            const struct scarp_samples rows = rows_from(out, first, &spare);
            chunk(&call, here / VEC_LANES, inputs, &scratch, &rows);
        } else {
            const struct scarp_samples rows = rows_from(out, first, &none);
            chunk_padded(&call, here, inputs, &scratch, &rows);
        }
    }
}

static void points2_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 2, 0);
}

static void points2_f64(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 2, 1);
}

static void points3_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 3, 0);
}

static void points3_f64(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 3, 1);
}

#endif
