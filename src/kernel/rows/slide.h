/* SPDX-License-Identifier: MIT
 *
 * Computes rows of a grid along which columns go up, without tables in memory. A table of two
 * vectors holds two neighbouring blocks of lattice columns and slides on by a block. Each block of
 * columns is reduced to its lines just before. Compared with rows.h this saves stores, and loads
 * that cross cache lines. place_columns makes sure that a block of samples begins in the lower half
 * of a table and ends within it.
 */
#ifndef SCARP_KERNEL_ROWS_SLIDE_H
#define SCARP_KERNEL_ROWS_SLIDE_H

#include "lines.h"

VEC_INLINE void slide_line(struct stretch_line *l, struct line next, int is_flat)
{
    l->b = vf_table_slide(l->b, next.b);
    if (!is_flat) {
        l->a = vf_table_slide(l->a, next.a);
    }
}

/* Slides the tables on: block i of columns comes in on the right, the one on the left goes. No lane
   chooses what comes after the last column. */
VEC_INLINE void slide(struct stretch_lines *l, const struct along_x *x, size_t i,
                      const struct along_row *r, struct variant v)
{
    struct column c = {0};
    if (i < x->column_blocks) {
        c = row_column((vu)x->hash[i], r, v);
    }
#define DO(i, name) slide_line(&l->line[i], c.name, flat(v))
    EACH_LINE(v, DO);
#undef DO
}

/* Computes one row. */
VEC_INLINE void slide_row(const struct along_x *x, const struct along_row *row,
                          const struct target *target, struct variant v, enum put put)
{
    const struct weights w = target->weights; /* copies: nothing that is stored can alias them */
    const struct outputs to = target->outputs;
    const struct along_block *block = x->block, *const row_end = block + x->blocks;
    const struct stretch *stretch = x->stretch;
    struct stretch_lines l = {0};
    size_t next = 0, to_at = 0;
    for (; block < row_end; stretch++) {
        while (next < stretch->base / VEC_LANES + TABLE_BLOCKS) {
            slide(&l, x, next++, row, v);
        }
        for (const struct along_block *const end = block + stretch->blocks; block < end; block++) {
            const struct sides s = get_sides(&l, vu_in_register((vu)block->index), 0, v);
            const struct sample n = join_sides(block, &s, v);
            put_any_sample(&to, to_at, &w, &n, v, put);
            to_at += to.block;
        }
    }
}

#endif
