/* SPDX-License-Identifier: MIT
 *
 * Takes a grid through the steps of a recipe, piece by piece. A piece has whole rows, and whole
 * slices, if there is room: so it is long where the caller's arrays are, and may be computed there.
 * It is narrow where masks may hide it, or where few rows have room.
 *
 * Steps that do not depend on all axes run on a box of their own, which is one sample thick along
 * the others: all of the grid if that fits into a register, or else what the piece needs. They run
 * again only when that changes. What others read of them is spread to the boxes of those.
 *
 * An output that is one noise, at the places of the points, is one call.
 */
#include "evaluate.h"

#include <math.h>
#include <string.h>

#include "../calls/run.h"
#include "graph.h"

#define BLOCK 16   /* floats that are copied at once */
#define NARROW 256 /* columns */

/* Where a box of the grid goes. */
struct target {
    struct recipe_box box;
    size_t row_stride, slice_stride;
};

static struct target tight(const struct recipe_box *box)
{
    const struct target to = {*box, box->count[0], box->count[0] * box->count[1]};
    return to;
}

static bool is_same(const struct recipe_box *a, const struct recipe_box *b, int axis)
{
    return a->from[axis] == b->from[axis] && a->count[axis] == b->count[axis];
}

static size_t samples_of(const struct recipe_box *box)
{
    return box->count[0] * box->count[1] * box->count[2];
}

static void copy_row(float *to, const float *from, size_t count)
{
    size_t i = 0;
    for (; i + BLOCK <= count; i += BLOCK) {
        memcpy(to + i, from + i, BLOCK * sizeof *to);
    }
    for (; i < count; i++) {
        to[i] = from[i];
    }
}

static void fill_row(float *to, float value, size_t count)
{
    size_t i = 0;
    for (; i + BLOCK <= count; i += BLOCK) {
        for (int k = 0; k < BLOCK; k++) {
            to[i + (size_t)k] = value;
        }
    }
    for (; i < count; i++) {
        to[i] = value;
    }
}

/* Spreads what was computed in the box `has`, which is one sample thick along the axes that are not
   in `axes`. */
static void spread(const float *from, const struct recipe_box *has, int axes,
                   const struct target *to, float *array)
{
    size_t start[3], count[3];
    for (int i = 0; i < 3; i++) {
        start[i] = (axes >> i & 1) != 0 ? to->box.from[i] - has->from[i] : 0;
        count[i] = to->box.count[i];
    }
    const bool is_slice = count[0] == to->row_stride && /* as one row */
                          ((axes & 3) == 0 || ((axes & 3) == 3 && count[0] == has->count[0]));
    const size_t width = is_slice ? count[0] * count[1] : count[0], rows = is_slice ? 1 : count[1];
    for (size_t slice = 0; slice < count[2]; slice++) {
        const size_t z = start[2] + ((axes & 4) != 0 ? slice : 0);
        for (size_t row = 0; row < rows; row++) {
            const size_t y = start[1] + ((axes & 2) != 0 ? row : 0);
            const float *const at = from + (z * has->count[1] + y) * has->count[0] + start[0];
            float *const line = array + slice * to->slice_stride + row * to->row_stride;
            if ((axes & 1) != 0) {
                copy_row(line, at, width);
            } else {
                fill_row(line, *at, width);
            }
        }
    }
}

static void spread_samples(const struct recipe_machine *m, int node, const struct target *to,
                           const struct scarp_samples *out)
{
    const int axes = m->has_parts ? m->schedule->axes_of[node] : m->schedule->all_axes;
    struct scarp_samples s;
    scarpi_recipe_find_in_register(m, node, m->schedule->register_of[node], &s);
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        float *const array = recipe_member(out, i);
        if (array != NULL && recipe_member(&s, i) != NULL) {
            spread(recipe_member(&s, i), &m->box[axes], axes, to, array);
        }
    }
}

/* Makes copies of what these steps read of those that depend on fewer axes. They are there already
   where the box moved only along others. */
static void spread_copies(struct recipe_machine *m, int axes, const struct recipe_box *before)
{
    const struct recipe_box *const box = &m->box[axes];
    const struct target to = tight(box);
    for (int i = 0; i < m->schedule->copies; i++) {
        const struct recipe_copy *const copy = &m->schedule->copy[i];
        const int from = m->schedule->axes_of[copy->node];
        bool is_there = m->has_box[axes];
        for (int axis = 0; axis < 3; axis++) {
            is_there = is_there && before->count[axis] == box->count[axis] &&
                       ((from >> axis & 1) == 0 || before->from[axis] == box->from[axis]);
        }
        if (copy->axes == axes && !is_there) {
            struct scarp_samples out;
            scarpi_recipe_find_in_register(m, copy->node, copy->in_register, &out);
            spread_samples(m, copy->node, &to, &out);
        }
    }
}

