/* SPDX-License-Identifier: MIT
 *
 * Octaves with straight axes on grids whose rows are short: blocks go on across the ends of rows,
 * as arrays of points do, but positions are made per axis, not per sample. Each axis has a table of
 * its fractions and cells. Along x, a block reads its lanes there; along y and z, it takes the
 * entry of the row it begins in, and from where a row ends on that of the next one:
 *
 *     lanes    0 1 2 3 4 5 6 7
 *     x        3 4 0 1 2 3 4 0        a grid with 5 samples in a row
 *     y        6 6 7 7 7 7 7 8
 *
 * The table of x begins again behind its end, as far as a block reaches.
 */
#ifndef SCARP_KERNEL_CROSSING_H
#define SCARP_KERNEL_CROSSING_H

#include "grid.h"

/* What passes of a basis take: the hashes of corners, mixed axes (enum corner_form), or cells. */
enum crossing_form { CROSSING_HASHED, CROSSING_MIXED, CROSSING_UNHASHED, CROSSING_FORMS };

/* The entries of an axis: fractions, and the bits of both lattice coordinates, mixed, or of the
   cell only. */
struct crossing_table {
    vf *t, *h0, *h1;
};

/* An octave along the axes of a grid, and the sample that comes next. */
struct crossing {
    const struct scarp_grid *grid;
    struct crossing_table table[3];
    size_t count[3]; /* samples along each axis */
    size_t at[3];
};

typedef void crossing_pass(vf *lattice, struct crossing *crossing, size_t blocks);

/* Samples at a place in each lane. */
struct crossing_entry {
    vf t, h0, h1;
};

/* Bits that are no number go through no register for numbers. */
VEC_INLINE vf crossing_bits(const vf *column, size_t i)
{
    uint32_t bits;
    memcpy(&bits, (const float *)column + i, sizeof bits);
    return (vf)vu_set(bits);
}

VEC_INLINE struct crossing_entry crossing_entry_of(const struct crossing_table *table, size_t i,
                                                   enum crossing_form form)
{
    const vf h0 = crossing_bits(table->h0, i);
    const struct crossing_entry e = {crossing_bits(table->t, i), h0,
                                     form == CROSSING_UNHASHED ? h0 : crossing_bits(table->h1, i)};
    return e;
}

/* Takes the entry `i` from the lanes of the mask on. */
VEC_INLINE void crossing_switch(struct crossing_entry *e, vm mask,
                                const struct crossing_table *table, size_t i,
                                enum crossing_form form)
{
    const struct crossing_entry next = crossing_entry_of(table, i, form);
    e->t = vm_choose(mask, next.t, e->t);
    e->h0 = vm_choose(mask, next.h0, e->h0);
    if (form != CROSSING_UNHASHED) {
        e->h1 = vm_choose(mask, next.h1, e->h1);
    }
}

VEC_INLINE void crossing_put(vf *to, const struct crossing_entry *x, const struct crossing_entry *y,
                             const struct crossing_entry *z, int dimensions,
                             enum crossing_form form)
{
    const struct mixed m = {
        {{(vu)x->h0, (vu)x->h1}, {(vu)y->h0, (vu)y->h1}, {(vu)z->h0, (vu)z->h1}}};
    to[0] = x->t;
    to[1] = y->t;
    if (dimensions == 3) {
        to[2] = z->t;
    }
    if (form != CROSSING_UNHASHED) {
        lattice_put_corners(to, &m, dimensions,
                            form == CROSSING_MIXED ? CORNERS_MIXED : CORNERS_HASHED);
        return;
    }
    to[dimensions] = x->h0;
    to[dimensions + 1] = y->h0;
    if (dimensions == 3) {
        to[dimensions + 2] = z->h0;
    }
}

/* Locates the next blocks. */
VEC_INLINE void crossing_run(vf *to, struct crossing *crossing, size_t blocks, int dimensions,
                             enum crossing_form form)
{
    const struct crossing a = *crossing; /* a copy: nothing that is stored can alias it */
    const vf lanes = (vf){VEC_NUMBERS} + vf_set(0.5f);
    size_t left = a.count[0] - a.at[0], j = a.at[1], k = a.at[2];
    for (size_t b = 0; b < blocks; b++) {
        const float *const t = (const float *)a.table[0].t + a.count[0] - left;
        const float *const h0 = (const float *)a.table[0].h0 + a.count[0] - left;
        const float *const h1 = (const float *)a.table[0].h1 + a.count[0] - left;
        const struct crossing_entry x = {vf_load(t), vf_load(h0),
                                         vf_load(form == CROSSING_UNHASHED ? h0 : h1)};
        struct crossing_entry y = crossing_entry_of(&a.table[1], j, form), z = y;
        if (dimensions == 3) {
            z = crossing_entry_of(&a.table[2], k, form);
        }
        for (; left <= VEC_LANES; left += a.count[0]) {
            const vm mask = vm_less(vf_set((float)left), lanes);
            j++;
            if (dimensions == 3 && j == a.count[1]) {
                j = 0;
                crossing_switch(&z, mask, &a.table[2], ++k, form);
            }
            crossing_switch(&y, mask, &a.table[1], j, form);
        }
        left -= VEC_LANES;
        crossing_put(to, &x, &y, &z, dimensions, form);
        to += form == CROSSING_UNHASHED ? UNHASHED_SIZE(dimensions)
              : dimensions == 2         ? LATTICE_SIZE2
                                        : LATTICE_SIZE3;
    }
    crossing->at[0] = a.count[0] - left;
    crossing->at[1] = j;
    crossing->at[2] = k;
}

