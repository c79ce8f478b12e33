/* SPDX-License-Identifier: MIT
 *
 * Rows of a grid, along which columns go up, from tables that are not kept in memory: where a table
 * holds two vectors, it is two neighbouring blocks of lattice columns, and slides on by a block.
 * Each block of columns is reduced to its lines just before. Compared with columns.h this saves
 * stores, and loads that cross cache lines. A block of samples begins in the lower half and ends
 * within the upper one, of which place_columns makes sure. Included by columns.h.
 */
#ifndef SCARP_KERNEL_SLIDE_H
#define SCARP_KERNEL_SLIDE_H

#include "lines.h"

VEC_INLINE void slide_line(struct stretch_line *l, struct line next)
{
    l->a = vf_table_slide(l->a, next.a);
    l->b = vf_table_slide(l->b, next.b);
}

VEC_INLINE void slide_gradient(struct stretch_line *l, const struct column *next, int dimensions,
                               int order)
{
#define DO(i, name) slide_line(&l[i], next->name)
    EACH_LINE(DO);
#undef DO
}

VEC_INLINE void slide_number(struct stretch_line *l, vf next)
{
    l->b = vf_table_slide(l->b, next);
}

VEC_INLINE void slide_value(struct stretch_line *l, const struct value_column *next, int dimensions,
                            int order)
{
#define DO(i, name) slide_number(&l[i], next->name)
    EACH_LINE(DO);
#undef DO
}

/* Block i of columns comes in on the right, the one on the left goes. What comes after the last
   column is not chosen by any lane. */
VEC_INLINE void slide(struct stretch_lines *l, const struct along_x *x, size_t i,
                      const struct along_row *r, enum scarp_basis basis, int dimensions, int order)
{
    const int any = i < x->column_blocks;
    if (basis == SCARP_GRADIENT) {
        struct column c = {0};
        if (any) {
            c = gradient_column(x->u.narrow.hash[i], r, dimensions, order);
        }
        slide_gradient(l->line, &c, dimensions, order);
    } else {
        struct value_column c = {0};
        if (any) {
            c = value_column(x->u.narrow.hash[i], r, dimensions, order);
        }
        slide_value(l->line, &c, dimensions, order);
    }
}

/* Row r of the tile, into row `to` of samples. */
VEC_INLINE void slide_row(const struct along_x *x, const struct along_rows *rows, size_t r,
                          size_t blocks, const struct weights *weights, int first,
                          const struct scarp_samples *to_row, enum scarp_basis basis,
                          int dimensions, int order)
{
    const struct along_row row = row_of(rows, r, dimensions);
    const struct weights w = *weights;
    const struct scarp_samples to = *to_row;
    const struct stretch *stretch = x->stretch;
    struct stretch_lines l = {0};
    size_t next = 0;
    for (size_t b = 0; b < blocks; stretch++) {
        while (next < stretch->base / VEC_LANES + TABLE_BLOCKS) {
            slide(&l, x, next++, &row, basis, dimensions, order);
        }
        for (const size_t end = b + stretch->blocks; b < end; b++) {
            const vu at = x->u.narrow.index[b];
            const struct sides s = get_sides(&l, at, 0, basis, dimensions, order);
            const struct sample n = join_sides(x, b, &s, basis, dimensions, order);
            add_sample(&to, first, &to, b, &n, &w, dimensions, order);
        }
    }
}

#endif
