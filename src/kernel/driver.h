/* SPDX-License-Identifier: MIT
 *
 * The only loop over octaves, for points and grids alike. It takes a part of a call, rows of
 * blocks, through the stages: positions, basis, shape, and sums. Included by points.h and grid.h.
 *
 * Each stage is a pass of its own over the part. One pass that did all would be a single chain of
 * some 25 dependent operations per block, and out-of-order windows hold only two or three blocks of
 * it: shorter chains overlap better. Measured on Zen 5 with gcc 12 and AVX2, million points per
 * second, gradient noise 2D and 3D: one pass 870 and 400, two passes 1120 and 460. (A pass over two
 * interleaved blocks in wider vector types spills: gcc 12 takes such types apart through memory.)
 */
#ifndef SCARP_KERNEL_DRIVER_H
#define SCARP_KERNEL_DRIVER_H

#include <string.h>

#include "../kernels.h"
#include "rows/rows.h"
#include "shape/shape.h"

/* The most blocks of a part that go through passes. The cost of a pass is spread thin: with 8
   blocks AVX-512 loses 6 to 12 %. */
#define PART_BLOCKS 32

/* What is between the passes. With this, a call takes less than 48 KiB of stack. Fewer blocks go
   through at a time where a call needs much for each. */
#define SCRATCH_BYTES (30 * 1024)

struct scratch {
    vf space[SCRATCH_BYTES / sizeof(vf)];
};

/* A basis: what it has for each [dimensions - 2][order]. */
struct basis {
    points_pass *points[2][3];
    rows_pass *rows[2][3]; /* NULL: there is no fast path */
};

