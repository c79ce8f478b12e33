/* SPDX-License-Identifier: MIT
 *
 * The public functions that tell editors what a recipe is made of.
 */
#include <string.h>

#include "../calls/run.h"
#include "../dispatch/fpmode.h"
#include "graph.h"
#include "summary.h"
#include "text.h"
#include "words.h"

static uint64_t mixed(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *const byte = bytes;
    for (size_t i = 0; i < size; i++) { /* FNV-1a */
        hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

static uint64_t hash_of_noise(const struct recipe *r, int noise, uint64_t hash)
{
    for (; noise >= 0; noise = r->noise[noise].warp) {
        hash = mixed(hash, r->noise[noise].noise, sizeof r->noise[noise].noise);
    }
    return hash;
}

/* The hash of all that a node is computed from, but for the numbers of nodes, places and noises,
   which depend on what else is in the text. `of` has the hashes of the nodes before. */
static uint64_t hash_of_node(const struct recipe *r, int node, const uint64_t *of)
{
    const struct recipe_node *const n = &r->node[node];
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    int16_t reads[RECIPE_READS];
    int slopes;
    const int count = scarpi_recipe_reads(r, node, reads, &slopes);
    hash = mixed(hash, &n->operation, sizeof n->operation);
    hash = mixed(hash, &n->detail, sizeof n->detail);
    hash = mixed(hash, n->k, sizeof n->k);
    for (int i = 0; i < count; i++) {
        hash = mixed(hash, &of[reads[i]], sizeof of[reads[i]]);
    }
    for (int p = n->place; p >= 0; p = r->place[p].frame) {
        hash = mixed(hash, r->place[p].m, sizeof r->place[p].m);
        hash = mixed(hash, r->place[p].t, sizeof r->place[p].t);
        hash = mixed(hash, &r->place[p].dimensions, sizeof r->place[p].dimensions);
    }
    if (n->operation == OP_NOISE || n->operation == OP_VECTOR || n->operation == OP_CELL) {
        hash = hash_of_noise(r, n->index, hash);
    } else if (n->operation == OP_GULLIES) {
        hash = mixed(hash, &r->gully[n->index], sizeof r->gully[n->index]);
    } else if (n->operation == OP_CURVE) {
        hash = mixed(hash, r->knot[n->index], n->knots * sizeof r->knot[0]);
    }
    return hash;
}

static NOINLINE uint64_t hash_of(const struct recipe *r, int node)
{
    uint64_t of[RECIPE_NODES];
    for (int i = 0; i <= node; i++) {
        of[i] = hash_of_node(r, i, of);
    }
    return of[node];
}

/* A number, as it is sampled: scaled, if it is the first output */
static double number_of(const struct recipe *r, const struct recipe_expression *x)
{
    const int first = r->outputs > 0 ? r->statement[r->output[0]].expression : -1;
    const int is_scaled = x->type == EXPRESSION_NUMBER && x - r->expression == first;
    return is_scaled ? r->scale[1] * x->number : x->number;
}

static uint64_t hash_of_value(const struct recipe *r, const struct recipe_expression *x)
{
    if (x->kind == SCARP_RECIPE_NUMBER) {
        const double number = number_of(r, x);
        return mixed(1, &number, sizeof number);
    }
    return x->node >= 0 ? hash_of(r, x->node) : 0;
}

static void set_span(uint32_t to[2], struct recipe_span span)
{
    to[0] = span.from;
    to[1] = span.to;
}

static const struct recipe *described(const struct scarp_recipe *recipe)
{
    return scarpi_is_recipe(recipe) ? scarpi_recipe_of(recipe) : NULL;
}

static int is_field(const struct recipe_expression *x)
{
    return (x->kind == SCARP_RECIPE_FIELD || x->kind == SCARP_RECIPE_NOISE) && x->node >= 0;
}

/* What a field is made of */
static void set_summary(const struct recipe *r, int node, struct scarp_recipe_entry *entry)
{
    struct recipe_summary summary;
    const struct fpmode caller = fpmode_enter();
    scarpi_recipe_summary(r, node, &summary);
    fpmode_leave(caller);
    entry->cell[0] = summary.cell[0];
    entry->cell[1] = summary.cell[1];
    entry->jumps = (uint32_t)summary.jumps;
}

enum scarp_status scarp_recipe_entry_at(const struct scarp_recipe *recipe, size_t index,
                                        struct scarp_recipe_entry *entry)
{
    if (recipe == NULL || entry == NULL) {
        return SCARP_ERROR_NULL;
    }
    const struct recipe *const r = described(recipe);
    if (r == NULL || index >= (size_t)r->statements) {
        return SCARP_ERROR_PARAMETER;
    }
    const struct recipe_statement *const s = &r->statement[index];
    memset(entry, 0, sizeof *entry);
    set_span(entry->span, s->span);
    set_span(entry->name, s->name);
    entry->part = s->expression;
    entry->output = -1;
    entry->dimensions = r->dimensions;
    for (int i = 0; i < r->outputs; i++) {
        entry->output = r->output[i] == (int16_t)index ? i : entry->output;
    }
    entry->is_param = s->type == STATEMENT_PARAM;
    if (entry->is_param) {
        entry->kind = SCARP_RECIPE_NUMBER;
        entry->value = s->value;
        entry->slider[0] = s->lowest;
        entry->slider[1] = s->highest;
        entry->hash = mixed(1, &s->value, sizeof s->value);
        return SCARP_OK;
    }
    struct scarp_recipe_part part;
    if (s->expression >= 0 &&
        scarp_recipe_part_at(recipe, (size_t)s->expression, &part) == SCARP_OK) {
        entry->kind = part.kind;
        entry->value = part.value;
        memcpy(entry->range, part.range, sizeof entry->range);
        entry->axes = part.axes;
        entry->order = part.order;
        entry->hash = part.hash;
        if (is_field(&r->expression[s->expression])) {
            set_summary(r, r->expression[s->expression].node, entry);
        }
    }
    return SCARP_OK;
}

enum scarp_status scarp_recipe_part_at(const struct scarp_recipe *recipe, size_t index,
                                       struct scarp_recipe_part *part)
{
    static const char operations[] = {
        [EXPRESSION_ADD] = '+',    [EXPRESSION_SUBTRACT] = '-', [EXPRESSION_MULTIPLY] = '*',
        [EXPRESSION_DIVIDE] = '/', [EXPRESSION_NEGATIVE] = '-', [EXPRESSION_POWER] = '^'};
    if (recipe == NULL || part == NULL) {
        return SCARP_ERROR_NULL;
    }
    const struct recipe *const r = described(recipe);
    if (r == NULL || index >= (size_t)r->expressions) {
        return SCARP_ERROR_PARAMETER;
    }
    const struct recipe_expression *const x = &r->expression[index];
    memset(part, 0, sizeof *part);
    set_span(part->span, x->span);
    set_span(part->name, x->name);
    set_span(part->argument, x->argument);
    part->kind = x->kind;
    part->parent = x->parent;
    part->operation = operations[x->type];
    part->function = x->type == EXPRESSION_CALL ? scarpi_recipe_function_of(r, x->name) : -1;
    part->entry = x->type == EXPRESSION_NAME && x->kind != SCARP_RECIPE_WORD
                      ? scarpi_recipe_find(r, x->name, r->statements)
                      : -1;
    part->value = x->kind == SCARP_RECIPE_NUMBER ? number_of(r, x) : 0.0;
    if (is_field(x)) {
        const struct recipe_node *const n = &r->node[x->node];
        part->range[0] = n->interval.lowest;
        part->range[1] = n->interval.highest;
        part->axes = n->axes;
        part->order = n->order;
    }
    part->hash = hash_of_value(r, x);
    return SCARP_OK;
}

enum scarp_status scarp_recipe_function_at(size_t index, struct scarp_recipe_function *function)
{
    if (function == NULL) {
        return SCARP_ERROR_NULL;
    }
    const struct scarp_recipe_function *const f =
        index < FUNCTION_COUNT ? scarpi_recipe_function_number((int)index) : NULL;
    if (f == NULL) {
        return SCARP_ERROR_PARAMETER;
    }
    *function = *f;
    return SCARP_OK;
}
