/* SPDX-License-Identifier: MIT
 *
 * Stage 2 along rows of a grid, the fast path of bases that take unhashed locations, where axes
 * are straight.
 * What depends on x is prepared once for all rows of a tile: the fraction of each sample, and the
 * mixed lattice coordinates of the columns of cells that the strip crosses. A row then draws what
 * it needs of these columns, some at a time, into tables; each block takes from there what the one
 * or few columns have that its lanes are in.
 */
#ifndef SCARP_KERNEL_ROWS_CELLS_H
#define SCARP_KERNEL_ROWS_CELLS_H

#include "../basis/simplex_points.h"
#include "along.h"

/* Tables have a column before the first that a strip crosses, and two after the last. */
#define COLUMNS_BEFORE 1
#define COLUMNS_BEYOND 3

/* Where there are more columns than this for each block, points are served faster one by one. */
#define COLUMNS_PER_BLOCK 2

/* An octave along x, y and z. Columns are counted from the first in the tables. */
struct along_cells {
    const struct scarp_octave *octave;
    size_t blocks, column_blocks; /* of samples; of columns */
    int by_points;                /* whether rows do not pay */
    vf *t, *column;               /* of each block: fractions, and bits of the columns */
    vf *hash;                     /* of each column, mixed */
    uint16_t low[STRIP_BLOCKS],
        high[STRIP_BLOCKS]; /* the columns that a block begins and ends in */
    float y[TILE_ROWS], z;
    uint32_t cell_y[TILE_ROWS], cell_z;
    uint32_t first_cell; /* of the first column, within the period */
};

static size_t most_column_blocks(size_t blocks)
{
    return (COLUMNS_PER_BLOCK * blocks + 1 + COLUMNS_BEYOND) / VEC_LANES + 1;
}

/* Vectors that along_cells needs for a strip. */
static size_t along_cells_size(size_t blocks)
{
    return 2 * blocks + most_column_blocks(blocks);
}

static void along_cells_begin(struct along_cells *along, vf *space, size_t blocks)
{
    along->blocks = blocks;
    along->t = space;
    along->column = space + blocks;
    along->hash = space + 2 * blocks;
}

/* Mixes the coordinates of the columns from `cell` on, which is within the period. */
static void hash_cell_columns(struct along_cells *along, const struct scarp_octave *o,
                              uint32_t cell)
{
    for (size_t b = 0; b < along->column_blocks; b++) {
        uint32_t cells[VEC_LANES];
        for (size_t i = 0; i < VEC_LANES; i++) {
            cells[i] = cell;
            cell = cell == o->last[0] ? 0 : cell + 1;
        }
        along->hash[b] = (vf)vu_turn8(vu_load(cells) * vu_set(HASH_X) + vu_set(o->key[0]));
    }
}

/* The coordinates along an axis, of which some are in `array`. */
VEC_INLINE struct split cells_split(const struct scarp_octave *o, int axis, const double *array,
                                    size_t block, enum axes axes)
{
    struct coordinate_arrays at = {.axes = axes};
    const struct frame f = {DOUBLES, AXES_STRAIGHT, 2};
    vu far = vu_set(0);
    at.array[axis] = array;
    at.advance[axis] = VEC_LANES;
    return unhashed_split(o, axis, &at, block, f, &far);
}

/* Prepares the octave at a strip, whose coordinates are `x`. */
static void along_cells_x(struct along_cells *along, const struct scarp_octave *o, const double *x,
                          enum axes axes)
{
    const size_t blocks = along->blocks, last = blocks * VEC_LANES - 1;
    uint32_t cells[STRIP_BLOCKS * VEC_LANES];
    along->octave = o;
    size_t b = 0;
    do {
        const struct split s = cells_split(o, 0, x, b, AXES_STRAIGHT);
        vu_store(cells + b * VEC_LANES, s.cell);
        along->t[b] = s.t;
    } while (++b < blocks);
    const int descending = (int32_t)(cells[last] - cells[0]) < 0;
    const uint32_t lowest = cells[descending ? last : 0];
    const uint32_t width = cells[descending ? 0 : last] - lowest;
    along->by_points = width > COLUMNS_PER_BLOCK * blocks || !cells_in_order(o, x, blocks);
    if (along->by_points) {
        return;
    }
    along->column_blocks = (width + 1 + COLUMNS_BEYOND) / VEC_LANES + 1;
    const uint32_t first = lowest - COLUMNS_BEFORE;
    for (b = 0; b < blocks; b++) {
        const uint32_t *const of = cells + b * VEC_LANES;
        along->column[b] = (vf)(vu_load(of) - vu_set(first));
        along->low[b] = (uint16_t)(of[descending ? VEC_LANES - 1 : 0] - first);
        along->high[b] = (uint16_t)(of[descending ? 0 : VEC_LANES - 1] - first);
    }
    const vu within = cells_split(o, 0, x, descending ? blocks - 1 : 0, axes).cell;
    const uint32_t cell = within[descending ? VEC_LANES - 1 : 0];
    along->first_cell = cell == 0 ? o->last[0] : cell - 1;
    hash_cell_columns(along, o, along->first_cell);
}

/* Prepares the octave at `count` coordinates along y, padded to whole blocks, and at one along z,
   which fills a block. */
static void along_cells_rows(struct along_cells *along, const struct scarp_octave *o, size_t count,
                             const struct positions *at, enum axes axes, int dimensions)
{
    for (size_t r = 0; r < count; r += VEC_LANES) {
        const struct split s = cells_split(o, 1, (const double *)at->array[1], r / VEC_LANES, axes);
        vf_store(along->y + r, s.t);
        vu_store(along->cell_y + r, s.cell);
    }
    if (dimensions == 3) {
        const struct split s = cells_split(o, 2, (const double *)at->array[2], 0, axes);
        along->z = s.t[0];
        along->cell_z = s.cell[0];
    }
}

/* A lattice coordinate along y or z, mixed. */
VEC_INLINE uint32_t mixed_cell(const struct scarp_octave *o, int axis, uint32_t cell)
{
    const uint32_t h = cell * hash_multiplier[axis] + o->key[axis];
    return h >> 8 | h << 24;
}

VEC_INLINE uint32_t next_cell(const struct scarp_octave *o, int axis, uint32_t cell)
{
    return cell == o->last[axis] ? 0 : cell + 1;
}

VEC_INLINE uint32_t previous_cell(const struct scarp_octave *o, int axis, uint32_t cell)
{
    return cell == 0 ? o->last[axis] : cell - 1;
}

/* b, but a in the lanes that are in a column. */
VEC_INLINE struct sample in_column(vu columns, uint32_t column, const struct sample *a,
                                   const struct sample *b, struct variant v)
{
    const vm here = vm_equal(columns, vu_set(column));
    struct sample s;
#define CHOOSE(i, member, rank) s.member = vm_choose(here, a->member, b->member)
    EACH_OUTPUT(v, CHOOSE);
#undef CHOOSE
    return s;
}

#endif
