/* SPDX-License-Identifier: MIT */
#include "evaluate.h"

#include <math.h>
#include <string.h>

#include "../calls/run.h"
#include "graph.h"
#include "machine.h"
#include "plan.h"

#define ALIGNMENT 64
#define GRANULE 16       /* registers have room for a multiple of this many points */
#define PIECE 64         /* columns of a grid that go through the steps together */
#define MOST_POINTS 4096 /* of a register: more would leave the caches */
#define BEST_POINTS 4096 /* that scratch memory should have room for, in large calls */

/* The machine lies in the scratch memory, too, since kernels need nearly all the stack of a call.
 */
#define MACHINE_BYTES ((sizeof(struct recipe_machine) + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT)

/* How many arrays derivatives up to an order have. */
static size_t arrays_of(int dimensions, int order)
{
    static const unsigned char count[2][3] = {{1, 3, 6}, {1, 4, 10}};
    return count[dimensions - 2][order];
}

int scarpi_recipe_order_of(const struct scarp_samples *out, int dimensions)
{
    const struct scarp_request kind = scarpi_request_of_samples(dimensions, out);
    return kind.dphase || kind.order == SCARP_UNSUPPORTED_ORDER ? -1 : kind.order;
}

static size_t bytes_for(size_t registers, size_t floats, int dimensions, size_t points)
{
    const size_t room = (points + GRANULE - 1) / GRANULE * GRANULE;
    return room * (registers * floats * sizeof(float) + (size_t)dimensions * sizeof(double)) +
           MACHINE_BYTES + ALIGNMENT;
}

size_t scarpi_recipe_bytes(const struct recipe *recipe, const struct recipe_schedule *schedule,
                           int order, size_t points)
{
    const int highest = order + schedule->extra < 2 ? order + schedule->extra : 2;
    return bytes_for((size_t)schedule->registers, arrays_of(recipe->dimensions, highest),
                     recipe->dimensions, points > 0 ? points : BEST_POINTS);
}

void scarpi_recipe_raise_orders(const struct recipe *recipe, const struct recipe_schedule *schedule,
                                uint8_t order_of[RECIPE_NODES])
{
    for (int k = schedule->steps - 1; k >= 0; k--) {
        int16_t reads[RECIPE_READS];
        int slopes;
        const int n = schedule->step[k], count = scarpi_recipe_reads(recipe, n, reads, &slopes);
        const int traits = scarpi_recipe_traits(recipe->node[n].operation);
        for (int i = 0; i < count && i < slopes; i++) {
            const int is_base = (traits & NEEDS_SLOPES) != 0 && i == 0;
            if (order_of[reads[i]] < order_of[n] + is_base) {
                order_of[reads[i]] = (uint8_t)(order_of[n] + is_base);
            }
        }
    }
}

/* Which derivatives are computed of each node. Returns the highest order, or -1 if a node does not
   have what is asked of it. */
static int set_orders(struct recipe_machine *m, const struct recipe_evaluation *call)
{
    const struct recipe *const r = call->recipe;
    int highest = 0;
    for (int k = 0; k < m->schedule->steps; k++) {
        m->order_of[m->schedule->step[k]] = 0;
    }
    for (int i = 0; i < call->outputs; i++) {
        const int order = scarpi_recipe_order_of(&call->out[i], r->dimensions);
        if (order < 0) {
            return -1;
        }
        uint8_t *const of = &m->order_of[call->root[i]];
        *of = (uint8_t)(order > *of ? order : *of);
        highest = order > highest ? order : highest;
    }
    if (highest == 0 && m->schedule->extra == 0) { /* values are made of values */
        return 0;
    }
    scarpi_recipe_raise_orders(r, m->schedule, m->order_of);
    for (int k = 0; k < m->schedule->steps; k++) {
        const int n = m->schedule->step[k], order = m->order_of[n];
        highest = order > highest ? order : highest;
        if (order > r->node[n].order) {
            return -1;
        }
    }
    return highest;
}

/* Divides what is left of the scratch memory into registers and positions. Returns 0 if no point
   fits in. */
static int set_memory(struct recipe_machine *m, int dimensions, int order, size_t size)
{
    m->floats = arrays_of(dimensions, order);
    const size_t each = bytes_for((size_t)m->schedule->registers, m->floats, dimensions, GRANULE) -
                        MACHINE_BYTES - ALIGNMENT;
    m->room = size / each * GRANULE;
    m->room = m->room < MOST_POINTS ? m->room : MOST_POINTS;
    char *at = (char *)m + MACHINE_BYTES;
    for (int i = 0; i < dimensions; i++) {
        m->position[i] = at;
        at += m->room * sizeof(double);
    }
    m->registers = (float *)(void *)at;
    return m->room > 0;
}

