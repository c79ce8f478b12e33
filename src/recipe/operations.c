/* SPDX-License-Identifier: MIT
 *
 * Nodes that combine others: each is one call of the chain rule.
 */
#include <float.h>
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
        int state = scarpi_recipe_is_left_out(m, g->parent) ? GUARD_LEFT_OUT : GUARD_OPEN;
        if (state == GUARD_OPEN && g->kind == GUARD_BY_BOUNDS) {
            state = scarpi_recipe_decide(m, guard);
        } else if (state == GUARD_OPEN) {
            const struct scarp_samples mask = scarpi_recipe_samples(m, g->mask);
            const float value = g->kind == GUARD_BY_1 ? 1.0f : 0.0f;
            state = is_level(m->chunk->count, &mask, value) ? GUARD_LEFT_OUT : GUARD_OPEN;
        }
        m->state[guard] = (uint8_t)state;
    }
    return m->state[guard] != GUARD_OPEN;
}

/* The guard that leaves an operand of a gate out, or 0. */
static int left_out(struct recipe_machine *m, int gate)
{
    for (int i = 1; i <= m->schedule->guards; i++) {
        if (m->schedule->guard[i].gate == gate && scarpi_recipe_is_left_out(m, i)) {
            return i;
        }
    }
    return 0;
}

static enum scarp_status run_gate(struct recipe_machine *m, int node,
                                  const struct scarp_samples in[3], const struct scarp_samples *out)
{
    const size_t count = m->chunk->count;
    const int guard = left_out(m, node), operand = m->schedule->guard[guard].operand;
    const int operation = m->recipe->node[node].operation;
    if (guard != 0 && operation == OP_MULTIPLY) {
        fill(count, 0.0f, out);
        return SCARP_OK;
    }
    if (guard != 0 && (operation == OP_MIX || operation == OP_MIN || operation == OP_MAX)) {
        copy(count, &in[!operand], out);
        return SCARP_OK;
    }
    if (guard != 0) { /* the value is the same for any number that is as low, or as high */
        fill(count, m->state[guard] == GUARD_BELOW ? -FLT_MAX : FLT_MAX, &in[operand]);
    }
    return scarpi_recipe_combine(m->recipe, &m->recipe->node[node], count, in, out);
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
    if (n->operation == OP_CONSTANT) {
        fill(count, n->k[0], &out);
        return SCARP_OK;
    }
    return run_gate(m, node, in, &out);
}
