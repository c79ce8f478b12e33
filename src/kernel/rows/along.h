/* SPDX-License-Identifier: MIT
 *
 * Prepares an octave with straight axes along the axes of a grid: along x for the blocks that all
 * rows of a tile share, and along y and z for the rows.
 *
 *     columns     0           1           2           3        of the lattice
 *                 |           |           |           |
 *     samples     |  .  .  .  |  .  .  .  |  .  .  .  |        of a row, 1/4 cell apart
 *                 |           |           |           |
 *     block 0        [.  .  .    .]                            each lane needs the lines of the
 *     block 1                        [.  .    .  .]            columns at its left and right
 *
 * Along x, each block gets the fractions of its samples and the number of its first column; each
 * column gets its hash. Along y and z, each row gets its two cells, fractions and fades. rows.h
 * computes lines a x + b of the columns from these, once per row, and looks them up per block.
 */
#ifndef SCARP_KERNEL_ROWS_ALONG_H
#define SCARP_KERNEL_ROWS_ALONG_H

#include "../basis/basis.h"

/* The most blocks of a strip, and the most rows of a tile. The more, the less often is prepared
   what they share; but the stack is small: driver.h. */
#define STRIP_BLOCKS (VEC_LANES == 16 ? 32 : 384 / VEC_LANES)
#ifndef TILE_ROWS
#define TILE_ROWS 96
#endif

/* Blocks of columns that a table reads. */
#define TABLE_BLOCKS (VF_TABLE / VEC_LANES)

/* With this many blocks per column, it pays to keep the lines of one column instead of a table. */
#define MIN_RUN 4

/* How the rows of a strip get their lines. */
enum columns_kind {
    WIDE,   /* each sample computes those of its own two columns */
    TABLES, /* from tables in memory: rows.h */
    SLIDES  /* from tables that slide on along the row: rows.h, slide.h */
};

/* Neighbouring blocks that read their lines from one table. */
struct stretch {
    uint32_t base; /* the table's first column, counted from the strip's lowest */
    uint16_t blocks;
    uint16_t in_column; /* whether all lanes are in that column and need no table */
};

/* A block of samples along x. */
struct along_block {
    vf t;
    struct fade fade;
    vf index; /* the bits of each lane's column, from the table's first, for vf_permute */
};

/* An octave along x. */
struct along_x {
    size_t blocks;
    struct along_block *block;
    vf *hash; /* the bits of mixed lattice coordinates: of each column; WIDE: of both neighbours
                 of each sample */
    enum columns_kind kind; /* the next two members are unset if WIDE */
    uint32_t lowest;        /* the first column */
    size_t column_blocks;   /* blocks of columns in use */
    struct stretch stretch[STRIP_BLOCKS];
};

/* An octave along y on the rows of a tile, and along z, where all lanes are the same. */
struct along_rows {
    float y[TILE_ROWS], s[TILE_ROWS], u[TILE_ROWS], du[TILE_ROWS], ddu[TILE_ROWS];
    uint32_t hash[2][2][TILE_ROWS]; /* [y][z] of the lower and upper neighbours; 2D: [y][0] */
    vf z;
    struct fade w;
    int component; /* of vector noise, which rows are of */
};

