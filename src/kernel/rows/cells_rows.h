/* SPDX-License-Identifier: MIT
 *
 * Cellular noise along rows of a grid. The features around some rows between the same two lines of
 * the lattice are drawn once for all of them. Those that no sample of these rows in a column of
 * cells can be nearest to are left out, and the others listed for the blocks in that column. The
 * bits are those of basis/cells.h, because the features do the same in the same order.
 */
#ifndef SCARP_KERNEL_ROWS_CELLS_ROWS_H
#define SCARP_KERNEL_ROWS_CELLS_ROWS_H

#include "rows.h"

/* The tables of a line of cells: how far features stray along x, and the squares of the most and of
   the least that they are from the rows across x. */
enum { TABLE_STRAY, TABLE_MOST, TABLE_LEAST, CELL_TABLES };

#define CELL_LINES 9 /* the most lines */

/* The features that count in a column, in the order of the search; `row_y` says for which row the
   ways from them, and the squares across, are. */
struct listed {
    float x, across, y, z;
    float middle_y; /* of the feature, within the cell of the rows */
    uint32_t hash;
};

struct cells_list {
    uint32_t column;
    int count;
    size_t row;
    struct listed feature[3 * CELL_LINES];
};

#define CELL_LISTS 4 /* lists that are kept from row to row */
#define LISTS_SIZE (CELL_LISTS * sizeof(struct cells_list) / sizeof(vf) + 1)

/* The lists; then the tables of all lines; then, by column of the middle, which features count
   there: bit 3 l + i is the feature of line l that is i - 1 columns further. */
static size_t cell_tables_size(int dimensions, size_t blocks)
{
    const size_t lines = dimensions == 2 ? 3 : CELL_LINES;
    return LISTS_SIZE + (CELL_TABLES * lines + 2) * most_column_blocks(blocks);
}

/* Rows of the same cells, at which row the pass is, and what is drawn for them. */
struct cells_row {
    const struct along_cells *along;
    float *tables;
    size_t stride; /* floats of a table */
    size_t row;
    float y, z;
    float y_low, y_high; /* of all the rows */
    uint32_t cell_y, cell_z;
    uint32_t mixed[CELL_LINES]; /* across x, by line */
    struct search search;
    int soft; /* whether features are added up that are less than 1 away */
    struct cells_list *list;
};

static float *cell_table(const struct cells_row *row, int line, int table)
{
    return row->tables + (size_t)(line * CELL_TABLES + table) * row->stride;
}

static uint32_t cell_by_step(const struct scarp_octave *o, int axis, uint32_t cell, int step)
{
    return step < 0 ? previous_cell(o, axis, cell) : step > 0 ? next_cell(o, axis, cell) : cell;
}

/* Draws a line of cells that is so many steps from the rows. */
VEC_INLINE void draw_cells(struct cells_row *row, int line, int step_y, int step_z)
{
    const struct along_cells *const along = row->along;
    const struct scarp_octave *const o = along->octave;
    const int is_space = row->search.dimensions == 3;
    const vf jitter = vf_set(o->jitter), z = vf_set(row->z);
    const vf middle_y = vf_set((float)step_y + 0.5f), middle_z = vf_set((float)step_z + 0.5f);
    float *const stray = cell_table(row, line, TABLE_STRAY);
    uint32_t yz = mixed_cell(o, 1, cell_by_step(o, 1, row->cell_y, step_y));
    if (is_space) {
        yz ^= mixed_cell(o, 2, cell_by_step(o, 2, row->cell_z, step_z));
    }
    row->mixed[line] = yz;
    for (size_t at = 0; at < row->stride; at += VEC_LANES) {
        const vu hash = hash_corner((vu)along->hash[at / VEC_LANES], vu_set(yz));
        const vf low = feature_step(vf_set(row->y_low), middle_y, jitter, hash * FEATURE_Y);
        const vf high = feature_step(vf_set(row->y_high), middle_y, jitter, hash * FEATURE_Y);
        const vf gap = vf_positive(vf_greater(low, -high));
        vf deep = vf_set(0.0f);
        if (is_space) {
            deep = feature_step(z, middle_z, jitter, hash * FEATURE_Z);
            deep *= deep;
        }
        vf_store(stray + at, jitter * vf_from_vi((vi)hash));
        vf_store(stray + TABLE_MOST * row->stride + at, vf_greater(low * low, high * high) + deep);
        vf_store(stray + TABLE_LEAST * row->stride + at, gap * gap + deep);
    }
}

/* The most and the least that a feature is from the samples of a column: squares. */
struct reach {
    vf most, least;
};

/* `stray` is the table of the feature's line, from the column of the feature on, which is `step` -
   1 columns further than that of the samples. */
