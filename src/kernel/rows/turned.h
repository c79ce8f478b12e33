/* SPDX-License-Identifier: MIT
 *
 * Stage 1 along rows of a grid whose axes are turned: p = J x + o, where the first column of J
 * times x is prepared once for all rows of a tile. Along a row each component of p goes one way: if
 * the last lane of a block is in the cell in which the block on its left begins, both blocks lie in
 * it, and their corners have the same hashes. The bits are those of the lattice pass of doubles
 * (../lattice.h), because the order of operations is the same.
 */
#ifndef SCARP_KERNEL_ROWS_TURNED_H
#define SCARP_KERNEL_ROWS_TURNED_H

#include "along.h"

/* Two blocks look for a cell that they share if together they are less than that many cells wide.
   From there on too few find one. */
#define SHARING_WIDTH 0.5

/* Whether hashes are made in a loop of their own (../lattice.h). With 4 lanes it takes 2 % more in
   3D. */
#define TURNED_LOOPS_TWICE (VEC_LANES == 8)

/* Doubles in the scratch space, whose vectors are floats. */
typedef double turned_double __attribute__((may_alias));

/* An octave along x, for each axis of its frame: the products of every sample; then, for each
   block, those of its last lane and of the first lane of the block on its left, padded to whole
   vectors. */
struct turned_x {
    turned_double *along[3], *last[3], *before[3];
    int shares; /* whether two blocks may lie in one cell */
};

/* Doubles for the ends of that many blocks. */
static size_t ends_size(size_t blocks)
{
    return (blocks + VEC_LANES / 2 - 1) / (VEC_LANES / 2) * (VEC_LANES / 2);
}

/* Vectors that turned_x needs for a strip. */
static size_t turned_size(int dimensions, size_t blocks)
{
    return (size_t)dimensions * (blocks * VEC_LANES + 2 * ends_size(blocks)) * sizeof(double) /
           sizeof(vf);
}

/* Prepares an octave at x, in `space`. */
static void turned_begin(struct turned_x *t, vf *space, const struct scarp_octave *o, size_t blocks,
                         const double *x, int dimensions)
{
    turned_double *next = (turned_double *)space;
    t->shares = blocks > 1;
    for (int i = 0; i < dimensions; i++) {
        turned_double *const along = next, *const last = along + blocks * VEC_LANES;
        turned_double *const before = last + ends_size(blocks);
        const double j = o->jacobian64[i][0];
        for (size_t n = 0; n < blocks * VEC_LANES; n++) {
            along[n] = j * x[n];
        }
        for (size_t b = 0; b < ends_size(blocks); b++) {
            const size_t block = least(b, blocks - 1);
            last[b] = along[block * VEC_LANES + VEC_LANES - 1];
            before[b] = along[block > 0 ? (block - 1) * VEC_LANES : 0];
        }
        const double width = blocks > 1 ? last[1] - before[1] : 0.0;
        t->shares &= width > -SHARING_WIDTH && width < SHARING_WIDTH;
        t->along[i] = along;
        t->last[i] = last;
        t->before[i] = before;
        next = before + ends_size(blocks);
    }
}

/* What all samples of a row share along an axis. */
struct turned_row {
    double y, z, offset;
};

VEC_INLINE vd turned_at(const double *along, const struct turned_row *r, int dimensions)
{
    vd p = vd_load(along) + vd_set(r->y);
    if (dimensions == 3) {
        p += vd_set(r->z);
    }
    return p + vd_set(r->offset);
}

/* How many blocks find their cells at once, in whole vectors of doubles. */
#define SHARING_BLOCKS 16

/* The cells along each axis in which blocks of a row end, and whether (all ones) that is where the
   block on the left begins. */
struct row_cells {
    double cell[3][SHARING_BLOCKS];
    uint64_t same[SHARING_BLOCKS];
};

/* Finds those of blocks `first` to `last`, exclusively. */
VEC_INLINE void find_cells(struct row_cells *c, const struct turned_x *t,
                           const struct turned_row row[3], size_t first, size_t last,
                           int dimensions)
{
    for (size_t b = 0; b < last - first; b += VEC_LANES / 2) {
        vec_u64 same = (vec_u64)(vd_set(0.0) == vd_set(0.0));
        for (int i = 0; i < dimensions; i++) {
            const vd cell = vd_floor(turned_at(t->last[i] + first + b, &row[i], dimensions));
            const vd left = vd_floor(turned_at(t->before[i] + first + b, &row[i], dimensions));
            same &= (vec_u64)(cell == left); /* not if they are NaN */
            memcpy(c->cell[i] + b, &cell, sizeof cell);
        }
        memcpy(c->same + b, &same, sizeof same);
    }
    if (first == 0) {
        c->same[0] = 0;
    }
}

/* Gives p along each axis, for both halves of block b. */
VEC_INLINE void turned_block(vd p[3][2], const struct turned_x *t, size_t b,
                             const struct turned_row row[3], int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        const turned_double *const along = t->along[i] + b * VEC_LANES;
        p[i][0] = turned_at(along, &row[i], dimensions);
        p[i][1] = turned_at(along + VEC_LANES / 2, &row[i], dimensions);
    }
}

