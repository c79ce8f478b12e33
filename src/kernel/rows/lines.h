/* SPDX-License-Identifier: MIT
 *
 * Makes the lines (../basis/columns.h) of the lattice columns that a row of a grid crosses, from
 * the hashes along the axes, and looks them up for the lanes of a block in tables of registers.
 * slide.h and rows.h say where tables come from.
 */
#ifndef SCARP_KERNEL_ROWS_LINES_H
#define SCARP_KERNEL_ROWS_LINES_H

#include "along.h"

enum { LINE_VALUE, LINE_Y, LINE_Z, LINE_YY, LINE_YZ, LINE_ZZ, LINES };

/* DO(index, member of struct column) for each line that variant v asks for. */
#define EACH_LINE(v, DO)                                                                           \
    do {                                                                                           \
        DO(LINE_VALUE, value);                                                                     \
        if ((v).order >= 1) {                                                                      \
            DO(LINE_Y, y);                                                                         \
            if ((v).dimensions == 3) {                                                             \
                DO(LINE_Z, z);                                                                     \
            }                                                                                      \
        }                                                                                          \
        if ((v).order >= 2) {                                                                      \
            DO(LINE_YY, yy);                                                                       \
            if ((v).dimensions == 3) {                                                             \
                DO(LINE_YZ, yz);                                                                   \
                DO(LINE_ZZ, zz);                                                                   \
            }                                                                                      \
        }                                                                                          \
    } while (0)

/* The hashes, and the lines, of the columns whose mixed coordinates are `h`, on a row. */
VEC_INLINE struct corners row_corners(vu h, const struct along_row *r, struct variant v)
{
    struct corners c;
    c.h[0][0] = hash_corner(h, r->h.h[0][0]);
    c.h[1][0] = hash_corner(h, r->h.h[1][0]);
    if (v.dimensions == 3) {
        c.h[0][1] = hash_corner(h, r->h.h[0][1]);
        c.h[1][1] = hash_corner(h, r->h.h[1][1]);
    }
    return r->component > 0 ? component_corners(&c, r->component, v) : c;
}

VEC_INLINE struct column row_column(vu h, const struct along_row *r, struct variant v)
{
    const struct corners c = row_corners(h, r, v);
    return basis_column(&c, &r->at, v);
}

/* The lines of a stretch: tables of them or, if it is in one column, those to its left and right,
   which all its blocks share. Flat lines have only b. */
struct stretch_line {
    vf_table a, b;
    struct line left, right;
};

struct stretch_lines {
    struct stretch_line line[LINES];
};

/* The lines of the column of each lane, and of the one on its right. `at` is not used if
   `in_column`. */
VEC_INLINE void get_line(const struct stretch_line *l, vu at, int in_column, int is_flat,
                         struct line *left, struct line *right)
{
    if (in_column) {
        *left = l->left;
        *right = l->right;
        return;
    }
    const vu next = at + vu_set(VF_INDEX_NEXT);
    left->b = vf_permute(l->b, at);
    right->b = vf_permute(l->b, next);
    if (!is_flat) {
        left->a = vf_permute(l->a, at);
        right->a = vf_permute(l->a, next);
    }
}

/* The columns on both sides of a block. */
struct sides {
    struct column left, right;
};

VEC_INLINE struct sides get_sides(const struct stretch_lines *l, vu at, int in_column,
                                  struct variant v)
{
    struct sides s;
#define DO(i, name) get_line(&l->line[i], at, in_column, flat(v), &s.left.name, &s.right.name)
    EACH_LINE(v, DO);
#undef DO
    return s;
}

VEC_INLINE struct sample join_sides(const struct along_block *x, const struct sides *s,
                                    struct variant v)
{
    return join(&s->left, &s->right, x->t, x->fade, v);
}

/* Where rows go, the weights that multiply them, and the gradients of a variant that flows. */
struct target {
    struct outputs outputs;
    struct weights weights;
    const struct directions *directions;
};

#endif
