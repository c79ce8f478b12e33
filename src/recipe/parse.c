/* SPDX-License-Identifier: MIT
 *
 * From a text to statements and expressions, by recursive descent:
 *
 *     recipe     = { statement newline }
 *     statement  = "recipe" number
 *                | "space" number
 *                | "tile" number "," number [ "," number ]
 *                | "param" name "=" signed [ "[" signed "," signed "]" ]
 *                | [ "out" ] name "=" sum
 *     sum        = product { ("+" | "-") product }
 *     product    = unary { ("*" | "/") unary }
 *     unary      = "-" unary | primary [ "^" number ]
 *     primary    = number | name | name "(" [ argument { "," argument } ] ")" | "(" sum ")"
 *     argument   = name "=" sum | sum [ ":" sum ]
 *
 * # begins a comment. Newlines count outside of parentheses only. After an error the reader goes on
 * at the next line of the text that begins with a letter, so that one call finds all errors.
 */
#include "parse.h"

#include <stdbool.h>
#include <string.h>

#include "words.h"

struct reader {
    struct recipe *recipe;
    struct recipe_errors *errors;
    size_t at;
    int parentheses, nesting;
    bool has_failed; /* in this statement */
};

void scarpi_recipe_fail(struct recipe_errors *errors, const struct recipe *recipe,
                        struct recipe_span span, const char *text, const char *member)
{
    struct scarp_recipe_error error = {.from = span.from,
                                       .to = span.to,
                                       .line = 1,
                                       .column = 1,
                                       .text = text,
                                       .member = member,
                                       .nearest = errors->nearest};
    errors->nearest = 0.0;
    for (size_t i = 0; i < span.from; i++) {
        const bool is_end = recipe->text[i] == '\n';
        error.line += is_end;
        error.column = is_end ? 1 : error.column + 1;
    }
    /* They are told in the order of the text, and the first ones if there is no room for all. */
    size_t at = errors->found < errors->capacity ? errors->found : errors->capacity;
    for (; at > 0 && errors->list[at - 1].from > error.from; at--) {
        if (at < errors->capacity) {
            errors->list[at] = errors->list[at - 1];
        }
    }
    if (at < errors->capacity) {
        errors->list[at] = error;
    }
    errors->found++;
}

int scarpi_recipe_is(const struct recipe *recipe, struct recipe_span span, const char *word)
{
    const size_t length = (size_t)(span.to - span.from);
    return strncmp(recipe->text + span.from, word, length) == 0 && word[length] == '\0';
}

int scarpi_recipe_find(const struct recipe *recipe, struct recipe_span name, int count)
{
    const size_t length = (size_t)(name.to - name.from);
    for (int i = count - 1; i >= 0; i--) {
        const struct recipe_span other = recipe->statement[i].name;
        if ((size_t)(other.to - other.from) == length &&
            memcmp(recipe->text + other.from, recipe->text + name.from, length) == 0) {
            return i;
        }
    }
    return -1;
}

static int fail_at(struct reader *r, struct recipe_span span, const char *text)
{
    if (!r->has_failed) {
        r->has_failed = true;
        scarpi_recipe_fail(r->errors, r->recipe, span, text, NULL);
    }
    return -1;
}

