/* SPDX-License-Identifier: MIT
 *
 * Words, signs and numbers of a text, and errors at them.
 */
#include "reader.h"

int scarpi_reader_fail_at(struct recipe_reader *r, struct recipe_span span, const char *text)
{
    if (!r->has_failed) {
        r->has_failed = true;
        scarpi_recipe_fail(r->errors, r->recipe, span, text, NULL);
    }
    return -1;
}

struct recipe_span scarpi_reader_word(const struct recipe_reader *r, size_t at)
{
    const char *const text = r->recipe->text;
    size_t end = at;
    if (end < (size_t)r->recipe->length && reader_is_letter(text[end])) {
        while (end < (size_t)r->recipe->length &&
               (reader_is_letter(text[end]) || reader_is_digit(text[end]))) {
            end++;
        }
    }
    return (struct recipe_span){(uint16_t)at, (uint16_t)end};
}

int scarpi_reader_fail(struct recipe_reader *r, const char *text)
{
    struct recipe_span span = scarpi_reader_word(r, r->at);
    span.to = (uint16_t)(span.to + (span.to == span.from && reader_next(r) != '\0' &&
                                    reader_next(r) != '\n'));
    return scarpi_reader_fail_at(r, span, text);
}

void scarpi_reader_skip(struct recipe_reader *r)
{
    for (;; r->at++) {
        if (reader_next(r) == '#') {
            while (r->at < (size_t)r->recipe->length && reader_next(r) != '\n') {
                r->at++;
            }
        }
        const char c = reader_next(r);
        if (c != ' ' && c != '\t' && c != '\r' && !(c == '\n' && r->parentheses > 0)) {
            return;
        }
    }
}

bool scarpi_reader_take(struct recipe_reader *r, char sign)
{
    scarpi_reader_skip(r);
    if (reader_next(r) != sign) {
        return false;
    }
    r->at++;
    scarpi_reader_skip(r);
    return true;
}

bool scarpi_reader_number(struct recipe_reader *r, double *value)
{
    const size_t size =
        scarpi_read_number(r->recipe->text + r->at, (size_t)r->recipe->length - r->at, value);
    if (size == 0) {
        scarpi_reader_fail(r, "expected a number of at most 38 digits, 0 or from 1e-60 to 1e60");
        return false;
    }
    r->at += size;
    if (reader_is_letter(reader_next(r)) || reader_next(r) == '.') {
        scarpi_reader_fail(r, "unexpected letter or point after a number");
        return false;
    }
    return true;
}

bool scarpi_reader_signed(struct recipe_reader *r, double *value)
{
    scarpi_reader_skip(r);
    const bool is_negative = scarpi_reader_take(r, '-');
    if (!scarpi_reader_number(r, value)) {
        return false;
    }
    *value = is_negative ? -*value : *value;
    scarpi_reader_skip(r);
    return true;
}
