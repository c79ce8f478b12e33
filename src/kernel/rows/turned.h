/* SPDX-License-Identifier: MIT
 *
 * Stage 1 along rows of a grid whose axes are turned: p = J x + o, where the part of p that depends
 * on x is prepared once for all rows of a tile, and that of a row once for its samples
 * (../positions.h). Along a row each component of p goes one way: if the last lane of a block is in
 * the cell in which the block on its left begins, both blocks lie in it, and their corners have the
 * same hashes. The bits are those of the passes of doubles, because both parts are rounded before
 * they are added.
 */
#ifndef SCARP_KERNEL_ROWS_TURNED_H
#define SCARP_KERNEL_ROWS_TURNED_H

#include "../far.h"
#include "along.h"

/* Two blocks look for a cell that they share if together they are less than that many cells wide.
   From there on too few find one. */
#define SHARING_WIDTH 0.5

/* Whether hashes are made in a loop of their own (../lattice.h). With 4 lanes it takes 2 % more in
   3D. */
#define TURNED_LOOPS_TWICE (VEC_LANES == 8)

/* Integers in the scratch space, whose vectors are floats. */
typedef uint32_t turned_u32 __attribute__((may_alias));

/* Parts of p along an axis: cells, modulo 2^32, and multiples of 2^-24 cells, below a whole one. */
struct turned_parts {
    turned_u32 *cell, *rest;
};

/* An octave at the samples of a tile, for each axis of its frame: the parts of each column; then,
   for each block, those of its last lane and of the first lane of the block on its left, padded to
   whole vectors; and the parts of each row. */
struct turned_tile {
    struct turned_axis axis[3];
    size_t blocks; /* of a row */
    struct turned_parts column[3], last[3], before[3], row[3];
    struct positions at; /* x of the columns, y of the rows, and z */
    int shares;          /* whether two blocks may lie in one cell */
    int overflows;       /* whether some part is infinite or NaN */
};

/* That many integers, padded to whole vectors. */
static size_t turned_padded(size_t count)
{
    return (count + VEC_LANES - 1) / VEC_LANES * VEC_LANES;
}

/* Vectors of scratch space for a tile. */
static size_t turned_size(int dimensions, size_t rows, size_t blocks)
{
    const size_t parts = blocks * VEC_LANES + 2 * turned_padded(blocks) + turned_padded(rows);
    return (size_t)dimensions * 2 * parts / VEC_LANES;
}

/* Takes arrays of `count` parts from the space at *from. */
static struct turned_parts take_parts(turned_u32 **from, size_t count)
{
    const struct turned_parts parts = {*from, *from + count};
    *from += 2 * count;
    return parts;
}

/* Puts a block of parts, given in units of 2^-24 cells. */
VEC_INLINE void put_parts(const struct turned_parts *to, size_t block, vec_u64 low, vec_u64 high)
{
    vu_store((uint32_t *)to->cell + block * VEC_LANES,
             vu_low_bits((vd)(low >> 24), (vd)(high >> 24)));
    vu_store((uint32_t *)to->rest + block * VEC_LANES,
             vu_low_bits((vd)low, (vd)high) & vu_set(0xffffff));
}

/* Prepares the columns along an axis. Returns 0, or NaN if a part is infinite or NaN. */
VEC_INLINE vd put_columns(const struct turned_tile *t, int axis)
{
    const struct turned_parts to = t->column[axis];
    const double *const x = t->at.array[0];
    const vd j = vd_set(t->axis[axis].j[0]), zero = vd_set(0.0);
    const struct turned_axis none = {.shift = TURNED_SHIFT}; /* rows have the offset */
    vd nan = zero;
    for (size_t b = 0; b < t->blocks; b++) {
        const vd low = j * vd_load(x + b * VEC_LANES);
        const vd high = j * vd_load(x + b * VEC_LANES + VEC_LANES / 2);
        put_parts(&to, b, far_sum(&none, low, zero), far_sum(&none, high, zero));
        nan += far_nan(low, high);
    }
    return nan;
}

