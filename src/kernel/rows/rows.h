/* SPDX-License-Identifier: MIT
 *
 * Stage 2 along rows of a grid, the fast path of bases that reduce lattice columns to lines, where
 * axes are straight. What depends on x is prepared once for all rows of a tile (along.h); the
 * lattice columns that a row crosses are reduced to their lines once per row, in a small table;
 * each block of samples then reads its lines with permutes instead of hashing, from registers that
 * serve as many blocks as they reach (a stretch). The bits are those of the points pass, because
 * the lines are the same.
 *
 * Tables of two vectors, AVX-512's, slide on by one where columns go up along a row. Some variants
 * need no memory for that: slide.h.
 *
 * A table serves lanes in VF_TABLE - 1 neighbouring columns. Where a block needs more, or columns
 * are nearly as many as samples, each lane has its own two columns (WIDE), and shares with the
 * others of its row what depends on y and z.
 */
#ifndef SCARP_KERNEL_ROWS_H
#define SCARP_KERNEL_ROWS_H

#include "cells.h"
#include "slide.h"

/* An octave on the rows of a tile, from row `begin` on. `table` has `table_size` vectors for the
   lines of columns, which hold at least one row: see table_size_of(). */
struct row_octave {
    union {
        struct { /* of bases that blend corners */
            struct along_x x;
            struct along_rows rows;
        };
        struct along_cells cells; /* of bases that take unhashed locations */
    };
    size_t begin;
    enum scarp_basis basis; /* for passes that serve several */
    int order;              /* likewise: the highest derivative */
    const float *turn;      /* of the octave, or its derivative; for passes that flow */
    vf *table;
    size_t table_size;
};

/* Tables of lines a x + b: one for the b of each line, then one for the a of each, `stride` vectors
   apart. Each has the columns of one row after the other. */
struct tables {
    vf *start;
    size_t stride;
};

static size_t line_count(int dimensions, int order)
{
    static const unsigned char counts[2][3] = {{1, 2, 3}, {1, 3, 6}};
    return counts[dimensions - 2][order];
}

/* Vectors for the tables of one row of a strip, whose columns may be as many as its samples, with
   one on the right and those that a read at the end takes beyond. */
static size_t table_size_of(int dimensions, int order, size_t blocks)
{
    return 2 * line_count(dimensions, order) * (blocks + 1 + TABLE_BLOCKS);
}

/* Where the b, or the a, of line i of variant v are. */
VEC_INLINE vf *table_of(const struct tables *t, int i, int slopes, struct variant v)
{
    const int line = v.dimensions == 3 || i < LINE_Z ? i : i - 1;
    const int half = slopes ? (int)line_count(v.dimensions, v.order) : 0;
    return t->start + (size_t)(line + half) * t->stride;
}

/* Reduces the columns of a row to their lines, from block `at` of the tables on. */
VEC_INLINE void reduce_row(const struct tables *t, const struct along_x *x, size_t at,
                           const struct along_row *row, struct variant v)
{
    for (size_t block = 0; block < x->column_blocks; block++) {
        const struct column c = row_column((vu)x->hash[block], row, v);
#define DO(i, name)                                                                                \
    do {                                                                                           \
        table_of(t, i, 0, v)[at + block] = c.name.b;                                               \
        if (!flat(v)) {                                                                            \
            table_of(t, i, 1, v)[at + block] = c.name.a;                                           \
        }                                                                                          \
    } while (0)
        EACH_LINE(v, DO);
#undef DO
    }
}

/* Loads line i from column `base` of the tables on. */
VEC_INLINE void open_line(struct stretch_line *l, const struct tables *t, int i, size_t base,
                          int in_column, struct variant v)
{
    const float *const b = (const float *)table_of(t, i, 0, v) + base;
    const float *const a = (const float *)table_of(t, i, 1, v) + base;
    if (in_column) {
        l->left.b = vf_set(b[0]);
        l->right.b = vf_set(b[1]);
    } else {
        l->b = vf_table_load(b);
    }
    if (!flat(v) && in_column) {
        l->left.a = vf_set(a[0]);
        l->right.a = vf_set(a[1]);
    } else if (!flat(v)) {
        l->a = vf_table_load(a);
    }
}