VEC_INLINE struct reach reach_of(const float *stray, size_t stride, int step)
{
    const vf x = vf_set((float)step - 0.5f) + vf_load(stray);
    const vf gap = vf_positive(vf_greater(x - 1.0f, -x));
    const struct reach r = {vf_load(stray + TABLE_MOST * stride) +
                                vf_greater(x * x, (1.0f - x) * (1.0f - x)),
                            vf_load(stray + TABLE_LEAST * stride) + gap * gap};
    return r;
}

/* Decides which features count in the columns from at + 1 on. From a column, the first is at most
   so far as the one that is nearest to the column's far end; features that are further away than
   that from all of the column are left out. */
VEC_INLINE vu features_that_count(const struct cells_row *row, int lines, size_t at)
{
    vf first = vf_set(FAR_AWAY), second = first;
    vu bits = vu_set(0);
    for (int line = 0; line < (row->soft ? 0 : lines); line++) {
        const float *const stray = cell_table(row, line, TABLE_STRAY) + at;
        for (int i = 0; i < 3; i++) {
            const struct reach r = reach_of(stray + i, row->stride, i);
            second = vf_lesser(vf_greater(r.most, first), second);
            first = vf_lesser(r.most, first);
        }
    }
    const vf limit = (row->soft ? vf_set(1.0f) : row->search.second ? second : first) * RING_MARGIN;
    for (int line = lines - 1; line >= 0; line--) {
        const float *const stray = cell_table(row, line, TABLE_STRAY) + at;
        for (int i = 2; i >= 0; i--) {
            const struct reach r = reach_of(stray + i, row->stride, i);
            bits = (bits << 1) | vm_keep(vm_less(r.least, limit), vu_set(1));
        }
    }
    return bits;
}

static uint32_t *counting_features(const struct cells_row *row, int dimensions)
{
    return (uint32_t *)cell_table(row, dimensions == 2 ? 3 : CELL_LINES, 0);
}

/* Draws what the rows need. */
static void draw_cells_rows(struct cells_row *row)
{
    const int depth = row->search.dimensions == 3, lines = depth ? CELL_LINES : 3;
    uint32_t *const counting = counting_features(row, row->search.dimensions);
    int line = 0;
    for (int z = -depth; z <= depth; z++) {
        for (int y = -1; y <= 1; y++) {
            draw_cells(row, line++, y, z);
        }
    }
    for (size_t at = 0; at < row->stride; at += VEC_LANES) {
        vu_store(counting + 1 + at, features_that_count(row, lines, at));
    }
    for (int i = 0; i < CELL_LISTS; i++) {
        row->list[i].column = UINT32_MAX;
    }
}

/* Lists the features that count in a column. */
static void list_cells(struct cells_list *list, const struct cells_row *row, uint32_t column)
{
    const struct scarp_octave *const o = row->along->octave;
    const uint32_t *const x = (const uint32_t *)row->along->hash;
    const int is_space = row->search.dimensions == 3;
    uint32_t bits = counting_features(row, row->search.dimensions)[column];
    struct listed *to = list->feature;
    for (; bits != 0; bits &= bits - 1, to++) {
        const int i = __builtin_ctz(bits), line = i / 3;
        const uint32_t h = x[column + (uint32_t)(i % 3) - 1] ^ row->mixed[line];
        const uint32_t hash = h * (h + HASH_K);
        to->hash = hash;
        to->x = ((float)(i % 3) - 0.5f) + o->jitter * (float)(int32_t)hash;
        to->middle_y = ((float)(line % 3) - 0.5f) + o->jitter * (float)(int32_t)(hash * FEATURE_Y);
        if (is_space) {
            to->z = row->z -
                    (((float)(line / 3) - 0.5f) + o->jitter * (float)(int32_t)(hash * FEATURE_Z));
        }
    }
    list->count = (int)(to - list->feature);
    list->column = column;
    list->row = SIZE_MAX;
}

/* The list of a column for the row where the pass is. */
static __attribute__((noinline)) const struct cells_list *cells_of_column(struct cells_row *row,
                                                                          uint32_t column)
{
    struct cells_list *const list = &row->list[column % CELL_LISTS];
    const int is_space = row->search.dimensions == 3;
    if (list->column != column) {
        list_cells(list, row, column);
    }
    for (int i = 0; list->row != row->row && i < list->count; i++) {
        struct listed *const f = &list->feature[i];
        f->y = row->y - f->middle_y;
        f->across = is_space ? f->y * f->y + f->z * f->z : f->y * f->y;
    }
    list->row = row->row;
    return list;
}