/* The same of rows. */
VEC_INLINE vd put_rows(const struct turned_tile *t, int axis, size_t rows, int dimensions)
{
    const struct turned_parts to = t->row[axis];
    const struct turned_axis a = t->axis[axis];
    const double *const y = t->at.array[1];
    const vd z = vd_set(t->at.shared[2]), zero = vd_set(0.0);
    vd nan = zero;
    for (size_t r = 0; r < rows; r += VEC_LANES) {
        const vd low = turned_row_f64(&a, vd_load(y + r), z, dimensions);
        const vd high = turned_row_f64(&a, vd_load(y + r + VEC_LANES / 2), z, dimensions);
        put_parts(&to, r / VEC_LANES, far_sum(&a, zero, low), far_sum(&a, zero, high));
        nan += far_nan(low, high);
    }
    return nan;
}

/* Puts what blocks compare with their neighbours. */
static void put_ends(const struct turned_tile *t, int axis)
{
    const struct turned_parts from = t->column[axis];
    for (size_t b = 0; b < turned_padded(t->blocks); b++) {
        const size_t block = least(b, t->blocks - 1);
        const size_t last = block * VEC_LANES + VEC_LANES - 1;
        const size_t before = block > 0 ? (block - 1) * VEC_LANES : 0;
        t->last[axis].cell[b] = from.cell[last];
        t->last[axis].rest[b] = from.rest[last];
        t->before[axis].cell[b] = from.cell[before];
        t->before[axis].rest[b] = from.rest[before];
    }
}

/* Whether two blocks may lie in one cell along an axis, and cells go up or down along x without a
   break. */
static int may_share(const struct turned_tile *t, int axis)
{
    const double *const x = t->at.array[0];
    const double j = t->axis[axis].j[0];
    const double first = j * x[0], last = j * x[t->blocks * VEC_LANES - 1];
    const double width = t->blocks > 1 ? j * x[2 * VEC_LANES - 1] - first : SHARING_WIDTH;
    return width > -SHARING_WIDTH && width < SHARING_WIDTH && first > -0x1p50 && first < 0x1p50 &&
           last > -0x1p50 && last < 0x1p50;
}

/* Prepares an octave, whose stretch along y is given, for `rows` rows. The arrays are in `space`;
   t->at and t->blocks are set. */
static __attribute__((noinline)) void turned_begin(struct turned_tile *t, vf *space,
                                                   const struct scarp_octave *o, double stretch,
                                                   size_t rows, int dimensions)
{
    turned_u32 *next = (turned_u32 *)space;
    vd nan = vd_set(0.0);
    t->shares = 1;
    VEC_ROLLED_LOOP
    for (int i = 0; i < dimensions; i++) {
        t->axis[i] = turned_axis_of(o, i, i == 1 ? stretch : 1.0);
        t->column[i] = take_parts(&next, t->blocks * VEC_LANES);
        t->last[i] = take_parts(&next, turned_padded(t->blocks));
        t->before[i] = take_parts(&next, turned_padded(t->blocks));
        t->row[i] = take_parts(&next, turned_padded(rows));
        nan += put_columns(t, i) + put_rows(t, i, rows, dimensions);
        t->shares &= may_share(t, i);
    }
    for (int i = 0; i < dimensions && t->shares; i++) {
        put_ends(t, i);
    }
    t->overflows = vu_any((vu)(nan != nan));
}

/* The part of a row along an axis, in all lanes. */
struct turned_row {
    vu cell, rest;
};

/* Adds the parts of a block. */
VEC_INLINE struct split turned_at(const struct turned_parts *parts, size_t at,
                                  const struct turned_row *row)
{
    const vu rest = vu_load((const uint32_t *)parts->rest + at) + row->rest;
    const vu cell = vu_load((const uint32_t *)parts->cell + at) + row->cell;
    const struct split s = {cell + (rest >> 24), turned_fraction(rest)};
    return s;
}

