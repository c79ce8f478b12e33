/* SPDX-License-Identifier: MIT
 *
 * Simplex noise along rows of a grid. Vertices stand in lines along x, of which few are near enough
 * to a row; what their gradients give across x is drawn once per row. The bits are those of
 * basis/simplex.h, because each vertex adds the same.
 */
#ifndef SCARP_KERNEL_ROWS_SIMPLEX_H
#define SCARP_KERNEL_ROWS_SIMPLEX_H

#include "rows.h"

/* A line of vertices: where the row lies from it, and its tables: gradients along x, what they give
   across (vertex_across), then, of passes with derivatives, gradients along y and z. */
struct vertices {
    float d[3]; /* along y and z; d[0] is not used */
    float left; /* of r^2 */
    const float *g[3], *across;
};

#define VERTEX_TABLES 4 /* the most tables of a line */
#define VERTEX_LINES 7  /* the most lines */

static size_t vertices_size(int dimensions, size_t blocks)
{
    return (dimensions == 2 ? 2 * 3 : VERTEX_LINES * VERTEX_TABLES) * most_column_blocks(blocks);
}

/* Draws the tables of a line at `to`, whose hashes have `yz` across x, and returns where the next
   may begin. */
VEC_INLINE vf *draw_vertices(struct vertices *line, vf *to, const struct along_cells *along,
                             uint32_t yz, int is_centre, struct variant v)
{
    const size_t blocks = along->column_blocks;
    line->g[0] = (const float *)to;
    line->across = (const float *)(to + blocks);
    line->g[1] = (const float *)(to + 2 * blocks);
    line->g[2] = (const float *)(to + 3 * blocks);
    line->left = v.dimensions == 2
                     ? TRIANGLE_R2 - line->d[1] * line->d[1]
                     : TETRAHEDRON_R2 - (line->d[1] * line->d[1] + line->d[2] * line->d[2]);
    for (size_t b = 0; b < blocks; b++) {
        struct vertex at = {.d = {vf_set(0.0f), vf_set(line->d[1]), vf_set(line->d[2])}};
        const vu h = (vu)along->hash[b] ^ vu_set(yz);
        if (v.dimensions == 2) {
            const vu hash = h * (h + vu_set(HASH_K));
            at.g[0] = vf_lookup(&gradient2_x, hash);
            at.g[1] = vf_lookup(&gradient2_y, hash);
        } else {
            vertex_gradient3(&at, h * (h + vu_set(is_centre ? HASH_CENTRE : HASH_K)));
        }
        to[b] = at.g[0];
        to[blocks + b] = vertex_across(&at, v);
        if (v.order >= 1) {
            to[2 * blocks + b] = at.g[1];
            if (v.dimensions == 3) {
                to[3 * blocks + b] = at.g[2];
            }
        }
    }
    return to + blocks * (size_t)(v.order == 0 ? 2 : v.dimensions + 1);
}

/* A vertex in all lanes, x from it. */
VEC_INLINE struct vertex vertex_in(const struct vertices *line, size_t column, vf x,
                                   struct variant v)
{
    struct vertex at;
    at.d[0] = x;
    at.g[0] = vf_set(line->g[0][column]);
    if (v.order >= 1) {
        for (int i = 1; i < v.dimensions; i++) {
            at.d[i] = vf_set(line->d[i]);
            at.g[i] = vf_set(line->g[i][column]);
        }
    }
    return at;
}

VEC_INLINE struct sample sample_in(const struct vertices *line, size_t column, vf x,
                                   struct variant v)
{
    const struct vertex at = vertex_in(line, column, x, v);
    return vertex_sample(&at, vf_set(line->left), vf_set(line->across[column]), v);
}

/* The vertex a where the mask is set, else b. */
VEC_INLINE struct vertex vertex_of(vm mask, const struct vertex *a, const struct vertex *b,
                                   struct variant v)
{
    struct vertex at;
    for (int i = 0; i < (v.order >= 1 ? v.dimensions : 1); i++) {
        at.d[i] = vm_choose(mask, a->d[i], b->d[i]);
        at.g[i] = vm_choose(mask, a->g[i], b->g[i]);
    }
    return at;
}

/* The triangles of column k, between the lines below and above a row. */
VEC_INLINE struct sample triangles_in(const struct vertices line[2], size_t odd, size_t k,
                                      const struct triangle *at, struct variant v)
{
    const struct sample a = sample_in(&line[0], k + 1, at->x - 1.0f, v);
    const struct sample b = sample_in(&line[1], k + odd, at->x - 0.5f, v);
    const struct vertex low = vertex_in(&line[0], k, at->x, v);
    const struct vertex high = vertex_in(&line[1], k + odd + 1, at->x - 1.5f, v);
    const struct vertex third = vertex_of(at->lower, &low, &high, v);
    const vf left = vm_choose(at->lower, vf_set(line[0].left), vf_set(line[1].left));
    const vf across =
        vm_choose(at->lower, vf_set(line[0].across[k]), vf_set(line[1].across[k + odd + 1]));
    const struct sample c = vertex_sample(&third, left, across, v);
    const struct sample both = sum_of(&a, &b, v);
    return sum_of(&both, &c, v);
}