VEC_INLINE struct stretch_lines open_lines(const struct tables *t, size_t base, int in_column,
                                           struct variant v)
{
    struct stretch_lines l;
#define DO(i, name) open_line(&l.line[i], t, i, base, in_column, v)
    EACH_LINE(v, DO);
#undef DO
    return l;
}

/* Whether a variant slides without tables in memory. That takes more code: each loop computes
   columns. With tables, values of value noise and Hessians take up to 10 and 26 % longer, all else
   as long or less. */
VEC_INLINE int slides_in_registers(struct variant v)
{
    return VF_TABLE > VEC_LANES && (v.order == 2 || (v.order == 0 && flat(v)));
}

/* Slides line i on to the table from column `base` on. */
VEC_INLINE void slide_on(struct stretch_line *l, const struct tables *t, int i, size_t base,
                         struct variant v)
{
    const size_t last = base + VF_TABLE - VEC_LANES;
    l->b = vf_table_slide(l->b, vf_load((const float *)table_of(t, i, 0, v) + last));
    if (!flat(v)) {
        l->a = vf_table_slide(l->a, vf_load((const float *)table_of(t, i, 1, v) + last));
    }
}

/* Computes a row from the columns that the tables begin with. */
VEC_INLINE void table_row(const struct along_x *x, const struct tables *t,
                          const struct target *target, struct variant v, enum put put)
{
    const struct weights w = target->weights; /* copies: nothing that is stored can alias them */
    const struct outputs to = target->outputs;
    const struct along_block *block = x->block, *const row_end = block + x->blocks;
    const struct stretch *stretch = x->stretch;
    const int slides = VF_TABLE > VEC_LANES && !slides_in_registers(v);
    struct stretch_lines l = {0};
    size_t to_at = 0, slid = SIZE_MAX; /* the base of `l` when it slides on */
    for (; block < row_end; stretch++) {
        const struct along_block *const end = block + stretch->blocks;
        const size_t base = stretch->base;
        if (stretch->in_column) {
            const struct stretch_lines columns = open_lines(t, base, 1, v);
            const struct sides s = get_sides(&columns, vu_set(0), 1, v);
            VEC_SHORT_LOOP
            for (; block < end; block++) {
                const struct sample n = join_sides(block, &s, v);
                put_any_sample(&to, to_at, &w, &n, v, put);
                to_at += to.block;
            }
            continue;
        }
        if (slides && base == slid) {
#define DO(i, name) slide_on(&l.line[i], t, i, base, v)
            EACH_LINE(v, DO);
#undef DO
        } else {
            l = open_lines(t, base, 0, v);
        }
        slid = base + VEC_LANES;
        for (; block < end; block++) {
            const struct sides s = get_sides(&l, vu_in_register((vu)block->index), 0, v);
            const struct sample n = join_sides(block, &s, v);
            put_any_sample(&to, to_at, &w, &n, v, put);
            to_at += to.block;
        }
    }
}

/* Computes a WIDE row, where each lane has its own two columns. That is slower than memory, so it
   never streams. */
VEC_INLINE void wide_row(const struct along_x *x, const struct along_row *row,
                         const struct target *target, struct variant v, enum put put)
{
    const struct weights w = target->weights;
    const struct outputs to = target->outputs;
    const struct along_block *block = x->block, *const end = block + x->blocks;
    const vf *hash = x->hash;
    size_t to_at = 0;
    for (; block < end; block++) {
        const struct corners side[2] = {row_corners((vu)hash[0], row, v),
                                        row_corners((vu)hash[1], row, v)};
        struct column c[2];
        basis_columns(c, side, &row->at, v);
        const struct sample n = join(&c[0], &c[1], block->t, block->fade, v);
        add_sample(&to, to_at, &w, &n, v, put);
        to_at += to.block;
        hash += 2;
    }
}

/* Clears the blocks after the last one in use: tables read them, but no lane chooses them. */
static void clear_beyond(const struct tables *t, size_t lines, size_t at)
{
    for (size_t i = 0; i < lines; i++) {
        for (size_t n = 0; n < TABLE_BLOCKS; n++) {
            t->start[i * t->stride + at + n] = vf_set(0.0f);
        }
    }
}