/* How many blocks find their cells at once, in whole vectors. */
#define SHARING_BLOCKS 16

/* Finds for each block from `first` to before `last` bits that are 0 if it shares a cell with the
   block on its left. */
VEC_INLINE void find_cells(uint32_t differ[SHARING_BLOCKS], const struct turned_tile *t,
                           const struct turned_row row[3], size_t first, size_t last,
                           int dimensions)
{
    for (size_t b = first; b < last; b += VEC_LANES) {
        vu bits = vu_set(0);
        for (int i = 0; i < dimensions; i++) {
            bits |=
                turned_at(&t->last[i], b, &row[i]).cell ^ turned_at(&t->before[i], b, &row[i]).cell;
        }
        vu_store(differ + (b - first), bits);
    }
    if (first == 0) {
        differ[0] = 1;
    }
}

/* Stores the fractions of a block, and returns its cells in `cell`. */
VEC_INLINE void turned_block(vf *to, vu cell[3], const struct turned_tile *t, size_t block,
                             const struct turned_row row[3], int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        const struct split s = turned_at(&t->column[i], block * VEC_LANES, &row[i]);
        cell[i] = s.cell;
        to[i] = s.t;
    }
}

/* Puts the blocks of a row on the lattice, of which neighbours share no hashes. The hashes of each
   block come after the fractions of the next, since the chain from a position to its hashes is
   long: out-of-order windows hold only two blocks of it. */
VEC_INLINE void put_turned_row(vf *lattice, const struct scarp_octave *o,
                               const struct turned_tile *t, const struct turned_row row[3],
                               int dimensions, enum corner_form form)
{
    const size_t size = lattice_size(dimensions);
    vu cell[3], next[3];
    turned_block(lattice, cell, t, 0, row, dimensions);
    for (size_t b = 1; b < t->blocks; b++) {
        turned_block(lattice + size, next, t, b, row, dimensions);
        const struct mixed m = mix_axes(o, cell, AXES_TURNED, dimensions);
        lattice_put_corners(lattice, &m, dimensions, form);
        for (int i = 0; i < dimensions; i++) {
            cell[i] = next[i];
        }
        lattice += size;
    }
    const struct mixed m = mix_axes(o, cell, AXES_TURNED, dimensions);
    lattice_put_corners(lattice, &m, dimensions, form);
}

/* Puts the blocks of a row on the lattice, where neighbours may share hashes. */
VEC_INLINE void put_sharing_row(vf *lattice, const struct scarp_octave *o,
                                const struct turned_tile *t, const struct turned_row row[3],
                                int dimensions, enum corner_form form)
{
    const size_t size = lattice_size(dimensions);
    uint32_t differ[SHARING_BLOCKS];
    for (size_t b = 0; b < t->blocks; b++) {
        vu cell[3];
        if (b % SHARING_BLOCKS == 0) {
            find_cells(differ, t, row, b, least(t->blocks, b + SHARING_BLOCKS), dimensions);
        }
        turned_block(lattice, cell, t, b, row, dimensions);
        if (differ[b % SHARING_BLOCKS] != 0) {
            const struct mixed m = mix_axes(o, cell, AXES_TURNED, dimensions);
            lattice_put_corners(lattice, &m, dimensions, form);
        } else {
            for (size_t n = (size_t)dimensions; n < size; n++) {
                lattice[n] = lattice[(ptrdiff_t)n - (ptrdiff_t)size];
            }
        }
        lattice += size;
    }
}

/* Puts the blocks of a row, unhashed. */
VEC_INLINE void put_unhashed_row(vf *to, const struct turned_tile *t,
                                 const struct turned_row row[3], int dimensions)
{
    for (size_t b = 0; b < t->blocks; b++) {
        vu cell[3];
        turned_block(to, cell, t, b, row, dimensions);
        for (int i = 0; i < dimensions; i++) {
            to[dimensions + i] = (vf)cell[i];
        }
        to += unhashed_size(dimensions);
    }
}

