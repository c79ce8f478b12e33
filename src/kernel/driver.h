/* SPDX-License-Identifier: MIT
 *
 * The only loop over octaves, for points and grids alike. It takes a tile of a call, rows of
 * blocks, through the stages:
 *
 *     x, y, z                       cells, hashes          noise            shaped
 *        |                               |                   |                |
 *        +--> positions.h, lattice.h ----+--> basis/ --------+--> fractal/ ---+--> sample.h
 *             or unhashed.h                     or rows/            or turn.h        adds it to the
 *                                                                                  sums or stores
 *     for each octave of the tile         scratch space between the stages         the outputs
 *
 * Sums of octaves as they are, along straight axes, go from the basis to the sums at once.
 *
 * Each stage is a pass of its own over the tile. One pass that did all would be a single chain of
 * some 25 dependent operations per block, and out-of-order windows hold only two or three blocks of
 * it: shorter chains overlap better. On Zen 5 with gcc 12 and AVX2, one pass computes 870 (2D) and
 * 400 (3D) million points of gradient noise per second, two passes 1120 and 460. (A pass over two
 * interleaved blocks in wider vector types spills: gcc 12 takes such types apart through memory.)
 */
#ifndef SCARP_KERNEL_DRIVER_H
#define SCARP_KERNEL_DRIVER_H

#include <string.h>

#include "../dispatch/kernels.h"
#include "bases.h"
#include "basis/components.h"
#include "moved.h"
#include "rows/turned.h"

/* The most blocks of a tile of points. Many blocks share the fixed cost of a pass: with 8, AVX-512
   loses 6 to 12 %. */
#define TILE_BLOCKS 32

/* The scratch space holds what is between the passes. With these sizes, a call takes less than 45
   KiB of stack as the library is built by default, and less than the promised 48 where it is
   compiled with -O1 or hardened. Tiles have fewer blocks where a block needs much. A set whose
   frames are larger has less. So have chunks, in which there are more calls within each other,
   grids that are computed as points, and grids of so many octaves that these need much of the
   stack. */
#ifndef SCRATCH_BYTES
#define SCRATCH_BYTES (26 * 1024)
#endif
#define CHUNK_BYTES (SCRATCH_BYTES - 3328)
#define FLAT_BYTES (SCRATCH_BYTES - 2048)
#define GRID_BYTES_MANY (SCRATCH_BYTES - 2560)

/* Scratch space, or what is left of it. */
struct workspace {
    vf *space;
    size_t vectors;
};

/* What all tiles of a call share: its passes, and vectors of scratch space per block. */
struct passes {
    const struct scarp_call_plan *plan;
    int dimensions, basis_order;
    enum layout layout;       /* of the positions */
    int takes_unhashed;       /* struct basis */
    enum corner_form corners; /* of corners, by a basis that takes hashes */
    const struct basis *basis;
    lattice_pass *const *lattice_passes; /* by axes; of a basis that takes hashes */
    basis_pass *basis_pass;
    enum turned_form turned_form;
    int by_rows;             /* whether that takes one row */
    rows_pass *rows_pass;    /* NULL: none, or points */
    fractal_pass *turn_pass; /* NULL where no derivatives are to be turned */
    const struct fractal *fractal;
    fractal_pass *fractal_pass; /* NULL: none */
    phase_pass *phase_pass;     /* NULL: none, or no DPHASE */
    size_t lattice_size, noise_size, state_size;
    size_t turning_size, moving_size; /* struct phase_shaping */
    size_t sums_size;                 /* vectors of all outputs at a block */
    int straight_fbm;                 /* whether it is fBm with straight axes */
};

