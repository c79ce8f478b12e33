/* SPDX-License-Identifier: MIT
 *
 * An octave along a row of a grid, straight axes: what depends on x is prepared once for a tile of
 * rows; the lattice columns that a row crosses are reduced to their lines (noise.h) once per row,
 * in a small table; each block of samples then reads its lines with permutes instead of hashing.
 * Included by fractal.h. Bits are those of the point passes, because the lines are.
 *
 * A block's lanes must lie in VEC_LANES - 1 neighbouring columns. Where steps are wider, each lane
 * has its own two columns (`wide`), and shares with the others of its row what depends on y and z.
 */
#ifndef SCARP_KERNEL_COLUMNS_H
#define SCARP_KERNEL_COLUMNS_H

#include "octave.h"

/* Columns of a chunk whose blocks are narrow, in blocks; one more than there are samples, and what
   the last permute reads. */
#define COLUMN_BLOCKS (CHUNK_BLOCKS + 2)

/* An octave along x, at a chunk. */
struct along_x {
    uint32_t cell[CHUNK_POINTS]; /* of each sample */
    vf t[CHUNK_BLOCKS];
    int narrow;           /* 0: what follows is unset, and the union has `wide` */
    uint32_t lowest;      /* the first column */
    size_t column_blocks; /* blocks of columns in use */
    struct fade fade[CHUNK_BLOCKS];
    uint32_t base[CHUNK_BLOCKS]; /* each block's first column, counted from `lowest` */
    size_t run[CHUNK_BLOCKS];    /* where a block begins a run: how many blocks it has, all
                                    in one column; 0 for a block that is in several columns */
    union {
        struct {
            vu index[CHUNK_BLOCKS]; /* each lane's column, from the block's first: for vf_permute */
            vu hash[COLUMN_BLOCKS]; /* mixed lattice coordinate of each column */
        } narrow;
        struct axis wide[CHUNK_BLOCKS];
    } u;
};

/* Rows of a tile. */
#define GRID_ROWS 32

/* An octave along y on the rows of a tile, and along z, where all lanes are the same. */
struct along_rows {
    float y[GRID_ROWS], s[GRID_ROWS], u[GRID_ROWS], du[GRID_ROWS], ddu[GRID_ROWS];
    uint32_t hash[2][2][GRID_ROWS]; /* [y][z] of the lower and upper neighbours; 2D: [y][0] */
    vf z;
    struct fade w;
};

enum { LINE_VALUE, LINE_Y, LINE_Z, LINE_YY, LINE_YZ, LINE_ZZ, LINES };

/* The lines of the columns of one row after the other, `column_blocks` for each. */
struct columns {
    const struct along_x *x;
    const struct along_rows *rows;
    vf a[LINES][COLUMN_BLOCKS], b[LINES][COLUMN_BLOCKS];
};

/* Where the blocks and their lanes lie among the columns, from the cell of each sample, which go up
   or down along x. Returns 0 where some block is too wide. */
static int place_columns(struct along_x *x, size_t blocks)
{
    const uint32_t *const cells = x->cell;
    const size_t last = blocks * VEC_LANES - 1;
    const int descending = (int32_t)(cells[last] - cells[0]) < 0;
    const uint32_t lowest = cells[descending ? last : 0];
    const uint32_t highest = cells[descending ? 0 : last] - lowest + 1; /* the one on the right */
    if (highest > CHUNK_POINTS) {
        return 0;
    }
    for (size_t b = 0; b < blocks; b++) {
        const uint32_t *const cell = cells + b * VEC_LANES;
        const uint32_t first = cell[descending ? VEC_LANES - 1 : 0];
        const uint32_t width = cell[descending ? 0 : VEC_LANES - 1] - first;
        if (width >= VEC_LANES - 1) {
            return 0;
        }
        x->base[b] = first - lowest;
        x->u.narrow.index[b] = vf_index(vu_load(cell) - vu_set(first));
        x->run[b] = width == 0;
    }
    for (size_t b = blocks - 1; b-- > 0;) {
        if (x->run[b] != 0 && x->run[b + 1] != 0 && x->base[b] == x->base[b + 1]) {
            x->run[b] = x->run[b + 1] + 1;
        }
    }
    x->lowest = lowest;
    x->column_blocks = highest / VEC_LANES + 1;
    return 1;
}

/* Whether cells, modulo 2^32, go up or down along x without a break: the lattice does not repeat in
   between, no low bits of cells are lost, and nothing is NaN. */