/* Makes NaN of the fractions of samples whose p overflows. Blocks have `size` vectors. */
static __attribute__((noinline, cold)) void put_overflows(vf *to, size_t size,
                                                          const struct turned_tile *t, size_t begin,
                                                          size_t rows, int dimensions)
{
    const double *const x = t->at.array[0], *const y = t->at.array[1];
    const vd z = vd_set(t->at.shared[2]);
    for (size_t r = begin; r < begin + rows; r++) {
        for (size_t b = 0; b < t->blocks; b++, to += size) {
            for (int i = 0; i < dimensions; i++) {
                const vd row = turned_row_f64(&t->axis[i], vd_set(y[r]), z, dimensions);
                const vd j = vd_set(t->axis[i].j[0]);
                const vd low = j * vd_load(x + b * VEC_LANES);
                const vd high = j * vd_load(x + b * VEC_LANES + VEC_LANES / 2);
                to[i] += vf_from_vd(far_nan(low, row), far_nan(high, row));
            }
        }
    }
}

/* Puts `rows` rows of a tile from row `begin` on. */
VEC_INLINE void turned_run(vf *to, const struct scarp_octave *octave,
                           const struct turned_tile *tile, size_t begin, size_t rows,
                           int dimensions, enum turned_form form)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    const struct turned_tile t = *tile;
    const enum corner_form corners = form == TURNED_HASHED ? CORNERS_HASHED : CORNERS_MIXED;
    const size_t size = form == TURNED_CELLS ? unhashed_size(dimensions) : lattice_size(dimensions);
    vf *next = to;
    for (size_t r = begin; r < begin + rows; r++, next += t.blocks * size) {
        struct turned_row row[3];
        for (int i = 0; i < dimensions; i++) {
            row[i].cell = vu_set(t.row[i].cell[r]);
            row[i].rest = vu_set(t.row[i].rest[r]);
        }
        if (form == TURNED_CELLS) {
            put_unhashed_row(next, &t, row, dimensions);
        } else if (t.shares) {
            put_sharing_row(next, &o, &t, row, dimensions, corners);
        } else {
            put_turned_row(next, &o, &t, row, dimensions,
                           TURNED_LOOPS_TWICE ? CORNERS_MIXED : corners);
#if TURNED_LOOPS_TWICE
            if (form == TURNED_HASHED) {
                (dimensions == 2 ? hash_blocks2 : hash_blocks3)(next, t.blocks);
            }
#endif
        }
    }
    if (t.overflows) {
        put_overflows(to, size, tile, begin, rows, dimensions);
    }
}

typedef void turned_pass(vf *to, const struct scarp_octave *octave, const struct turned_tile *tile,
                         size_t begin, size_t rows);

#define TURNED_PASS(name, form, d)                                                                 \
    static void name(vf *to, const struct scarp_octave *octave, const struct turned_tile *tile,    \
                     size_t begin, size_t rows)                                                    \
    {                                                                                              \
        turned_run(to, octave, tile, begin, rows, d, form);                                        \
    }

TURNED_PASS(turned2_hashes, TURNED_HASHED, 2)
TURNED_PASS(turned3_hashes, TURNED_HASHED, 3)
TURNED_PASS(turned2_axes, TURNED_MIXED, 2)
TURNED_PASS(turned3_axes, TURNED_MIXED, 3)
TURNED_PASS(turned2_cells, TURNED_CELLS, 2)
TURNED_PASS(turned3_cells, TURNED_CELLS, 3)

/* By [form][dimensions - 2]. */
static turned_pass *const turned_passes[TURNED_FORMS][2] = {
    [TURNED_HASHED] = {turned2_hashes, turned3_hashes},
    [TURNED_MIXED] = {turned2_axes, turned3_axes},
    [TURNED_CELLS] = {turned2_cells, turned3_cells},
};

#undef TURNED_PASS

#endif