/* This, and what takes a tile through an octave, is out of line for the sake of size. */
static __attribute__((noinline)) void passes_choose(struct passes *passes,
                                                    const struct scarp_call_plan *plan,
                                                    int dimensions, enum layout layout)
{
    const struct fractal *const fractal = &fractals[plan->fractal];
    const int d = dimensions - 2, order = plan->order + fractal->extra_order;
    const int turns = plan->rotate && plan->order > 0 && !fractal->octave_axes;
    const struct basis *const basis = basis_of(plan);
    const int moves = plan->dphase && fractal->phase[d] != NULL;
    passes->plan = plan;
    passes->dimensions = dimensions;
    passes->basis_order = order;
    passes->layout = layout;
    passes->corners = corner_form_of(plan->basis);
    passes->lattice_passes = layout == MOVED ? NULL : lattice_passes[passes->corners][d][layout];
    passes->turned_form = basis->takes_unhashed               ? TURNED_CELLS
                          : passes->corners == CORNERS_HASHED ? TURNED_HASHED
                                                              : TURNED_MIXED;
    passes->by_rows = plan->component > 0 && plan->basis == SCARP_VALUE;
    passes->basis_pass =
        passes->by_rows ? components_passes[SCARP_VALUE][d][order] : basis->points[d][order];
    passes->rows_pass = layout == ROW ? basis->rows[d][order] : NULL;
    passes->turn_pass = turns ? turn_passes[d][plan->order - 1] : NULL;
    passes->fractal = fractal;
    passes->fractal_pass = fractal->pass[d][plan->order];
    passes->basis = basis;
    passes->takes_unhashed = basis->takes_unhashed;
    passes->lattice_size =
        basis->takes_unhashed ? unhashed_size(dimensions) : lattice_size(dimensions);
    passes->noise_size = turns || passes->fractal_pass != NULL ? sample_size(dimensions, order) : 0;
    passes->state_size = state_size(plan, dimensions);
    passes->phase_pass = moves ? fractal->phase[d] : NULL;
    passes->turning_size = moves ? turning_size(plan->fractal, dimensions) : 0;
    passes->moving_size = moves ? moving_size(plan->fractal, dimensions) : 0;
    passes->sums_size = sample_size(dimensions, plan->order) + (plan->dphase ? 1 : 0);
    passes->straight_fbm = passes->fractal_pass == NULL && !plan->rotate;
}

/* A tile of a call. Points count as one row. */
struct tile {
    struct locations locations;
    struct positions at;                  /* ROW: x for all rows, and z */
    const double *y;                      /* ROW: the y of each row, padded to whole vectors */
    size_t first;                         /* MOVED: the first block, counted from `at` */
    struct outputs *to;                   /* where octaves are added up */
    const struct outputs *stored;         /* the noise before it is shaped, at `noise` */
    const struct outputs *turning_stored; /* its phase derivative, at `turning` */
    enum put put;                         /* how the first octave is put */
    int is_far;                           /* DOUBLES with turned axes: far.h, for some octave */
    int is_located;                       /* whether the samples are on the lattice already */
    size_t group;                         /* ROW: how many rows go through the passes at once */
    struct row_octave *row_octave;        /* of a ROW */
    struct turned_tile turned;            /* of a ROW with turned axes */
    vf *along; /* where these two keep what depends on x; MOVED: where columns are split */
    vf *noise, *state, *spare, *sums_stored;
    vf *turning, *moving; /* struct phase_shaping */
};

/* Copies the first `count` samples of row r of `stored` to the caller's arrays, from `first` on. */
static void copy_out(const struct scarp_outputs *out, size_t first, const struct outputs *stored,
                     size_t r, size_t count)
{
    for (int i = 0; i < OUTPUTS; i++) {
        if (out->array[i] == NULL) {
            continue;
        }
        const float *from = stored->array[i] + r * stored->row[i];
        float *to = out->array[i] + first, *const end = to + count;
        for (; (size_t)(end - to) >= VEC_LANES; to += VEC_LANES, from += stored->block) {
            vf_store(to, vf_load(from));
        }
        memcpy(to, from, (size_t)(end - to) * sizeof(float));
    }
}

/* Whether octave k of a grid is prepared for the rows pass. */
static int has_rows_pass(const struct passes *passes, int k)
{
    return passes->rows_pass != NULL && axes_of(passes->plan, k) != AXES_TURNED;
}

/* Whether octave k goes through the rows pass: points may be faster where rows cross many cells. */
static int takes_rows_pass(const struct passes *passes, const struct tile *tile, int k)
{
    return has_rows_pass(passes, k) &&
           !(passes->takes_unhashed && tile->row_octave->cells.by_points);
}

/* Finds the cells and the fractions of a tile's samples. */
static void locate_unhashed(const struct passes *passes, const struct tile *tile,
                            const struct scarp_octave *o, enum axes axes)
{
    const struct frame f = {passes->layout, axes, passes->dimensions};
    const size_t blocks = tile->locations.extent.blocks;
    struct positions at = tile->at;
    for (size_t r = 0; r < tile->locations.extent.rows; r++) {
        if (passes->layout == ROW) {
            at.shared[1] = tile->y[r];
        }
        unhashed_row(tile->locations.lattice + r * blocks * passes->lattice_size, o, blocks, &at,
                     f);
    }
}