/* Computes row r, which is not WIDE. If it has tables, they begin with its columns. */
VEC_INLINE void put_row(const struct row_octave *o, size_t r, const struct tables *t,
                        const struct target *to, struct variant v, enum put put)
{
    if (slides_in_registers(v) && o->x.kind == SLIDES) {
        const struct along_row row = row_of(&o->rows, r, to->directions, v.dimensions);
        slide_row(&o->x, &row, to, v, put);
    } else {
        table_row(&o->x, t, to, v, put);
    }
}

/* Takes as many rows at a time as the tables have room for: first all their columns, then all their
   samples, so that neither waits for the other. */
VEC_INLINE void rows_run(const struct row_octave *o, size_t rows, const struct weights *weights,
                         const struct outputs *outputs, enum put put, struct variant v)
{
    struct target to;
    outputs_copy(&to.outputs, outputs, v);
    to.weights = *weights;
    struct directions directions;
    to.directions = &directions;
    if (v.flows) {
        (v.dimensions == 2 ? turn_directions2 : turn_directions3)(&directions, o->turn);
    }
    const int tables =
        !VEC_SMALL && o->x.kind != WIDE && !(slides_in_registers(v) && o->x.kind == SLIDES);
    const size_t lines = line_count(v.dimensions, v.order) * (flat(v) ? 1 : 2);
    const struct tables t = {o->table, tables ? o->table_size / lines : 0};
    const size_t column_blocks = tables ? o->x.column_blocks : 0;
    size_t room = rows;
    if (tables) {
        room = least(rows, (t.stride - TABLE_BLOCKS) / (VEC_SMALL ? 1 : column_blocks));
        clear_beyond(&t, lines, room * column_blocks);
    }
    for (size_t begin = o->begin, last = begin + rows; begin < last; begin += room) {
        const size_t end = least(last, begin + room);
        for (size_t r = begin; tables && r < end; r++) {
            const struct along_row row = row_of(&o->rows, r, &directions, v.dimensions);
            reduce_row(&t, &o->x, (r - begin) * column_blocks, &row, v);
        }
        for (size_t r = begin; r < end; r++) {
            const struct tables here = {t.start + (r - begin) * column_blocks, t.stride};
            if (VEC_SMALL || o->x.kind == WIDE) {
                const struct along_row row = row_of(&o->rows, r, &directions, v.dimensions);
                wide_row(&o->x, &row, &to, v, put);
            } else if (v.order >
                       (v.flows ? 0 : 1)) { /* there, a branch for each block costs little */
                put_row(o, r, &here, &to, v, put);
            } else if (put == PUT_STREAM) {
                put_row(o, r, &here, &to, v, PUT_STREAM);
            } else if (put == PUT_FIRST) {
                put_row(o, r, &here, &to, v, PUT_FIRST);
            } else {
                put_row(o, r, &here, &to, v, PUT_ADD);
            }
            outputs_next_row(&to.outputs, v);
        }
    }
}

/* Adds an octave on `rows` rows to `to`, or puts it there. */
typedef void rows_pass(const struct row_octave *octave, size_t rows, const struct weights *weights,
                       const struct outputs *to, enum put put);

#define ROWS_PASS(name, basis, dimensions, order, flows)                                           \
    static void name(const struct row_octave *octave, size_t rows, const struct weights *weights,  \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order, flows};                                \
        rows_run(octave, rows, weights, to, put, v);                                               \
    }
#define GRADIENT_ROWS(name, basis, flows)                                                          \
    ROWS_PASS(name##2_rows0, basis, 2, 0, flows)                                                   \
    ROWS_PASS(name##2_rows1, basis, 2, 1, flows)                                                   \
    ROWS_PASS(name##3_rows0, basis, 3, 0, flows)                                                   \
    ROWS_PASS(name##3_rows1, basis, 3, 1, flows)
#define HESSIAN_ROWS(name, basis)                                                                  \
    ROWS_PASS(name##2_rows2, basis, 2, 2, 0)                                                       \
    ROWS_PASS(name##3_rows2, basis, 3, 2, 0)

GRADIENT_ROWS(gradient, SCARP_GRADIENT, 0)
GRADIENT_ROWS(flow, SCARP_GRADIENT, 1)
GRADIENT_ROWS(value, SCARP_VALUE, 0)
HESSIAN_ROWS(gradient, SCARP_GRADIENT)
HESSIAN_ROWS(value, SCARP_VALUE)

#undef ROWS_PASS
#undef GRADIENT_ROWS
#undef HESSIAN_ROWS

#endif
