/* SPDX-License-Identifier: MIT
 *
 * Steps are nodes in an order in which each stands behind those that it reads: operands that need
 * more registers come first, masks before what they mask. In space, nodes that do not depend on z
 * come before all others, so that grids compute them once per column.
 *
 * Products and mixes are gates: where the mask is 0 (of mixes, or 1) with all derivatives, they are
 * defined to be 0, or one operand, whatever the other one is. So nodes that are needed for that
 * other one alone may be left out for a chunk of points, and nobody sees it. Such nodes form a
 * guard. Guards are nested or apart, since a guard has all that is reached through one operand
 * only.
 */
#include "schedule.h"

#include <string.h>

#include "graph.h"

/* Sets of nodes */
struct set {
    uint64_t word[RECIPE_NODES / 64];
};

static int has(const struct set *set, int n)
{
    return (int)(set->word[n / 64] >> n % 64 & 1);
}

static void put(struct set *set, int n)
{
    set->word[n / 64] |= UINT64_C(1) << n % 64;
}

struct scheduler {
    const struct recipe *recipe;
    struct recipe_schedule *to;
    struct set live, done, columns; /* columns: needed once per column */
    uint8_t need[RECIPE_NODES];     /* registers */
    uint8_t position[RECIPE_NODES]; /* of the step */
};

static void find_live(struct scheduler *s, const int16_t *roots, int count)
{
    for (int i = 0; i < count; i++) {
        put(&s->live, roots[i]);
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
            put(&s->live, reads[i]);
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
    return can_be_level(recipe, node->in[0]) ? 0 : can_be_level(recipe, node->in[1]) ? 1 : -1;
}

/* What a node reads: masks first, then what needs most registers. */
static int in_order(const struct scheduler *s, int n, int16_t reads[RECIPE_READS])
{
    int slopes;
    const int count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
    const int mask = mask_of(s->recipe, n);
    for (int i = 1; i < count; i++) {
        const int16_t moved = reads[i];
        const int weight = mask >= 0 && moved == s->recipe->node[n].in[mask] ? 256 : s->need[moved];
        int to = i;
        for (; to > 0; to--) {
            const int16_t other = reads[to - 1];
            const int is_mask = mask >= 0 && other == s->recipe->node[n].in[mask];
            if (is_mask || s->need[other] >= weight) {
                break;
            }
            reads[to] = other;
        }
        reads[to] = moved;
    }
    return count;
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
        int16_t reads[RECIPE_READS];
        const int n = stack[depth], count = in_order(s, n, reads);
        while (next[depth] < count && has(&s->done, reads[next[depth]])) {
            next[depth]++;
        }
        if (next[depth] < count) {
            stack[depth + 1] = (uint8_t)reads[next[depth]++];
            next[++depth] = 0;
            continue;
        }
        put(&s->done, n);
        s->position[n] = (uint8_t)s->to->steps;
        s->to->step[s->to->steps++] = (uint8_t)n;
        depth--;
    }
}

static void add_all(struct scheduler *s, const int16_t *roots, int count)
{
    const struct recipe *const r = s->recipe;
    for (int n = 0; r->dimensions == 3 && n < r->nodes; n++) {
        if (has(&s->live, n) && (r->node[n].axes & 4) == 0) {
            add_steps(s, n);
        }
    }
    s->to->columns = s->to->steps;
    for (int i = 0; i < count; i++) {
        add_steps(s, roots[i]);
    }
}

static int is_worth_it(const struct recipe_node *node)
{
    return node->operation == OP_NOISE || node->operation == OP_VECTOR ||
           node->operation == OP_CELL || node->operation == OP_GULLIES;
}

/* Adds what a node reads to a set, but for one operand. */
static void put_reads(const struct scheduler *s, struct set *set, int n, int but)
{
    int16_t reads[RECIPE_READS];
    int slopes;
    const int count = scarpi_recipe_reads(s->recipe, n, reads, &slopes);
    for (int i = 0; i < count; i++) {
        if (i != but) {
            put(set, reads[i]);
        }
    }
}

