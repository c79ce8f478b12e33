/* SPDX-License-Identifier: MIT
 *
 * Steps are nodes in an order in which each stands behind those that it reads: operands that need
 * more registers come first, masks before what they mask. Nodes that depend on fewer axes come
 * before all others, by axes, so that grids compute them once along each of the other ones. What
 * others read of them stays in registers of its own: as it is, and as a copy for each set of axes.
 */
#include "schedule.h"

#include <string.h>

#include "graph.h"
#include "guards.h"

static void find_live(struct scheduler *s, const int16_t *roots, int count)
{
    for (int i = 0; i < count; i++) {
        put_node(&s->live, roots[i]);
    }
    for (int n = s->recipe->nodes - 1; n >= 0; n--) {
        int16_t reads[RECIPE_READS];
        int slopes = 0;
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

/* What comes first among the reads of a node: masks, what may leave another operand out, then what
   needs most registers. */
static int weight_of(const struct scheduler *s, int n, int read)
{
    const int mask = scarpi_recipe_mask_of(s->recipe, n);
    const int is_mask = mask >= 0 && read == s->recipe->node[n].in[mask];
    const int ease = is_mask ? 256 : scarpi_recipe_is_bounded_gate(s, n) ? 255 - s->cost[read] : 0;
    return ease * 256 + s->need[read];
}

/* What is computed in front of a node, in this order. */
enum { BEFORE = FREE_NODES + RECIPE_READS };
static int in_order(const struct scheduler *s, int n, int16_t before[BEFORE])
{
    int slopes, first = 0;
    if (scarpi_recipe_is_bounded_gate(s, n)) {
        first = scarpi_recipe_find_free(s, n, before);
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
    /* Behind all others: calls that do not run by parts leave them out (evaluate.c). */
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
        scarpi_recipe_put_reads(s->recipe, &by, s->to->step[k], -1);
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
        scarpi_recipe_find_costs(&s);
        scarpi_recipe_find_safe_nodes(&s);
        add_all(&s, roots, count);
        scarpi_recipe_add_guards(&s, roots, count);
        add_copies(&s, roots, count);
        set_registers(&s, roots, count);
        find_homes(&s, roots, count);
    }
}
