/* SPDX-License-Identifier: MIT */
#include "evaluate.h"

#include <math.h>
#include <string.h>

#include "../calls/run.h"
#include "graph.h"
#include "machine.h"
#include "plans.h"

#define ALIGNMENT 64
#define GRANULE 16 /* registers have room for a multiple of this many points */

/* Of registers, or of outputs where there are none: more would leave the second-level cache. Pieces
   of grids are large, since each is a call of its own for each noise; but chunks that masks may
   hide are not, and those of points gain nothing. */
#define MOST_BYTES ((size_t)1 << 19)
#define MOST_POINTS ((size_t)4096)
#define MOST_OF_GRIDS ((size_t)65536)
#define BEST_POINTS ((size_t)4096) /* that scratch memory should have room for, in large calls */

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

/* How many registers a call needs: none if all steps run in the caller's arrays. Those of copies are
   the last ones. */
static size_t registers_of(const struct recipe_machine *m, const struct recipe_evaluation *call)
{
    const unsigned directs = scarpi_recipe_find_directs(m, call);
    int is_direct = call->grid == NULL || scarpi_recipe_has_no_gaps(call);
    for (int k = 0; k < m->schedule->steps; k++) {
        const int home = m->schedule->home_of[m->schedule->step[k]];
        is_direct = is_direct && home > 0 && (directs >> (home - 1) & 1) != 0;
    }
    const int copies = m->has_parts ? 0 : m->schedule->copies;
    return is_direct ? 0 : (size_t)(m->schedule->registers - copies);
}

/* Divides what is left of the scratch memory into registers and positions. Returns 0 if no point
   fits in. */
static int set_memory(struct recipe_machine *m, const struct recipe_evaluation *call, int order,
                      size_t size)
{
    const int dimensions = call->recipe->dimensions;
    bool has_positions = false;
    for (int k = 0; k < m->schedule->steps; k++) {
        has_positions = has_positions ||
                        scarpi_recipe_needs_positions(m, m->schedule->step[k], call->grid != NULL);
    }
    m->floats = arrays_of(dimensions, order);
    const size_t registers = registers_of(m, call);
    const size_t used = registers > 0 ? registers : (size_t)call->outputs;
    const size_t positions = has_positions ? (size_t)dimensions * sizeof(double) : 0;
    const size_t each = registers * m->floats * sizeof(float) + positions;
    const size_t most = MOST_BYTES / (used * m->floats * sizeof(float) + positions);
    const size_t limit =
        call->grid != NULL && m->schedule->guards == 0 ? MOST_OF_GRIDS : MOST_POINTS;
    m->room = (most < limit ? most : limit) / GRANULE * GRANULE;
    m->room = each > 0 && size / each < m->room ? size / each / GRANULE * GRANULE : m->room;
    /* Compact pieces lie behind masks more often, and calls take longer for a few long rows. */
    m->is_narrow = call->grid != NULL && registers > 0 &&
                   (m->schedule->guards > 0 || m->room / 4 < call->grid->count[0]);
    char *at = (char *)m + MACHINE_BYTES;
    for (int i = 0; i < dimensions; i++) {
        m->position[i] = at;
        at += has_positions ? m->room * sizeof(double) : 0;
    }
    m->registers = (float *)(void *)at;
    return m->room > 0;
}

enum scarp_status scarpi_recipe_run_steps(struct recipe_machine *m,
                                          const struct recipe_chunk *chunk, int from, int to)
{
    enum scarp_status status = SCARP_OK;
    m->chunk = chunk;
    memset(m->state, GUARD_UNKNOWN, sizeof m->state);
    for (int k = from; status == SCARP_OK && k < to; k++) {
        const int n = m->schedule->step[k], home = m->schedule->home_of[n];
        if ((home > 0 && (m->wholes >> (home - 1) & 1) != 0) ||
            (m->schedule->guard_of[n] != 0 &&
             scarpi_recipe_is_left_out(m, m->schedule->guard_of[n]))) {
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
    size_t members = 0;
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        members += recipe_member(out, i) != NULL;
    }
    return scarpi_recipe_order_of(out, m->recipe->dimensions) == m->order_of[node] &&
           members == arrays_of(m->recipe->node[node].dimensions, m->order_of[node]);
}

unsigned scarpi_recipe_find_directs(const struct recipe_machine *m,
                                    const struct recipe_evaluation *call)
{
    unsigned directs = 0;
    for (int i = 0; i < call->outputs; i++) {
        const int has_home = m->schedule->home_of[call->root[i]] == i + 1;
        directs |= (unsigned)(has_home && has_all_members(m, call->root[i], &call->out[i])) << i;
    }
    return directs;
}

/* Copies outputs of points from i on that are in registers. */
static NOINLINE void copy_outputs(const struct recipe_machine *m,
                                  const struct recipe_evaluation *call, size_t i, size_t count)
{
    for (int output = 0; output < call->outputs; output++) {
        if ((m->directs >> output & 1) != 0) {
            continue;
        }
        struct scarp_samples s;
        scarpi_recipe_find_samples(m, call->root[output], &s);
        for (int k = 0; k < RECIPE_MEMBERS; k++) {
            float *const array = recipe_member(&call->out[output], k);
            if (array != NULL) {
                memcpy(array + i, recipe_member(&s, k), count * sizeof *array);
            }
        }
    }
}

static KEEP_STATUS enum scarp_status run_points(struct recipe_machine *m,
                                                const struct recipe_evaluation *call)
{
    const size_t bytes = call->has_doubles ? sizeof(double) : sizeof(float);
    enum scarp_status status = SCARP_OK;
    m->directs = scarpi_recipe_find_directs(m, call);
    for (size_t i = 0; status == SCARP_OK && i < call->count; i += m->room) {
        struct recipe_chunk chunk = {.count =
                                         call->count - i < m->room ? call->count - i : m->room};
        for (int axis = 0; axis < call->recipe->dimensions; axis++) {
            chunk.at[axis] = (const char *)call->at[axis] + i * bytes;
        }
        m->direct_from = i;
        status = scarpi_recipe_run_steps(m, &chunk, 0, m->schedule->steps);
        copy_outputs(m, call, i, chunk.count);
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
    m->directs = m->wholes = 0;
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
    const bool is_whole = call->grid != NULL && scarpi_recipe_find_wholes(m, call);
    m->has_parts = call->grid != NULL && m->schedule->first_of[m->schedule->all_axes] > 0 &&
                   scarpi_recipe_is_finite(call->grid, call->recipe->dimensions);
    if (!is_whole && !set_memory(m, call, order, call->size - lost - MACHINE_BYTES)) {
        return SCARP_ERROR_SIZE;
    }
    if (!asks_for_something(call)) { /* a grid may have any number of samples */
        return SCARP_OK;
    }
    enum scarp_status status = SCARP_OK;
    if (m->wholes != 0) {
        status = scarpi_recipe_run_wholes(m, call);
    }
    if (status == SCARP_OK && !is_whole) {
        status = call->grid != NULL ? scarpi_recipe_run_grid(m, call) : run_points(m, call);
    }
    if (status != SCARP_OK) {
        spoil(call);
    }
    return status;
}