/* A feature in all lanes, t from the left wall of the column. */
VEC_INLINE struct feature feature_listed(const struct listed *from, vf t, int dimensions)
{
    struct feature f;
    f.d[0] = t - vf_set(from->x);
    f.d[1] = vf_set(from->y);
    if (dimensions == 3) {
        f.d[2] = vf_set(from->z);
    }
    f.hash = vu_set(from->hash);
    f.s = f.d[0] * f.d[0] + vf_set(from->across);
    return f;
}

/* Searches the ring for a block. Cells along x are numbered within the period here. */
static __attribute__((noinline)) void cells_row_ring(struct found *found,
                                                     const struct cells_row *row, size_t block)
{
    const struct along_cells *const along = row->along;
    const vf t[3] = {along->t[block], vf_set(row->y), vf_set(row->z)};
    const uint64_t period = (uint64_t)along->octave->last[0] + 1;
    vu cells = (vu)along->column[block];
    for (int i = 0; i < VEC_LANES; i++) {
        cells[i] = (uint32_t)((along->first_cell + (uint64_t)cells[i]) % period);
    }
    const vf cell[3] = {(vf)cells, (vf)vu_set(row->cell_y), (vf)vu_set(row->cell_z)};
    cells_ring(found, t, cell, along->octave, row->search.dimensions, row->search.second);
}

/* Copies the members that the search uses. gcc 12 copies a whole struct through memory, word by
 * word. */
VEC_INLINE void found_copy(struct found *to, const struct found *from, struct search search)
{
    for (int i = 0; i < 1 + search.second; i++) {
        to->s[i] = from->s[i];
        for (int axis = 0; axis < (search.steps ? search.dimensions : 0); axis++) {
            to->d[i][axis] = from->d[i][axis];
        }
    }
    if (search.cells) {
        to->hash = from->hash;
    }
}

/* Replaces what the search has found, in the lanes of `here`, by what another search has. */
VEC_INLINE void found_choose(struct found *to, vm here, const struct found *from,
                             struct search search)
{
    for (int i = 0; i < 1 + search.second; i++) {
        to->s[i] = vm_choose(here, from->s[i], to->s[i]);
        for (int axis = 0; axis < (search.steps ? search.dimensions : 0); axis++) {
            to->d[i][axis] = vm_choose(here, from->d[i][axis], to->d[i][axis]);
        }
    }
    if (search.cells) {
        to->hash = vm_choose(here, from->hash, to->hash);
    }
}

/* Searches the features of a list in all lanes, or adds them up. */
VEC_INLINE void cells_listed(struct found *found, struct sample *sum, const struct cells_list *list,
                             vf t, vf zero, struct variant v)
{
    found_begin(found, zero);
#define BEGIN(i, member, rank) sum->member = zero
    EACH_OUTPUT(v, BEGIN);
#undef BEGIN
    VEC_ROLLED_LOOP
    for (int i = 0; i < list->count; i++) {
        const struct feature f = feature_listed(&list->feature[i], t, v.dimensions);
        if (v.basis == SCARP_CELL_SOFT) {
            soft_add(sum, &f, v);
        } else {
            found_add(found, &f, search_of(v));
        }
    }
}

/* What all blocks of a row share: copies, which nothing that is stored can alias. */
struct cells_shared {
    const vf *t, *column; /* of struct along_cells */
    size_t blocks;
    vf zero; /* across x */
    vf wall, ring;
    float middle;
};

VEC_INLINE void cells_share(struct cells_shared *to, const struct cells_row *row, struct variant v)
{
    const struct along_cells *const along = row->along;
    const vf y = vf_set(row->y), z = vf_set(row->z);
    to->zero = v.dimensions == 3 ? y + z : y;
    to->wall = v.dimensions == 3 ? vf_lesser(to_wall(y), to_wall(z)) : to_wall(y);
    to->ring = ring_distance(along->octave);
    to->middle = along->octave->middle;
    to->t = along->t;
    to->column = along->column;
    to->blocks = along->blocks;
}

/* The list of a column; `last` is the one that was asked for before. */
VEC_INLINE const struct cells_list *next_list(const struct cells_list *last, struct cells_row *row,
                                              uint32_t column)
{
    return last != NULL && column == last->column ? last : cells_of_column(row, column);
}

