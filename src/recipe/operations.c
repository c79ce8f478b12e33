/* SPDX-License-Identifier: MIT
 *
 * Nodes that combine others: each is one call of the chain rule.
 */
#include "operations.h"

#include <string.h>

#include "machine.h"

#define MEMBERS 10 /* from the value to dzz, in the order of struct scarp_samples */

static float *member(const struct scarp_samples *samples, int i)
{
    float *array;
    memcpy(&array, (const char *)samples + (size_t)i * sizeof array, sizeof array);
    return array;
}

static void fill(size_t count, float value, const struct scarp_samples *to)
{
    for (int i = 0; i < MEMBERS; i++) {
        float *const array = member(to, i);
        for (size_t k = 0; array != NULL && k < count; k++) {
            array[k] = i == 0 ? value : 0.0f;
        }
    }
}

static void copy(size_t count, const struct scarp_samples *from, const struct scarp_samples *to)
{
    for (int i = 0; i < MEMBERS; i++) {
        float *const array = member(to, i);
        if (array != NULL && array != member(from, i)) {
            memcpy(array, member(from, i), count * sizeof *array);
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
    for (int i = 0; i < MEMBERS; i++) {
        const float *const array = member(a, i);
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

enum scarp_status scarpi_recipe_curve(const struct recipe *recipe, const struct recipe_node *node,
                                      size_t count, const float *a, float *value)
{
    float x[SCARP_CURVE_KNOTS], y[SCARP_CURVE_KNOTS], in[2];
    for (int i = 0; i < node->knots; i++) {
        x[i] = recipe->knot[node->index + i][0];
        y[i] = recipe->knot[node->index + i][1];
    }
    memcpy(in, a, count * sizeof *a);
    const struct scarp_samples from = {.value = in}, to = {.value = value};
    return scarp_curve(count, &from, node->knots, x, y, &to);
}

static enum scarp_status run_curve(const struct recipe_machine *m, const struct recipe_node *n,
                                   const struct scarp_samples *a, const struct scarp_samples *out)
{
    float x[SCARP_CURVE_KNOTS], y[SCARP_CURVE_KNOTS];
    for (int i = 0; i < n->knots; i++) {
        x[i] = m->recipe->knot[n->index + i][0];
        y[i] = m->recipe->knot[n->index + i][1];
    }
    return scarp_curve(m->chunk->count, a, n->knots, x, y, out);
}

static enum scarp_status run_gate(struct recipe_machine *m, int node,
                                  const struct scarp_samples in[3], const struct scarp_samples *out)
{
    const size_t count = m->chunk->count;
    const int operand = left_out(m, node);
    const int is_product = m->recipe->node[node].operation == OP_MULTIPLY;
    if (operand < 0) {
        return is_product ? scarp_multiply(count, &in[0], &in[1], out)
                          : scarp_mix(count, &in[0], &in[1], &in[2], out);
    }
    if (is_product) {
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
    const struct scarp_samples out = scarpi_recipe_samples(m, node);
    struct scarp_samples in[3] = {{0}};
    for (int i = 0; i < 3; i++) {
        if (n->in[i] >= 0) {
            in[i] = scarpi_recipe_samples(m, n->in[i]);
        }
    }
    const struct scarp_samples *const a = &in[0], *const b = &in[1];
    switch (n->operation) {
    case OP_CONSTANT: fill(count, n->k[0], &out); return SCARP_OK;
    case OP_ADD: return scarp_add(count, a, b, &out);
    case OP_MULTIPLY:
    case OP_MIX: return run_gate(m, node, in, &out);
    case OP_DIVIDE: return scarp_divide(count, a, b, &out);
    case OP_AFFINE: return scarp_affine(count, a, n->k[0], n->k[1], &out);
    case OP_MIN: return scarp_min(count, a, b, &out);
    case OP_MAX: return scarp_max(count, a, b, &out);
    case OP_SMOOTH_MIN: return scarp_smooth_min(count, a, b, n->k[0], &out);
    case OP_SMOOTH_MAX: return scarp_smooth_max(count, a, b, n->k[0], &out);
    case OP_CLAMP: return scarp_clamp(count, a, n->k[0], n->k[1], &out);
    case OP_ABS: return scarp_abs(count, a, &out);
    case OP_SMOOTH_ABS: return scarp_smooth_abs(count, a, n->k[0], &out);
    case OP_SMOOTHSTEP: return scarp_smoothstep(count, a, n->k[0], n->k[1], &out);
    case OP_TERRACE: return scarp_terrace(count, a, n->k[0], n->k[1], n->k[2], &out);
    case OP_CURVE: return run_curve(m, n, a, &out);
    case OP_SQRT: return scarp_sqrt(count, a, &out);
    case OP_SINE: return scarp_sine(count, a, &out);
    case OP_PULSE: return scarp_pulse(count, a, &out);
    default: return scarp_slope(count, a, &out); /* OP_SLOPE */
    }
}
