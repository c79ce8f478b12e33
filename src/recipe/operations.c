/* SPDX-License-Identifier: MIT
 *
 * Nodes that combine others: each is one call of the chain rule.
 */
#include <string.h>

#include "combine.h"
#include "machine.h"

static void fill(size_t count, float value, const struct scarp_samples *to)
{
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        float *const array = recipe_member(to, i);
        for (size_t k = 0; array != NULL && k < count; k++) {
            array[k] = i == 0 ? value : 0.0f;
        }
    }
}

static void copy(size_t count, const struct scarp_samples *from, const struct scarp_samples *to)
{
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        float *const array = recipe_member(to, i);
        if (array != NULL && array != recipe_member(from, i)) {
            memcpy(array, recipe_member(from, i), count * sizeof *array);
        }
    }
}

static bool is_all(size_t count, const float *array, float value)
{
    size_t i = 0;
    while (i < count && array[i] == value) {
        i++;
    }
    return i == count;
}

/* Whether samples have the same value everywhere, and no derivatives. */
static bool is_level(size_t count, const struct scarp_samples *a, float value)
{
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        const float *const array = recipe_member(a, i);
        if (array != NULL && !is_all(count, array, i == 0 ? value : 0.0f)) {
            return false;
        }
    }
    return true;
}

bool scarpi_recipe_is_left_out(struct recipe_machine *m, int guard)
{
    if (guard == 0) {
        return false;
    }
    if (m->state[guard] == GUARD_UNKNOWN) {
        const struct recipe_guard *const g = &m->schedule->guard[guard];
        struct scarp_samples mask = {0};
        bool is_left_out = scarpi_recipe_is_left_out(m, g->parent);
        if (!is_left_out) {
            mask = scarpi_recipe_samples(m, g->mask);
            is_left_out = is_level(m->chunk->count, &mask, g->one ? 1.0f : 0.0f);
        }
        m->state[guard] = is_left_out ? GUARD_LEFT_OUT : GUARD_OPEN;
    }
    return m->state[guard] == GUARD_LEFT_OUT;
}

/* The operand of a gate that is left out, or -1. */
static int left_out(struct recipe_machine *m, int gate)
{
    for (int i = 1; i <= m->schedule->guards; i++) {
        if (m->schedule->guard[i].gate == gate && scarpi_recipe_is_left_out(m, i)) {
            return m->schedule->guard[i].operand;
        }
    }
    return -1;
}

static enum scarp_status run_gate(struct recipe_machine *m, int node,
                                  const struct scarp_samples in[3], const struct scarp_samples *out)
{
    const size_t count = m->chunk->count;
    const int operand = left_out(m, node);
    if (operand < 0) {
        return scarpi_recipe_combine(m->recipe, &m->recipe->node[node], count, in, out);
    }
    if (m->recipe->node[node].operation == OP_MULTIPLY) {
        fill(count, 0.0f, out);
    } else {
        copy(count, &in[!operand], out);
    }
    return SCARP_OK;
}

enum scarp_status scarpi_recipe_run_operation(struct recipe_machine *m, int node)
{
    const struct recipe_node *const n = &m->recipe->node[node];
    const size_t count = m->chunk->count;
    struct scarp_samples out, in[3]; /* what it does not read stays unset */
    scarpi_recipe_find_samples(m, node, &out);
    for (int i = 0; i < 3; i++) {
        if (n->in[i] >= 0) {
            scarpi_recipe_find_samples(m, n->in[i], &in[i]);
        }
    }
    switch (n->operation) {
    case OP_CONSTANT: fill(count, n->k[0], &out); return SCARP_OK;
    case OP_MULTIPLY:
    case OP_MIX: return run_gate(m, node, in, &out);
    default: return scarpi_recipe_combine(m->recipe, n, count, in, &out);
    }
}