static int cells_in_order(const struct scarp_octave *o, const double *position, size_t blocks)
{
    const double first = o->frequency64 * position[0] + o->offset64[0];
    const double last = o->frequency64 * position[blocks * VEC_LANES - 1] + o->offset64[0];
    const double width = last - first;
    return first > -0x1p50 && first < 0x1p50 && last > -0x1p50 && last < 0x1p50 &&
           width > -0x1p30 && width < 0x1p30;
}

/* The octave at a chunk of coordinates. `order` is the highest derivative that will be asked for.
 */
VEC_INLINE void along_x_run(struct along_x *x, const struct scarp_octave *o, size_t blocks,
                            const double *position, enum scarp_fade fade_kind, enum axes axes,
                            int order)
{
    const void *const positions[3] = {position, NULL, NULL};
    for (size_t b = 0; b < blocks; b++) {
        const struct split s = straight(o, 0, positions, b, 1, axes);
        vu_store(x->cell + b * VEC_LANES, s.cell);
        x->t[b] = s.t;
    }
    x->narrow = cells_in_order(o, position, blocks) && place_columns(x, blocks);
    for (size_t b = 0; x->narrow && b < x->column_blocks; b++) {
        const vu column = vu_lanes() + vu_set(x->lowest + (uint32_t)(b * VEC_LANES));
        x->u.narrow.hash[b] = hash_axis(column, HASH_X, o->key[0]).h0;
    }
    for (size_t b = 0; b < blocks; b++) {
        if (!x->narrow) {
            x->u.wide[b] = hash_axis(vu_load(x->cell + b * VEC_LANES), HASH_X, o->key[0]);
        }
        const struct fade u = fade(fade_kind, x->t[b]);
        x->fade[b].s = u.s;
        x->fade[b].u = u.u;
        if (order >= 1) {
            x->fade[b].du = u.du;
            x->fade[b].ddu = u.ddu;
        }
    }
}

static void along_x(struct along_x *x, const struct scarp_octave *o, size_t blocks,
                    const double *position, enum scarp_fade fade_kind, enum axes axes, int order)
{
    if (fade_kind == SCARP_QUINTIC) {
        along_x_run(x, o, blocks, position, SCARP_QUINTIC, axes, order);
    } else {
        along_x_run(x, o, blocks, position, SCARP_CUBIC, axes, order);
    }
}

/* The octave at `count` coordinates along y, and at one along z. What lies beyond, up to a whole
   block, is computed from what the array has there. */
static void along_rows(struct along_rows *rows, const struct scarp_octave *o, size_t count,
                       const double y[GRID_ROWS], double z, enum scarp_fade fade_kind,
                       int dimensions, enum axes axes)
{
    double same[VEC_LANES];
    for (size_t i = 0; i < VEC_LANES; i++) {
        same[i] = z;
    }
    const void *const positions[3] = {NULL, y, same};
    struct axis hz;
    if (dimensions == 3) {
        const struct split sz = straight(o, 2, positions, 0, 1, axes);
        hz = hash_axis(sz.cell, HASH_Z, o->key[2]);
        rows->z = sz.t;
        rows->w = fade(fade_kind, sz.t);
    }
    for (size_t r = 0; r < count; r += VEC_LANES) {
        const struct split sy = straight(o, 1, positions, r / VEC_LANES, 1, axes);
        const struct axis hy = hash_axis(sy.cell, HASH_Y, o->key[1]);
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
            vu_store(rows->hash[0][0] + r, c.h00);
            vu_store(rows->hash[0][1] + r, c.h01);
            vu_store(rows->hash[1][0] + r, c.h10);
            vu_store(rows->hash[1][1] + r, c.h11);
        }
    }
}

/* One row of them, in all lanes. */
struct along_row {
    vf y, z;
    struct fade v, w;
    vu hash[2][2];
};

VEC_INLINE struct along_row row_of(const struct along_rows *rows, size_t r, int dimensions)
{
    struct along_row row;
    row.y = vf_set(rows->y[r]);
    row.v.s = vf_set(rows->s[r]);
    row.v.u = vf_set(rows->u[r]);
    row.v.du = vf_set(rows->du[r]);
    row.v.ddu = vf_set(rows->ddu[r]);
    for (int i = 0; i < 2; i++) {
        row.hash[i][0] = vu_set(rows->hash[i][0][r]);
        if (dimensions == 3) {
            row.hash[i][1] = vu_set(rows->hash[i][1][r]);
        }
    }
    if (dimensions == 3) {
        row.z = rows->z;
        row.w = rows->w;
    }
    return row;
}

