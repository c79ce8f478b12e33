/* SPDX-License-Identifier: MIT
 *
 * Products and mixes are gates: where the mask is 0 (of mixes, or 1) with all derivatives, they are
 * defined to be 0, or one operand, whatever the other one is. So nodes that are needed for that
 * other one alone may be left out for a chunk of points, and nobody sees it. Such nodes form a
 * guard. Guards are nested or apart, since a guard has all that is reached through one operand
 * only.
 *
 * Functions of skips.h are gates, too: there bounds of the operands leave one out. Such a guard has
 * no nodes that cost nothing, as coordinates: these come first, and say what the bounds are.
 */
#include "guards.h"

#include "graph.h"
#include "schedule.h"

static int is_worth_it(const struct recipe_node *node)
{
    return node->operation == OP_NOISE || node->operation == OP_VECTOR ||
           node->operation == OP_CELL || node->operation == OP_GULLIES;
}

static int octaves_of(const struct recipe *recipe, const struct recipe_node *node)
{
    struct scarp_noise levels[5];
    int octaves = 0;
    if (node->operation == OP_GULLIES) {
        return 8; /* or so */
    }
    scarpi_recipe_spell_noise(recipe, node->index, levels);
    for (const struct scarp_noise *level = levels; level != NULL; level = level->warp) {
        octaves += level->octaves > 1.0f ? (int)level->octaves : 1;
    }
    return octaves;
}

void scarpi_recipe_find_costs(struct scheduler *s)
{
    for (int n = 0; n < s->recipe->nodes; n++) {
        const struct recipe_node *const node = &s->recipe->node[n];
        int16_t reads[RECIPE_READS];
        int slopes, cost = is_worth_it(node) ? octaves_of(s->recipe, node) : 0;
        const int count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
        for (int i = 0; i < count; i++) {
            cost += s->cost[reads[i]];
        }
        s->cost[n] = (uint8_t)(cost < 255 ? cost : 255);
    }
}

/* Whether a node costs next to nothing where a gate is computed. */
static int is_free(const struct scheduler *s, int gate, int n)
{
    return s->cost[n] == 0 || s->to->axes_of[n] != s->to->axes_of[gate];
}

static void put_bounding(const struct scheduler *s, struct node_set *set, int n)
{
    int16_t by[2];
    const int count = scarpi_recipe_bounded_by(s->recipe, n, by);
    for (int i = 0; i < count; i++) {
        put_node(set, by[i]);
    }
}

/* The free nodes from which the bounds of nodes in a set follow, as a gate sees them; numbers are
   none of them. */
static int find_free(const struct scheduler *s, int gate, struct node_set *below,
                     int16_t free[FREE_NODES])
{
    int count = 0;
    for (int n = gate - 1; n >= 0 && count < FREE_NODES; n--) {
        if (!has(below, n)) {
            continue;
        }
        if (!is_free(s, gate, n)) {
            put_bounding(s, below, n);
        } else if (s->recipe->node[n].operation != OP_CONSTANT) {
            free[count++] = (int16_t)n;
        }
    }
    return count;
}

int scarpi_recipe_is_bounded_gate(const struct scheduler *s, int n)
{
    return s->cost[n] > 0 && scarpi_recipe_skips(s->recipe->node[n].operation) > 0;
}

int scarpi_recipe_find_free(const struct scheduler *s, int gate, int16_t free[FREE_NODES])
{
    struct node_set below = {{0}};
    put_bounding(s, &below, gate);
    return find_free(s, gate, &below, free);
}

/* A mask can be 0, or 1, with all derivatives, at all points of a chunk. */
static int can_be_level(const struct recipe *recipe, int n)
{
    for (;;) { /* a product is level where its second factor is, say */
        const struct recipe_node *const node = &recipe->node[n];
        if (node->operation != OP_AFFINE && node->operation != OP_MULTIPLY) {
            return (scarpi_recipe_traits(node->operation) & CAN_BE_LEVEL) != 0;
        }
        n = node->in[0];
    }
}

/* Likewise where it is one of several, one of which can be level. */
static int can_take_level(const struct recipe *recipe, int n)
{
    const struct recipe_node *node = &recipe->node[n];
    while (node->operation == OP_AFFINE) {
        node = &recipe->node[node->in[0]];
    }
    return scarpi_recipe_skips(node->operation) == 2 &&
           (can_be_level(recipe, node->in[0]) || can_be_level(recipe, node->in[1]));
}

/* The operand that is a mask, or -1. */
int scarpi_recipe_mask_of(const struct recipe *recipe, int n)
{
    const struct recipe_node *const node = &recipe->node[n];
    if (node->operation == OP_MIX) {
        return 2;
    }
    if (node->operation != OP_MULTIPLY || node->in[0] == node->in[1]) {
        return -1;
    }
    return can_be_level(recipe, node->in[0])     ? 0
           : can_be_level(recipe, node->in[1])   ? 1
           : can_take_level(recipe, node->in[0]) ? 0
           : can_take_level(recipe, node->in[1]) ? 1
                                                 : -1;
}

/* Adds what a node reads to a set, but for one operand. */
void scarpi_recipe_put_reads(const struct recipe *recipe, struct node_set *set, int n, int but)
{
    int16_t reads[RECIPE_READS];
    int slopes;
    const int count = scarpi_recipe_reads(recipe, n, reads, &slopes);
    for (int i = 0; i < count; i++) {
        if (i != but) {
            put_node(set, reads[i]);
        }
    }
}

/* Whether a node that is needed for the operand of a guard alone is in it. Steps in front of the
   mask, or of the mask of a guard around this one, cannot be left out, nor those that do not depend
   on all axes of the mask. */