/* The lines near a row of tetrahedra: of corners, then of centres. */
struct tetrahedra {
    struct vertices line[VERTEX_LINES];
    int corners, count;
};

/* Adds a line, unless it is too far from the row to add anything. */
VEC_INLINE vf *add_line(struct tetrahedra *to, vf *table, const struct along_cells *along,
                        const float d[3], const uint32_t cell[3], int is_centre, struct variant v)
{
    const float left = TETRAHEDRON_R2 - (d[1] * d[1] + d[2] * d[2]);
    if (left <= 0.0f) {
        return table;
    }
    struct vertices *const line = &to->line[to->count++];
    line->d[1] = d[1];
    line->d[2] = d[2];
    const uint32_t yz =
        mixed_cell(along->octave, 1, cell[1]) ^ mixed_cell(along->octave, 2, cell[2]);
    return draw_vertices(line, table, along, yz, is_centre, v);
}

/* Centres of cubes are at the middle of the cell, and next to it along y or along z on the side
   where the row is; corners are at its four edges along x. */
VEC_INLINE void draw_tetrahedra(struct tetrahedra *to, vf *table, const struct along_cells *along,
                                size_t r, struct variant v)
{
    const struct scarp_octave *const o = along->octave;
    const float t[3] = {0.0f, along->y[r] - 0.5f, along->z - 0.5f};
    const uint32_t cell[3] = {0, along->cell_y[r], along->cell_z};
    to->count = 0;
    for (int i = 0; i < 4; i++) {
        const int up[3] = {0, i & 1, i >> 1};
        float d[3] = {0.0f};
        uint32_t at[3] = {0};
        for (int axis = 1; axis < 3; axis++) {
            d[axis] = up[axis] ? t[axis] - 0.5f : t[axis] + 0.5f;
            at[axis] = up[axis] ? next_cell(o, axis, cell[axis]) : cell[axis];
        }
        table = add_line(to, table, along, d, at, 0, v);
    }
    to->corners = to->count;
    for (int i = 0; i < 3; i++) {
        float d[3] = {0.0f, t[1], t[2]};
        uint32_t at[3] = {0, cell[1], cell[2]};
        if (i > 0) {
            const int down = t[i] < 0.0f;
            d[i] = down ? t[i] + 1.0f : t[i] - 1.0f;
            at[i] = down ? previous_cell(o, i, cell[i]) : next_cell(o, i, cell[i]);
        }
        table = add_line(to, table, along, d, at, 1, v);
    }
}

/* The tetrahedra of column k, t from its middle along x. */
VEC_INLINE struct sample tetrahedra_in(const struct tetrahedra *at, size_t k, vf t,
                                       struct variant v)
{
    struct sample corners, centres;
#define ZERO(i, member, rank) corners.member = centres.member = vf_set(0.0f)
    EACH_OUTPUT(v, ZERO);
#undef ZERO
    int i = 0;
    for (; i < at->corners; i++) {
        const struct sample a = sample_in(&at->line[i], k, t + 0.5f, v);
        const struct sample b = sample_in(&at->line[i], k + 1, t - 0.5f, v);
        const struct sample both = sum_of(&a, &b, v);
        corners = sum_of(&corners, &both, v);
    }
    const vm down = vm_less(t, vf_set(0.0f));
    const vf beside = vm_choose(down, t + 1.0f, t - 1.0f);
    for (; i < at->count; i++) {
        const struct vertices *const line = &at->line[i];
        const struct sample a = sample_in(line, k, t, v);
        centres = sum_of(&centres, &a, v);
        if (line->left > 0.25f) { /* else the next vertex is further than r */
            const struct vertex low = vertex_in(line, k - 1, beside, v);
            const struct vertex high = vertex_in(line, k + 1, beside, v);
            const struct vertex other = vertex_of(down, &low, &high, v);
            const vf across =
                vm_choose(down, vf_set(line->across[k - 1]), vf_set(line->across[k + 1]));
            const struct sample b = vertex_sample(&other, vf_set(line->left), across, v);
            centres = sum_of(&centres, &b, v);
        }
    }
    return sum_of(&corners, &centres, v);
}

/* A row: its lines, and in 2D whether it is odd, and where it is between lines. */
struct simplex_row {
    struct tetrahedra lines;
    size_t odd;
    vf half, shift;
};

