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
#include "shape.h"

static struct scarp_samples samples_of(struct rows *rows)
{
    float *r[ROWS];
    for (int i = 0; i < ROWS; i++) {
        r[i] = (float *)rows->row[i];
    }
    const struct scarp_samples s = {r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], r[9]};
    return s;
}

/* A call, as all chunks see it. */
struct points_call {
    const struct scarp_plan *plan;
    int dimensions, doubles;
    octave_pass *octave;
    turn_pass *turn;   /* NULL where no derivatives are to be turned */
    shape_pass *shape; /* NULL for fBm */
};

static struct points_call call_of(const struct scarp_plan *plan, int dimensions, int doubles)
{
    const int erosion = plan->fractal == SCARP_EROSION;
    struct points_call call = {.plan = plan, .dimensions = dimensions, .doubles = doubles};
    call.octave = octave_passes[dimensions - 2][plan->basis][plan->order + erosion];
    if (plan->rotate && plan->order > 0 && !erosion) {
        call.turn = turn_passes[dimensions - 2][plan->order - 1];
    }
    if (plan->fractal != SCARP_FBM) {
        call.shape = shape_passes[plan->fractal - 1][dimensions - 2][plan->order];
    }
    return call;
}

/* Where the passes of a chunk leave their results. */
struct scratch {
    union {
        struct lattice lattice;
        struct rows turned; /* after the pass that reads the lattice */
    } first;
    struct rows raw;
    union state state;
    struct rows sums;
};

/* to = from + an octave of fBm, from the lattice in `scratch`. */
static void add_octave(const struct points_call *call, const struct scarp_octave *o, enum axes axes,
                       size_t blocks, struct scratch *scratch, const struct rows *from,
                       const struct scarp_samples *to)
{
    static const struct weights unit = {1.0f, 1.0f, 1.0f};
    const struct weights weights = {o->amplitude, o->slope, o->curvature};
    const enum scarp_fade fade = call->plan->fade;
    if (axes == AXES_TURNED && call->turn != NULL) {
        const struct scarp_samples raw = samples_of(&scratch->raw);
        call->octave(&scratch->first.lattice, blocks, fade, &unit, NULL, &raw);
        call->turn(o, blocks, &scratch->raw, from, to);
    } else {
        call->octave(&scratch->first.lattice, blocks, fade, &weights, from, to);
    }
}

/* The same for the other fractals. */
static void add_shaped(const struct points_call *call, const struct scarp_octave *o, enum axes axes,
                       size_t blocks, struct scratch *scratch, const struct rows *from,
                       const struct scarp_samples *to)
{
    const struct rows *n = &scratch->raw;
    if (call->plan->fractal == SCARP_EROSION) {
        const struct weights own = {o->amplitude, o->amplitude, o->amplitude};
        const struct scarp_samples raw = samples_of(&scratch->raw);
        call->octave(&scratch->first.lattice, blocks, call->plan->fade, &own, NULL, &raw);
    } else {
        const int turned = axes == AXES_TURNED && call->turn != NULL;
        n = turned ? &scratch->first.turned : &scratch->raw;
        const struct scarp_samples rows =
            samples_of(turned ? &scratch->first.turned : &scratch->raw);
        add_octave(call, o, axes, blocks, scratch, NULL, &rows);
    }
    call->shape(call->plan, o, axes, blocks, n, &scratch->state, from, to);
}

/* All octaves of a chunk of whole blocks. The last one writes to `out`, whose rows are all there.
 */
static void chunk(const struct points_call *call, size_t blocks, const void *const position[3],
                  struct scratch *scratch, const struct scarp_samples *out)
{
    const struct scarp_plan *const plan = call->plan;
    const struct scarp_samples sums = samples_of(&scratch->sums);
    if (call->shape != NULL) {
        state_begin(plan, &scratch->state, blocks);
    }
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const struct rows *const from = k > 0 ? &scratch->sums : NULL;
        const struct scarp_samples *const to = k == plan->octaves - 1 ? out : &sums;
        const enum axes axes = k == 0 ? AXES_FIRST : plan->rotate ? AXES_TURNED : AXES_STRAIGHT;
        lattice_passes[call->dimensions - 2][call->doubles][axes](&scratch->first.lattice, o,
                                                                  blocks, position);
        if (call->shape != NULL) {
            add_shaped(call, o, axes, blocks, scratch, from, to);
        } else {
            add_octave(call, o, axes, blocks, scratch, from, to);
        }
    }
}

/* Moves on by `first` points; members that are NULL stand for rows of `spare`. */
static struct scarp_samples rows_from(const struct scarp_samples *out, size_t first,
                                      const struct scarp_samples *spare)
{
    const struct scarp_samples rows = {
        out->value ? out->value + first : spare->value, out->dx ? out->dx + first : spare->dx,
        out->dy ? out->dy + first : spare->dy,          out->dz ? out->dz + first : spare->dz,
        out->dxx ? out->dxx + first : spare->dxx,       out->dxy ? out->dxy + first : spare->dxy,
        out->dxz ? out->dxz + first : spare->dxz,       out->dyy ? out->dyy + first : spare->dyy,
        out->dyz ? out->dyz + first : spare->dyz,       out->dzz ? out->dzz + first : spare->dzz,
    };
    return rows;
}

/* A chunk whose last block is incomplete: through padded copies, so that nothing beyond an array is
   touched. The padding is 0, which raises no floating-point exception. */
static void chunk_padded(const struct points_call *call, size_t count,
                         const void *const position[3], struct scratch *scratch,
                         const struct scarp_samples *out)
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
    float *const arrays[ROWS] = {out->value, out->dx,  out->dy,  out->dz,  out->dxx,
                                 out->dxy,   out->dxz, out->dyy, out->dyz, out->dzz};
    for (int i = 0; i < ROWS; i++) {
        if (arrays[i] != NULL) {
            memcpy(arrays[i], scratch->sums.row[i], count * sizeof(float));
        }
    }
}

static void points(const struct scarp_plan *plan, size_t count, const void *const position[3],
                   const struct scarp_samples *out, int dimensions, int doubles)
{
    const struct points_call call = call_of(plan, dimensions, doubles);
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