/* Evaluates a block of a row. */
VEC_INLINE void cells_row_block(struct cells_row *row, const struct cells_shared *shared,
                                const struct cells_list **list, size_t block,
                                const struct cells_target *to, struct variant v)
{
    const struct search search = search_of(v);
    const vf t = shared->t[block], zero = 0.0f * (t + shared->zero);
    const uint32_t low = row->along->low[block], high = row->along->high[block];
    struct found found, other;
    struct sample sum, more;
    *list = next_list(*list, row, low);
    cells_listed(&found, &sum, *list, t, zero, v);
    for (uint32_t k = low + 1; k <= high; k++) {
        *list = next_list(*list, row, k);
        cells_listed(&other, &more, *list, t, zero, v);
        if (v.basis == SCARP_CELL_SOFT) {
            sum = in_column((vu)shared->column[block], k, &more, &sum, v);
        } else {
            const vm here = vm_equal((vu)shared->column[block], vu_set(k));
            found_choose(&found, here, &other, search);
        }
    }
    if (v.basis == SCARP_CELL_SOFT) {
        const struct sample n = soft_root(&sum, vf_set(shared->middle), v);
        cells_put(to, &n, v);
        return;
    }
    const vf wall = vf_lesser(to_wall(t), shared->wall);
    if (__builtin_expect(needs_ring(found.s[search.second], wall, shared->ring), 0)) {
        found_begin(&other, zero);          /* the ring keeps everything */
        found_copy(&other, &found, search); /* so that the original stays in registers */
        cells_row_ring(&other, row, block);
        found_copy(&found, &other, search);
    }
    cells_make_any(&found, to, shared->middle, v);
}

/* Draws for the rows from `first` to before `end` as far as they are in the same cells. Returns the
   row after them. */
static __attribute__((noinline)) size_t begin_cells(struct cells_row *row, size_t first, size_t end)
{
    const struct along_cells *const along = row->along;
    size_t r = first;
    row->cell_y = along->cell_y[first];
    row->y_low = 2.0f;
    row->y_high = -1.0f;
    for (; r < end && along->cell_y[r] == row->cell_y; r++) {
        const float y = along->y[r]; /* NaN needs no features */
        row->y_low = y < row->y_low ? y : row->y_low;
        row->y_high = y > row->y_high ? y : row->y_high;
    }
    draw_cells_rows(row);
    return r;
}

VEC_INLINE void cells_rows(const struct row_octave *octave, size_t rows,
                           const struct weights *weights, const struct outputs *outputs,
                           enum put put, struct variant v)
{
    const struct along_cells *const along = &octave->cells;
    const volatile struct cells_kind kind = {octave->basis, octave->order, put};
    struct cells_row row; /* most of it is not to be set here */
    row.along = along;
    row.list = (struct cells_list *)octave->table;
    row.tables = (float *)(octave->table + LISTS_SIZE);
    row.stride = along->column_blocks * VEC_LANES;
    row.z = along->z;
    row.cell_z = along->cell_z;
    row.search = search_of(v);
    row.soft = v.basis == SCARP_CELL_SOFT;
    for (size_t r = 0, end = 0; r < rows; r++) {
        struct cells_target to = {outputs, weights, &kind, r, 0};
        const struct cells_list *list = NULL;
        if (r == end) {
            end = begin_cells(&row, octave->begin + r, octave->begin + rows) - octave->begin;
        }
        row.row = r;
        row.y = along->y[octave->begin + r];
        struct cells_shared shared;
        cells_share(&shared, &row, v);
        for (size_t b = 0; b < shared.blocks; b++) {
            cells_row_block(&row, &shared, &list, b, &to, v);
            to.at += outputs->block;
        }
    }
}

/* As in basis/cells_points.h. */
#define CELLS_ROWS(name, search, dimensions, order)                                                \
    static void name(const struct row_octave *octave, size_t rows, const struct weights *weights,  \
                     const struct outputs *to, enum put put)                                       \
    {                                                                                              \
        const struct variant v = {search, dimensions, order, 0};                                   \
        cells_rows(octave, rows, weights, to, put, v);                                             \
    }
#define CELLS_ROWS_OF(d)                                                                           \
    CELLS_ROWS(nearest##d##_rows0, SCARP_CELL_F1, d, 0)                                            \
    CELLS_ROWS(nearest##d##_rows, SCARP_CELL_F1, d, 2)                                             \
    CELLS_ROWS(second##d##_rows0, SCARP_CELL_F2, d, 0)                                             \
    CELLS_ROWS(second##d##_rows, SCARP_CELL_F2, d, 2)                                              \
    CELLS_ROWS(cell##d##_rows, SCARP_CELL_VALUE, d, 2)                                             \
    CELLS_ROWS(soft##d##_rows0, SCARP_CELL_SOFT, d, 0)                                             \
    CELLS_ROWS(soft##d##_rows1, SCARP_CELL_SOFT, d, 1)                                             \
    CELLS_ROWS(soft##d##_rows2, SCARP_CELL_SOFT, d, 2)

CELLS_ROWS_OF(2)
CELLS_ROWS_OF(3)

#undef CELLS_ROWS
#undef CELLS_ROWS_OF

#endif
