/* SPDX-License-Identifier: MIT
 *
 * An octave along a row of a grid, straight axes: what depends on x is prepared once for a tile of
 * rows; the lattice columns that a row crosses are reduced to their lines (noise.h) once per row,
 * in a small table; each block of samples then reads its lines with permutes instead of hashing,
 * from registers that serve as many blocks as they reach (a stretch). Included by fractal.h. Bits
 * are those of the point passes, because the lines are.
 *
 * Tables of two vectors, AVX-512's, need no memory where columns go up along a row: slide.h.
 *
 * A table serves lanes in VF_TABLE - 1 neighbouring columns. Where a block needs more, or columns
 * are nearly as many as samples, each lane has its own two columns (`wide`), and shares with the
 * others of its row what depends on y and z.
 */
#ifndef SCARP_KERNEL_COLUMNS_H
#define SCARP_KERNEL_COLUMNS_H

#include "slide.h"

/* The lines of the columns of one row after the other, `column_blocks` for each (TABLES only). */
struct columns {
    const struct along_x *x;
    const struct along_rows *rows;
    vf a[LINES][COLUMN_BLOCKS], b[LINES][COLUMN_BLOCKS];
};

VEC_INLINE void put_line(struct columns *c, int i, size_t block, struct line line)
{
    c->a[i][block] = line.a;
    c->b[i][block] = line.b;
}

VEC_INLINE void put_gradient(struct columns *columns, size_t at, const struct column *c,
                             int dimensions, int order)
{
#define DO(i, name) put_line(columns, i, at, c->name)
    EACH_LINE(DO);
#undef DO
}

VEC_INLINE void put_value(struct columns *columns, size_t at, const struct value_column *c,
                          int dimensions, int order)
{
#define DO(i, name) columns->b[i][at] = c->name
    EACH_LINE(DO);
#undef DO
}

/* Reduces the columns of a row to their lines, from block `at` of the tables. */
VEC_INLINE void reduce_row(struct columns *columns, size_t row, size_t at, enum scarp_basis basis,
                           int dimensions, int order)
{
    const struct along_x *const x = columns->x;
    const struct along_row r = row_of(columns->rows, row, dimensions);
    for (size_t i = 0; i < x->column_blocks; i++) {
        if (basis == SCARP_GRADIENT) {
            const struct column c = gradient_column(x->u.narrow.hash[i], &r, dimensions, order);
            put_gradient(columns, at + i, &c, dimensions, order);
        } else {
            const struct value_column c = value_column(x->u.narrow.hash[i], &r, dimensions, order);
            put_value(columns, at + i, &c, dimensions, order);
        }
    }
}

VEC_INLINE void open_line(struct stretch_line *l, const struct columns *c, int i, size_t base,
                          int in_column, enum scarp_basis basis)
{
    const float *const a = (const float *)c->a[i] + base;
    const float *const b = (const float *)c->b[i] + base;
    if (in_column) {
        l->left.b = vf_set(b[0]);
        l->right.b = vf_set(b[1]);
    } else {
        l->b = vf_table_load(b);
    }
    if (basis == SCARP_GRADIENT && in_column) {
        l->left.a = vf_set(a[0]);
        l->right.a = vf_set(a[1]);
    } else if (basis == SCARP_GRADIENT) {
        l->a = vf_table_load(a);
    }
}

VEC_INLINE struct stretch_lines open_lines(const struct columns *c, size_t base, int in_column,
                                           enum scarp_basis basis, int dimensions, int order)
{
    struct stretch_lines l;
#define DO(i, name) open_line(&l.line[i], c, i, base, in_column, basis)
    EACH_LINE(DO);
#undef DO
    return l;
}

/* Row `to` of samples from the columns at block `at` of the tables. */
VEC_INLINE void table_row(const struct columns *columns, size_t at, size_t blocks,
                          const struct weights *weights, int first,
                          const struct scarp_samples *to_row, enum scarp_basis basis,
                          int dimensions, int order)
{
    const struct along_x *const x = columns->x;
    const struct weights w = *weights;
    const struct scarp_samples to = *to_row;
    const struct stretch *stretch = x->stretch;
    for (size_t b = 0; b < blocks; stretch++) {
        const size_t end = b + stretch->blocks, base = at * VEC_LANES + stretch->base;
        if (stretch->in_column) {
            const struct stretch_lines l = open_lines(columns, base, 1, basis, dimensions, order);
            const struct sides s = get_sides(&l, vu_set(0), 1, basis, dimensions, order);
            VEC_SHORT_LOOP
            for (; b < end; b++) {
                const struct sample n = join_sides(x, b, &s, basis, dimensions, order);
                add_sample(&to, first, &to, b, &n, &w, dimensions, order);
            }
            continue;
        }
        const struct stretch_lines l = open_lines(columns, base, 0, basis, dimensions, order);
        for (; b < end; b++) {
            const vu at_columns = x->u.narrow.index[b];
            const struct sides s = get_sides(&l, at_columns, 0, basis, dimensions, order);
            const struct sample n = join_sides(x, b, &s, basis, dimensions, order);
            add_sample(&to, first, &to, b, &n, &w, dimensions, order);
        }
    }
}