/* Runs the steps of some axes on a box. */
static KEEP_STATUS enum scarp_status run_box(struct recipe_machine *m,
                                             const struct scarp_grid *whole, int axes)
{
    const struct recipe_box *const box = &m->box[axes];
    const struct recipe_schedule *const s = m->schedule;
    struct scarp_grid part = *whole;
    const struct recipe_chunk chunk = {.count = samples_of(box), .grid = &part};
    part.row_stride = part.slice_stride = 0;
    for (int i = 0; i < m->recipe->dimensions; i++) {
        part.first[i] += (int64_t)box->from[i];
        part.count[i] = box->count[i];
    }
    return scarpi_recipe_run_steps(m, &chunk, m->has_parts ? s->first_of[axes] : 0,
                                   s->first_of[axes + 1]);
}

static bool has_steps(const struct recipe_machine *m, int axes)
{
    return m->schedule->first_of[axes] < m->schedule->first_of[axes + 1];
}

/* The sets of axes whose steps run at once for the whole grid, a bit for each. */
static unsigned find_at_once(const struct recipe_machine *m, const struct scarp_grid *grid)
{
    unsigned at_once = 0;
    for (int axes = 0; axes < m->schedule->all_axes && m->has_parts; axes++) {
        uint64_t samples = 1; /* at most the square of what has room, or UINT64_MAX */
        for (int i = 0; i < 3; i++) {
            const size_t count = (axes >> i & 1) != 0 ? grid->count[i] : 1;
            samples = count > m->room || samples > m->room ? UINT64_MAX : samples * count;
        }
        at_once |= (unsigned)(samples <= m->room) << axes;
    }
    return at_once;
}

/* The box on which steps of some axes run for a piece. */
static struct recipe_box box_for(const struct recipe_machine *m, const struct scarp_grid *grid,
                                 int axes, const struct recipe_box *piece)
{
    struct recipe_box box = {{0, 0, 0}, {1, 1, 1}};
    const bool is_at_once = (m->at_once >> axes & 1) != 0;
    for (int i = 0; i < 3; i++) {
        if ((axes >> i & 1) != 0) {
            box.from[i] = is_at_once ? 0 : piece->from[i];
            box.count[i] = is_at_once ? grid->count[i] : piece->count[i];
        }
    }
    return box;
}

/* Runs all steps for a piece. */
static KEEP_STATUS enum scarp_status
run_piece(struct recipe_machine *m, const struct scarp_grid *grid, const struct recipe_box *piece)
{
    const int all = m->schedule->all_axes;
    for (int axes = m->has_parts ? 0 : all; axes <= all; axes++) {
        if (m->has_parts && !has_steps(m, axes)) {
            continue;
        }
        const struct recipe_box before = m->box[axes];
        const struct recipe_box box = box_for(m, grid, axes, piece);
        const bool is_there = m->has_box[axes] && axes != all && is_same(&before, &box, 0) &&
                              is_same(&before, &box, 1) && is_same(&before, &box, 2);
        if (is_there) {
            continue;
        }
        m->axes = (uint8_t)axes;
        m->box[axes] = box;
        if (m->has_parts) {
            spread_copies(m, axes, &before);
        }
        m->has_box[axes] = true;
        const enum scarp_status status = run_box(m, grid, axes);
        if (status != SCARP_OK) {
            return status;
        }
    }
    return SCARP_OK;
}

/* Copies the outputs of a piece that are not there yet. */
static NOINLINE void copy_outputs(const struct recipe_machine *m,
                                  const struct recipe_evaluation *call, const struct target *to)
{
    const size_t from =
        to->box.from[0] + to->box.from[1] * to->row_stride + to->box.from[2] * to->slice_stride;
    for (int i = 0; i < call->outputs; i++) {
        if (((m->directs | m->wholes) >> i & 1) == 0) {
            struct scarp_samples out;
            scarpi_recipe_find_output(&call->out[i], from, &out);
            spread_samples(m, call->root[i], to, &out);
        }
    }
}

bool scarpi_recipe_find_wholes(struct recipe_machine *m, const struct recipe_evaluation *call)
{
    int count = 0;
    for (int i = 0; i < call->outputs; i++) {
        const struct recipe_node *const n = &m->recipe->node[call->root[i]];
        const int is_whole = n->operation == OP_NOISE && n->place == 0 &&
                             m->schedule->home_of[call->root[i]] == i + 1;
        m->wholes |= (unsigned)is_whole << i;
        count += is_whole;
    }
    return count == call->outputs;
}

enum scarp_status scarpi_recipe_run_wholes(struct recipe_machine *m,
                                           const struct recipe_evaluation *call)
{
    const struct recipe_chunk chunk = {.grid = call->grid};
    enum scarp_status status = SCARP_OK;
    m->chunk = &chunk;
    for (int i = 0; status == SCARP_OK && i < call->outputs; i++) {
        if ((m->wholes >> i & 1) != 0) {
            status = scarpi_recipe_run_noise(m, call->root[i], &call->out[i]);
        }
    }
    m->chunk = NULL;
    return status;
}

bool scarpi_recipe_is_finite(const struct scarp_grid *grid, int dimensions)
{
    bool good = true;
    for (int i = 0; i < dimensions; i++) {
        const double first = (double)grid->first[i];
        const double last = (double)(grid->first[i] + (int64_t)(grid->count[i] - 1));
        good = good && fabs(grid->origin[i] + first * grid->step[i]) < INFINITY &&
               fabs(grid->origin[i] + last * grid->step[i]) < INFINITY;
    }
    return good;
}