#define BASIS(name)                                                                                \
    {                                                                                              \
        .points = {{name##2_points0, name##2_points1, name##2_points2},                            \
                   {name##3_points0, name##3_points1, name##3_points2}},                           \
        .rows = {{name##2_rows0, name##2_rows1, name##2_rows2},                                    \
                 {name##3_rows0, name##3_rows1, name##3_rows2}},                                   \
    }

static const struct basis bases[] = {
    [SCARP_GRADIENT] = BASIS(gradient),
    [SCARP_VALUE] = BASIS(value),
};

#undef BASIS

/* What all parts of a call share: its passes, and vectors of scratch space per block. */
struct call {
    const struct scarp_plan *plan;
    int dimensions, basis_order;
    points_pass *points;
    rows_pass *rows;  /* NULL: none */
    shape_pass *turn; /* NULL where no derivatives are to be turned */
    const struct shape *shape;
    shape_pass *shape_pass; /* NULL: none */
    size_t lattice, noise, state;
    int plain; /* whether it is fBm with straight axes */
};

static struct call call_of(const struct scarp_plan *plan, int dimensions)
{
    const struct shape *const shape = &shapes[plan->fractal];
    const int order = plan->order + shape->extra_order;
    struct call call = {.plan = plan, .dimensions = dimensions, .basis_order = order};
    call.shape = shape;
    call.points = bases[plan->basis].points[dimensions - 2][order];
    call.rows = bases[plan->basis].rows[dimensions - 2][order];
    call.shape_pass = shape->pass[dimensions - 2][plan->order];
    if (plan->rotate && plan->order > 0 && !shape->own_axes) {
        call.turn = turn_passes[dimensions - 2][plan->order - 1];
    }
    call.lattice = lattice_size(dimensions);
    if (call.shape_pass != NULL || call.turn != NULL) {
        call.noise = sample_size(dimensions, order);
    }
    call.state = state_size(plan, dimensions);
    call.plain = call.shape_pass == NULL && !plan->rotate;
    return call;
}

/* A part of a call. Points are one row. */
struct part {
    struct extent extent;
    enum layout layout;
    struct positions at;             /* of a ROW: x for all rows, z */
    const double *y;                 /* of a ROW: of each row, filled up to whole vectors */
    const struct outputs *sums, *to; /* all octaves but the last are added up in `sums` */
    enum put put;                    /* how an only octave is put by a rows pass */
    struct row_octave *octave;       /* of a ROW */
    vf *lattice, *noise, *state, *spare, *sums_stored;
};

/* The first `count` numbers of row r of stored samples, to the arrays from `first` on. */
static void copy_out(const struct scarp_outputs *out, size_t first, const struct outputs *stored,
                     size_t r, size_t count)
{
    for (int i = 0; i < OUTPUTS; i++) {
        for (size_t n = 0; out->array[i] != NULL && n < count; n += VEC_LANES) {
            const float *const block =
                stored->array[i] + r * stored->row[i] + n / VEC_LANES * stored->block;
            memcpy(out->array[i] + first + n, block, least(count - n, VEC_LANES) * sizeof(float));
        }
    }
}

/* The part's positions on the lattice of octave k. */
static void place_part(const struct call *call, const struct part *part, int k)
{
    lattice_pass *const pass =
        lattice_passes[call->dimensions - 2][part->layout][axes_of(call->plan, k)];
    if (part->layout != ROW) {
        pass(part->lattice, &call->plan->octave[k], part->extent.blocks, &part->at);
        return;
    }
    struct positions at = part->at;
    for (size_t r = 0; r < part->extent.rows; r++) {
        at.shared[1] = part->y[r];
        pass(part->lattice + r * part->extent.blocks * call->lattice, &call->plan->octave[k],
             part->extent.blocks, &at);
    }
}

/* Octave k of the basis, times its weights, is added to `from`, giving `to`. */
static void add_basis(const struct call *call, const struct part *part, int k,
                      const struct weights *weights, struct sums from, const struct outputs *to)
{
    if (part->layout == ROW && call->rows != NULL && axes_of(call->plan, k) != AXES_TURNED) {
        const enum put put = k > 0 && call->plain ? PUT_ADD : part->put;
        call->rows(part->octave, part->extent.rows, weights, to, put);
        return;
    }
    const struct placed at = {part->lattice, part->extent, call->plan->fade};
    place_part(call, part, k);
    call->points(&at, weights, from, to);
}

/* The same of octave k shaped. Where its axes are turned, weights come with the turn. */
static void add_shaped(const struct call *call, const struct part *part, int k, struct sums from,
                       const struct outputs *to)
{
    const struct scarp_octave *const o = &call->plan->octave[k];
    const enum axes axes = axes_of(call->plan, k);
    const struct shaping shaping = {call->plan, o, axes, part->extent, part->noise, part->state};
    const int turns = axes == AXES_TURNED && call->turn != NULL;
    const float a = turns ? 1.0f : o->amplitude;
    const struct weights own = {{a, a, a}}, straight = {{o->amplitude, o->slope, o->curvature}};
    struct outputs stored;
    outputs_stored(&stored, part->noise, call->dimensions, call->basis_order, part->extent.blocks);
    add_basis(call, part, k, turns || call->shape->own_axes ? &own : &straight, no_sums, &stored);
    if (turns && call->shape_pass == NULL) {
        call->turn(&shaping, from, to);
        return;
    }
    if (turns) {
        call->turn(&shaping, no_sums, &stored);
    }
    call->shape_pass(&shaping, from, to);
}

/* What an octave of a grid needs along its axes. Only along x is it worth keeping for the part
   below, and only if there is no other octave. */
static void prepare_rows(const struct call *call, const struct part *part, int k, int first_part)
{
    const struct scarp_plan *const plan = call->plan;
    const enum axes axes = axes_of(plan, k);
    if (part->layout != ROW || call->rows == NULL || axes == AXES_TURNED) {
        return;
    }
    double z[VEC_LANES];
    for (size_t i = 0; i < VEC_LANES; i++) {
        z[i] = part->at.shared[2];
    }
    const struct positions at = {.array = {NULL, part->y, z}};
    const struct frame f = {DOUBLES, axes, call->dimensions};
    if (plan->octaves > 1 || first_part) {
        along_x(&part->octave->x, &plan->octave[k], part->extent.blocks, &part->at, plan->fade,
                axes);
    }
    along_rows(&part->octave->rows, &plan->octave[k], part->extent.rows, &at, plan->fade, f);
}

/* All octaves of a part. Those but the last are added up in part->sums. */
static void sum_octaves(const struct call *call, const struct part *part, int first_part)
{
    const struct scarp_plan *const plan = call->plan;
    const size_t bytes = sample_size(call->dimensions, plan->order) * sizeof(vf);
    state_begin(plan, part->state, call->state, part->extent.rows * part->extent.blocks);
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const struct sums sums = {part->sums_stored, bytes}, from = k > 0 ? sums : no_sums;
        const struct outputs *const to = k == plan->octaves - 1 ? part->to : part->sums;
        prepare_rows(call, part, k, first_part);
        if (call->shape_pass != NULL || (call->turn != NULL && axes_of(plan, k) == AXES_TURNED)) {
            add_shaped(call, part, k, from, to);
        } else {
            const struct weights weights = {{o->amplitude, o->slope, o->curvature}};
            add_basis(call, part, k, &weights, from, to);
        }
    }
}

#endif