VEC_INLINE void draw_row(struct simplex_row *row, vf *table, const struct along_cells *along,
                         size_t r, struct variant v)
{
    if (v.dimensions == 3) {
        draw_tetrahedra(&row->lines, table, along, r, v);
        return;
    }
    const float b = along->y[r], y = ROW_HEIGHT * b;
    const uint32_t cell = along->cell_y[r];
    struct vertices *const line = row->lines.line;
    row->odd = cell & 1;
    row->half = vf_set(row->odd ? 0.5f : 0.0f);
    row->shift = vf_set(0.5f * b);
    line[0].d[1] = y;
    line[1].d[1] = y - ROW_HEIGHT;
    line[0].d[2] = line[1].d[2] = 0.0f;
    vf *const next =
        draw_vertices(&line[0], table, along, mixed_cell(along->octave, 1, cell), 0, v);
    draw_vertices(&line[1], next, along, mixed_cell(along->octave, 1, cell + 1), 0, v);
}

/* A block of a row: in 2D its triangle, in 3D its distance from the middle of the cell; and the
   columns that its lanes are in. */
struct row_block {
    struct triangle triangle;
    vf t;
    vu columns;
    size_t first, last;
};

VEC_INLINE void place_block(struct row_block *block, const struct simplex_row *row,
                            const struct along_cells *along, size_t i, struct variant v)
{
    block->columns = (vu)along->column[i];
    block->first = along->low[i];
    block->last = along->high[i];
    if (v.dimensions == 3) {
        block->t = along->t[i] - 0.5f;
        return;
    }
    const struct triangle at = triangle_at(along->t[i] - row->half, row->shift);
    const vm all = vm_equal(vu_set(0), vu_set(0));
    block->triangle = at;
    block->columns -= vm_keep(at.before, vu_set(1));
    block->first -= (size_t)vm_any(at.before);
    block->last -= (size_t)!vm_any(vm_without(all, at.before));
}

VEC_INLINE struct sample column_in(const struct simplex_row *row, size_t k,
                                   const struct row_block *block, struct variant v)
{
    return v.dimensions == 2 ? triangles_in(row->lines.line, row->odd, k, &block->triangle, v)
                             : tetrahedra_in(&row->lines, k, block->t, v);
}

/* A block, most of which lie in a single column: values take up to 20 % less time where this has
   code of its own, derivatives as much as in the loop. */
VEC_INLINE struct sample block_in(const struct simplex_row *row, const struct row_block *block,
                                  struct variant v)
{
    size_t k = block->first;
    struct sample n;
    if (v.order == 0) {
        n = column_in(row, k, block, v);
        while (k < block->last) {
            const struct sample other = column_in(row, ++k, block, v);
            n = in_column(block->columns, (uint32_t)k, &other, &n, v);
        }
        return n;
    }
    do {
        const struct sample other = column_in(row, k, block, v);
        n = k == block->first ? other : in_column(block->columns, (uint32_t)k, &other, &n, v);
    } while (k++ < block->last);
    return n;
}

VEC_INLINE void simplex_rows(const struct row_octave *o, size_t rows, const struct weights *weights,
                             const struct outputs *outputs, enum put put, struct variant v)
{
    const struct weights w = *weights; /* copies: nothing that is stored can alias them */
    struct outputs to;
    outputs_copy(&to, outputs, v);
    for (size_t r = o->begin; r < o->begin + rows; r++) {
        struct simplex_row row;
        size_t to_at = 0;
        draw_row(&row, o->table, &o->cells, r, v);
        for (size_t i = 0; i < o->cells.blocks; i++) {
            struct row_block block;
            place_block(&block, &row, &o->cells, i, v);
            const struct sample n = block_in(&row, &block, v);
            put_any_sample(&to, to_at, &w, &n, v, put);
            to_at += to.block;
        }
        outputs_next_row(&to, v);
    }
}

/* Hessians in 3D, whose sums fill the registers three times over, go through the points pass. */
#define SIMPLEX_ROWS(dimensions, order)                                                            \
    static void simplex##dimensions##_rows##order(const struct row_octave *octave, size_t rows,    \
                                                  const struct weights *weights,                   \
                                                  const struct outputs *to, enum put put)          \
    {                                                                                              \
        const struct variant v = {SCARP_SIMPLEX, dimensions, order, 0};                            \
        simplex_rows(octave, rows, weights, to, put, v);                                           \
    }

SIMPLEX_ROWS(2, 0)
SIMPLEX_ROWS(2, 1)
SIMPLEX_ROWS(2, 2)
SIMPLEX_ROWS(3, 0)
SIMPLEX_ROWS(3, 1)

#undef SIMPLEX_ROWS

#endif