/* Stops at the first step that fails. */
static KEEP_STATUS enum scarp_status run_steps(struct recipe_machine *m,
                                               const struct recipe_chunk *chunk, int from, int to)
{
    enum scarp_status status = SCARP_OK;
    m->chunk = chunk;
    memset(m->state, GUARD_UNKNOWN, sizeof m->state);
    for (int k = from; status == SCARP_OK && k < to; k++) {
        const int n = m->schedule->step[k];
        if (m->schedule->guard_of[n] != 0 &&
            scarpi_recipe_is_left_out(m, m->schedule->guard_of[n])) {
            continue;
        }
        if (m->recipe->node[n].place >= 0) {
            status = scarpi_recipe_run_placed(m, n);
        } else if (m->recipe->node[n].operation != OP_COMPONENT) {
            status = scarpi_recipe_run_operation(m, n);
        }
    }
    return status;
}

/* Whether an output has exactly the members that are computed of its node. */
static int has_all_members(const struct recipe_machine *m, int node,
                           const struct scarp_samples *out)
{
    struct scarp_samples s;
    scarpi_recipe_find_samples(m, node, &s);
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        if ((recipe_member(&s, i) == NULL) != (recipe_member(out, i) == NULL)) {
            return 0;
        }
    }
    return 1;
}

/* The outputs that can be computed where the caller wants them; the others are copied there. */
static unsigned find_directs(const struct recipe_machine *m, const struct recipe_evaluation *call)
{
    unsigned directs = 0;
    for (int i = 0; i < call->outputs; i++) {
        const int is_alone = m->schedule->alone >> i & 1;
        directs |= (unsigned)(is_alone && has_all_members(m, call->root[i], &call->out[i])) << i;
    }
    return directs;
}

/* Copies outputs that are in registers: `width` elements, `step` apart from the next ones. */
struct target {
    size_t from; /* the first element */
    size_t width, rows, slices, row_stride, slice_stride;
};

static void copy_outputs(const struct recipe_machine *m, const struct recipe_evaluation *call,
                         unsigned directs, const struct target *to)
{
    for (int i = 0; i < call->outputs; i++) {
        if ((directs >> i & 1) != 0) {
            continue;
        }
        const struct scarp_samples s = scarpi_recipe_samples(m, call->root[i]);
        for (int k = 0; k < RECIPE_MEMBERS; k++) {
            const float *source = recipe_member(&s, k);
            float *const array = recipe_member(&call->out[i], k);
            for (size_t row = 0; array != NULL && row < to->rows * to->slices; row++) {
                memcpy(array + to->from + row % to->rows * to->row_stride +
                           row / to->rows * to->slice_stride,
                       source, to->width * sizeof *array);
                source += to->width;
            }
        }
    }
}

static KEEP_STATUS enum scarp_status run_points(struct recipe_machine *m,
                                                const struct recipe_evaluation *call)
{
    const unsigned directs = find_directs(m, call);
    const size_t bytes = call->has_doubles ? sizeof(double) : sizeof(float);
    enum scarp_status status = SCARP_OK;
    for (size_t i = 0; status == SCARP_OK && i < call->count; i += m->room) {
        struct recipe_chunk chunk = {.count =
                                         call->count - i < m->room ? call->count - i : m->room};
        for (int axis = 0; axis < call->recipe->dimensions; axis++) {
            chunk.at[axis] = (const char *)call->at[axis] + i * bytes;
        }
        m->directs = directs;
        m->direct_from = i;
        status = run_steps(m, &chunk, 0, m->schedule->steps);
        copy_outputs(m, call, directs,
                     &(struct target){.from = i, .width = chunk.count, .rows = 1, .slices = 1});
    }
    return status;
}

/* Repeats what was computed of the first slice for all slices of a column. */
static void repeat_columns(const struct recipe_machine *m, size_t points, size_t slices)
{
    for (int k = 0; k < m->schedule->columns; k++) {
        const struct scarp_samples s = scarpi_recipe_samples(m, m->schedule->step[k]);
        for (int i = 0; i < RECIPE_MEMBERS; i++) {
            float *const array = recipe_member(&s, i);
            for (size_t slice = 1; array != NULL && slice < slices; slice++) {
                memcpy(array + slice * points, array, points * sizeof *array);
            }
        }
    }
}

/* A piece of a grid: whole columns of it, as many slices at once as there is room for. */
static KEEP_STATUS enum scarp_status run_piece(struct recipe_machine *m,
                                               const struct recipe_evaluation *call,
                                               unsigned directs, const struct scarp_grid *piece)
{
    const struct scarp_grid *const g = call->grid;
    const size_t points = piece->count[0] * piece->count[1];
    const size_t slices = call->recipe->dimensions == 3 ? g->count[2] : 1;
    const size_t most = m->room / points < slices ? m->room / points : slices;
    const size_t from = (size_t)(piece->first[1] - g->first[1]) * g->row_stride +
                        (size_t)(piece->first[0] - g->first[0]);
    struct scarp_grid part = *piece;
    struct recipe_chunk chunk = {.count = points, .grid = &part};
    const int columns = call->recipe->dimensions == 3 ? m->schedule->columns : 0;
    const int is_whole = piece->count[0] == g->row_stride || piece->count[1] == 1;
    enum scarp_status status = SCARP_OK;
    part.count[2] = 1;
    if (columns > 0) {
        m->directs = 0;
        status = run_steps(m, &chunk, 0, columns);
        repeat_columns(m, points, most);
    }
    for (size_t slice = 0; status == SCARP_OK && slice < slices; slice += most) {
        part.first[2] = g->first[2] + (int64_t)slice;
        part.count[2] = slices - slice < most ? slices - slice : most;
        chunk.count = points * part.count[2];
        const struct target to = {.from = from + slice * g->slice_stride,
                                  .width = piece->count[0],
                                  .rows = piece->count[1],
                                  .slices = part.count[2],
                                  .row_stride = g->row_stride,
                                  .slice_stride = g->slice_stride};
        const int is_tight = is_whole && (part.count[2] == 1 || g->slice_stride == points);
        const unsigned chosen = is_tight ? directs : 0;
        m->directs = chosen;
        m->direct_from = to.from;
        status = run_steps(m, &chunk, columns, m->schedule->steps);
        copy_outputs(m, call, chosen, &to);
    }
    return status;
}