VEC_INLINE void put_line(struct columns *c, int i, size_t block, struct line line)
{
    c->a[i][block] = line.a;
    c->b[i][block] = line.b;
}

/* The lines of the columns whose mixed coordinates are `h`, on a row. */
VEC_INLINE struct column gradient_column(vu h, const struct along_row *r, int dimensions, int order)
{
    return dimensions == 2
               ? gradient_column2(h * r->hash[0][0], h * r->hash[1][0], r->y, r->v, order)
               : gradient_column3(h * r->hash[0][0], h * r->hash[0][1], h * r->hash[1][0],
                                  h * r->hash[1][1], r->y, r->z, r->v, r->w, order);
}

VEC_INLINE struct value_column value_column(vu h, const struct along_row *r, int dimensions,
                                            int order)
{
    return dimensions == 2 ? value_column2(h * r->hash[0][0], h * r->hash[1][0], r->v, order)
                           : value_column3(h * r->hash[0][0], h * r->hash[0][1], h * r->hash[1][0],
                                           h * r->hash[1][1], r->v, r->w, order);
}

/* Reduces the columns of row r to their lines, from block `at` of the tables. */
VEC_INLINE void reduce_gradient(struct columns *columns, size_t row, size_t at, int dimensions,
                                int order)
{
    const struct along_x *const x = columns->x;
    const struct along_row r = row_of(columns->rows, row, dimensions);
    for (size_t i = 0; i < x->column_blocks; i++) {
        const struct column c = gradient_column(x->u.narrow.hash[i], &r, dimensions, order);
        put_line(columns, LINE_VALUE, at + i, c.value);
        if (order >= 1) {
            put_line(columns, LINE_Y, at + i, c.y);
            if (dimensions == 3) {
                put_line(columns, LINE_Z, at + i, c.z);
            }
        }
        if (order >= 2) {
            put_line(columns, LINE_YY, at + i, c.yy);
            if (dimensions == 3) {
                put_line(columns, LINE_YZ, at + i, c.yz);
                put_line(columns, LINE_ZZ, at + i, c.zz);
            }
        }
    }
}

VEC_INLINE void reduce_value(struct columns *columns, size_t row, size_t at, int dimensions,
                             int order)
{
    const struct along_x *const x = columns->x;
    const struct along_row r = row_of(columns->rows, row, dimensions);
    for (size_t i = 0; i < x->column_blocks; i++) {
        const struct value_column c = value_column(x->u.narrow.hash[i], &r, dimensions, order);
        columns->b[LINE_VALUE][at + i] = c.value;
        if (order >= 1) {
            columns->b[LINE_Y][at + i] = c.y;
            if (dimensions == 3) {
                columns->b[LINE_Z][at + i] = c.z;
            }
        }
        if (order >= 2) {
            columns->b[LINE_YY][at + i] = c.yy;
            if (dimensions == 3) {
                columns->b[LINE_YZ][at + i] = c.yz;
                columns->b[LINE_ZZ][at + i] = c.zz;
            }
        }
    }
}

/* Each lane's column, and the one on its right. */
struct lanes {
    uint32_t base;
    vu left, right;
};

/* A number of both columns. */
struct both {
    vf left, right;
};

/* `single`: all lanes are in one column. */
VEC_INLINE struct both of_columns(const vf *table, const struct lanes *at, int single)
{
    const float *const numbers = (const float *)table + at->base;
    if (single) {
        const struct both same = {vf_set(numbers[0]), vf_set(numbers[1])};
        return same;
    }
    const vf run = vf_load(numbers);
    const struct both each = {vf_permute(run, at->left), vf_permute(run, at->right)};
    return each;
}

VEC_INLINE void get_lines(const struct columns *c, int i, const struct lanes *at, struct line *left,
                          struct line *right, int single)
{
    const struct both a = of_columns(c->a[i], at, single);
    const struct both b = of_columns(c->b[i], at, single);
    *left = (struct line){a.left, b.left};
    *right = (struct line){a.right, b.right};
}

