/* SPDX-License-Identifier: MIT
 *
 * Compiles all statements of a recipe, and schedules its outputs.
 */
#include "compile.h"

#include "graph.h"
#include "schedule.h"

/* Empties the graph. The root is the place of the points, or another one if they are scaled. */
static void start(struct recipe_compiler *c, struct recipe *recipe, struct recipe_errors *errors)
{
    c->recipe = recipe;
    c->errors = errors;
    c->depth = 0;
    for (int i = 0; i < recipe->statements; i++) {
        c->noise[i] = RECIPE_UNKNOWN;
        for (int place = 0; place < RECIPE_PLACES; place++) {
            c->node[i][place] = RECIPE_UNKNOWN;
        }
    }
    recipe->nodes = recipe->noises = recipe->gullies = recipe->places = recipe->knots = 0;
    for (int e = 0; e < recipe->expressions; e++) {
        recipe->expression[e].kind = SCARP_RECIPE_BAD;
        recipe->expression[e].node = RECIPE_NONE;
    }
    struct recipe_place points = {.rest = {RECIPE_NONE, RECIPE_NONE, RECIPE_NONE},
                                  .frame = RECIPE_NONE,
                                  .warp = RECIPE_NONE,
                                  .before = RECIPE_NONE,
                                  .dimensions = recipe->dimensions};
    for (int i = 0; i < recipe->dimensions; i++) {
        points.m[i][i] = 1.0;
    }
    (void)scarpi_recipe_add_place(recipe, points);
    for (int i = 0; i < recipe->dimensions; i++) {
        points.m[i][i] = 1.0 / recipe->scale[0];
    }
    c->root = scarpi_recipe_add_place(recipe, points);
}

/* Parts inside of calls that transform have no node yet. Editors show them, too, as they are where
   nothing is transformed. There may be none: no room, say. */
static void compile_parts(struct recipe_compiler *c)
{
    c->errors = NULL;
    for (int e = 0; e < c->recipe->expressions; e++) {
        const struct recipe_expression *const x = &c->recipe->expression[e];
        if (x->node == RECIPE_NONE &&
            (x->kind == SCARP_RECIPE_BAD || x->kind == SCARP_RECIPE_NOISE)) {
            (void)scarpi_recipe_value(c, e, c->root);
        }
    }
}

/* An output as it is sampled: a node, also of a number. The values of the first one are scaled. */
static struct recipe_value output_of(struct recipe_compiler *c, int output)
{
    struct recipe *const r = c->recipe;
    const int e = r->statement[r->output[output]].expression;
    const struct recipe_expression *const x = &r->expression[e];
    struct recipe_value value = {x->kind, x->node, x->number};
    if (output == 0 && r->scale[1] != 1.0) {
        value = scarpi_recipe_combined(c, e, EXPRESSION_MULTIPLY, scarpi_recipe_number(r->scale[1]),
                                       value);
    }
    value.node = scarpi_recipe_field(c, e, value);
    return value;
}

void scarpi_recipe_compile(struct recipe *recipe, struct recipe_errors *errors)
{
    struct recipe_compiler c;
    struct recipe_value output[RECIPE_OUTPUTS];
    int16_t roots[RECIPE_OUTPUTS];
    start(&c, recipe, errors);
    for (int i = 0; i < recipe->statements; i++) {
        const int e = recipe->statement[i].expression;
        if (e >= 0) {
            const struct recipe_value value = scarpi_recipe_value(&c, e, c.root);
            c.node[i][c.root] =
                (int16_t)(value.kind == SCARP_RECIPE_NUMBER ? RECIPE_UNKNOWN : value.node);
        }
    }
    for (int i = 0; i < recipe->outputs && errors->found == 0; i++) {
        output[i] = output_of(&c, i);
        roots[i] = (int16_t)output[i].node;
    }
    recipe->is_bad = errors->found != 0;
    if (!recipe->is_bad) {
        scarpi_recipe_schedule(recipe, roots, recipe->outputs, 1, &recipe->schedule);
    }
    compile_parts(&c);
    for (int i = 0; i < recipe->outputs && !recipe->is_bad; i++) {
        struct recipe_expression *const x =
            &recipe->expression[recipe->statement[recipe->output[i]].expression];
        x->node = roots[i];
        if (x->type != EXPRESSION_NUMBER) { /* which keeps what the text has */
            x->number = output[i].number;
        }
    }
}
