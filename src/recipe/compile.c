/* SPDX-License-Identifier: MIT */
#include "compile.h"

#include <math.h>
#include <string.h>

#include "graph.h"
#include "schedule.h"

struct recipe_value scarpi_recipe_bad(struct recipe_compiler *c, int e, const char *text,
                                      const char *member)
{
    struct recipe_expression *const x = &c->recipe->expression[e];
    if (c->errors != NULL) {
        if (x->kind != SCARP_RECIPE_BAD || x->node != -2) { /* else it was told at another place */
            scarpi_recipe_fail(c->errors, c->recipe, x->span, text, member);
        }
        x->kind = SCARP_RECIPE_BAD;
        x->node = -2;
    }
    return (struct recipe_value){SCARP_RECIPE_BAD, -1, 0.0};
}

struct recipe_value scarpi_recipe_full(struct recipe_compiler *c, int e)
{
    if (c->errors != NULL) {
        c->errors->is_size = 1;
    }
    return scarpi_recipe_bad(c, e,
                             "the recipe is too large: it has too many fields, noises, places, "
                             "gullies or knots",
                             NULL);
}

static struct recipe_value bad_silently(void)
{
    return (struct recipe_value){SCARP_RECIPE_BAD, -1, 0.0};
}

struct recipe_value scarpi_recipe_number(double number)
{
    return (struct recipe_value){SCARP_RECIPE_NUMBER, -1, number};
}

struct recipe_node scarpi_recipe_operation(int operation, int a, int b)
{
    return (struct recipe_node){.operation = (uint8_t)operation,
                                .in = {(int16_t)a, (int16_t)b, -1},
                                .place = -1,
                                .index = -1};
}

struct recipe_value scarpi_recipe_node(struct recipe_compiler *c, int e, struct recipe_node node)
{
    const int added = scarpi_recipe_add_node(c->recipe, node);
    return added < 0 ? scarpi_recipe_full(c, e)
                     : (struct recipe_value){SCARP_RECIPE_FIELD, added, 0.0};
}

int scarpi_recipe_field(struct recipe_compiler *c, int e, struct recipe_value value)
{
    if (value.kind != SCARP_RECIPE_NUMBER) {
        return value.node;
    }
    struct recipe_node node = scarpi_recipe_operation(OP_CONSTANT, -1, -1);
    node.k[0] = (float)value.number;
    if (!(fabsf(node.k[0]) < INFINITY)) {
        return scarpi_recipe_bad(c, e, "a number is too large", NULL).node;
    }
    return scarpi_recipe_node(c, e, node).node;
}

int scarpi_recipe_take_number(struct recipe_compiler *c, int e, double *number)
{
    const struct recipe_value value = scarpi_recipe_value(c, e, 0);
    if (value.kind == SCARP_RECIPE_FIELD) {
        (void)scarpi_recipe_bad(c, e, "expected a number, and this depends on the place", NULL);
    }
    *number = value.number;
    return value.kind == SCARP_RECIPE_NUMBER;
}

struct recipe_value scarpi_recipe_affine(struct recipe_compiler *c, int e, int a, double scale,
                                         double offset)
{
    struct recipe_node node = scarpi_recipe_operation(OP_AFFINE, a, -1);
    node.k[0] = (float)scale;
    node.k[1] = (float)offset;
    if (a < 0) {
        return bad_silently();
    }
    if (!(fabsf(node.k[0]) < INFINITY && fabsf(node.k[1]) < INFINITY)) {
        return scarpi_recipe_bad(c, e, "a number is too large", NULL);
    }
    if (node.k[0] == 1.0f && node.k[1] == 0.0f) {
        return (struct recipe_value){SCARP_RECIPE_FIELD, a, 0.0};
    }
    return scarpi_recipe_node(c, e, node);
}

static struct recipe_value folded(struct recipe_compiler *c, int e, int type, double a, double b)
{
    if (type == EXPRESSION_DIVIDE && b == 0.0) {
        return scarpi_recipe_bad(c, e, "a division by 0", NULL);
    }
    const double r = type == EXPRESSION_ADD        ? a + b
                     : type == EXPRESSION_SUBTRACT ? a - b
                     : type == EXPRESSION_MULTIPLY ? a * b
                                                   : a / b;
    return fabs(r) <= 1e60 ? scarpi_recipe_number(r)
                           : scarpi_recipe_bad(c, e, "a number is too large", NULL);
}

