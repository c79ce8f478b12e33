/* SPDX-License-Identifier: MIT
 *
 * Steps are nodes in an order in which each stands behind those that it reads: operands that need
 * more registers come first, masks before what they mask. Nodes that depend on fewer axes come
 * before all others, by axes, so that grids compute them once along each of the other ones. What
 * others read of them stays in registers of its own: as it is, and as a copy for each set of axes.
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
#include "schedule.h"

#include <string.h>

#include "graph.h"
#include "skips.h"

struct scheduler {
    const struct recipe *recipe;
    struct recipe_schedule *to;
    struct node_set live, done;
    struct node_set kept;           /* read by steps of other axes, or a root of fewer axes */
    struct node_set safe;           /* see skips.h */
    int is_full;                    /* there was no room for copies */
    uint8_t need[RECIPE_NODES];     /* registers */
    uint8_t position[RECIPE_NODES]; /* of the step */
    uint8_t cost[RECIPE_NODES];     /* octaves, of all that is needed */
};

static void find_live(struct scheduler *s, const int16_t *roots, int count)
{
    for (int i = 0; i < count; i++) {
        put_node(&s->live, roots[i]);
    }
    for (int n = s->recipe->nodes - 1; n >= 0; n--) {
        int16_t reads[RECIPE_READS];
        int slopes;
        slopes = 0;
        const int read = has(&s->live, n) ? scarpi_recipe_reads(s->recipe, n, reads, &slopes) : 0;
        const int traits = scarpi_recipe_traits(s->recipe->node[n].operation);
        for (int i = 0; i < read; i++) {
            const int is_base = (traits & NEEDS_SLOPES) != 0 && i == 0;
            const int extra = i < slopes ? s->to->extra_of[n] + is_base : 0;
            put_node(&s->live, reads[i]);
            if (s->to->extra_of[reads[i]] < extra) {
                s->to->extra_of[reads[i]] = (uint8_t)extra;
            }
        }
        if (s->to->extra < s->to->extra_of[n]) {
            s->to->extra = s->to->extra_of[n];
        }
    }
}

static void find_needs(struct scheduler *s)
{
    for (int n = 0; n < s->recipe->nodes; n++) {
        int16_t reads[RECIPE_READS];
        int slopes;
        const int count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
        int most = 1, equal = 0;
        for (int i = 0; i < count; i++) {
            const int need = s->need[reads[i]];
            equal = need > most ? 1 : equal + (need == most);
            most = need > most ? need : most;
        }
        s->need[n] = (uint8_t)(most + (equal > 1) < 255 ? most + (equal > 1) : 255);
    }
}

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

static void find_costs(struct scheduler *s)
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
enum { FREE_NODES = 8 };
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