/* Stores the fractions of a block, and returns its cells in `cell`. The operations are those of
   split_f64(), but halves are stored and not joined. */
VEC_INLINE void put_fractions(vf *lattice, vu cell[3], vd p[3][2], int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        const vd lower0 = vd_floor(p[i][0]), lower1 = vd_floor(p[i][1]);
        cell[i] = vu_low_bits(lower0 + 0x1.8p52, lower1 + 0x1.8p52);
        vf_store_vd((float *)(lattice + i), p[i][0] - lower0, p[i][1] - lower1);
    }
}

/* Puts the blocks of a row on the lattice, of which neighbours share no hashes. The hashes of each
   block come after the fractions of the next, since the chain from a position to its hashes is
   long: out-of-order windows hold only two blocks of it. */
VEC_INLINE void put_turned_row(vf *lattice, const struct scarp_octave *o, size_t blocks,
                               const struct turned_x *t, const struct turned_row row[3],
                               int dimensions, enum corner_form form)
{
    const size_t size = lattice_size(dimensions);
    vu cell[3], next[3];
    vd p[3][2];
    turned_block(p, t, 0, row, dimensions);
    put_fractions(lattice, cell, p, dimensions);
    for (size_t b = 1; b < blocks; b++) {
        turned_block(p, t, b, row, dimensions);
        put_fractions(lattice + size, next, p, dimensions);
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
VEC_INLINE void put_sharing_row(vf *lattice, const struct scarp_octave *o, size_t blocks,
                                const struct turned_x *t, const struct turned_row row[3],
                                int dimensions, enum corner_form form)
{
    const size_t size = lattice_size(dimensions);
    struct row_cells cells;
    for (size_t b = 0; b < blocks; b++) {
        const size_t k = b % SHARING_BLOCKS;
        vu cell[3];
        vd p[3][2];
        if (k == 0) {
            find_cells(&cells, t, row, b, least(blocks, b + SHARING_BLOCKS), dimensions);
        }
        turned_block(p, t, b, row, dimensions);
        if (!cells.same[k]) {
            put_fractions(lattice, cell, p, dimensions);
            const struct mixed m = mix_axes(o, cell, AXES_TURNED, dimensions);
            lattice_put_corners(lattice, &m, dimensions, form);
        } else {
            for (size_t n = (size_t)dimensions; n < size; n++) {
                lattice[n] = lattice[(ptrdiff_t)n - (ptrdiff_t)size];
            }
            for (int i = 0; i < dimensions; i++) {
                const vd lower = vd_set(cells.cell[i][k]);
                vf_store_vd((float *)(lattice + i), p[i][0] - lower, p[i][1] - lower);
            }
        }
        lattice += size;
    }
}

/* Puts rows on the lattice, whose y are given, at that z. */
VEC_INLINE void turned_run(vf *lattice, const struct scarp_octave *octave, struct extent extent,
                           const struct turned_x *x, const struct positions *at, int dimensions,
                           enum corner_form form)
{
    const struct scarp_octave o = *octave; /* a copy: nothing that is stored can alias it */
    const struct turned_x t = *x;
    const double *const y = at->array[1];
    for (size_t r = 0; r < extent.rows; r++) {
        struct turned_row row[3];
        for (int i = 0; i < dimensions; i++) {
            row[i].y = o.jacobian64[i][1] * y[r];
            row[i].z = o.jacobian64[i][2] * at->shared[2];
            row[i].offset = o.offset[i];
        }
        if (t.shares) {
            put_sharing_row(lattice, &o, extent.blocks, &t, row, dimensions, form);
        } else {
            put_turned_row(lattice, &o, extent.blocks, &t, row, dimensions,
                           TURNED_LOOPS_TWICE ? CORNERS_MIXED : form);
#if TURNED_LOOPS_TWICE
            if (form == CORNERS_HASHED) {
                (dimensions == 2 ? hash_blocks2 : hash_blocks3)(lattice, extent.blocks);
            }
#endif
        }
        lattice += extent.blocks * lattice_size(dimensions);
    }
}

typedef void turned_pass(vf *lattice, const struct scarp_octave *octave, struct extent extent,
                         const struct turned_x *x, const struct positions *at);

#define TURNED_PASS(name, form, dimensions)                                                        \
    static void name(vf *lattice, const struct scarp_octave *octave, struct extent extent,         \
                     const struct turned_x *x, const struct positions *at)                         \
    {                                                                                              \
        turned_run(lattice, octave, extent, x, at, dimensions, form);                              \
    }

TURNED_PASS(turned2_hashes, CORNERS_HASHED, 2)
TURNED_PASS(turned3_hashes, CORNERS_HASHED, 3)
TURNED_PASS(turned2_axes, CORNERS_MIXED, 2)
TURNED_PASS(turned3_axes, CORNERS_MIXED, 3)

/* By [form][dimensions - 2]. */
static turned_pass *const turned_passes[CORNER_FORMS][2] = {
    [CORNERS_HASHED] = {turned2_hashes, turned3_hashes},
    [CORNERS_MIXED] = {turned2_axes, turned3_axes},
};

#undef TURNED_PASS

#endif