/* Vectors that along_x needs for a strip. */
static size_t along_size(size_t blocks)
{
    const size_t narrow = blocks + 1 + TABLE_BLOCKS, wide = 2 * blocks;
    return blocks * (sizeof(struct along_block) / sizeof(vf)) + (narrow > wide ? narrow : wide);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* The end of a run: the stretch from block b on whose samples all lie in one column. A block that
   crosses columns is a stretch of its own. */
static size_t end_of_run(const uint32_t *cells, size_t b, size_t blocks)
{
    const uint32_t column = cells[b * VEC_LANES];
    size_t end = b;
    while (end < blocks && cells[end * VEC_LANES + VEC_LANES - 1] == column) {
        end++;
    }
    return end > b ? end : b + 1;
}

/* The end of a window: the stretch from block b on whose blocks begin in the same VEC_LANES
   columns, counted from the strip's first. */
static size_t end_of_window(const uint32_t *cells, size_t b, size_t blocks)
{
    const uint32_t window = (cells[b * VEC_LANES] - cells[0]) / VEC_LANES;
    size_t end = b;
    while (end < blocks && (cells[end * VEC_LANES] - cells[0]) / VEC_LANES == window) {
        end++;
    }
    return end;
}

/* Cuts the blocks of a strip into stretches and finds each lane's column in the table of its
   stretch. `cells` has the column of each sample; they go up or down along x. Stretches are runs if
   there are many blocks to a column. Else they are windows if tables can slide, which they do
   upwards only. Else they are as long as a table reaches. Returns WIDE if a block needs more
   columns than a table has, or if two columns for each sample cost less: if there are nearly as
   many columns as samples, or more if tables slide (measured). */
static enum columns_kind stretch_columns(struct along_x *x, const uint32_t *cells, size_t blocks)
{
    const size_t count = blocks * VEC_LANES;
    const int descending = (int32_t)(cells[count - 1] - cells[0]) < 0;
    const uint32_t lowest = cells[descending ? count - 1 : 0];
    const size_t width = (size_t)(cells[descending ? 0 : count - 1] - lowest);
    const int runs = blocks >= MIN_RUN * (width + 1);
    const int slides = VF_TABLE > VEC_LANES && !runs && !descending;
    if (width >= (slides ? count : count * 7 / 8)) {
        return WIDE;
    }
    /* n samples cross at most (n - 1) (width + 1) / (count - 1) columns, rounded up. */
    const size_t most = (VF_TABLE - 2) * (count - 1) / (width + 1) + 1;
    const size_t reach = most < VEC_LANES ? 1 : most / VEC_LANES;
    struct stretch *stretch = x->stretch;
    for (size_t b = 0, end; b < blocks; b = end, stretch++) {
        end = runs     ? end_of_run(cells, b, blocks)
              : slides ? end_of_window(cells, b, blocks)
                       : least(b + reach, blocks);
        const uint32_t first = cells[b * VEC_LANES], last = cells[end * VEC_LANES - 1];
        const uint32_t left = descending ? last : first, right = descending ? first : last;
        const uint32_t base = left - (slides ? (left - lowest) % VEC_LANES : 0);
        if (right - base > VF_TABLE - 2) {
            return WIDE;
        }
        stretch->base = base - lowest;
        stretch->blocks = (uint16_t)(end - b);
        stretch->in_column = (uint16_t)(runs && first == last);
        for (size_t i = b; i < end; i++) {
            x->block[i].index = (vf)vf_index(vu_load(cells + i * VEC_LANES) - vu_set(base));
        }
    }
    x->lowest = lowest;
    x->column_blocks = (width + 1) / VEC_LANES + 1; /* with the column on the right */
    return slides ? SLIDES : TABLES;
}

/* Whether cells, modulo 2^32, go up or down along x without a break: the lattice does not repeat in
   between, no low bits of cells are lost, and nothing is NaN. */
static int cells_in_order(const struct scarp_octave *o, const double *position, size_t blocks)
{
    const double first = o->frequency64 * position[0] + o->offset[0];
    const double last = o->frequency64 * position[blocks * VEC_LANES - 1] + o->offset[0];
    const double width = last - first;
    return first > -0x1p50 && first < 0x1p50 && last > -0x1p50 && last < 0x1p50 &&
           width > -0x1p30 && width < 0x1p30;
}

/* Hashes the two columns of each sample. */
VEC_INLINE void hash_samples(struct along_x *x, const struct scarp_octave *o, const uint32_t *cells,
                             const struct positions *at, struct frame f)
{
    for (size_t b = 0; b < x->blocks; b++) {
        const vu cell =
            axes_repeat(f.axes) ? position(o, 0, at, b, f).cell : vu_load(cells + b * VEC_LANES);
        const struct axis h = hash_axis(cell, o, 0, f.axes);
        x->hash[2 * b] = (vf)h.h0;
        x->hash[2 * b + 1] = (vf)h.h1;
    }
}

/* Hashes the columns from the lowest one on. */
VEC_INLINE void hash_columns(struct along_x *x, const struct scarp_octave *o, const uint32_t *cells,
                             const struct positions *at, struct frame f)
{
    for (size_t b = 0; !axes_repeat(f.axes) && b < x->column_blocks; b++) {
        const vu column = vu_lanes() + vu_set(x->lowest + (uint32_t)(b * VEC_LANES));
        x->hash[b] = (vf)hash_axis(column, o, 0, f.axes).h0;
    }
    if (axes_repeat(f.axes)) {
        const int upwards = cells[0] == x->lowest;
        uint32_t column[VEC_LANES];
        vu_store(column, position(o, 0, at, upwards ? 0 : x->blocks - 1, f).cell);
        uint32_t next = column[upwards ? 0 : VEC_LANES - 1];
        for (size_t b = 0; b < x->column_blocks; b++) {
            for (size_t i = 0; i < VEC_LANES; i++) {
                column[i] = next;
                next = next == o->last[0] ? 0 : next + 1;
            }
            x->hash[b] = (vf)hash_axis(vu_load(column), o, 0, f.axes).h0;
        }
    }
}

/* Prepares the octave at a strip, whose coordinates are at->array[0]. A branch for the fade at each
   block costs nothing here. */
static void along_x(struct along_x *x, const struct scarp_octave *o, size_t blocks,
                    const struct positions *at, enum scarp_fade kind, enum axes axes)
{
    const struct frame f = {ROW, axes, 2};
    uint32_t cells[STRIP_BLOCKS * VEC_LANES];
    struct frame straight = f; /* cells go on where the lattice repeats */
    straight.axes = axes_repeat(f.axes) ? AXES_STRAIGHT : f.axes;
    x->blocks = blocks;
    size_t i = 0;
    do { /* a `for` would have gcc 12 warn at -O2 that `cells` may stay unset */
        const struct split s = position(o, 0, at, i, straight);
        vu_store(cells + i * VEC_LANES, s.cell);
        x->block[i].t = s.t;
        x->block[i].fade = fade(kind, s.t);
    } while (++i < blocks);
    x->kind = !VEC_SMALL && cells_in_order(o, at->array[0], blocks)
                  ? stretch_columns(x, cells, blocks)
                  : WIDE;
    if (x->kind == WIDE) {
        hash_samples(x, o, cells, at, f);
    } else {
        hash_columns(x, o, cells, at, f);
    }
}

/* Prepares the octave at `count` coordinates along y, padded to whole blocks, and at one along z,
   which fills a block. */
static void along_rows(struct along_rows *rows, const struct scarp_octave *o, size_t count,
                       const struct positions *at, enum scarp_fade fade_kind, struct frame f)
{
    const int dimensions = f.dimensions;
    struct axis hz;
    if (dimensions == 3) {
        const struct split sz = position(o, 2, at, 0, f);
        hz = hash_axis(sz.cell, o, 2, f.axes);
        rows->z = sz.t;
        rows->w = fade(fade_kind, sz.t);
    }
    for (size_t r = 0; r < count; r += VEC_LANES) {
        const struct split sy = position(o, 1, at, r / VEC_LANES, f);
        const struct axis hy = hash_axis(sy.cell, o, 1, f.axes);
        const struct fade v = fade(fade_kind, sy.t);
        vf_store(rows->y + r, sy.t);
        vf_store(rows->s + r, v.s);
        vf_store(rows->u + r, v.u);
        vf_store(rows->du + r, v.du);
        vf_store(rows->ddu + r, v.ddu);
        if (dimensions == 2) {
            vu_store(rows->hash[0][0] + r, hy.h0);
            vu_store(rows->hash[1][0] + r, hy.h1);
        } else {
            const struct corners_yz c = hash_yz(hy, hz);
            vu_store(rows->hash[0][0] + r, c.h[0][0]);
            vu_store(rows->hash[0][1] + r, c.h[0][1]);
            vu_store(rows->hash[1][0] + r, c.h[1][0]);
            vu_store(rows->hash[1][1] + r, c.h[1][1]);
        }
    }
}

/* One row of struct along_rows, in all lanes. */
struct along_row {
    struct across at;
    struct corners_yz h;
    int component;
};

VEC_INLINE struct along_row row_of(const struct along_rows *rows, size_t r,
                                   const struct directions *directions, int dimensions)
{
    struct along_row row;
    row.component = rows->component;
    row.at.directions = directions;
    row.at.y = vf_set(rows->y[r]);
    row.at.v.s = vf_set(rows->s[r]);
    row.at.v.u = vf_set(rows->u[r]);
    row.at.v.du = vf_set(rows->du[r]);
    row.at.v.ddu = vf_set(rows->ddu[r]);
    row.h.h[0][0] = vu_set(rows->hash[0][0][r]);
    row.h.h[1][0] = vu_set(rows->hash[1][0][r]);
    row.at.has_dots = VEC_DOTS;
    if (VEC_DOTS && dimensions == 2) {
        row.at.dots[0][0] = dots2(row.at.y);
        row.at.dots[1][0] = dots2(row.at.v.s);
    }
    if (dimensions == 3) {
        row.h.h[0][1] = vu_set(rows->hash[0][1][r]);
        row.h.h[1][1] = vu_set(rows->hash[1][1][r]);
        row.at.z = rows->z;
        row.at.w = rows->w;
    }
    if (VEC_DOTS && dimensions == 3) {
        row.at.dots[0][0] = dots3(row.at.y, row.at.z);
        row.at.dots[0][1] = dots3(row.at.y, row.at.w.s);
        row.at.dots[1][0] = dots3(row.at.v.s, row.at.z);
        row.at.dots[1][1] = dots3(row.at.v.s, row.at.w.s);
    }
    return row;
}

#endif