static char next(const struct reader *r)
{
    return r->at < (size_t)r->recipe->length ? r->recipe->text[r->at] : '\0';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The word that stands at a byte, which may be empty. */
static struct recipe_span word_at(const struct reader *r, size_t at)
{
    const char *const text = r->recipe->text;
    size_t end = at;
    if (end < (size_t)r->recipe->length && is_letter(text[end])) {
        while (end < (size_t)r->recipe->length && (is_letter(text[end]) || is_digit(text[end]))) {
            end++;
        }
    }
    return (struct recipe_span){(uint16_t)at, (uint16_t)end};
}

/* Says that something else was expected, at the word or byte that is there. */
static int fail(struct reader *r, const char *text)
{
    struct recipe_span span = word_at(r, r->at);
    span.to = (uint16_t)(span.to + (span.to == span.from && next(r) != '\0' && next(r) != '\n'));
    return fail_at(r, span, text);
}

static void skip_space(struct reader *r)
{
    for (;; r->at++) {
        if (next(r) == '#') {
            while (r->at < (size_t)r->recipe->length && next(r) != '\n') {
                r->at++;
            }
        }
        const char c = next(r);
        if (c != ' ' && c != '\t' && c != '\r' && !(c == '\n' && r->parentheses > 0)) {
            return;
        }
    }
}

static bool take(struct reader *r, char c)
{
    skip_space(r);
    if (next(r) != c) {
        return false;
    }
    r->at++;
    skip_space(r);
    return true;
}

static struct recipe_expression *expression(struct reader *r, int e)
{
    return &r->recipe->expression[e];
}

static int new_expression(struct reader *r, enum recipe_expression_type type, size_t from)
{
    struct recipe *const recipe = r->recipe;
    if (recipe->expressions == RECIPE_EXPRESSIONS) {
        r->errors->is_size = 1;
        return fail(r, "a recipe has at most 512 expressions");
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

static void set_operands(struct reader *r, int e, int a, int b)
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

static bool number(struct reader *r, double *value)
{
    const size_t size =
        scarpi_read_number(r->recipe->text + r->at, (size_t)r->recipe->length - r->at, value);
    if (size == 0) {
        fail(r, "expected a number of at most 38 digits, 0 or from 1e-60 to 1e60");
        return false;
    }
    r->at += size;
    if (is_letter(next(r)) || next(r) == '.') {
        fail(r, "a number goes on in a way that numbers do not");
        return false;
    }
    return true;
}

static bool signed_number(struct reader *r, double *value)
{
    skip_space(r);
    const bool is_negative = take(r, '-');
    if (!number(r, value)) {
        return false;
    }
    *value = is_negative ? -*value : *value;
    skip_space(r);
    return true;
}

static int sum(struct reader *r);

static int argument(struct reader *r)
{
    skip_space(r);
    const struct recipe_span name = word_at(r, r->at);
    const size_t from = r->at;
    r->at = name.to;
    if (name.to > name.from && take(r, '=')) {
        const int e = sum(r);
        if (e >= 0) {
            expression(r, e)->argument = name;
        }
        return e;
    }
    r->at = from;
    const int a = sum(r);
    if (a < 0 || !take(r, ':')) {
        return a;
    }
    const int b = sum(r), e = b < 0 ? -1 : new_expression(r, EXPRESSION_KNOT, from);
    if (e >= 0) {
        set_operands(r, e, a, b);
    }
    return e;
}

static int arguments(struct reader *r, int call)
{
    r->at++;
    r->parentheses++;
    skip_space(r);
    int last = -1;
    while (next(r) != ')') {
        if (last >= 0 && !take(r, ',')) {
            return fail(r, "expected , or )");
        }
        const int a = argument(r);
        if (a < 0) {
            return -1;
        }
        expression(r, a)->parent = (int16_t)call;
        *(last < 0 ? &expression(r, call)->a : &expression(r, last)->next) = (int16_t)a;
        last = a;
        skip_space(r);
    }
    r->parentheses--;
    r->at++;
    expression(r, call)->span.to = (uint16_t)r->at;
    return call;
}

static int primary(struct reader *r)
{
    skip_space(r);
    const size_t from = r->at;
    if (is_digit(next(r)) || next(r) == '.') {
        double value;
        const int e = number(r, &value) ? new_expression(r, EXPRESSION_NUMBER, from) : -1;
        if (e >= 0) {
            expression(r, e)->number = value;
        }
        return e;
    }
    if (next(r) == '(') {
        r->parentheses++;
        r->at++;
        const int e = sum(r);
        if (e < 0 || next(r) != ')') {
            return e < 0 ? -1 : fail(r, "expected )");
        }
        r->parentheses--;
        r->at++;
        expression(r, e)->span = (struct recipe_span){(uint16_t)from, (uint16_t)r->at};
        return e;
    }
    const struct recipe_span name = word_at(r, r->at);
    if (name.to == name.from) {
        return fail(r, "expected a number, a name or (");
    }
    r->at = name.to;
    const int e = new_expression(r, EXPRESSION_NAME, from);
    if (e < 0) {
        return -1;
    }
    expression(r, e)->name = name;
    skip_space(r);
    if (next(r) != '(') {
        r->at = name.to;
        return e;
    }
    expression(r, e)->type = EXPRESSION_CALL;
    return arguments(r, e);
}

static int power(struct reader *r)
{
    const int a = primary(r);
    if (a < 0 || !take(r, '^')) {
        return a;
    }
    double exponent;
    if (!number(r, &exponent)) {
        return -1;
    }
    if (exponent != 2.0 && exponent != 3.0 && exponent != 4.0) {
        return fail_at(r, (struct recipe_span){(uint16_t)(r->at - 1), (uint16_t)r->at},
                       "exponents are 2, 3 or 4");
    }
    const int e = new_expression(r, EXPRESSION_POWER, r->at);
    if (e >= 0) {
        set_operands(r, e, a, -1);
        expression(r, e)->exponent = (uint8_t)exponent;
    }
    return e;
}

static int unary(struct reader *r)
{
    skip_space(r);
    const size_t from = r->at;
    bool is_negative = false;
    while (take(r, '-')) {
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
static int operands(struct reader *r, const char signs[2], enum recipe_expression_type first,
                    int (*operand)(struct reader *))
{
    int a = operand(r);
    for (skip_space(r); a >= 0 && (next(r) == signs[0] || next(r) == signs[1]); skip_space(r)) {
        const int type = (int)first + (next(r) == signs[1]);
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

static int product(struct reader *r)
{
    return operands(r, "*/", EXPRESSION_MULTIPLY, unary);
}

static int sum(struct reader *r)
{
    if (r->nesting == RECIPE_NESTING) {
        return fail(r, "parentheses are nested more than 24 deep");
    }
    r->nesting++;
    const int e = operands(r, "+-", EXPRESSION_ADD, product);
    r->nesting--;
    return e;
}

static void set_version(struct reader *r)
{
    double version;
    const struct recipe_span span = word_at(r, r->at);
    if (r->recipe->statements > 0) {
        fail_at(r, span, "the version of the language stands before all else");
    } else if (signed_number(r, &version) && version != 1.0) {
        fail_at(r, (struct recipe_span){span.from, (uint16_t)r->at},
                "this library reads recipes of version 1");
    }
}

static void set_space(struct reader *r)
{
    double dimensions;
    const size_t from = r->at;
    if (r->recipe->statements > 0) {
        fail(r, "space stands before all parameters and fields");
    } else if (signed_number(r, &dimensions) && dimensions != 2.0 && dimensions != 3.0) {
        fail_at(r, (struct recipe_span){(uint16_t)from, (uint16_t)r->at},
                "space has 2 or 3 dimensions");
    } else if (!r->has_failed) {
        r->recipe->dimensions = (uint8_t)dimensions;
    }
}

static void set_tile(struct reader *r)
{
    double *const tile = r->recipe->tile;
    const size_t from = r->at;
    if (r->recipe->statements > 0) {
        fail(r, "tile stands before all parameters and fields");
        return;
    }
    const int count = r->recipe->dimensions;
    for (int i = 0; i < count; i++) {
        if ((i > 0 && !take(r, ',')) || !signed_number(r, &tile[i])) {
            fail(r, "expected a length for each axis, with commas between them");
            return;
        }
        if (!(tile[i] > 0.0)) {
            fail_at(r, (struct recipe_span){(uint16_t)from, (uint16_t)r->at},
                    "lengths of a tile are above 0");
        }
    }
    r->recipe->is_tiled = !r->has_failed;
}

static bool param(struct reader *r, struct recipe_statement *to)
{
    to->lowest = -1e60;
    to->highest = 1e60;
    const size_t from = r->at;
    if (!signed_number(r, &to->value)) {
        return false;
    }
    if (take(r, '[')) {
        if (!signed_number(r, &to->lowest) || !take(r, ',') || !signed_number(r, &to->highest) ||
            !take(r, ']')) {
            fail(r, "expected [lowest, highest]");
        } else if (!(to->lowest <= to->value && to->value <= to->highest)) {
            fail_at(r, (struct recipe_span){(uint16_t)from, (uint16_t)r->at},
                    "the value is outside its interval");
        }
    }
    return !r->has_failed;
}

static bool name_is_free(struct reader *r, struct recipe_span name)
{
    static const char *const reserved[] = {"recipe", "space", "tile", "param", "out",
                                           "x",      "y",     "z",    "finest"};
    if (name.to == name.from) {
        return fail(r, "expected a name"), false;
    }
    for (size_t i = 0; i < sizeof reserved / sizeof reserved[0]; i++) {
        if (scarpi_recipe_is(r->recipe, name, reserved[i])) {
            return fail_at(r, name, "this name has a meaning of its own"), false;
        }
    }
    if (scarpi_recipe_function_of(r->recipe, name) >= 0) {
        return fail_at(r, name, "this is the name of a function"), false;
    }
    if (scarpi_recipe_find(r->recipe, name, r->recipe->statements) >= 0) {
        return fail_at(r, name, "this name is given above"), false;
    }
    return true;
}

/* name = ..., behind `param`, `out` or nothing */
static void assignment(struct reader *r, size_t from, enum recipe_statement_type type,
                       bool is_output)
{
    struct recipe *const recipe = r->recipe;
    const struct recipe_span name = word_at(r, r->at);
    struct recipe_statement made = {
        .name = name, .expression = -1, .type = (uint8_t)type, .is_output = is_output};
    if (!name_is_free(r, name)) {
        return;
    }
    if (recipe->statements == RECIPE_STATEMENTS) {
        r->errors->is_size = 1;
        fail_at(r, name, "a recipe has at most 96 names");
        return;
    }
    r->at = name.to;
    if (!take(r, '=')) {
        fail(r, "expected =");
    } else if (type == STATEMENT_PARAM) {
        (void)param(r, &made);
    } else {
        made.expression = (int16_t)sum(r);
    }
    skip_space(r);
    if (!r->has_failed && next(r) != '\n' && r->at < (size_t)recipe->length) {
        fail(r, "expected an operator or the end of the line");
    }
    if (r->has_failed) {
        made.expression = -1;
        made.type = STATEMENT_FIELD; /* so that its uses are no news */
    }
    made.span = (struct recipe_span){(uint16_t)from, (uint16_t)r->at};
    recipe->statement[recipe->statements++] = made;
}

static void statement(struct reader *r)
{
    const size_t from = r->at;
    const struct recipe_span word = word_at(r, r->at);
    if (word.to == word.from) {
        fail(r, "expected a name = expression");
        return;
    }
    size_t after = word.to;
    while (after < (size_t)r->recipe->length && r->recipe->text[after] == ' ') {
        after++;
    }
    static const char *const settings[] = {"recipe", "space", "tile"};
    static void (*const set[])(struct reader *) = {set_version, set_space, set_tile};
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (scarpi_recipe_is(r->recipe, word, settings[i])) {
            r->at = after;
            set[i](r);
            skip_space(r);
            if (!r->has_failed && next(r) != '\n' && r->at < (size_t)r->recipe->length) {
                fail(r, "expected the end of the line");
            }
            return;
        }
    }
    const bool is_param = scarpi_recipe_is(r->recipe, word, "param");
    const bool is_output = scarpi_recipe_is(r->recipe, word, "out");
    if (is_param || is_output) {
        r->at = after;
    }
    assignment(r, from, is_param ? STATEMENT_PARAM : STATEMENT_FIELD, is_output);
}

/* Behind a statement with an error: the next line that begins with a letter */
static void recover(struct reader *r, size_t from)
{
    const char *const text = r->recipe->text;
    for (r->at = from; r->at < (size_t)r->recipe->length; r->at++) {
        if (text[r->at] == '\n' && is_letter(text[r->at + 1])) {
            return;
        }
    }
}

static void set_outputs(struct reader *r)
{
    struct recipe *const recipe = r->recipe;
    int last = -1;
    for (int i = 0; i < recipe->statements; i++) {
        last = recipe->statement[i].type == STATEMENT_FIELD ? i : last;
        if (!recipe->statement[i].is_output) {
            continue;
        }
        if (recipe->outputs == RECIPE_OUTPUTS) {
            r->errors->is_size = 1;
            scarpi_recipe_fail(r->errors, recipe, recipe->statement[i].name,
                               "a recipe has at most 16 outputs", NULL);
            return;
        }
        recipe->output[recipe->outputs++] = (int16_t)i;
    }
    if (recipe->outputs == 0 && last >= 0) {
        recipe->output[recipe->outputs++] = (int16_t)last;
        recipe->statement[last].is_output = 1;
    }
    if (recipe->outputs == 0 && r->errors->found == 0) {
        const struct recipe_span end = {(uint16_t)recipe->length, (uint16_t)recipe->length};
        scarpi_recipe_fail(r->errors, recipe, end, "a recipe needs a name = expression", NULL);
    }
}

void scarpi_recipe_read(struct recipe *recipe, struct recipe_errors *errors)
{
    struct reader r = {.recipe = recipe, .errors = errors};
    bool is_first = true;
    recipe->dimensions = 2;
    for (;;) {
        skip_space(&r);
        if (next(&r) == '\n') {
            r.at++;
            continue;
        }
        if (r.at >= (size_t)recipe->length) {
            break;
        }
        const size_t from = r.at;
        r.has_failed = false;
        if (is_first && !scarpi_recipe_is(recipe, word_at(&r, from), "recipe")) {
            fail(&r, "a recipe begins with its version: recipe 1");
            r.has_failed = false;
        }
        is_first = false;
        statement(&r);
        r.parentheses = r.nesting = 0;
        if (r.has_failed) {
            recover(&r, from);
        }
    }
    set_outputs(&r);
}