/* Locates the tile's samples, which are displaced. */
static __attribute__((noinline)) void locate_displaced(const struct passes *passes,
                                                       const struct tile *tile, int k)
{
    struct moved m = {.columns = tile->along,
                      .corners = passes->corners,
                      .dimensions = passes->dimensions,
                      .takes_unhashed = passes->takes_unhashed};
    for (int i = 0; i < passes->dimensions; i++) {
        m.axis[i] = tile->at.array[i];
    }
    locate_octave(tile->locations.lattice, &m, passes->plan, k, tile->first,
                  tile->locations.extent.blocks);
}

/* Finds the corners of the cells of a tile's samples. */
VEC_INLINE void locate_corners(const struct passes *passes, const struct tile *tile,
                               const struct scarp_octave *o, enum axes axes)
{
    const struct extent extent = tile->locations.extent;
    if (passes->layout != ROW) {
        passes->lattice_passes[axes](tile->locations.lattice, o, extent.blocks, &tile->at);
        return;
    }
    struct positions at = tile->at;
    for (size_t r = 0; r < extent.rows; r++) {
        at.shared[1] = tile->y[r];
        passes->lattice_passes[axes](tile->locations.lattice +
                                         r * extent.blocks * passes->lattice_size,
                                     o, extent.blocks, &at);
    }
}

/* Moves the hashes of a tile of gradient noise on to the next component of vector noise. */
static void tile_next_component(const struct passes *passes, const struct tile *tile)
{
    const size_t blocks = tile->locations.extent.rows * tile->locations.extent.blocks;
    (passes->dimensions == 2 ? next_component2 : next_component3)(tile->locations.lattice, blocks);
}

/* Locates the tile's samples on the lattice of octave k. */
static __attribute__((noinline)) void locate_tile(const struct passes *passes,
                                                  const struct tile *tile, int k)
{
    const enum axes axes = axes_of(passes->plan, k);
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const struct extent extent = tile->locations.extent;
    if (passes->layout == MOVED) {
        locate_displaced(passes, tile, k);
    } else if (passes->layout == ROW && axes == AXES_TURNED) {
        turned_passes[passes->turned_form][passes->dimensions - 2](
            tile->locations.lattice, o, &tile->turned, tile->row_octave->begin, extent.rows);
    } else if (passes->layout == DOUBLES && axes == AXES_TURNED && tile->is_far &&
               is_far(o->frequency64, extent.blocks * VEC_LANES, tile->at.array,
                      passes->dimensions)) {
        far_row(tile->locations.lattice, o, extent.blocks, &tile->at, passes->dimensions,
                passes->turned_form);
    } else if (passes->takes_unhashed) {
        locate_unhashed(passes, tile, o, axes);
    } else {
        locate_corners(passes, tile, o, axes);
    }
    for (int i = 0; i < passes->plan->component && passes->plan->basis == SCARP_GRADIENT; i++) {
        tile_next_component(passes, tile);
    }
}

/* Adds octave k of the basis, times its weights, to `to`, or puts it there. */
VEC_INLINE void add_basis(const struct passes *passes, const struct tile *tile, int k,
                          const struct weights *weights, const struct outputs *to, enum put put)
{
    if (takes_rows_pass(passes, tile, k)) {
        tile->row_octave->turn = passes->plan->octave[k].turn;
        tile->row_octave->basis = passes->plan->basis;
        tile->row_octave->order = passes->basis_order;
        passes->rows_pass(tile->row_octave, tile->locations.extent.rows, weights, to, put);
        return;
    }
    if (!tile->is_located) {
        locate_tile(passes, tile, k);
    }
    if (passes->by_rows) {
        component_rows(passes->basis_pass, &tile->locations, weights, to, put,
                       passes->lattice_size);
    } else {
        passes->basis_pass(&tile->locations, weights, to, put);
    }
}

/* Adds the derivative of the basis with respect to the phase, after add_basis, which has located
   the tile. `order` is that of the outputs which `to` takes. */