static struct recipe_value divided(struct recipe_compiler *c, int e, struct recipe_value a,
                                   struct recipe_value b)
{
    if (b.kind == SCARP_RECIPE_NUMBER) {
        return b.number == 0.0 ? scarpi_recipe_bad(c, e, "a division by 0", NULL)
                               : scarpi_recipe_affine(c, e, a.node, 1.0 / b.number, 0.0);
    }
    const struct recipe_interval by = c->recipe->node[b.node].interval;
    if (by.lowest <= 0.0f && by.highest >= 0.0f) {
        return scarpi_recipe_bad(
            c, e, "the divisor can be 0: keep it away from that, by clamp or max", NULL);
    }
    const int field = scarpi_recipe_field(c, e, a);
    return field < 0 ? bad_silently()
                     : scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_DIVIDE, field, b.node));
}

static struct recipe_value combined(struct recipe_compiler *c, int e, int type,
                                    struct recipe_value a, struct recipe_value b)
{
    if (a.kind == SCARP_RECIPE_BAD || b.kind == SCARP_RECIPE_BAD) {
        return bad_silently();
    }
    if (a.kind == SCARP_RECIPE_NUMBER && b.kind == SCARP_RECIPE_NUMBER) {
        return folded(c, e, type, a.number, b.number);
    }
    if (type == EXPRESSION_DIVIDE) {
        return divided(c, e, a, b);
    }
    if (type == EXPRESSION_MULTIPLY) {
        return a.kind == SCARP_RECIPE_NUMBER ? scarpi_recipe_affine(c, e, b.node, a.number, 0.0)
               : b.kind == SCARP_RECIPE_NUMBER
                   ? scarpi_recipe_affine(c, e, a.node, b.number, 0.0)
                   : scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_MULTIPLY, a.node, b.node));
    }
    const double sign = type == EXPRESSION_ADD ? 1.0 : -1.0;
    if (a.kind == SCARP_RECIPE_NUMBER) {
        return scarpi_recipe_affine(c, e, b.node, sign, a.number);
    }
    if (b.kind == SCARP_RECIPE_NUMBER) {
        return scarpi_recipe_affine(c, e, a.node, 1.0, sign * b.number);
    }
    const int second = scarpi_recipe_affine(c, e, b.node, sign, 0.0).node;
    return second < 0 ? bad_silently()
                      : scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_ADD, a.node, second));
}

static struct recipe_value coordinate(struct recipe_compiler *c, int e, int place, int axis)
{
    const int p = scarpi_recipe_spelled_out(c, e, place);
    if (p < 0) {
        return bad_silently();
    }
    if (axis >= c->recipe->place[p].dimensions) {
        return scarpi_recipe_bad(c, e, "there is no z in the plane: see space and flat", NULL);
    }
    if (c->recipe->is_tiled) {
        return scarpi_recipe_bad(c, e, "a coordinate does not repeat, and the recipe has a tile",
                                 NULL);
    }
    struct recipe_node node = scarpi_recipe_operation(OP_COORDINATE, -1, -1);
    node.place = (int16_t)p;
    node.detail = (uint8_t)axis;
    return scarpi_recipe_node(c, e, node);
}

static int axis_of(const struct recipe_compiler *c, int e)
{
    const struct recipe_span name = c->recipe->expression[e].name;
    const char letter = c->recipe->text[name.from];
    return name.to - name.from == 1 && letter >= 'x' && letter <= 'z' ? letter - 'x' : -1;
}

static struct recipe_value named(struct recipe_compiler *c, int e, int place)
{
    struct recipe *const r = c->recipe;
    const int axis = axis_of(c, e);
    if (axis >= 0) {
        return coordinate(c, e, place, axis);
    }
    const int i = scarpi_recipe_find(r, r->expression[e].name, r->statements);
    if (i < 0 || r->statement[i].span.to > r->expression[e].name.from) {
        return scarpi_recipe_bad(
            c, e, i < 0 ? "there is no such name" : "a name is used above or in its own statement",
            NULL);
    }
    const struct recipe_statement *const named = &r->statement[i];
    if (named->type == STATEMENT_PARAM) {
        return scarpi_recipe_number(named->value);
    }
    if (named->expression < 0 || c->known[i][place] < 0) {
        return bad_silently();
    }
    if (r->expression[named->expression].kind == SCARP_RECIPE_NOISE) {
        r->expression[e].kind = SCARP_RECIPE_NOISE;
    }
    if (c->known[i][place] > 0) { /* else chains of names would double at each */
        return (struct recipe_value){SCARP_RECIPE_FIELD, c->known[i][place] - 1, 0.0};
    }
    const struct recipe_value value = scarpi_recipe_value(c, named->expression, place);
    if (value.kind != SCARP_RECIPE_NUMBER) {
        c->known[i][place] = (int16_t)(value.node + (value.node >= 0));
    }
    return value;
}

