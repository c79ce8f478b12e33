/* SPDX-License-Identifier: MIT
 *
 * Finds fields in CSV (RFC 4180, one line per record, whatever the delimiter) and in text.
 */
#include "sample/field.h"

#include <string.h>

#include "shared/bounds.h"
#include "shared/number.h"

#define NUMBER_MOST 128 /* bytes of a number with a decimal comma */

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

const char *field_skip_blanks(const char *at)
{
    while (is_blank(*at)) {
        at++;
    }
    return at;
}

/* Past blanks that are not the delimiter */
static const char *skip_blanks(const char *at, char delimiter)
{
    while (is_blank(*at) && *at != delimiter) {
        at++;
    }
    return at;
}

static void trim(struct field *field, char delimiter)
{
    field->begin = skip_blanks(field->begin, delimiter);
    if (field->end < field->begin) { /* nothing but blanks, and the loop above ran on */
        field->end = field->begin;
    }
    while (field->end > field->begin && is_blank(field->end[-1])) {
        field->end--;
    }
}

/* After the quote that ends what begins at `at`; NULL: there is none. Two are a quote inside. */
static const char *after_quotes(const char *at)
{
    for (;;) {
        at = strchr(at, '"');
        if (at == NULL || at[1] != '"') {
            return at != NULL ? at + 1 : NULL;
        }
        at += 2;
    }
}

static struct field field_between(const char *at, char delimiter)
{
    const char ends[] = {delimiter, '\0'};
    struct field field = {.begin = skip_blanks(at, delimiter)};
    const char *after = field.begin;
    if (*field.begin == '"') {
        field.quoted = true;
        field.begin++;
        after = after_quotes(field.begin);
        if (after == NULL) {
            field.end = field.begin;
            field.problem = "has a quote that is not closed";
            return field;
        }
        field.end = after - 1;
        after = skip_blanks(after, delimiter);
        if (*after != delimiter && *after != '\0') {
            field.problem = "goes on after its quotes";
            return field;
        }
    } else {
        after += strcspn(after, ends);
        field.end = after;
    }
    trim(&field, delimiter);
    field.next = *after == delimiter && *after != '\0' ? after + 1 : NULL;
    return field;
}

struct field field_csv(const char *at)
{
    return field_between(at, ',');
}

struct field field_semicolon(const char *at)
{
    return field_between(at, ';');
}

struct field field_tab(const char *at)
{
    return field_between(at, '\t');
}

const char *field_after(const struct field *field, const char *at)
{
    return at + (field->quoted && *at == '"' ? 2 : 1);
}

bool field_number(const struct field *field, bool commas, double *value, char *mark)
{
    char copy[NUMBER_MOST];
    const char *begin = field->begin, *end = field->end;
    const size_t length = (size_t)(end - begin);
    const char *const comma = commas ? memchr(begin, ',', length) : NULL;
    *mark = memchr(begin, '.', length) != NULL ? '.' : '\0';
    if (comma != NULL) {
        if (*mark != '\0' || comma == begin || comma + 1 == end || !is_digit(comma[-1]) ||
            !is_digit(comma[1]) || length >= sizeof copy) {
            return false;
        }
        memcpy(copy, begin, length);
        copy[length] = '\0';
        copy[comma - begin] = '.';
        begin = copy;
        end = copy + length;
        *mark = ',';
    }
    return begin != end && number_read(begin, value) == end;
}

static char small(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool field_same(const struct field *a, const struct field *b)
{
    const char *p = a->begin, *q = b->begin;
    while (p < a->end && q < b->end && small(*p) == small(*q)) {
        p = field_after(a, p);
        q = field_after(b, q);
    }
    return p == a->end && q == b->end;
}

/* UTF-8 is not cut within a character. */
const char *field_show(const struct field *field, char shown[FIELD_SHOWN])
{
    size_t length = 0;
    const char *at = field->begin;
    for (; at < field->end && length < FIELD_SHOWN - 1; at = field_after(field, at)) {
        shown[length++] = *at;
    }
    if (at < field->end && ((unsigned char)*at & 0xc0) == 0x80) {
        while (length > 0 && ((unsigned char)shown[length - 1] & 0xc0) == 0x80) {
            length--;
        }
        length -= length > 0;
    }
    shown[length] = '\0';
    return shown;
}

struct field field_text(const char *at)
{
    struct field field = {.begin = field_skip_blanks(at)};
    field.end = field.begin + strcspn(field.begin, " \t");
    const char *const next = field_skip_blanks(field.end);
    field.next = *next != '\0' ? next : NULL;
    return field;
}