bool scarpi_recipe_has_no_gaps(const struct recipe_evaluation *call)
{
    return call->grid->row_stride == call->grid->count[0] || call->grid->count[1] == 1;
}

/* `count` cut into as few parts as possible, none larger than `most`, and all about equal. */
static size_t cut(size_t count, size_t most)
{
    if (count <= most || most == 0) {
        return count <= most ? count : 1;
    }
    const size_t parts = count / most + (count % most != 0);
    return count / parts + (count % parts != 0);
}

/* How large pieces are. */
static void size_pieces(const struct recipe_machine *m, const struct scarp_grid *grid,
                        const size_t count[3], size_t most[3])
{
    const size_t slice = count[0] > m->room / count[1] ? m->room + 1 : count[0] * count[1];
    const bool has_gaps = grid->slice_stride != slice;
    const size_t widest = m->is_narrow && m->room > NARROW ? NARROW : m->room;
    most[0] = m->is_narrow && count[0] > widest ? widest : cut(count[0], widest);
    most[1] = m->is_narrow || most[0] == count[0] ? cut(count[1], m->room / most[0]) : 1;
    most[2] = most[0] * most[1] == slice && !(m->directs != 0 && has_gaps)
                  ? cut(count[2], m->room / slice)
                  : 1;
}

/* Whether nothing is left to compute that depends on all axes, and the rest is computed at once. */
static bool is_only_spread(const struct recipe_machine *m)
{
    const struct recipe_schedule *const s = m->schedule;
    for (int axes = 0; axes < s->all_axes; axes++) {
        if (has_steps(m, axes) && (m->at_once >> axes & 1) == 0) {
            return false;
        }
    }
    for (int k = s->first_of[s->all_axes]; k < s->steps; k++) {
        const int home = s->home_of[s->step[k]];
        if (home == 0 || (m->wholes >> (home - 1) & 1) == 0) {
            return false;
        }
    }
    return m->has_parts;
}

/* The axis along which pieces follow each other: one on which steps do not depend that run piece
   by piece. */
static int inner_axis(const struct recipe_machine *m)
{
    const struct recipe_schedule *const s = m->schedule;
    int inner = 0, most = 1;
    for (int axis = 0; axis < m->recipe->dimensions && m->has_parts; axis++) {
        int steps = 0;
        for (int axes = 0; axes < s->all_axes; axes++) {
            const bool is_apart = (axes >> axis & 1) == 0 && (m->at_once >> axes & 1) == 0;
            steps += is_apart ? s->first_of[axes + 1] - s->first_of[axes] : 0;
        }
        inner = steps >= most ? axis : inner;
        most = steps > most ? steps : most;
    }
    return inner;
}

static KEEP_STATUS enum scarp_status run_pieces(struct recipe_machine *m,
                                                const struct recipe_evaluation *call,
                                                const size_t count[3], const size_t most[3])
{
    const struct scarp_grid *const g = call->grid;
    const int inner = inner_axis(m);
    const int order[3] = {inner, inner == 0, inner == 2 ? 1 : 2};
    struct target to = {.row_stride = g->row_stride, .slice_stride = g->slice_stride};
    enum scarp_status status = SCARP_OK;
    size_t at[3] = {0, 0, 0};
    while (status == SCARP_OK && at[order[2]] < count[order[2]]) {
        for (int i = 0; i < 3; i++) {
            to.box.from[i] = at[i];
            to.box.count[i] = count[i] - at[i] < most[i] ? count[i] - at[i] : most[i];
        }
        m->direct_from = at[0] + at[1] * g->row_stride + at[2] * g->slice_stride;
        status = run_piece(m, g, &to.box);
        if (status == SCARP_OK) {
            copy_outputs(m, call, &to);
        }
        for (int i = 0; i < 3; i++) { /* the next piece */
            at[order[i]] += most[order[i]];
            if (i == 2 || at[order[i]] < count[order[i]]) {
                break;
            }
            at[order[i]] = 0;
        }
    }
    return status;
}

enum scarp_status scarpi_recipe_run_grid(struct recipe_machine *m,
                                         const struct recipe_evaluation *call)
{
    struct scarp_grid grid = *call->grid;
    struct recipe_evaluation inside = *call;
    size_t most[3] = {grid.count[0], grid.count[1], grid.count[2]};
    if (call->recipe->dimensions == 2) {
        grid.count[2] = most[2] = 1;
        grid.slice_stride = 0;
    }
    inside.grid = &grid;
    memset(m->has_box, 0, sizeof m->has_box);
    m->at_once = find_at_once(m, &grid);
    const struct recipe_box all = {{0, 0, 0}, {grid.count[0], grid.count[1], grid.count[2]}};
    if (!is_only_spread(m)) {
        m->directs = !m->is_narrow && scarpi_recipe_has_no_gaps(call)
                         ? scarpi_recipe_find_directs(m, call)
                         : 0;
        size_pieces(m, &grid, all.count, most);
    }
    return run_pieces(m, &inside, all.count, most);
}
