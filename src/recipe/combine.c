/* SPDX-License-Identifier: MIT
 *
 * The calls of functions that combine fields: those of plan/functions.def.
 */
#include "combine.h"

#include "../plan/functions.h"

static enum scarp_status run_curve(const struct recipe *recipe, const struct recipe_node *node,
                                   size_t count, const struct scarp_samples *a,
                                   const struct scarp_samples *out)
{
    float x[SCARP_CURVE_KNOTS], y[SCARP_CURVE_KNOTS];
    for (int i = 0; i < node->knots; i++) {
        x[i] = recipe->knot[node->index + i][0];
        y[i] = recipe->knot[node->index + i][1];
    }
    return scarp_curve(count, a, node->knots, x, y, out);
}

/* What kernels compute, by operation; without inputs: something else. */
static const struct kernel_function {
    uint8_t function, inputs;
} kernel_functions[OP_COUNT] = {
#define OPERATOR(NAME, name, FORM, COMPUTED, ...)                                                  \
    IF_KERNEL_##COMPUTED([OP_##NAME] = {CHAIN_##NAME, INPUTS_OF_##FORM}, )
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../plan/functions.def"
};

enum scarp_status scarpi_recipe_combine(const struct recipe *recipe, const struct recipe_node *node,
                                        size_t count, const struct scarp_samples in[3],
                                        const struct scarp_samples *out)
{
    const struct scarp_samples *const at[3] = {&in[0], &in[1], &in[2]};
    const struct kernel_function *const f = &kernel_functions[node->operation];
    if (f->inputs > 0 && out->dx == NULL) { /* values only, as most calls at few points ask for */
        const float *values[CHAIN_INPUTS] = {NULL};
        for (int i = 0; i < f->inputs; i++) {
            values[i] = in[i].value;
        }
        return scarpi_chain_values((enum scarp_chain_function)f->function, count, values, node->k,
                                   out->value);
    }
#define FORM_CURVE(function, count, in, k, out) run_curve(recipe, node, count, (in)[0], out)
#define OPERATOR(NAME, name, FORM, ...)                                                            \
    case OP_##NAME:                                                                                \
        return FORM_##FORM(scarp_##name, count, at, node->k, out);
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (node->operation) {
#include "../plan/functions.def"
    default: return SCARP_ERROR_PARAMETER; /* there is no other */
    }
}

static int has_numbers(int operation)
{
#define OPERATOR(NAME, name, FORM, ...) IF_NUMBERS_##FORM(case OP_##NAME:)
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (operation) {
#include "../plan/functions.def"
        return 1;
    default: return 0;
    }
}

/* A call for only a value says. */
enum scarp_status scarpi_recipe_try_numbers(const struct recipe_node *node)
{
    float zero = 0.0f, value;
    const struct scarp_samples a = {.value = &zero}, in[3] = {a, a, a}, out = {.value = &value};
    return has_numbers(node->operation) ? scarpi_recipe_combine(NULL, node, 1, in, &out) : SCARP_OK;
}
