/* SPDX-License-Identifier: MIT
 *
 * Which operands cannot matter in a chunk of points, since bounds say so. A lesser or greater takes
 * nothing of an operand that is beyond all values of the other one, nor does a smooth one where
 * they are apart by its width. What is held between two numbers, or is level beyond two, has one
 * value where its operand is beyond these. Then the operand is not computed, and no bit shows it:
 *
 * - Bounds are strict: where both values are equal, signs of 0 might show.
 * - What is left out is no NaN: it is made of nodes that are finite numbers wherever coordinates are
 *   near, and these are.
 * - Derivatives are those of the operand that is taken, to the bit, of a lesser or greater alone.
 *   Others multiply the derivatives of both by partial ones, which may be 0: that gives 0, -0 or NaN.
 *   So these are gates where only their value is asked for.
 *
 * The bounds of a chunk follow from the values that are computed of it already: of the nodes at the
 * edge of what a guard has, such as a coordinate. They take the rules of interval.c from there.
 */
#include "skips.h"

#include <math.h>
#include <string.h>

#include "../calls/run.h"
#include "graph.h"
#include "interval.h"
#include "machine.h"

typedef struct recipe_interval bounds;

#define NEAR 0x1p40  /* no coordinate of near points is larger */
#define PLACE 0x1p64 /* nor is one of their places, so positions of all octaves are below 2^116 */
#define VALUE 0x1p100f
#define LANES 16
#define FEW 32 /* points, which cost less than to decide */

int scarpi_recipe_skips(int operation)
{
    switch (operation) {
    case OP_MIN:
    case OP_MAX:
    case OP_SMOOTH_MIN:
    case OP_SMOOTH_MAX: return 2;
    case OP_CLAMP:
    case OP_SMOOTHSTEP:
    case OP_CURVE: return 1;
    default: return 0;
    }
}

int scarpi_recipe_bounded_by(const struct recipe *recipe, int node, int16_t by[2])
{
    const struct recipe_node *const n = &recipe->node[node];
    int count = 0;
    if (n->operation == OP_GULLIES) { /* of the displacement, whatever the base is */
        return 0;
    }
    for (int i = 0; i < 2; i++) {
        if (n->in[i] >= 0) {
            by[count++] = n->in[i];
        }
    }
    return count;
}

/* Whether a lesser value is so much less that a smooth function of width k takes nothing of the
   greater one, or of the lesser one: as chain_smooth_min() says it. */
static bool is_apart(float lesser, float greater, float k)
{
    return 1.0f - (greater - lesser) * (1.0f / k) <= 0.0f;
}

static int side_of_step(const struct recipe_node *n, bounds a)
{
    const float lo = n->k[0], by = 1.0f / (n->k[1] - lo);
    const float lowest = (a.lowest - lo) * by, highest = (a.highest - lo) * by;
    if (by > 0.0f) {
        return highest < 0.0f ? GUARD_BELOW : lowest >= 1.0f ? GUARD_ABOVE : GUARD_OPEN;
    }
    return highest >= 1.0f ? GUARD_BELOW : lowest < 0.0f ? GUARD_ABOVE : GUARD_OPEN;
}

int scarpi_recipe_side_of(const struct recipe *recipe, int gate, bounds operand, bounds kept)
{
    const struct recipe_node *const n = &recipe->node[gate];
    const float(*const knot)[2] = &recipe->knot[n->knots > 0 ? n->index : 0];
    switch (n->operation) {
    case OP_MIN: return kept.highest < operand.lowest ? GUARD_ABOVE : GUARD_OPEN;
    case OP_MAX: return operand.highest < kept.lowest ? GUARD_BELOW : GUARD_OPEN;
    case OP_SMOOTH_MIN:
        return is_apart(kept.highest, operand.lowest, n->k[0]) ? GUARD_ABOVE : GUARD_OPEN;
    case OP_SMOOTH_MAX:
        return is_apart(operand.highest, kept.lowest, n->k[0]) ? GUARD_BELOW : GUARD_OPEN;
    case OP_CLAMP:
        return operand.highest < n->k[0]  ? GUARD_BELOW
               : operand.lowest > n->k[1] ? GUARD_ABOVE
                                          : GUARD_OPEN;
    case OP_SMOOTHSTEP: return side_of_step(n, operand);
    case OP_CURVE:
        return operand.highest <= knot[0][0]             ? GUARD_BELOW
               : operand.lowest >= knot[n->knots - 1][0] ? GUARD_ABOVE
                                                         : GUARD_OPEN;
    default: return GUARD_OPEN;
    }
}

/* The bounds of a node, of those that it reads. Steps and curves, whose rules make calls, have what
   their nodes have, or one value where they are level. */
