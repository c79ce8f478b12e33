/* SPDX-License-Identifier: MIT
 *
 * The lines (noise.h) of the lattice columns that a row of a grid crosses: made from the hashes
 * along the axes, kept in tables of registers, looked up for the lanes of a block, joined to
 * samples. Included by slide.h, which tells where tables come from, as does columns.h.
 */
#ifndef SCARP_KERNEL_LINES_H
#define SCARP_KERNEL_LINES_H

#include "along.h"
#include "octave.h"

enum { LINE_VALUE, LINE_Y, LINE_Z, LINE_YY, LINE_YZ, LINE_ZZ, LINES };

/* DO(index, member of struct column or value_column) for each line that `order` and `dimensions`,
   constants where this stands, ask for. */
#define EACH_LINE(DO)                                                                              \
    do {                                                                                           \
        DO(LINE_VALUE, value);                                                                     \
        if (order >= 1) {                                                                          \
            DO(LINE_Y, y);                                                                         \
            if (dimensions == 3) {                                                                 \
                DO(LINE_Z, z);                                                                     \
            }                                                                                      \
        }                                                                                          \
        if (order >= 2) {                                                                          \
            DO(LINE_YY, yy);                                                                       \
            if (dimensions == 3) {                                                                 \
                DO(LINE_YZ, yz);                                                                   \
                DO(LINE_ZZ, zz);                                                                   \
            }                                                                                      \
        }                                                                                          \
    } while (0)

/* The lines of the columns whose mixed coordinates are `h`, on a row. */
VEC_INLINE struct column gradient_column(vu h, const struct along_row *r, int dimensions, int order)
{
    return dimensions == 2
               ? gradient_column2(hash_corner(h, r->hash[0][0]), hash_corner(h, r->hash[1][0]),
                                  r->y, r->v, order)
               : gradient_column3(hash_corner(h, r->hash[0][0]), hash_corner(h, r->hash[0][1]),
                                  hash_corner(h, r->hash[1][0]), hash_corner(h, r->hash[1][1]),
                                  r->y, r->z, r->v, r->w, order);
}

VEC_INLINE struct value_column value_column(vu h, const struct along_row *r, int dimensions,
                                            int order)
{
    return dimensions == 2
               ? value_column2(hash_corner(h, r->hash[0][0]), hash_corner(h, r->hash[1][0]), r->v,
                               order)
               : value_column3(hash_corner(h, r->hash[0][0]), hash_corner(h, r->hash[0][1]),
                               hash_corner(h, r->hash[1][0]), hash_corner(h, r->hash[1][1]), r->v,
                               r->w, order);
}

/* The lines of a stretch: tables of them or, if it is in one column, those to its left and right,
   which all its blocks share. */
struct stretch_line {
    vf_table a, b;
    struct line left, right;
};

struct stretch_lines {
    struct stretch_line line[LINES];
};

/* The lines of the column of each lane, and of the one on its right; `at` is not used in one
   column. */
VEC_INLINE void get_line(const struct stretch_line *l, vu at, int in_column, struct line *left,
                         struct line *right)
{
    if (in_column) {
        *left = l->left;
        *right = l->right;
        return;
    }
    const vu next = at + vu_set(VF_INDEX_NEXT);
    *left = (struct line){vf_permute(l->a, at), vf_permute(l->b, at)};
    *right = (struct line){vf_permute(l->a, next), vf_permute(l->b, next)};
}

VEC_INLINE void get_columns(const struct stretch_line *l, vu at, int in_column, struct column *left,
                            struct column *right, int dimensions, int order)
{
#define DO(i, name) get_line(&l[i], at, in_column, &left->name, &right->name)
    EACH_LINE(DO);
#undef DO
}

VEC_INLINE void get_number(const struct stretch_line *l, vu at, int in_column, vf *left, vf *right)
{
    *left = in_column ? l->left.b : vf_permute(l->b, at);
    *right = in_column ? l->right.b : vf_permute(l->b, at + vu_set(VF_INDEX_NEXT));
}

VEC_INLINE void get_value_columns(const struct stretch_line *l, vu at, int in_column,
                                  struct value_column *left, struct value_column *right,
                                  int dimensions, int order)
{
#define DO(i, name) get_number(&l[i], at, in_column, &left->name, &right->name)
    EACH_LINE(DO);
#undef DO
}

/* The lines to the left and right of a block. */
struct sides {
    struct column gl, gr;
    struct value_column vl, vr;
};

VEC_INLINE struct sides get_sides(const struct stretch_lines *l, vu at, int in_column,
                                  enum scarp_basis basis, int dimensions, int order)
{
    struct sides s;
    if (basis == SCARP_GRADIENT) {
        get_columns(l->line, at, in_column, &s.gl, &s.gr, dimensions, order);
    } else {
        get_value_columns(l->line, at, in_column, &s.vl, &s.vr, dimensions, order);
    }
    return s;
}

VEC_INLINE struct sample join_sides(const struct along_x *x, size_t b, const struct sides *s,
                                    enum scarp_basis basis, int dimensions, int order)
{
    return basis == SCARP_GRADIENT ? join(&s->gl, &s->gr, x->t[b], x->fade[b], dimensions, order)
                                   : value_join(&s->vl, &s->vr, x->fade[b], dimensions, order);
}

#endif