static KEEP_STATUS enum scarp_status run_grid(struct recipe_machine *m,
                                              const struct recipe_evaluation *call)
{
    const struct scarp_grid *const g = call->grid;
    const size_t slices = call->recipe->dimensions == 3 ? g->count[2] : 1;
    const size_t most = m->room < PIECE ? m->room : PIECE;
    const size_t width = g->count[0] < most ? g->count[0] : most;
    /* In space, a piece is as deep as it is high, if there is room. */
    size_t rows = m->room / width;
    while (slices > 1 && rows > 1 && rows * rows > m->room / width) {
        rows = rows / 2;
    }
    rows = rows < g->count[1] ? rows : g->count[1];
    unsigned directs = find_directs(m, call);
    enum scarp_status status = SCARP_OK;
    for (int i = 0; i < call->outputs; i++) { /* what is computed once per column is copied */
        for (int k = 0; k < m->schedule->columns; k++) {
            directs &= ~((unsigned)(m->schedule->step[k] == call->root[i]) << i);
        }
    }
    for (size_t row = 0; row < g->count[1]; row += rows) {
        for (size_t column = 0; status == SCARP_OK && column < g->count[0]; column += width) {
            struct scarp_grid piece = *g;
            piece.row_stride = piece.slice_stride = 0;
            piece.first[0] += (int64_t)column;
            piece.first[1] += (int64_t)row;
            piece.count[0] = g->count[0] - column < width ? g->count[0] - column : width;
            piece.count[1] = g->count[1] - row < rows ? g->count[1] - row : rows;
            status = run_piece(m, call, directs, &piece);
        }
    }
    return status;
}

static int asks_for_something(const struct recipe_evaluation *call)
{
    int asked = 0;
    for (int i = 0; i < call->outputs * RECIPE_MEMBERS; i++) {
        asked |= recipe_member(&call->out[i / RECIPE_MEMBERS], i % RECIPE_MEMBERS) != NULL;
    }
    return asked;
}

/* So that memory that nobody wrote is never taken for values: makes all outputs NaN. */
static void spoil(const struct recipe_evaluation *call)
{
    const struct scarp_grid *const g = call->grid;
    const size_t width = g != NULL ? g->count[0] : call->count, rows = g != NULL ? g->count[1] : 1;
    const size_t slices = g != NULL && call->recipe->dimensions == 3 ? g->count[2] : 1;
    for (int i = 0; i < call->outputs * RECIPE_MEMBERS; i++) {
        float *const array = recipe_member(&call->out[i / RECIPE_MEMBERS], i % RECIPE_MEMBERS);
        for (size_t row = 0; array != NULL && row < rows * slices; row++) {
            const size_t from =
                g != NULL ? row % rows * g->row_stride + row / rows * g->slice_stride : 0;
            for (size_t k = 0; k < width; k++) {
                array[from + k] = NAN;
            }
        }
    }
}

enum scarp_status scarpi_recipe_evaluate(const struct recipe_evaluation *call)
{
    const size_t lost = -(uintptr_t)call->memory % ALIGNMENT;
    if (call->size < lost + MACHINE_BYTES) {
        return SCARP_ERROR_SIZE;
    }
    struct recipe_machine *const m = (void *)((char *)call->memory + lost);
    m->directs = 0;
    m->recipe = call->recipe;
    m->schedule = call->schedule;
    m->plan = scarpi_recipe_plan_of(call->plan);
    m->has_doubles = call->has_doubles != 0;
    m->out = call->out;
    m->root = call->root;
    const int order = set_orders(m, call);
    if (order < 0) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (!set_memory(m, call->recipe->dimensions, order, call->size - lost - MACHINE_BYTES)) {
        return SCARP_ERROR_SIZE;
    }
    if (!asks_for_something(call)) { /* a grid may have any number of samples */
        return SCARP_OK;
    }
    const enum scarp_status status = call->grid != NULL ? run_grid(m, call) : run_points(m, call);
    if (status != SCARP_OK) {
        spoil(call);
    }
    return status;
}