/* Row r of samples `to` where blocks are wide: each lane has its own two columns. */
VEC_INLINE void wide_row(const struct columns *columns, size_t row, size_t blocks,
                         const struct weights *weights, int first,
                         const struct scarp_samples *to_row, enum scarp_basis basis, int dimensions,
                         int order)
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

/* Tables read what comes after the last block in use, too, though no lane of it is chosen. (After
   the last rows, which may be fewer, come those before them.) */
static void clear_blocks(struct columns *columns, size_t at)
{
    for (int i = 0; i < LINES; i++) {
        for (size_t n = 0; n < TABLE_BLOCKS; n++) {
            columns->a[i][at + n] = vf_set(0.0f);
            columns->b[i][at + n] = vf_set(0.0f);
        }
    }
}

/* Row r, whose columns are at block `at` of the tables, if it has any there. Wide rows are slower
   than memory, and never streamed. */
VEC_INLINE void sample_row(const struct columns *columns, size_t r, size_t at, size_t blocks,
                           const struct weights *weights, int first, const struct scarp_samples *to,
                           enum scarp_basis basis, int dimensions, int order)
{
    if (first != STREAM && columns->x->kind == WIDE) {
        wide_row(columns, r, blocks, weights, first, to, basis, dimensions, order);
    } else if (VF_TABLE > VEC_LANES && columns->x->kind == SLIDES) {
        slide_row(columns->x, columns->rows, r, blocks, weights, first, to, basis, dimensions,
                  order);
    } else {
        table_row(columns, at, blocks, weights, first, to, basis, dimensions, order);
    }
}

/* As many rows at a time as the tables have room for: first all their columns, then all their
   samples, so that neither waits for the other. */
VEC_INLINE void sample_rows(struct columns *columns, size_t rows, size_t blocks,
                            const struct weights *weights, int first,
                            const struct scarp_samples *to, enum scarp_basis basis, int dimensions,
                            int order)
{
    const enum columns_kind kind = columns->x->kind;
    const size_t column_blocks = kind == TABLES ? columns->x->column_blocks : 0;
    size_t room = rows;
    if (kind == TABLES) {
        room = least(rows, (COLUMN_BLOCKS - TABLE_BLOCKS) / column_blocks);
        clear_blocks(columns, room * column_blocks);
    }
    for (size_t begin = 0; begin < rows; begin += room) {
        const size_t end = least(rows, begin + room);
        for (size_t r = begin; kind == TABLES && r < end; r++) {
            reduce_row(columns, r, (r - begin) * column_blocks, basis, dimensions, order);
        }
        for (size_t r = begin; r < end; r++) {
            const size_t at = (r - begin) * column_blocks;
            if (first == STREAM && kind != WIDE) {
                sample_row(columns, r, at, blocks, weights, STREAM, &to[r], basis, dimensions,
                           order);
            } else if (first) {
                sample_row(columns, r, at, blocks, weights, 1, &to[r], basis, dimensions, order);
            } else {
                sample_row(columns, r, at, blocks, weights, 0, &to[r], basis, dimensions, order);
            }
        }
    }
}

/* An octave on the rows of a tile is added to `to`, one for each row, or starts it if `first`,
   which may be STREAM. */
typedef void columns_pass(struct columns *columns, size_t rows, size_t blocks,
                          const struct weights *weights, int first, const struct scarp_samples *to);

#define COLUMNS_PASS(name, basis, dims, order)                                                     \
    static void name(struct columns *columns, size_t rows, size_t blocks,                          \
                     const struct weights *weights, int first, const struct scarp_samples *to)     \
    {                                                                                              \
        sample_rows(columns, rows, blocks, weights, first, to, basis, dims, order);                \
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