#define CROSSING_PASS(name, dimensions, form)                                                      \
    static void name(vf *lattice, struct crossing *crossing, size_t blocks)                        \
    {                                                                                              \
        crossing_run(lattice, crossing, blocks, dimensions, form);                                 \
    }
CROSSING_PASS(across2_hashed, 2, CROSSING_HASHED)
CROSSING_PASS(across2_mixed, 2, CROSSING_MIXED)
CROSSING_PASS(across2_unhashed, 2, CROSSING_UNHASHED)
CROSSING_PASS(across3_hashed, 3, CROSSING_HASHED)
CROSSING_PASS(across3_mixed, 3, CROSSING_MIXED)
CROSSING_PASS(across3_unhashed, 3, CROSSING_UNHASHED)
#undef CROSSING_PASS

static crossing_pass *const crossing_passes[2][CROSSING_FORMS] = {
    {across2_hashed, across2_mixed, across2_unhashed},
    {across3_hashed, across3_mixed, across3_unhashed},
};

static enum crossing_form crossing_form_of(const struct passes *passes)
{
    return passes->takes_unhashed             ? CROSSING_UNHASHED
           : passes->corners == CORNERS_MIXED ? CROSSING_MIXED
                                              : CROSSING_HASHED;
}

/* Vectors of each column of the table of an axis with that many samples. The last block may go on
   behind the last row, as far as it reaches; columns are continued by up to two vectors. */
static size_t crossing_vectors(size_t count)
{
    return (count + 3 * VEC_LANES - 1) / VEC_LANES;
}

/* Columns of a table: bases that take unhashed locations have one of cells only. */
static size_t crossing_columns(int takes_unhashed)
{
    return takes_unhashed ? 2 : 3;
}

/* Begins with a grid, whose tables come to `space`. Returns where the rest of it begins. */
static vf *crossing_begin(struct crossing *crossing, const struct scarp_grid *grid, vf *space,
                          const struct passes *passes)
{
    crossing->grid = grid;
    crossing->count[2] = 1;
    for (int axis = 0; axis < passes->dimensions; axis++) {
        const size_t vectors = crossing_vectors(grid->count[axis]);
        crossing->count[axis] = grid->count[axis];
        crossing->table[axis].t = space;
        crossing->table[axis].h0 = space + vectors;
        crossing->table[axis].h1 = space + 2 * vectors;
        space += crossing_columns(passes->takes_unhashed) * vectors;
    }
    return space;
}

/* Continues a column of the table of an axis behind its last entry: along x with the first ones,
   along y and z with the last one. */
VEC_INLINE void crossing_continue(vf *column, size_t count, int axis)
{
    float *const to = (float *)column;
    if (axis > 0) {
        vf_store(to + count, crossing_bits(column, count - 1));
        return;
    }
    for (size_t i = count; i < count + VEC_LANES; i += count) {
        vf_store(to + i, vf_load(to)); /* of a short row, more of it each time */
    }
}

/* Fills in the table of an axis. */
static void crossing_fill(const struct crossing *crossing, const struct passes *passes, int k,
                          int axis)
{
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const enum axes axes = axes_of(passes->plan, k);
    const struct crossing_table *const table = &crossing->table[axis];
    const size_t count = crossing->count[axis];
    double x[VEC_LANES];
    const struct positions positions = {.array = {x, x, x}};
    const struct frame f = {DOUBLES, axes, 2};
    for (size_t i = 0; i < count; i += VEC_LANES) {
        block_coordinates(x, crossing->grid, axis, i, count - i);
        if (passes->takes_unhashed) {
            const struct split s = cells_split(o, axis, x, 0, AXES_STRAIGHT);
            table->t[i / VEC_LANES] = s.t;
            table->h0[i / VEC_LANES] = (vf)s.cell;
        } else {
            const struct split s = position(o, axis, &positions, 0, f);
            const struct axis h = hash_axis(s.cell, o, axis, axes);
            table->t[i / VEC_LANES] = s.t;
            table->h0[i / VEC_LANES] = (vf)h.h0;
            table->h1[i / VEC_LANES] = (vf)h.h1;
        }
    }
    crossing_continue(table->t, count, axis);
    crossing_continue(table->h0, count, axis);
    if (!passes->takes_unhashed) {
        crossing_continue(table->h1, count, axis);
    }
}

/* The scratch space that tables may have. The rest has room for the sums of a block and a tile of
   eight. */
#define CROSSING_TABLES (FLAT_BYTES / sizeof(vf) - (8 * (LATTICE_SIZE3 + 1) + 10))

/* The samples that are added up octave by octave, so that they stay in the caches. */
#define CROSSING_SAMPLES ((size_t)16384)

