/* SPDX-License-Identifier: MIT
 *
 * Values and nodes: errors at expressions, numbers that become nodes, and arithmetic.
 */
#include <math.h>

#include "compile.h"
#include "graph.h"

struct recipe_value scarpi_recipe_bad(struct recipe_compiler *c, int e, const char *text,
                                      const char *member)
{
    struct recipe_expression *const x = &c->recipe->expression[e];
    if (c->errors != NULL) {
        if (x->kind != SCARP_RECIPE_BAD ||
            x->node != RECIPE_BAD) { /* else it is reported already */
            scarpi_recipe_fail(c->errors, c->recipe, x->span, text, member);
        }
        x->kind = SCARP_RECIPE_BAD;
        x->node = RECIPE_BAD;
    }
    return scarpi_recipe_bad_already();
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

struct recipe_value scarpi_recipe_bad_already(void)
{
    return (struct recipe_value){SCARP_RECIPE_BAD, RECIPE_BAD, 0.0};
}

struct recipe_value scarpi_recipe_number(double number)
{
    return (struct recipe_value){SCARP_RECIPE_NUMBER, RECIPE_NONE, number};
}

struct recipe_node scarpi_recipe_operation(int operation, int a, int b)
{
    return (struct recipe_node){.operation = (uint8_t)operation,
                                .in = {(int16_t)a, (int16_t)b, RECIPE_NONE},
                                .place = RECIPE_NONE,
                                .index = RECIPE_NONE};
}

struct recipe_value scarpi_recipe_node(struct recipe_compiler *c, int e, struct recipe_node node)
{
    const int added = scarpi_recipe_add_node(c->recipe, node);
    return added < 0 ? scarpi_recipe_full(c, e)
                     : (struct recipe_value){SCARP_RECIPE_FIELD, added, 0.0};
}

int scarpi_recipe_place(struct recipe_compiler *c, int e, const struct recipe_place *place)
{
    const int added = scarpi_recipe_add_place(c->recipe, *place);
    return added >= 0 ? added : scarpi_recipe_full(c, e).node;
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

struct recipe_value scarpi_recipe_affine(struct recipe_compiler *c, int e, int a, double scale,
                                         double offset)
{
    struct recipe_node node = scarpi_recipe_operation(OP_AFFINE, a, RECIPE_NONE);
    node.k[0] = (float)scale;
    node.k[1] = (float)offset;
    if (a < 0) {
        return scarpi_recipe_bad_already();
    }
    if (!(fabsf(node.k[0]) < INFINITY && fabsf(node.k[1]) < INFINITY)) {
        return scarpi_recipe_bad(c, e, "a number is too large", NULL);
    }
    if (node.k[0] == 1.0f && node.k[1] == 0.0f) {
        return (struct recipe_value){SCARP_RECIPE_FIELD, a, 0.0};
    }
    const struct recipe_node *const in = &c->recipe->node[a];
    if (in->operation == OP_AFFINE && in->k[1] == 0.0f && node.k[0] == 1.0f) {
        node.in[0] = in->in[0]; /* adding to a product with 0 added has the same bits */
        node.k[0] = in->k[0];
    }
    return scarpi_recipe_node(c, e, node);
}

int scarpi_recipe_sum(struct recipe_compiler *c, int e, int a, int b)
{
    if (a == RECIPE_BAD || b == RECIPE_BAD) {
        return RECIPE_BAD;
    }
    if (a == RECIPE_NONE || b == RECIPE_NONE) {
        return a == RECIPE_NONE ? b : a;
    }
    return scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_ADD, a, b)).node;
}

static struct recipe_value folded(struct recipe_compiler *c, int e, int type, double a, double b)
{
    if (type == EXPRESSION_DIVIDE && b == 0.0) {
        return scarpi_recipe_bad(c, e, "division by 0", NULL);
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
        return b.number == 0.0 ? scarpi_recipe_bad(c, e, "division by 0", NULL)
                               : scarpi_recipe_affine(c, e, a.node, 1.0 / b.number, 0.0);
    }
    const struct recipe_interval by = c->recipe->node[b.node].interval;
    if (by.lowest <= 0.0f && by.highest >= 0.0f) {
        return scarpi_recipe_bad(
            c, e, "the divisor can be 0: keep it away from 0 with clamp or max", NULL);
    }
    const int field = scarpi_recipe_field(c, e, a);
    return field < 0 ? scarpi_recipe_bad_already()
                     : scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_DIVIDE, field, b.node));
}

struct recipe_value scarpi_recipe_combined(struct recipe_compiler *c, int e, int type,
                                           struct recipe_value a, struct recipe_value b)
{
    if (a.kind == SCARP_RECIPE_BAD || b.kind == SCARP_RECIPE_BAD) {
        return scarpi_recipe_bad_already();
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
    return second < 0 ? scarpi_recipe_bad_already()
                      : scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_ADD, a.node, second));
}