static bounds bounds_of(const struct recipe *recipe, int node, const bounds *of,
                        const struct scarp_box *box)
{
    const struct recipe_node *const n = &recipe->node[node];
    const int side =
        n->in[0] < 0 ? GUARD_OPEN : scarpi_recipe_side_of(recipe, node, of[n->in[0]], of[n->in[0]]);
    float level = 0.0f;
    if (n->operation == OP_SMOOTHSTEP) {
        level = (side == GUARD_ABOVE) == (n->k[1] > n->k[0]) ? 1.0f : 0.0f;
    } else if (n->operation == OP_CURVE) {
        level = recipe->knot[n->index + (side == GUARD_ABOVE ? n->knots - 1 : 0)][1];
    } else {
        return scarpi_recipe_interval_of(recipe, n, of, box);
    }
    return side != GUARD_OPEN ? (bounds){level, level} : n->interval;
}

/* Whether all coordinates of a place are finite where points are in a box, and those of the places
   that it is made of. */
static bool is_place_near(const struct recipe *recipe, int place, const bounds *of,
                          const struct scarp_box *box)
{
    bool near = true;
    for (; near && place >= 0; place = recipe->place[place].frame) {
        for (int i = 0; i < recipe->place[place].dimensions; i++) {
            double lowest, highest;
            scarpi_recipe_coordinate(recipe, place, i, of, box, &lowest, &highest);
            near = near && lowest >= -PLACE && highest <= PLACE;
        }
    }
    return near;
}

NOINLINE void scarpi_recipe_find_safe(const struct recipe *recipe, struct node_set *safe)
{
    const struct scarp_box box = {{-NEAR, -NEAR, -NEAR}, {NEAR, NEAR, NEAR}};
    bounds of[RECIPE_NODES];
    for (int n = 0; n < recipe->nodes; n++) {
        int16_t reads[RECIPE_READS];
        int slopes;
        const int count = scarpi_recipe_reads(recipe, n, reads, &slopes);
        const struct recipe_node *const node = &recipe->node[n];
        of[n] = bounds_of(recipe, n, of, &box);
        bool is_safe = of[n].lowest > -VALUE && of[n].highest < VALUE;
        /* Slopes may be infinite, or NaN. */
        is_safe = is_safe && (scarpi_recipe_traits(node->operation) & NEEDS_SLOPES) == 0;
        for (int i = 0; i < count; i++) {
            is_safe = is_safe && has(safe, reads[i]);
        }
        if (is_safe && is_place_near(recipe, node->place, of, &box)) {
            put_node(safe, n);
        }
    }
}

/*
 * In a chunk
 */

#define ARE_NEAR(type)                                                                             \
    static bool are_near_##type(size_t count, const type *x)                                       \
    {                                                                                              \
        int far = 0;                                                                               \
        for (size_t i = 0; i < count; i++) {                                                       \
            far |= !(x[i] >= -(type)NEAR && x[i] <= (type)NEAR);                                   \
        }                                                                                          \
        return !far;                                                                               \
    }

ARE_NEAR(float)
ARE_NEAR(double)

/* Whether the points of a chunk are near: finite, and so small that no position overflows. */
static bool is_near(struct recipe_machine *m)
{
    const struct scarp_grid *const g = m->chunk->grid;
    bool near = true;
    for (int i = 0; near && i < m->recipe->dimensions; i++) {
        if (g != NULL) {
            const double last = (double)(g->first[i] + (int64_t)(g->count[i] - 1));
            const double end[2] = {g->origin[i] + (double)g->first[i] * g->step[i],
                                   g->origin[i] + last * g->step[i]};
            near = are_near_double(2, end);
        } else {
            near = m->has_doubles ? are_near_double(m->chunk->count, m->chunk->at[i])
                                  : are_near_float(m->chunk->count, m->chunk->at[i]);
        }
    }
    return near;
}

/* The bounds of values; all numbers, if one is no finite number. */
static bounds seen(size_t count, const float *value)
{
    float lowest[LANES], highest[LANES], nothing[LANES];
    bounds r = {value[0], value[0]};
    float none = 0.0f; /* or NaN */
    size_t i = 0;
    if (count >= LANES) {
        for (int k = 0; k < LANES; k++) {
            lowest[k] = highest[k] = value[k];
            nothing[k] = 0.0f;
        }
        for (; i + LANES <= count; i += LANES) {
            for (int k = 0; k < LANES; k++) {
                const float v = value[i + (size_t)k];
                lowest[k] = v < lowest[k] ? v : lowest[k];
                highest[k] = v > highest[k] ? v : highest[k];
                nothing[k] += v - v;
            }
        }
        for (int k = 0; k < LANES; k++) {
            r.lowest = lowest[k] < r.lowest ? lowest[k] : r.lowest;
            r.highest = highest[k] > r.highest ? highest[k] : r.highest;
            none += nothing[k];
        }
    }
    for (; i < count; i++) {
        r.lowest = value[i] < r.lowest ? value[i] : r.lowest;
        r.highest = value[i] > r.highest ? value[i] : r.highest;
        none += value[i] - value[i];
    }
    return none == 0.0f ? r : (bounds){-INFINITY, INFINITY};
}