VEC_INLINE void get_columns(const struct columns *c, const struct lanes *at, struct column *l,
                            struct column *r, int dimensions, int order, int single)
{
    get_lines(c, LINE_VALUE, at, &l->value, &r->value, single);
    if (order >= 1) {
        get_lines(c, LINE_Y, at, &l->y, &r->y, single);
        if (dimensions == 3) {
            get_lines(c, LINE_Z, at, &l->z, &r->z, single);
        }
    }
    if (order >= 2) {
        get_lines(c, LINE_YY, at, &l->yy, &r->yy, single);
        if (dimensions == 3) {
            get_lines(c, LINE_YZ, at, &l->yz, &r->yz, single);
            get_lines(c, LINE_ZZ, at, &l->zz, &r->zz, single);
        }
    }
}

VEC_INLINE void get_value(const struct columns *c, int i, const struct lanes *at, vf *left,
                          vf *right, int single)
{
    const struct both b = of_columns(c->b[i], at, single);
    *left = b.left;
    *right = b.right;
}

VEC_INLINE void get_value_columns(const struct columns *c, const struct lanes *at,
                                  struct value_column *l, struct value_column *r, int dimensions,
                                  int order, int single)
{
    get_value(c, LINE_VALUE, at, &l->value, &r->value, single);
    if (order >= 1) {
        get_value(c, LINE_Y, at, &l->y, &r->y, single);
        if (dimensions == 3) {
            get_value(c, LINE_Z, at, &l->z, &r->z, single);
        }
    }
    if (order >= 2) {
        get_value(c, LINE_YY, at, &l->yy, &r->yy, single);
        if (dimensions == 3) {
            get_value(c, LINE_YZ, at, &l->yz, &r->yz, single);
            get_value(c, LINE_ZZ, at, &l->zz, &r->zz, single);
        }
    }
}

/* The lines to the left and right of a block. */
struct sides {
    struct column gl, gr;
    struct value_column vl, vr;
};

VEC_INLINE struct sides get_sides(const struct columns *columns, const struct lanes *at, int single,
                                  enum scarp_basis basis, int dimensions, int order)
{
    struct sides s;
    if (basis == SCARP_GRADIENT) {
        get_columns(columns, at, &s.gl, &s.gr, dimensions, order, single);
    } else {
        get_value_columns(columns, at, &s.vl, &s.vr, dimensions, order, single);
    }
    return s;
}

VEC_INLINE struct sample join_sides(const struct along_x *x, size_t b, const struct sides *s,
                                    enum scarp_basis basis, int dimensions, int order)
{
    return basis == SCARP_GRADIENT ? join(&s->gl, &s->gr, x->t[b], x->fade[b], dimensions, order)
                                   : value_join(&s->vl, &s->vr, x->fade[b], dimensions, order);
}

/* Row `to` of samples from the columns at block `at` of the tables. */
VEC_INLINE void sample_row(const struct columns *columns, size_t at, size_t blocks,
                           const struct weights *weights, int first,
                           const struct scarp_samples *to_row, enum scarp_basis basis,
                           int dimensions, int order)
{
    const struct along_x *const x = columns->x;
    const struct weights w = *weights;
    const struct scarp_samples to = *to_row;
    const uint32_t offset = (uint32_t)(at * VEC_LANES);
    for (size_t b = 0; b < blocks;) {
        const vu left = x->u.narrow.index[b];
        const struct lanes lanes = {x->base[b] + offset, left, left + vu_set(VF_INDEX_NEXT)};
        if (x->run[b] == 0) {
            const struct sides s = get_sides(columns, &lanes, 0, basis, dimensions, order);
            const struct sample n = join_sides(x, b, &s, basis, dimensions, order);
            add_sample(&to, first, &to, b, &n, &w, dimensions, order);
            b++;
            continue;
        }
        const struct sides s = get_sides(columns, &lanes, 1, basis, dimensions, order);
        for (const size_t end = b + x->run[b]; b < end; b++) {
            const struct sample n = join_sides(x, b, &s, basis, dimensions, order);
            add_sample(&to, first, &to, b, &n, &w, dimensions, order);
        }
    }
}

/* Row r of samples `to` where blocks are wide: each lane has its own two columns. */
VEC_INLINE void sample_wide_row(const struct columns *columns, size_t row, size_t blocks,
                                const struct weights *weights, int first,
                                const struct scarp_samples *to_row, enum scarp_basis basis,
                                int dimensions, int order)
{
    const struct along_x *const x = columns->x;
    const struct along_row r = row_of(columns->rows, row, dimensions);
    const struct weights w = *weights;
    const struct scarp_samples to = *to_row;
    for (size_t b = 0; b < blocks; b++) {
        const struct axis h = x->u.wide[b];
        struct sides s;
        if (basis == SCARP_GRADIENT) {
            s.gl = gradient_column(h.h0, &r, dimensions, order);
            s.gr = gradient_column(h.h1, &r, dimensions, order);
        } else {
            s.vl = value_column(h.h0, &r, dimensions, order);
            s.vr = value_column(h.h1, &r, dimensions, order);
        }
        const struct sample n = join_sides(x, b, &s, basis, dimensions, order);
        add_sample(&to, first, &to, b, &n, &w, dimensions, order);
    }
}