/* How many indices of the last axis are computed at once, so that the tables fit: 0 if they do not.
 */
static size_t crossing_part(const struct scarp_grid *grid, int dimensions, int takes_unhashed)
{
    const size_t columns = crossing_columns(takes_unhashed), rows = grid->count[1];
    size_t room = CROSSING_TABLES / columns, samples = grid->count[0];
    if (grid->count[0] > room * VEC_LANES || (dimensions == 3 && rows > room * VEC_LANES)) {
        return 0; /* sums of these might overflow */
    }
    size_t used = crossing_vectors(grid->count[0]);
    if (dimensions == 3) {
        used += crossing_vectors(rows);
        samples *= rows;
    }
    if (used + crossing_vectors(1) > room) {
        return 0;
    }
    const size_t most = (room - used) * VEC_LANES - 3 * VEC_LANES + 1;
    return least(most, least(grid->count[dimensions - 1], 1 + CROSSING_SAMPLES / samples));
}

/* The part of a grid of a noise that is served here at once: sums of octaves with straight axes
   that do not repeat, to arrays without gaps between rows. */
static size_t crossing_serves(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                              int dimensions)
{
    const int is_straight = !plan->rotate || (plan->octaves == 1 && plan->first == 0);
    const int serves = plan->fractal == SCARP_FBM && is_straight &&
                       plan->repeat == SCARP_REPEAT_NEVER && !plan->dphase &&
                       !has_row_gaps(grid, dimensions);
    return serves ? crossing_part(grid, dimensions, basis_of(plan)->takes_unhashed) : 0;
}

/* Adds octave k to the blocks from `first` on, or puts it there. */
static void crossing_tile(const struct passes *passes, struct crossing *crossing,
                          struct locations *locations, int k, const struct outputs *to)
{
    const struct scarp_octave *const o = &passes->plan->octave[k];
    const struct weights weights = {{o->amplitude, o->slope, o->curvature}};
    crossing_passes[passes->dimensions - 2][crossing_form_of(passes)](locations->lattice, crossing,
                                                                      locations->extent.blocks);
    passes->basis_pass(locations, &weights, to, k > 0 ? PUT_ADD : PUT_FIRST);
}

/* Computes a grid, octave by octave, so that an octave makes its tables once. Octaves are added up
   in the caller's arrays; those of the last block, if it is not full, in the scratch space. */
static void crossing_grid(const struct passes *passes, const struct scarp_grid *grid,
                          const struct scarp_outputs *out, struct workspace work)
{
    const struct scarp_call_plan *const plan = passes->plan;
    const int dimensions = passes->dimensions;
    const size_t count = grid->count[0] * grid->count[1] * (dimensions == 3 ? grid->count[2] : 1);
    const size_t whole = count - count % VEC_LANES;
    struct crossing crossing;
    struct outputs to, stored;
    vf *const last = crossing_begin(&crossing, grid, work.space, passes);
    vf *const spare = last + passes->sums_size;
    const size_t room = work.vectors - (size_t)(spare - work.space);
    const size_t most = least(room / (passes->lattice_size + 1), TILE_BLOCKS);
    struct locations locations = {.lattice = spare + most,
                                  .extent = {.rows = 1},
                                  .fade = plan->fade,
                                  .basis = plan->basis,
                                  .order = passes->basis_order};
    outputs_stored(&stored, last, passes->sums_size, dimensions, plan->order, 0);
    for (int k = 0; k < plan->octaves; k++) {
        locations.octave = &plan->octave[k];
        locations.turn = plan->octave[k].turn;
        for (int axis = 0; axis < dimensions; axis++) {
            crossing_fill(&crossing, passes, k, axis);
            crossing.at[axis] = 0;
        }
        for (size_t first = 0; first < whole; first += locations.extent.blocks * VEC_LANES) {
            locations.extent.blocks = least((whole - first) / VEC_LANES, most);
            outputs_of(&to, out, plan->order, first, 0, spare);
            crossing_tile(passes, &crossing, &locations, k, &to);
        }
        if (whole < count) {
            locations.extent.blocks = 1;
            crossing_tile(passes, &crossing, &locations, k, &stored);
        }
    }
    copy_out(out, whole, &stored, 0, count - whole);
}

/* Computes a grid in parts, which are some indices of its last axis. */
static void crossing_parts(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                           const struct scarp_outputs *out, int dimensions, size_t part,
                           struct workspace work)
{
    const int axis = dimensions - 1;
    const size_t samples = grid->count[0] * (dimensions == 3 ? grid->count[1] : 1);
    struct passes passes;
    passes_choose(&passes, plan, dimensions, DOUBLES);
    for (size_t at = 0; at < grid->count[axis]; at += part) {
        struct scarp_grid some = *grid;
        struct scarp_outputs to;
        some.first[axis] += (int64_t)at;
        some.count[axis] = least(grid->count[axis] - at, part);
        for (int i = 0; i < OUTPUTS; i++) {
            to.array[i] = out->array[i] != NULL ? out->array[i] + at * samples : NULL;
        }
        crossing_grid(&passes, &some, &to, work);
    }
}

#endif