static int may_be_left_out(const struct scheduler *s, const struct recipe_guard *guard, int n)
{
    if (s->to->guard_of[n] != guard->parent) {
        return 0;
    }
    if (guard->kind == GUARD_BY_BOUNDS) {
        return !is_free(s, guard->gate, n);
    }
    return s->position[n] > s->position[guard->mask] &&
           (s->to->axes_of[guard->mask] & ~s->to->axes_of[n]) == 0;
}

/* The nodes that may be left out, if noise is among them. Returns the first step; -1: none. */
static int find_inside(const struct scheduler *s, const struct node_set *roots,
                       const struct recipe_guard *guard, struct node_set *inside)
{
    struct node_set below = {{0}}, outside = *roots; /* outside: read by others, too */
    int has_noise = 0, first = s->to->steps;
    put_node(&below, s->recipe->node[guard->gate].in[guard->operand]);
    for (int n = s->recipe->nodes - 1; n >= 0; n--) {
        if (!has(&s->live, n)) {
            continue;
        }
        if (has(&below, n) && !has(&outside, n) && may_be_left_out(s, guard, n)) {
            put_node(inside, n);
            scarpi_recipe_put_reads(s->recipe, &below, n, -1);
            has_noise = has_noise || is_worth_it(&s->recipe->node[n]);
            first = s->position[n] < first ? s->position[n] : first;
        } else {
            scarpi_recipe_put_reads(s->recipe, &outside, n, n == guard->gate ? guard->operand : -1);
        }
    }
    return has_noise ? first : -1;
}

/* The best bounds that a node may have in a chunk: one of its ends, if it is computed, or made of
   what is, in front of a step. */
static struct recipe_interval best_bounds(const struct scheduler *s, int gate, int n, int step,
                                          int high)
{
    struct node_set below = {{0}};
    int16_t free[FREE_NODES];
    struct recipe_interval in = s->recipe->node[n].interval;
    put_node(&below, n);
    if (s->position[n] < step || find_free(s, gate, &below, free) > 0) {
        in.lowest = in.highest = high ? in.highest : in.lowest;
    }
    return in;
}

/* Whether bounds may leave the operand of a guard out. */
static int can_skip(const struct scheduler *s, const struct recipe_guard *guard)
{
    const struct recipe_node *const gate = &s->recipe->node[guard->gate];
    const int operand = gate->in[guard->operand], kept = gate->in[!guard->operand];
    int skips = 0;
    for (int ends = 0; ends < 4 && has(&s->safe, operand); ends++) {
        const struct recipe_interval a =
            best_bounds(s, guard->gate, operand, guard->first, ends & 1);
        const struct recipe_interval b =
            kept < 0 ? a : best_bounds(s, guard->gate, kept, guard->first, ends >> 1);
        skips |= scarpi_recipe_side_of(s->recipe, guard->gate, a, b) != GUARD_OPEN;
    }
    return skips;
}

/* Guards what is needed for one operand of a gate alone. */
static void add_guard(struct scheduler *s, const struct node_set *roots, struct recipe_guard guard)
{
    struct node_set inside = {{0}};
    const int first = find_inside(s, roots, &guard, &inside);
    guard.first = (uint8_t)first;
    if (first < 0 || s->to->guards == RECIPE_GUARDS ||
        (guard.kind == GUARD_BY_BOUNDS && !can_skip(s, &guard))) {
        return;
    }
    s->to->guard[++s->to->guards] = guard;
    for (int n = 0; n < s->recipe->nodes; n++) {
        if (has(&inside, n)) {
            s->to->guard_of[n] = s->to->guards;
        }
    }
}

/* From gates that are computed late to those within their guards */
void scarpi_recipe_add_guards(struct scheduler *s, const int16_t *roots, int count)
{
    struct node_set is_root = {{0}};
    for (int i = 0; i < count; i++) {
        put_node(&is_root, roots[i]);
    }
    for (int k = s->to->steps - 1; k >= 0; k--) {
        const int gate = s->to->step[k], mask = scarpi_recipe_mask_of(s->recipe, gate);
        const struct recipe_node *const node = &s->recipe->node[gate];
        const int operands = mask >= 0 ? 2
                             : scarpi_recipe_is_bounded_gate(s, gate)
                                 ? scarpi_recipe_skips(node->operation)
                                 : 0;
        for (int operand = 0; operand < operands; operand++) {
            const int has_one = node->operation == OP_MIX && operand == 0;
            const struct recipe_guard guard = {.gate = (int16_t)gate,
                                               .mask = (int16_t)(mask >= 0 ? node->in[mask] : -1),
                                               .operand = (uint8_t)operand,
                                               .parent = s->to->guard_of[gate],
                                               .kind = mask < 0  ? GUARD_BY_BOUNDS
                                                       : has_one ? GUARD_BY_1
                                                                 : GUARD_BY_0};
            if (operand != mask && guard.mask != node->in[operand]) {
                add_guard(s, &is_root, guard);
            }
        }
    }
}

/* Nodes that bounds may leave out, if there is a gate that asks for it. */
void scarpi_recipe_find_safe_nodes(struct scheduler *s)
{
    int found = 0;
    for (int n = 0; n < s->recipe->nodes && !found; n++) {
        found = has(&s->live, n) && scarpi_recipe_is_bounded_gate(s, n);
    }
    if (found) {
        scarpi_recipe_find_safe(s->recipe, &s->safe);
    }
}

int scarpi_recipe_mask_guard(const struct recipe_schedule *schedule, int guard)
{
    while (guard != 0 && schedule->guard[guard].kind == GUARD_BY_BOUNDS) {
        guard = schedule->guard[guard].parent;
    }
    return guard;
}