/* Of three of them */
static bounds glanced(size_t count, const float *value)
{
    const float some[3] = {value[0], value[count / 2], value[count - 1]};
    return seen(3, some);
}

/* What the bounds of some nodes in a chunk follow from. */
struct view {
    struct node_set needed, pending; /* pending: not computed yet */
    int16_t known[RECIPE_NODES];
    int count;    /* of those that are known */
    int from, to; /* steps that are not computed yet */
};

static void add_to_view(struct view *v, int node)
{
    if (!has(&v->needed, node)) {
        put_node(&v->needed, node);
        if (!has(&v->pending, node)) {
            v->known[v->count++] = (int16_t)node;
        }
    }
}

/* Looks from the operands of a gate back to what is computed. */
static void look(const struct recipe_machine *m, const struct recipe_guard *g, struct view *v)
{
    int16_t by[2];
    int count = scarpi_recipe_bounded_by(m->recipe, g->gate, by);
    memset(&v->needed, 0, sizeof v->needed);
    memset(&v->pending, 0, sizeof v->pending);
    v->count = 0;
    v->from = v->to = g->first;
    while (m->schedule->step[v->to] != g->gate) {
        put_node(&v->pending, m->schedule->step[v->to++]);
    }
    for (int k = v->to;; k--) {
        for (int i = 0; i < count; i++) {
            add_to_view(v, by[i]);
        }
        if (k == v->from) {
            break;
        }
        const int node = m->schedule->step[k - 1];
        count = has(&v->needed, node) ? scarpi_recipe_bounded_by(m->recipe, node, by) : 0;
    }
}

/* The bounds of the needed nodes in a chunk. Those of noise are the same everywhere: what knows them
   better in a part of space belongs here. */
static void find_bounds(const struct recipe_machine *m, const struct view *v, bool all,
                        bounds of[RECIPE_NODES])
{
    const size_t count = m->chunk->count;
    for (int i = 0; i < v->count; i++) {
        const int node = v->known[i];
        const float *const value = scarpi_recipe_samples(m, node).value;
        of[node] = all ? seen(count, value) : glanced(count, value);
    }
    for (int k = v->from; k < v->to; k++) {
        const int node = m->schedule->step[k];
        int16_t by[2];
        if (has(&v->needed, node)) {
            of[node] = scarpi_recipe_bounded_by(m->recipe, node, by) > 0
                           ? bounds_of(m->recipe, node, of, NULL)
                           : m->recipe->node[node].interval;
        }
    }
}

static NOINLINE int decide(const struct recipe_machine *m, const struct recipe_guard *g)
{
    const struct recipe_node *const gate = &m->recipe->node[g->gate];
    const int operand = gate->in[g->operand];
    const int kept = scarpi_recipe_skips(gate->operation) == 2 ? gate->in[!g->operand] : operand;
    bounds of[RECIPE_NODES];
    struct view v;
    look(m, g, &v);
    int side = GUARD_ABOVE;
    for (int all = 0; all < 2 && side != GUARD_OPEN; all++) { /* three points mostly say no */
        find_bounds(m, &v, all != 0, of);
        side = scarpi_recipe_side_of(m->recipe, g->gate, of[operand], of[kept]);
    }
    return side;
}

int scarpi_recipe_decide(struct recipe_machine *m, int guard)
{
    const struct recipe_guard *const g = &m->schedule->guard[guard];
    const int operation = m->recipe->node[g->gate].operation;
    const bool keeps_slopes = operation == OP_MIN || operation == OP_MAX;
    if (m->chunk->count < FEW || (m->order_of[g->gate] > 0 && !keeps_slopes)) {
        return GUARD_OPEN;
    }
    for (int i = 1; i <= m->schedule->guards; i++) { /* one operand stays */
        if (i != guard && m->schedule->guard[i].gate == g->gate && m->state[i] > GUARD_OPEN) {
            return GUARD_OPEN;
        }
    }
    const int side = decide(m, g);
    if (side != GUARD_OPEN && m->state[0] == GUARD_UNKNOWN) { /* that of the points */
        m->state[0] = is_near(m) ? GUARD_LEFT_OUT : GUARD_OPEN;
    }
    return side == GUARD_OPEN || m->state[0] == GUARD_OPEN ? GUARD_OPEN : side;
}