static struct recipe_value value_of(struct recipe_compiler *c, int e, int place)
{
    const struct recipe_expression *const x = &c->recipe->expression[e];
    switch (x->type) {
    case EXPRESSION_NUMBER: return scarpi_recipe_number(x->number);
    case EXPRESSION_NAME: return named(c, e, place);
    case EXPRESSION_CALL: return scarpi_recipe_call(c, e, place);
    case EXPRESSION_NEGATIVE:
        return combined(c, e, EXPRESSION_MULTIPLY, scarpi_recipe_number(-1.0),
                        scarpi_recipe_value(c, x->a, place));
    case EXPRESSION_POWER: {
        const struct recipe_value a = scarpi_recipe_value(c, x->a, place);
        const struct recipe_value square = combined(c, e, EXPRESSION_MULTIPLY, a, a);
        return x->exponent == 2
                   ? square
                   : combined(c, e, EXPRESSION_MULTIPLY, square, x->exponent == 3 ? a : square);
    }
    case EXPRESSION_KNOT:
        return scarpi_recipe_bad(c, e, "x: value stands in curve() and blend() alone", NULL);
    default: {
        const struct recipe_value a = scarpi_recipe_value(c, x->a, place);
        return combined(c, e, x->type, a, scarpi_recipe_value(c, x->b, place));
    }
    }
}

struct recipe_value scarpi_recipe_value(struct recipe_compiler *c, int e, int place)
{
    struct recipe_expression *const x = &c->recipe->expression[e];
    if (c->depth == RECIPE_DEPTH) {
        return scarpi_recipe_bad(c, e, "expressions are nested more than 40 deep, through names",
                                 NULL);
    }
    c->depth++;
    const struct recipe_value value = value_of(c, e, place);
    c->depth--;
    if (place == 0 && value.kind != SCARP_RECIPE_BAD) {
        x->kind = x->kind == SCARP_RECIPE_NOISE ? x->kind : (uint8_t)value.kind;
        x->node = (int16_t)value.node;
        x->number = value.number;
    }
    return value;
}

static void start(struct recipe *recipe)
{
    recipe->nodes = recipe->noises = recipe->gullies = recipe->places = recipe->knots = 0;
    for (int e = 0; e < recipe->expressions; e++) {
        recipe->expression[e].kind = SCARP_RECIPE_BAD;
        recipe->expression[e].node = -1;
    }
    struct recipe_place points = {.rest = {-1, -1, -1},
                                  .frame = -1,
                                  .warp = -1,
                                  .before = -1,
                                  .dimensions = recipe->dimensions};
    for (int i = 0; i < recipe->dimensions; i++) {
        points.m[i][i] = 1.0;
    }
    (void)scarpi_recipe_add_place(recipe, points);
}

/* Parts that stand inside of calls that transform have no node yet. Editors show them, too, as they
   are where nothing is transformed. There may be none, for want of room, say. */
static void compile_parts(struct recipe_compiler *c)
{
    c->errors = NULL;
    for (int e = 0; e < c->recipe->expressions; e++) {
        const struct recipe_expression *const x = &c->recipe->expression[e];
        if (x->node == -1 && (x->kind == SCARP_RECIPE_BAD || x->kind == SCARP_RECIPE_NOISE)) {
            (void)scarpi_recipe_value(c, e, 0);
        }
    }
}

void scarpi_recipe_compile(struct recipe *recipe, struct recipe_errors *errors)
{
    struct recipe_compiler c = {.recipe = recipe, .errors = errors};
    int16_t roots[RECIPE_OUTPUTS];
    start(recipe);
    for (int i = 0; i < recipe->statements; i++) {
        const int e = recipe->statement[i].expression;
        if (e >= 0) {
            const struct recipe_value value = scarpi_recipe_value(&c, e, 0);
            c.known[i][0] = (int16_t)(value.kind == SCARP_RECIPE_BAD     ? -1
                                      : value.kind == SCARP_RECIPE_FIELD ? value.node + 1
                                                                         : 0);
        }
    }
    for (int i = 0; i < recipe->outputs && errors->found == 0; i++) {
        const int e = recipe->statement[recipe->output[i]].expression;
        const struct recipe_value value = {recipe->expression[e].kind, recipe->expression[e].node,
                                           recipe->expression[e].number};
        roots[i] = (int16_t)scarpi_recipe_field(&c, e, value);
        recipe->expression[e].node = roots[i];
    }
    recipe->is_bad = errors->found != 0;
    if (!recipe->is_bad) {
        scarpi_recipe_schedule(recipe, roots, recipe->outputs, &recipe->schedule);
    }
    compile_parts(&c);
}
