/* SPDX-License-Identifier: MIT
 *
 * From a text to statements:
 *
 *     recipe     = { statement newline }
 *     statement  = "recipe" number
 *                | "space" number
 *                | "tile" number "," number [ "," number ]
 *                | "param" name "=" signed [ "[" signed "," signed "]" ]
 *                | [ "out" ] name "=" expression
 *
 * # begins a comment. Newlines end a statement outside of parentheses only. After an error the
 * reader goes on at the next line of the text that begins with a letter, so that one call finds all
 * errors.
 */

#include "reader.h"
#include "words.h"

static void set_version(struct recipe_reader *r)
{
    double version;
    const struct recipe_span span = scarpi_reader_word(r, r->at);
    if (r->recipe->statements > 0) {
        scarpi_reader_fail_at(r, span, "the version must come before everything else");
    } else if (scarpi_reader_signed(r, &version) && version != 1.0) {
        scarpi_reader_fail_at(r, (struct recipe_span){span.from, (uint16_t)r->at},
                              "this library reads recipes of version 1");
    }
}

static void set_space(struct recipe_reader *r)
{
    double dimensions;
    const size_t from = r->at;
    if (r->recipe->statements > 0) {
        scarpi_reader_fail(r, "space must come before all parameters and fields");
    } else if (scarpi_reader_signed(r, &dimensions) && dimensions != 2.0 && dimensions != 3.0) {
        scarpi_reader_fail_at(r, (struct recipe_span){(uint16_t)from, (uint16_t)r->at},
                              "space must have 2 or 3 dimensions");
    } else if (!r->has_failed) {
        r->recipe->dimensions = (uint8_t)dimensions;
    }
}

static void set_tile(struct recipe_reader *r)
{
    double *const tile = r->recipe->tile;
    const size_t from = r->at;
    if (r->recipe->statements > 0) {
        scarpi_reader_fail(r, "tile must come before all parameters and fields");
        return;
    }
    const int count = r->recipe->dimensions;
    for (int i = 0; i < count; i++) {
        if ((i > 0 && !scarpi_reader_take(r, ',')) || !scarpi_reader_signed(r, &tile[i])) {
            scarpi_reader_fail(r, "expected a length for each axis, separated by commas");
            return;
        }
        if (!(tile[i] > 0.0)) {
            scarpi_reader_fail_at(r, (struct recipe_span){(uint16_t)from, (uint16_t)r->at},
                                  "the lengths of a tile must be above 0");
        }
    }
    r->recipe->is_tiled = !r->has_failed;
}

static bool param(struct recipe_reader *r, struct recipe_statement *to)
{
    to->lowest = -1e60;
    to->highest = 1e60;
    const size_t from = r->at;
    if (!scarpi_reader_signed(r, &to->value)) {
        return false;
    }
    if (scarpi_reader_take(r, '[')) {
        if (!scarpi_reader_signed(r, &to->lowest) || !scarpi_reader_take(r, ',') ||
            !scarpi_reader_signed(r, &to->highest) || !scarpi_reader_take(r, ']')) {
            scarpi_reader_fail(r, "expected [lowest, highest]");
        } else if (!(to->lowest <= to->value && to->value <= to->highest)) {
            scarpi_reader_fail_at(r, (struct recipe_span){(uint16_t)from, (uint16_t)r->at},
                                  "the value is outside its interval");
        }
    }
    return !r->has_failed;
}

static bool name_is_free(struct recipe_reader *r, struct recipe_span name)
{
    static const char *const reserved[] = {"recipe", "space", "tile", "param", "out",
                                           "x",      "y",     "z",    "finest"};
    if (name.to == name.from) {
        scarpi_reader_fail(r, "expected a name");
        return false;
    }
    for (size_t i = 0; i < sizeof reserved / sizeof reserved[0]; i++) {
        if (scarpi_recipe_is(r->recipe, name, reserved[i])) {
            scarpi_reader_fail_at(r, name, "this name is reserved");
            return false;
        }
    }
    if (scarpi_recipe_function_of(r->recipe, name) >= 0) {
        scarpi_reader_fail_at(r, name, "this is the name of a function");
        return false;
    }
    if (scarpi_recipe_find(r->recipe, name, r->recipe->statements) >= 0) {
        scarpi_reader_fail_at(r, name, "this name is already defined above");
        return false;
    }
    return true;
}

static void expect_end(struct recipe_reader *r, const char *text)
{
    scarpi_reader_skip(r);
    if (!r->has_failed && reader_next(r) != '\n' && r->at < (size_t)r->recipe->length) {
        scarpi_reader_fail(r, text);
    }
}

/* name = ..., after `param`, `out` or nothing */
static void assignment(struct recipe_reader *r, size_t from, enum recipe_statement_type type,
                       bool is_output)
{
    struct recipe *const recipe = r->recipe;
    const struct recipe_span name = scarpi_reader_word(r, r->at);
    struct recipe_statement made = {
        .name = name, .expression = -1, .type = (uint8_t)type, .is_output = is_output};
    if (!name_is_free(r, name)) {
        return;
    }
    if (recipe->statements == RECIPE_STATEMENTS) {
        r->errors->is_size = 1;
        scarpi_reader_fail_at(r, name, "a recipe has at most 96 names");
        return;
    }
    r->at = name.to;
    if (!scarpi_reader_take(r, '=')) {
        scarpi_reader_fail(r, "expected =");
    } else if (type == STATEMENT_PARAM) {
        (void)param(r, &made);
    } else {
        made.expression = (int16_t)scarpi_reader_expression(r);
    }
    expect_end(r, "expected an operator or the end of the line");
    if (r->has_failed) {
        made.expression = -1;
        made.type = STATEMENT_FIELD; /* its uses are no further errors */
    }
    made.span = (struct recipe_span){(uint16_t)from, (uint16_t)r->at};
    recipe->statement[recipe->statements++] = made;
}

static void statement(struct recipe_reader *r)
{
    const size_t from = r->at;
    const struct recipe_span word = scarpi_reader_word(r, r->at);
    if (word.to == word.from) {
        scarpi_reader_fail(r, "expected a name = expression");
        return;
    }
    size_t after = word.to;
    while (after < (size_t)r->recipe->length && r->recipe->text[after] == ' ') {
        after++;
    }
    static const char *const settings[] = {"recipe", "space", "tile"};
    static void (*const set[])(struct recipe_reader *) = {set_version, set_space, set_tile};
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (scarpi_recipe_is(r->recipe, word, settings[i])) {
            r->at = after;
            set[i](r);
            expect_end(r, "expected the end of the line");
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

/* After a statement with an error, goes to the next line that begins with a letter. */
static void recover(struct recipe_reader *r, size_t from)
{
    const char *const text = r->recipe->text;
    for (r->at = from; r->at < (size_t)r->recipe->length; r->at++) {
        if (text[r->at] == '\n' && reader_is_letter(text[r->at + 1])) {
            return;
        }
    }
}

static void set_outputs(struct recipe_reader *r)
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
    struct recipe_reader r = {.recipe = recipe, .errors = errors};
    bool is_first = true;
    recipe->dimensions = 2;
    for (;;) {
        scarpi_reader_skip(&r);
        if (reader_next(&r) == '\n') {
            r.at++;
            continue;
        }
        if (r.at >= (size_t)recipe->length) {
            break;
        }
        const size_t from = r.at;
        r.has_failed = false;
        if (is_first && !scarpi_recipe_is(recipe, scarpi_reader_word(&r, from), "recipe")) {
            scarpi_reader_fail(&r, "a recipe begins with its version: recipe 1");
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