static void add_turning(const struct passes *passes, const struct tile *tile, int k, int order,
                        const struct outputs *to, enum put put)
{
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const struct basis *const basis = passes->basis;
    const int d = passes->dimensions - 2;
    const float slope = scarpi_phase_slope(o, k);
    const struct weights weights = {{slope, slope, slope}};
    float derivative[4];
    scarpi_phase_derivative(derivative, o->turn);
    if (takes_rows_pass(passes, tile, k)) {
        tile->row_octave->turn = derivative;
        basis->rows[d][order](tile->row_octave, tile->locations.extent.rows, &weights, to, put);
        return;
    }
    struct locations locations = tile->locations;
    locations.turn = derivative;
    basis->points[d][order](&locations, &weights, to, put);
}

/* Adds the derivative of octave k with respect to the phase, which no fractal changes. This and the
   next are out of line, so that what they need is not on the stack while other passes run. */
static __attribute__((noinline)) void add_phase(const struct passes *passes,
                                                const struct tile *tile, int k,
                                                const struct outputs *to, enum put put)
{
    struct outputs phase;
    outputs_of_phase(&phase, to);
    add_turning(passes, tile, k, 0, &phase, put);
}

/* Adds the derivative with respect to the phase of an octave whose fractal comes next. */
static __attribute__((noinline)) void add_shaped_phase(const struct passes *passes,
                                                       const struct tile *tile, int k,
                                                       const struct shaping *shaping,
                                                       const struct outputs *to, enum put put)
{
    const struct phase_shaping at = {*shaping, passes->noise_size, passes->state_size,
                                     tile->turning, tile->moving};
    struct outputs phase;
    outputs_of_phase(&phase, to);
    add_turning(passes, tile, k, passes->fractal->extra_order, tile->turning_stored, PUT_FIRST);
    passes->phase_pass(&at, &phase, put);
}

/* Adds octave k through its fractal. The stored noise has the weights of its outputs; the amplitude
   alone if the fractal takes derivatives in the octave's axes; and none if the turn applies them. */
static void add_shaped(const struct passes *passes, const struct tile *tile, int k,
                       const struct outputs *to, enum put put)
{
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const enum axes axes = axes_of(passes->plan, k);
    const struct shaping shaping = {passes->plan,           o,           axes,
                                    tile->locations.extent, tile->noise, tile->state};
    const int turns = axes == AXES_TURNED && passes->turn_pass != NULL;
    const float a = turns ? 1.0f : o->amplitude;
    const struct weights amplitude = {{a, a, a}},
                         straight = {{o->amplitude, o->slope, o->curvature}};
    add_basis(passes, tile, k, turns || passes->fractal->octave_axes ? &amplitude : &straight,
              tile->stored, PUT_FIRST);
    if (turns && passes->fractal_pass == NULL) {
        passes->turn_pass(&shaping, to, put);
        if (passes->plan->dphase) {
            add_phase(passes, tile, k, to, put);
        }
        return;
    }
    if (turns) {
        passes->turn_pass(&shaping, tile->stored, PUT_FIRST);
    }
    if (passes->phase_pass != NULL) {
        add_shaped_phase(passes, tile, k, &shaping, to, put);
    }
    passes->fractal_pass(&shaping, to, put);
}

/* Whether octave k is stored before it is added to the outputs. */
static int is_stored(const struct passes *passes, int k)
{
    return passes->fractal_pass != NULL ||
           (passes->turn_pass != NULL && axes_of(passes->plan, k) == AXES_TURNED);
}

/* Adds octave k on a tile, or on some of its rows. */
static __attribute__((noinline)) void
add_octave(const struct passes *passes, const struct tile *tile, int k, const struct outputs *to)
{
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const enum put put = k > 0 ? PUT_ADD : tile->put;
    if (is_stored(passes, k)) {
        add_shaped(passes, tile, k, to, put);
    } else {
        const struct weights weights = {{o->amplitude, o->slope, o->curvature}};
        add_basis(passes, tile, k, &weights, to, put);
        if (passes->plan->dphase) {
            add_phase(passes, tile, k, to, put);
        }
    }
}

/* Adds octave k on a tile of a grid, some rows at a time, so that what is between its passes stays
   in the first-level cache. The tile is as before in the end. (A copy of it would wait until what
   was written in narrow stores has left the core: see outputs_stored.) */