static int is_bounded_gate(const struct scheduler *s, int n)
{
    return s->cost[n] > 0 && scarpi_recipe_skips(s->recipe->node[n].operation) > 0;
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
static int mask_of(const struct recipe *recipe, int n)
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

/* What comes first among the reads of a node: masks, what may leave another operand out, then what
   needs most registers. */
static int weight_of(const struct scheduler *s, int n, int read)
{
    const int mask = mask_of(s->recipe, n);
    const int is_mask = mask >= 0 && read == s->recipe->node[n].in[mask];
    const int ease = is_mask ? 256 : is_bounded_gate(s, n) ? 255 - s->cost[read] : 0;
    return ease * 256 + s->need[read];
}

/* What is computed in front of a node, in this order. */
enum { BEFORE = FREE_NODES + RECIPE_READS };
static int in_order(const struct scheduler *s, int n, int16_t before[BEFORE])
{
    int slopes, first = 0;
    if (is_bounded_gate(s, n)) {
        struct node_set below = {{0}};
        put_bounding(s, &below, n);
        first = find_free(s, n, &below, before);
    }
    int16_t *const reads = before + first;
    const int count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
    for (int i = 1; i < count; i++) {
        const int16_t moved = reads[i];
        int to = i;
        for (; to > 0 && weight_of(s, n, reads[to - 1]) < weight_of(s, n, moved); to--) {
            reads[to] = reads[to - 1];
        }
        reads[to] = moved;
    }
    return first + count;
}

/* Adds what is needed for a node, and itself, as steps. It goes down without recursion: recipes are
   up to 256 nodes deep. */
static void add_steps(struct scheduler *s, int root)
{
    uint8_t stack[RECIPE_NODES], next[RECIPE_NODES];
    int depth = 0;
    if (has(&s->done, root)) {
        return;
    }
    stack[0] = (uint8_t)root;
    next[0] = 0;
    while (depth >= 0) {
        int16_t before[BEFORE];
        const int n = stack[depth], count = in_order(s, n, before);
        while (next[depth] < count && has(&s->done, before[next[depth]])) {
            next[depth]++;
        }
        if (next[depth] < count) {
            stack[depth + 1] = (uint8_t)before[next[depth]++];
            next[++depth] = 0;
            continue;
        }
        put_node(&s->done, n);
        s->position[n] = (uint8_t)s->to->steps;
        s->to->step[s->to->steps++] = (uint8_t)n;
        depth--;
    }
}

static void add_all(struct scheduler *s, const int16_t *roots, int count)
{
    const int all = s->to->all_axes;
    for (int axes = 0; axes < all; axes++) { /* those of an operand are never the greater number */
        s->to->first_of[axes] = s->to->steps;
        for (int n = s->recipe->nodes - 1; n >= 0; n--) {
            if (has(&s->live, n) && s->to->axes_of[n] == axes) {
                add_steps(s, n);
            }
        }
    }
    s->to->first_of[all] = s->to->steps;
    for (int i = 0; i < count; i++) {
        add_steps(s, roots[i]);
    }
    s->to->first_of[all + 1] = s->to->steps;
}

/* Adds what a node reads to a set, but for one operand. */
static void put_reads(const struct scheduler *s, struct node_set *set, int n, int but)
{
    int16_t reads[RECIPE_READS];
    int slopes;
    const int count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
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
            put_reads(s, &below, n, -1);
            has_noise = has_noise || is_worth_it(&s->recipe->node[n]);
            first = s->position[n] < first ? s->position[n] : first;
        } else {
            put_reads(s, &outside, n, n == guard->gate ? guard->operand : -1);
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
static void add_guards(struct scheduler *s, const int16_t *roots, int count)
{
    struct node_set is_root = {{0}};
    for (int i = 0; i < count; i++) {
        put_node(&is_root, roots[i]);
    }
    for (int k = s->to->steps - 1; k >= 0; k--) {
        const int gate = s->to->step[k], mask = mask_of(s->recipe, gate);
        const struct recipe_node *const node = &s->recipe->node[gate];
        const int operands = mask >= 0                  ? 2
                             : is_bounded_gate(s, gate) ? scarpi_recipe_skips(node->operation)
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

/* Functions that may write where they read, as the chain rule of scarp.h may */
static int is_in_place(int operation)
{
    return operation >= OP_ADD && (scarpi_recipe_traits(operation) & NEEDS_SLOPES) == 0;
}

struct registers {
    int16_t last[RECIPE_NODES]; /* the last step that reads a node */
    uint8_t busy[RECIPE_NODES];
    int count;
};

/* What is kept gets a register that no step had before: steps in front of it run again. */
static void take_register(struct scheduler *s, struct registers *r, int node)
{
    int k = has(&s->kept, node) ? r->count : 0;
    while (r->busy[k]) {
        k++;
    }
    r->busy[k] = 1;
    s->to->register_of[node] = (uint8_t)k;
    r->count = k + 1 > r->count ? k + 1 : r->count;
}

/* Frees the registers of nodes that a step reads for the last time. */
static void free_reads(const struct scheduler *s, struct registers *r, int step)
{
    int16_t reads[RECIPE_READS];
    int slopes;
    const int n = s->to->step[step], count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
    for (int i = 0; i < count; i++) {
        if (r->last[reads[i]] == step) {
            r->busy[s->to->register_of[reads[i]]] = 0;
        }
    }
}

static void set_registers(struct scheduler *s, const int16_t *roots, int count)
{
    struct registers r = {.count = 0};
    const int steps = s->to->steps;
    for (int k = 0; k < steps; k++) {
        int16_t reads[RECIPE_READS];
        int slopes;
        const int n = s->to->step[k], read = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
        r.last[n] = (int16_t)k;
        for (int i = 0; i < read; i++) {
            r.last[reads[i]] = (int16_t)(has(&s->kept, reads[i]) ? steps : k);
        }
    }
    for (int i = 0; i < count; i++) {
        r.last[roots[i]] = (int16_t)steps;
    }
    for (int k = 0; k < steps; k++) {
        const int n = s->to->step[k], operation = s->recipe->node[n].operation;
        if (is_in_place(operation)) {
            free_reads(s, &r, k);
        }
        if (operation != OP_COMPONENT) { /* the step of the vector has taken theirs */
            take_register(s, &r, n);
        }
        for (int i = n + 1; operation == OP_VECTOR && i < s->recipe->nodes; i++) {
            if (has(&s->live, i) && s->recipe->node[i].operation == OP_COMPONENT &&
                s->recipe->node[i].in[0] == n) {
                take_register(s, &r, i);
            }
        }
        if (!is_in_place(operation)) {
            free_reads(s, &r, k);
        }
        if (r.last[n] == k) { /* nobody reads it: components of a vector */
            r.busy[s->to->register_of[n]] = 0;
        }
    }
    for (int i = 0; i < s->to->copies && r.count < RECIPE_NODES; i++) {
        s->to->copy[i].in_register = (uint8_t)r.count++;
    }
    s->is_full |= s->to->copies > 0 && r.count == RECIPE_NODES;
    s->to->registers = (int16_t)r.count;
}

/* A step of these axes reads a node. */
static void add_copy(struct scheduler *s, int node, int axes)
{
    struct recipe_schedule *const to = s->to;
    int i = 0;
    if (to->axes_of[node] == axes) {
        return;
    }
    put_node(&s->kept, node);
    while (i < to->copies && (to->copy[i].node != node || to->copy[i].axes != axes)) {
        i++;
    }
    s->is_full |= i == RECIPE_COPIES;
    if (i == to->copies && i < RECIPE_COPIES) {
        to->copy[to->copies++] = (struct recipe_copy){.node = (uint8_t)node, .axes = (uint8_t)axes};
    }
}

static void add_copies(struct scheduler *s, const int16_t *roots, int count)
{
    for (int k = 0; k < s->to->steps; k++) {
        int16_t reads[RECIPE_READS];
        int slopes;
        const int n = s->to->step[k], read = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
        for (int i = 0; i < read; i++) {
            add_copy(s, reads[i], s->to->axes_of[n]);
        }
        for (int g = s->to->guard_of[n]; g > 0; g = s->to->guard[g].parent) {
            if (s->to->guard[g].mask >= 0) {
                add_copy(s, s->to->guard[g].mask, s->to->axes_of[n]);
            }
        }
    }
    for (int i = 0; i < count; i++) {
        if (s->to->axes_of[roots[i]] != s->to->all_axes) {
            put_node(&s->kept, roots[i]);
        }
    }
}

/* The operand that a function may overwrite on the way to a root, or -1: only the function reads
   it, it has the same derivatives and depends on all axes. */
static int overwritten(const struct scheduler *s, int n, const struct node_set *read_twice)
{
    const struct recipe_node *const node = &s->recipe->node[n];
    for (int i = 0; i < 3 && is_in_place(node->operation); i++) {
        const int in = node->in[i];
        if (in >= 0 && !has(read_twice, in) && s->to->axes_of[in] == s->to->all_axes &&
            s->recipe->node[in].dimensions == node->dimensions &&
            s->recipe->node[in].operation != OP_COMPONENT) {
            return in;
        }
    }
    return -1;
}

static void find_homes(struct scheduler *s, const int16_t *roots, int count)
{
    struct node_set read = {{0}}, read_twice = {{0}}; /* by two nodes, or a root that is read */
    for (int i = 0; i < count; i++) {
        put_node(has(&read, roots[i]) ? &read_twice : &read, roots[i]);
    }
    for (int k = 0; k < s->to->steps; k++) {
        struct node_set by = {{0}};
        put_reads(s, &by, s->to->step[k], -1);
        for (int i = 0; i < RECIPE_NODES / 64; i++) {
            read_twice.word[i] |= read.word[i] & by.word[i];
            read.word[i] |= by.word[i];
        }
    }
    for (int i = 0; i < count; i++) {
        if (!has(&read_twice, roots[i]) && s->to->axes_of[roots[i]] == s->to->all_axes) {
            for (int n = roots[i]; n >= 0; n = overwritten(s, n, &read_twice)) {
                s->to->home_of[n] = (uint8_t)(i + 1);
            }
        }
    }
}

static void find_axes(struct scheduler *s, int has_parts)
{
    const int all = s->recipe->dimensions == 3 ? RECIPE_ALL_AXES : RECIPE_ALL_AXES / 2;
    s->to->all_axes = (uint8_t)all;
    for (int n = 0; n < s->recipe->nodes; n++) {
        s->to->axes_of[n] = (uint8_t)(has_parts ? s->recipe->node[n].axes : all);
    }
}

/* Nodes that bounds may leave out, if there is a gate that asks for it. */
static void find_safe(struct scheduler *s)
{
    int found = 0;
    for (int n = 0; n < s->recipe->nodes && !found; n++) {
        found = has(&s->live, n) && is_bounded_gate(s, n);
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

void scarpi_recipe_schedule(const struct recipe *recipe, const int16_t *roots, int count,
                            int has_parts, struct recipe_schedule *schedule)
{
    struct scheduler s = {.is_full = 1};
    for (; s.is_full; has_parts = 0) {
        s = (struct scheduler){.recipe = recipe, .to = schedule};
        memset(schedule, 0, sizeof *schedule);
        find_axes(&s, has_parts);
        find_live(&s, roots, count);
        find_needs(&s);
        find_costs(&s);
        find_safe(&s);
        add_all(&s, roots, count);
        add_guards(&s, roots, count);
        add_copies(&s, roots, count);
        set_registers(&s, roots, count);
        find_homes(&s, roots, count);
    }
}
