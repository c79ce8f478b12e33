/* SPDX-License-Identifier: MIT
 *
 * From a text to a tree of expressions, by recursive descent:
 *
 *     sum        = product { ("+" | "-") product }
 *     product    = unary { ("*" | "/") unary }
 *     unary      = "-" unary | primary [ "^" number ]
 *     primary    = number | name | name "(" [ argument { "," argument } ] ")" | "(" sum ")"
 *     argument   = name "=" sum | sum [ ":" sum ]
 */
#include "reader.h"

static struct recipe_expression *expression(struct recipe_reader *r, int e)
{
    return &r->recipe->expression[e];
}

static int new_expression(struct recipe_reader *r, enum recipe_expression_type type, size_t from)
{
    struct recipe *const recipe = r->recipe;
    if (recipe->expressions == RECIPE_EXPRESSIONS) {
        r->errors->is_size = 1;
        return scarpi_reader_fail(r, "a recipe has at most 512 expressions");
    }
    recipe->expression[recipe->expressions] =
        (struct recipe_expression){.type = (uint8_t)type,
                                   .span = {(uint16_t)from, (uint16_t)r->at},
                                   .a = -1,
                                   .b = -1,
                                   .next = -1,
                                   .parent = -1,
                                   .node = -1};
    return recipe->expressions++;
}

static void set_operands(struct recipe_reader *r, int e, int a, int b)
{
    expression(r, e)->a = (int16_t)a;
    expression(r, e)->b = (int16_t)b;
    expression(r, a)->parent = (int16_t)e;
    expression(r, e)->span.from = expression(r, a)->span.from;
    if (b >= 0) {
        expression(r, b)->parent = (int16_t)e;
    }
    expression(r, e)->span.to = b >= 0 ? expression(r, b)->span.to : (uint16_t)r->at;
}

static int argument(struct recipe_reader *r)
{
    scarpi_reader_skip(r);
    const struct recipe_span name = scarpi_reader_word(r, r->at);
    const size_t from = r->at;
    r->at = name.to;
    if (name.to > name.from && scarpi_reader_take(r, '=')) {
        const int e = scarpi_reader_expression(r);
        if (e >= 0) {
            expression(r, e)->argument = name;
        }
        return e;
    }
    r->at = from;
    const int a = scarpi_reader_expression(r);
    if (a < 0 || !scarpi_reader_take(r, ':')) {
        return a;
    }
    const int b = scarpi_reader_expression(r),
              e = b < 0 ? -1 : new_expression(r, EXPRESSION_KNOT, from);
    if (e >= 0) {
        set_operands(r, e, a, b);
    }
    return e;
}

static int arguments(struct recipe_reader *r, int call)
{
    r->at++;
    r->parentheses++;
    scarpi_reader_skip(r);
    int last = -1;
    while (reader_next(r) != ')') {
        if (last >= 0 && !scarpi_reader_take(r, ',')) {
            return scarpi_reader_fail(r, "expected , or )");
        }
        const int a = argument(r);
        if (a < 0) {
            return -1;
        }
        expression(r, a)->parent = (int16_t)call;
        *(last < 0 ? &expression(r, call)->a : &expression(r, last)->next) = (int16_t)a;
        last = a;
        scarpi_reader_skip(r);
    }
    r->parentheses--;
    r->at++;
    expression(r, call)->span.to = (uint16_t)r->at;
    return call;
}

static int primary(struct recipe_reader *r)
{
    scarpi_reader_skip(r);
    const size_t from = r->at;
    if (reader_is_digit(reader_next(r)) || reader_next(r) == '.') {
        double value;
        const int e =
            scarpi_reader_number(r, &value) ? new_expression(r, EXPRESSION_NUMBER, from) : -1;
        if (e >= 0) {
            expression(r, e)->number = value;
        }
        return e;
    }
    if (reader_next(r) == '(') {
        r->parentheses++;
        r->at++;
        const int e = scarpi_reader_expression(r);
        if (e < 0 || reader_next(r) != ')') {
            return e < 0 ? -1 : scarpi_reader_fail(r, "expected )");
        }
        r->parentheses--;
        r->at++;
        expression(r, e)->span = (struct recipe_span){(uint16_t)from, (uint16_t)r->at};
        return e;
    }
    const struct recipe_span name = scarpi_reader_word(r, r->at);
    if (name.to == name.from) {
        return scarpi_reader_fail(r, "expected a number, a name or (");
    }
    r->at = name.to;
    const int e = new_expression(r, EXPRESSION_NAME, from);
    if (e < 0) {
        return -1;
    }
    expression(r, e)->name = name;
    scarpi_reader_skip(r);
    if (reader_next(r) != '(') {
        r->at = name.to;
        return e;
    }
    expression(r, e)->type = EXPRESSION_CALL;
    return arguments(r, e);
}

static int power(struct recipe_reader *r)
{
    const int a = primary(r);
    if (a < 0 || !scarpi_reader_take(r, '^')) {
        return a;
    }
    double exponent;
    if (!scarpi_reader_number(r, &exponent)) {
        return -1;
    }
    if (exponent != 2.0 && exponent != 3.0 && exponent != 4.0) {
        return scarpi_reader_fail_at(r,
                                     (struct recipe_span){(uint16_t)(r->at - 1), (uint16_t)r->at},
                                     "an exponent must be 2, 3 or 4");
    }
    const int e = new_expression(r, EXPRESSION_POWER, r->at);
    if (e >= 0) {
        set_operands(r, e, a, -1);
        expression(r, e)->exponent = (uint8_t)exponent;
    }
    return e;
}

static int unary(struct recipe_reader *r)
{
    scarpi_reader_skip(r);
    const size_t from = r->at;
    bool is_negative = false;
    while (scarpi_reader_take(r, '-')) {
        is_negative = !is_negative;
    }
    const int a = power(r);
    if (a < 0 || !is_negative) {
        return a;
    }
    if (expression(r, a)->type == EXPRESSION_NUMBER) {
        expression(r, a)->number = -expression(r, a)->number;
        expression(r, a)->span.from = (uint16_t)from;
        return a;
    }
    const int e = new_expression(r, EXPRESSION_NEGATIVE, from);
    if (e >= 0) {
        set_operands(r, e, a, -1);
        expression(r, e)->span = (struct recipe_span){(uint16_t)from, expression(r, a)->span.to};
    }
    return e;
}

/* Operands with signs between them, of which the first one is of the type `first`. */
static int operands(struct recipe_reader *r, const char signs[2], enum recipe_expression_type first,
                    int (*operand)(struct recipe_reader *))
{
    int a = operand(r);
    for (scarpi_reader_skip(r);
         a >= 0 && (reader_next(r) == signs[0] || reader_next(r) == signs[1]);
         scarpi_reader_skip(r)) {
        const int type = (int)first + (reader_next(r) == signs[1]);
        r->at++;
        const int b = operand(r);
        const int e = b < 0 ? -1 : new_expression(r, (enum recipe_expression_type)type, r->at);
        if (e >= 0) {
            set_operands(r, e, a, b);
        }
        a = e;
    }
    return a;
}

static int product(struct recipe_reader *r)
{
    return operands(r, "*/", EXPRESSION_MULTIPLY, unary);
}

int scarpi_reader_expression(struct recipe_reader *r)
{
    if (r->nesting == RECIPE_NESTING) {
        return scarpi_reader_fail(r, "parentheses are nested more than 24 deep");
    }
    r->nesting++;
    const int e = operands(r, "+-", EXPRESSION_ADD, product);
    r->nesting--;
    return e;
}