static void add_by_groups(const struct passes *passes, struct tile *tile, int k)
{
    const size_t rows = tile->locations.extent.rows;
    const size_t state_of_row = tile->locations.extent.blocks * passes->state_size;
    const size_t moving_of_row = tile->locations.extent.blocks * passes->moving_size;
    const double *const y = tile->y;
    vf *const state = tile->state, *const moving = tile->moving;
    for (size_t r = 0, here; r < rows; r += here) {
        here = least(rows - r, tile->group);
        tile->locations.extent.rows = here;
        tile->row_octave->begin = r;
        tile->y = y + r;
        tile->state = state + r * state_of_row;
        tile->moving = moving + r * moving_of_row;
        add_octave(passes, tile, k, tile->to);
        outputs_move(tile->to, passes->plan->order, (ptrdiff_t)here);
    }
    outputs_move(tile->to, passes->plan->order, -(ptrdiff_t)rows);
    tile->locations.extent.rows = rows;
    tile->y = y;
    tile->state = state;
    tile->moving = moving;
}

/* Prepares octave k along the axes of a grid. What depends on x is kept for the tiles below if
   there is no other octave. This is out of line, so that its arrays and those of the passes are not
   on the stack at the same time. */
static __attribute__((noinline)) void prepare_rows(const struct passes *passes,
                                                   const struct tile *tile, int k, int first_tile)
{
    const struct scarp_call_plan *const plan = passes->plan;
    const enum axes axes = axes_of(plan, k);
    double z[VEC_LANES];
    for (size_t i = 0; i < VEC_LANES; i++) {
        z[i] = tile->at.shared[2];
    }
    const struct positions at = {.array = {NULL, tile->y, z}};
    const struct frame f = {DOUBLES, axes, passes->dimensions};
    if (passes->takes_unhashed) {
        struct along_cells *const along = &tile->row_octave->cells;
        if (plan->octaves > 1 || first_tile) {
            along_cells_begin(along, tile->along, tile->locations.extent.blocks);
            along_cells_x(along, &plan->octave[k], tile->at.array[0], axes);
        }
        along_cells_rows(along, &plan->octave[k], tile->locations.extent.rows, &at, axes,
                         passes->dimensions);
        return;
    }
    if (plan->octaves > 1 || first_tile) {
        along_x(&tile->row_octave->x, &plan->octave[k], tile->locations.extent.blocks, &tile->at,
                plan->fade, axes);
    }
    tile->row_octave->rows.component = plan->component;
    along_rows(&tile->row_octave->rows, &plan->octave[k], tile->locations.extent.rows, &at,
               plan->fade, f);
}

/* The same of an octave whose axes are turned. */
static void prepare_turned(const struct passes *passes, struct tile *tile, int k)
{
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const double stretch = passes->takes_unhashed ? o->stretch : 1.0;
    tile->turned.blocks = tile->locations.extent.blocks;
    tile->turned.at = tile->at;
    tile->turned.at.array[1] = tile->y;
    turned_begin(&tile->turned, tile->along, o, stretch, tile->locations.extent.rows,
                 passes->dimensions);
}

/* Adds up all octaves of a tile. */
static void sum_octaves(const struct passes *passes, struct tile *tile, int first_tile)
{
    const struct scarp_call_plan *const plan = passes->plan;
    if (passes->state_size > 0) {
        state_begin(plan, tile->state, passes->state_size,
                    tile->locations.extent.rows * tile->locations.extent.blocks);
    }
    for (size_t i = 0;
         i < tile->locations.extent.rows * tile->locations.extent.blocks * passes->moving_size;
         i++) {
        tile->moving[i] = vf_set(0.0f);
    }
    tile->locations.basis = plan->basis;
    tile->locations.order = passes->basis_order;
    tile->locations.component = plan->component;
    tile->locations.component_end = plan->component + 1;
    for (int k = 0; k < plan->octaves; k++) {
        tile->locations.octave = &plan->octave[k];
        tile->locations.turn = plan->octave[k].turn;
        if (has_rows_pass(passes, k)) {
            prepare_rows(passes, tile, k, first_tile);
        } else if (passes->layout == ROW && axes_of(plan, k) == AXES_TURNED) {
            prepare_turned(passes, tile, k);
        }
        if (passes->layout == ROW) {
            add_by_groups(passes, tile, k);
        } else {
            add_octave(passes, tile, k, tile->to);
        }
    }
}

#endif