/* The block after the last one in use is read too, though no lane of it is chosen. */
static void clear_block(struct columns *columns, size_t at)
{
    for (int i = 0; i < LINES; i++) {
        columns->a[i][at] = vf_set(0.0f);
        columns->b[i][at] = vf_set(0.0f);
    }
}

/* As many rows at a time as the tables have room for: first all their columns, then all their
   samples, so that neither waits for the other. */
VEC_INLINE void sample_rows(struct columns *columns, size_t rows, size_t blocks,
                            const struct weights *weights, int first,
                            const struct scarp_samples *to, enum scarp_basis basis, int dimensions,
                            int order)
{
    if (!columns->x->narrow) {
        for (size_t r = 0; r < rows; r++) {
            sample_wide_row(columns, r, blocks, weights, first, &to[r], basis, dimensions, order);
        }
        return;
    }
    const size_t column_blocks = columns->x->column_blocks;
    const size_t room = (COLUMN_BLOCKS - 1) / column_blocks;
    for (size_t begin = 0; begin < rows; begin += room) {
        const size_t end = rows - begin < room ? rows : begin + room;
        for (size_t r = begin; r < end; r++) {
            const size_t at = (r - begin) * column_blocks;
            if (basis == SCARP_GRADIENT) {
                reduce_gradient(columns, r, at, dimensions, order);
            } else {
                reduce_value(columns, r, at, dimensions, order);
            }
        }
        clear_block(columns, (end - begin) * column_blocks);
        for (size_t r = begin; r < end; r++) {
            sample_row(columns, (r - begin) * column_blocks, blocks, weights, first, &to[r], basis,
                       dimensions, order);
        }
    }
}

/* An octave on the rows of a tile is added to `to`, one for each row, or starts it if `first`. */
typedef void columns_pass(struct columns *columns, size_t rows, size_t blocks,
                          const struct weights *weights, int first, const struct scarp_samples *to);

#define COLUMNS_PASS(name, basis, dims, order)                                                     \
    static void name(struct columns *columns, size_t rows, size_t blocks,                          \
                     const struct weights *weights, int first, const struct scarp_samples *to)     \
    {                                                                                              \
        if (first) {                                                                               \
            sample_rows(columns, rows, blocks, weights, 1, to, basis, dims, order);                \
        } else {                                                                                   \
            sample_rows(columns, rows, blocks, weights, 0, to, basis, dims, order);                \
        }                                                                                          \
    }

COLUMNS_PASS(gradient2_columns0, SCARP_GRADIENT, 2, 0)
COLUMNS_PASS(gradient2_columns1, SCARP_GRADIENT, 2, 1)
COLUMNS_PASS(gradient2_columns2, SCARP_GRADIENT, 2, 2)
COLUMNS_PASS(gradient3_columns0, SCARP_GRADIENT, 3, 0)
COLUMNS_PASS(gradient3_columns1, SCARP_GRADIENT, 3, 1)
COLUMNS_PASS(gradient3_columns2, SCARP_GRADIENT, 3, 2)
COLUMNS_PASS(value2_columns0, SCARP_VALUE, 2, 0)
COLUMNS_PASS(value2_columns1, SCARP_VALUE, 2, 1)
COLUMNS_PASS(value2_columns2, SCARP_VALUE, 2, 2)
COLUMNS_PASS(value3_columns0, SCARP_VALUE, 3, 0)
COLUMNS_PASS(value3_columns1, SCARP_VALUE, 3, 1)
COLUMNS_PASS(value3_columns2, SCARP_VALUE, 3, 2)

#undef COLUMNS_PASS

/* By [dimensions - 2][basis][order]. */
static columns_pass *const columns_passes[2][2][3] = {
    {{gradient2_columns0, gradient2_columns1, gradient2_columns2},
     {value2_columns0, value2_columns1, value2_columns2}},
    {{gradient3_columns0, gradient3_columns1, gradient3_columns2},
     {value3_columns0, value3_columns1, value3_columns2}},
};

#endif
