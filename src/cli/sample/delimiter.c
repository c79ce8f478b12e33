/* SPDX-License-Identifier: MIT
 *
 * What separates the columns of a file, found from its first row. A comma may be the decimal mark
 * of a number, so what is between the delimiters decides: coordinates, or the names of their
 * columns.
 */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "sample/points.h"

static const struct {
    const char *word;
    char character;
    field_fn *field;
} delimiters[] = {
    [DELIMITER_COMMA] = {"comma", ',', field_csv},
    [DELIMITER_SEMICOLON] = {"semicolon", ';', field_semicolon},
    [DELIMITER_TAB] = {"tab", '\t', field_tab},
    [DELIMITER_SPACE] = {"space", ' ', field_text},
    [DELIMITER_UNKNOWN] = {NULL, '\0', NULL},
};

field_fn *delimiter_field(int delimiter)
{
    return delimiters[delimiter].field;
}

char delimiter_character(int delimiter)
{
    return delimiters[delimiter].character;
}

const char *delimiter_word(int delimiter)
{
    return delimiters[delimiter].word;
}

bool delimiter_is_number(const struct field *field, int delimiter)
{
    char *end, mark;
    double value;
    strtod(field->begin, &end);
    return (end == field->end && end != field->begin) ||
           field_number(field, delimiter != DELIMITER_COMMA, &value, &mark);
}

/* Which characters of delimiters a row has, as bits: those outside quotes, if there are any */
static unsigned find_characters(const char *row)
{
    unsigned found[2] = {0, 0};
    bool is_quoted = false;
    for (; *row != '\0'; row++) {
        is_quoted ^= *row == '"';
        for (unsigned d = 0; d < DELIMITER_SPACE; d++) {
            found[is_quoted] |= *row == delimiters[d].character ? 1u << d : 0;
        }
    }
    return found[0] != 0 ? found[0] : found[1];
}

/* The fields of the coordinates: those that --columns numbers, or the first two. Returns how many
   of them there are, and sets *numbers to how many are numbers, *marks to their decimal marks. */
static size_t count_numbers(const char *row, const struct columns *chosen, int delimiter,
                            size_t *numbers, unsigned *marks)
{
    size_t column[COLUMNS_AXES], found = 0;
    const size_t wanted = chosen->count > 0 && chosen->numbered ? chosen->count : 2;
    columns_by_number(chosen, column);
    *numbers = 0;
    *marks = 0;
    for (size_t i = 0; row != NULL; i++) {
        const struct field field = delimiters[delimiter].field(row);
        for (size_t axis = 0; axis < wanted; axis++) {
            double value;
            char mark = '\0';
            if (column[axis] != i) {
                continue;
            }
            found++;
            *numbers += delimiter_is_number(&field, delimiter) ? 1 : 0;
            (void)field_number(&field, delimiter != DELIMITER_COMMA, &value, &mark);
            *marks |= mark == '.' ? 1 : mark == ',' ? 2 : 0;
        }
        row = field.next;
    }
    return found == wanted ? found : 0;
}

/* Whether the coordinates are numbers, with one kind of decimal mark */
static bool is_point(const char *row, const struct columns *chosen, int delimiter)
{
    size_t numbers;
    unsigned marks;
    const size_t found = count_numbers(row, chosen, delimiter, &numbers, &marks);
    return found > 0 && numbers == found && marks != 3;
}

static bool is_named(const char *row, const struct columns *chosen, int delimiter)
{
    const struct columns_header header = {.row = row, .field = delimiters[delimiter].field};
    return columns_are_named(chosen, &header);
}

static bool is_plain(const char *row, const struct columns *chosen, int delimiter)
{
    return is_point(row, chosen, delimiter) || is_named(row, chosen, delimiter);
}

/* Whether a row with tabs is one of names, which blanks may be part of */
static bool has_names(const char *row, const struct columns *chosen)
{
    size_t numbers;
    unsigned marks;
    return is_named(row, chosen, DELIMITER_TAB) ||
           (count_numbers(row, chosen, DELIMITER_TAB, &numbers, &marks) > 0 && numbers == 0);
}

/* Where the field of a column begins, counted from 0; NULL: there are fewer */
static const char *begin_of(const char *row, size_t column, int delimiter)
{
    struct field field = {.begin = NULL, .next = row};
    for (size_t i = 0; i <= column; i++) {
        if (field.next == NULL) {
            return NULL;
        }
        field = delimiters[delimiter].field(field.next);
    }
    return field.begin;
}

/* Whether tabs and blanks put the coordinates into the same fields */
static bool is_same_with_tabs(const char *row, const struct columns *chosen)
{
    size_t column[COLUMNS_AXES];
    const size_t wanted = chosen->count > 0 && chosen->numbered ? chosen->count : 2;
    columns_by_number(chosen, column);
    for (size_t axis = 0; axis < wanted; axis++) {
        if (begin_of(row, column[axis], DELIMITER_TAB) !=
            begin_of(row, column[axis], DELIMITER_SPACE)) {
            return false;
        }
    }
    return true;
}

/* What separates a row that has tabs and no commas. Fields may have blanks in them, and columns
   may be aligned by several tabs. */
static enum points_delimiter with_tabs(const char *row, const struct columns *chosen)
{
    const bool is_tab = is_point(row, chosen, DELIMITER_TAB);
    const bool is_space = is_point(row, chosen, DELIMITER_SPACE);
    if (is_tab && is_space) {
        return is_same_with_tabs(row, chosen) ? DELIMITER_SPACE : DELIMITER_UNKNOWN;
    }
    return is_tab || has_names(row, chosen) ? DELIMITER_TAB : DELIMITER_SPACE;
}

enum points_delimiter delimiter_of(const char *row, const struct columns *chosen, int format)
{
    const unsigned found = find_characters(row);
    const bool has_comma = (found >> DELIMITER_COMMA & 1) != 0;
    const bool has_tab = (found >> DELIMITER_TAB & 1) != 0;
    const bool may_be_text = format != POINTS_CSV;
    if ((found >> DELIMITER_SEMICOLON & 1) != 0) {
        const bool is_comma = has_comma && is_plain(row, chosen, DELIMITER_COMMA);
        const bool is_semicolon = !has_comma || is_plain(row, chosen, DELIMITER_SEMICOLON);
        return is_comma == is_semicolon ? DELIMITER_UNKNOWN
               : is_comma               ? DELIMITER_COMMA
                                        : DELIMITER_SEMICOLON;
    }
    if (has_comma) { /* between numbers, or in them */
        return is_plain(row, chosen, DELIMITER_COMMA)                  ? DELIMITER_COMMA
               : may_be_text && is_point(row, chosen, DELIMITER_SPACE) ? DELIMITER_SPACE
               : has_tab && is_plain(row, chosen, DELIMITER_TAB)       ? DELIMITER_TAB
                                                                       : DELIMITER_COMMA;
    }
    if (has_tab) {
        return may_be_text ? with_tabs(row, chosen) : DELIMITER_TAB;
    }
    return may_be_text ? DELIMITER_SPACE : DELIMITER_COMMA;
}
