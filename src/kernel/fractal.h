/* SPDX-License-Identifier: MIT
 *
 * How the passes over a chunk make an octave of a call and add it to the sum. Included by points.h
 * and grid.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_H
#define SCARP_KERNEL_FRACTAL_H

#include <string.h>

#include "columns.h"
#include "shape.h"

static struct scarp_samples samples_of(struct rows *rows)
{
    float *r[ROWS];
    for (int i = 0; i < ROWS; i++) {
        r[i] = (float *)rows->row[i];
    }
    const struct scarp_samples s = {.value = r[0],
                                    .dx = r[1],
                                    .dy = r[2],
                                    .dz = r[3],
                                    .dxx = r[4],
                                    .dxy = r[5],
                                    .dxz = r[6],
                                    .dyy = r[7],
                                    .dyz = r[8],
                                    .dzz = r[9]};
    return s;
}

/* Moves on by `first` points; members that are NULL stand for rows of `spare`. */
static struct scarp_samples rows_from(const struct scarp_samples *out, size_t first,
                                      const struct scarp_samples *spare)
{
    const struct scarp_samples rows = {
        .value = out->value ? out->value + first : spare->value,
        .dx = out->dx ? out->dx + first : spare->dx,
        .dy = out->dy ? out->dy + first : spare->dy,
        .dz = out->dz ? out->dz + first : spare->dz,
        .dxx = out->dxx ? out->dxx + first : spare->dxx,
        .dxy = out->dxy ? out->dxy + first : spare->dxy,
        .dxz = out->dxz ? out->dxz + first : spare->dxz,
        .dyy = out->dyy ? out->dyy + first : spare->dyy,
        .dyz = out->dyz ? out->dyz + first : spare->dyz,
        .dzz = out->dzz ? out->dzz + first : spare->dzz,
    };
    return rows;
}

/* `count` numbers of each row from a block on, to the arrays that are there. */
static void copy_rows(const struct scarp_samples *out, const struct rows *rows, size_t block,
                      size_t count)
{
    float *const arrays[ROWS] = {out->value, out->dx,  out->dy,  out->dz,  out->dxx,
                                 out->dxy,   out->dxz, out->dyy, out->dyz, out->dzz};
    for (int i = 0; i < ROWS; i++) {
        if (arrays[i] != NULL) {
            memcpy(arrays[i], &rows->row[i][block], count * sizeof(float));
        }
    }
}

/* The passes of a call, as all its chunks see them. */
struct passes {
    const struct scarp_plan *plan;
    int dimensions, doubles;
    octave_pass *octave;   /* noise from a struct lattice */
    columns_pass *columns; /* the same from a struct columns */
    turn_pass *turn;       /* NULL where no derivatives are to be turned */
    shape_pass *shape;     /* NULL for fBm */
};

static struct passes passes_of(const struct scarp_plan *plan, int dimensions, int doubles)
{
    const int erosion = plan->fractal == SCARP_EROSION;
    struct passes call = {.plan = plan, .dimensions = dimensions, .doubles = doubles};
    call.octave = octave_passes[dimensions - 2][plan->basis][plan->order + erosion];
    call.columns = columns_passes[dimensions - 2][plan->basis][plan->order + erosion];
    if (plan->rotate && plan->order > 0 && !erosion) {
        call.turn = turn_passes[dimensions - 2][plan->order - 1];
    }
    if (plan->fractal != SCARP_FBM) {
        call.shape = shape_passes[plan->fractal - 1][dimensions - 2][plan->order];
    }
    return call;
}

/* Where the passes of a chunk leave their results. `first` is what the noise comes from, or later
   the result of a pass after the one that has read it. */
struct scratch {
    union {
        struct lattice lattice;
        struct columns columns;
        struct rows turned;
    } first;
    struct rows raw;
    union state state;
    struct rows sums;
};

/* Where the noise of an octave at a chunk comes from: from the lattice in `scratch`, or, if `rows`
   is not 0, from its columns, the chunk being that many rows of a grid. */
struct source {
    size_t rows;
};

/* to = from + weights * noise; in grids `from` is `to`, or NULL. */
static void add_noise(const struct passes *call, const struct source *source, size_t blocks,
                      const struct weights *weights, struct scratch *scratch,
                      const struct scarp_samples *from, const struct scarp_samples *to)
{
    static const struct scarp_samples none; /* all NULL */
    struct scarp_samples rows[CHUNK_BLOCKS];
    if (source->rows == 0) {
        call->octave(&scratch->first.lattice, blocks, call->plan->fade, weights, from, to);
        return;
    }
    const size_t blocks_of_row = blocks / source->rows;
    for (size_t r = 0; r < source->rows; r++) {
        rows[r] = rows_from(to, r * blocks_of_row * VEC_LANES, &none);
    }
    call->columns(&scratch->first.columns, source->rows, blocks_of_row, weights, from == NULL,
                  rows);
}

/* to = from + an octave of fBm. */
static void add_octave(const struct passes *call, const struct scarp_octave *o, enum axes axes,
                       const struct source *source, size_t blocks, struct scratch *scratch,
                       const struct scarp_samples *from, const struct scarp_samples *to)
{
    static const struct weights unit = {1.0f, 1.0f, 1.0f};
    const struct weights weights = {o->amplitude, o->slope, o->curvature};
    if (axes == AXES_TURNED && call->turn != NULL) {
        const struct scarp_samples raw = samples_of(&scratch->raw);
        add_noise(call, source, blocks, &unit, scratch, NULL, &raw);
        call->turn(o, blocks, &scratch->raw, from, to);
    } else {
        add_noise(call, source, blocks, &weights, scratch, from, to);
    }
}

/* The same for the other fractals. */
static void add_shaped(const struct passes *call, const struct scarp_octave *o, enum axes axes,
                       const struct source *source, size_t blocks, struct scratch *scratch,
                       const struct scarp_samples *from, const struct scarp_samples *to)
{
    const struct rows *n = &scratch->raw;
    if (call->plan->fractal == SCARP_EROSION) {
        const struct weights own = {o->amplitude, o->amplitude, o->amplitude};
        const struct scarp_samples raw = samples_of(&scratch->raw);
        add_noise(call, source, blocks, &own, scratch, NULL, &raw);
    } else {
        const int turned = axes == AXES_TURNED && call->turn != NULL;
        n = turned ? &scratch->first.turned : &scratch->raw;
        const struct scarp_samples rows =
            samples_of(turned ? &scratch->first.turned : &scratch->raw);
        add_octave(call, o, axes, source, blocks, scratch, NULL, &rows);
    }
    call->shape(call->plan, o, axes, blocks, n, &scratch->state, from, to);
}

/* Octave k of the call is added to `from`, whatever the fractal. */
static void add_any(const struct passes *call, int k, enum axes axes, const struct source *source,
                    size_t blocks, struct scratch *scratch, const struct scarp_samples *from,
                    const struct scarp_samples *to)
{
    const struct scarp_octave *const o = &call->plan->octave[k];
    if (call->shape == NULL) {
        add_octave(call, o, axes, source, blocks, scratch, from, to);
        return;
    }
    if (k == 0) {
        state_begin(call->plan, &scratch->state, blocks);
    }
    add_shaped(call, o, axes, source, blocks, scratch, from, to);
}

/* How the axes of octave k lie. */
static enum axes axes_of(const struct scarp_plan *plan, int k)
{
    return k == 0 ? AXES_FIRST : plan->rotate ? AXES_TURNED : AXES_STRAIGHT;
}

#endif