/* Guards what is needed for one operand of a gate alone, if noise is among it. */
static void add_guard(struct scheduler *s, const struct set *roots, struct recipe_guard guard)
{
    const int operand = s->recipe->node[guard.gate].in[guard.operand];
    struct set below = {{0}}, outside = *roots; /* outside: read by others, too */
    struct set inside = {{0}};
    int has_noise = 0;
    put(&below, operand);
    for (int n = s->recipe->nodes - 1; n >= 0; n--) {
        /* Steps in front of the mask, or of the mask of a guard around this one, cannot be left
           out: what is computed once per column may be. */
        if (!has(&s->live, n)) {
            continue;
        }
        if (has(&below, n) && !has(&outside, n) && s->position[n] > s->position[guard.mask] &&
            s->to->guard_of[n] == guard.parent) {
            put(&inside, n);
            put_reads(s, &below, n, -1);
            has_noise = has_noise || is_worth_it(&s->recipe->node[n]);
        } else {
            put_reads(s, &outside, n, n == guard.gate ? guard.operand : -1);
        }
    }
    if (!has_noise || s->to->guards == RECIPE_GUARDS) {
        return;
    }
    s->to->guard[++s->to->guards] = guard;
    for (int n = operand; n >= 0; n--) {
        if (has(&inside, n)) {
            s->to->guard_of[n] = s->to->guards;
        }
    }
}

/* From gates that are computed late to those within their guards */
static void add_guards(struct scheduler *s, const int16_t *roots, int count)
{
    struct set is_root = {{0}};
    for (int i = 0; i < count; i++) {
        put(&is_root, roots[i]);
    }
    for (int k = s->to->steps - 1; k >= 0; k--) {
        const int gate = s->to->step[k], mask = mask_of(s->recipe, gate);
        if (mask < 0) {
            continue;
        }
        for (int operand = 0; operand < 2; operand++) {
            const struct recipe_guard guard = {.gate = (int16_t)gate,
                                               .mask = s->recipe->node[gate].in[mask],
                                               .operand = (uint8_t)operand,
                                               .parent = s->to->guard_of[gate],
                                               .one = s->recipe->node[gate].operation == OP_MIX &&
                                                      operand == 0};
            if (operand != mask && guard.mask != s->recipe->node[gate].in[operand]) {
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

static void take_register(struct scheduler *s, struct registers *r, int node)
{
    int k = 0;
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
        for (int i = 0; i < read; i++) { /* what is computed once per column stays */
            const int stays = s->position[reads[i]] < s->to->columns && k >= s->to->columns;
            r.last[reads[i]] = (int16_t)(stays || r.last[reads[i]] == steps ? steps : k);
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
    s->to->registers = (int16_t)r.count;
}

/* Finds the roots that may be computed where the caller wants them. */
static void find_alone(struct scheduler *s, const int16_t *roots, int count)
{
    struct set read = {{0}};
    for (int k = 0; k < s->to->steps; k++) {
        put_reads(s, &read, s->to->step[k], -1);
    }
    for (int i = 0; i < count; i++) {
        int is_alone = !has(&read, roots[i]);
        for (int j = 0; j < count; j++) {
            is_alone = is_alone && (i == j || roots[i] != roots[j]);
        }
        s->to->alone = (uint16_t)(s->to->alone | is_alone << i);
    }
}

void scarpi_recipe_schedule(const struct recipe *recipe, const int16_t *roots, int count,
                            struct recipe_schedule *schedule)
{
    struct scheduler s = {.recipe = recipe, .to = schedule};
    memset(schedule, 0, sizeof *schedule);
    find_live(&s, roots, count);
    find_needs(&s);
    add_all(&s, roots, count);
    add_guards(&s, roots, count);
    set_registers(&s, roots, count);
    find_alone(&s, roots, count);
}
