/* SPDX-License-Identifier: MIT
 *
 * Points from lines: CSV, with whatever delimiter, or columns with blanks between them. Lines are
 * found, ended with a NUL and read where the input put them; a batch ends early rather than wait
 * for the rest of a line.
 */
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sample/points.h"
#include "shared/error.h"

enum line_state {
    LINE_READY,
    LINE_LATER, /* the rest of it is still to come */
    LINE_NONE   /* the input ended or failed */
};

/* The line at hand is what lies between the unused bytes' start and `end`. */
static enum line_state take_line(struct points_text *text, struct input *input, size_t end)
{
    text->line = input->bytes + input->start;
    text->length = end - input->start;
    if (text->length > 0 && text->line[text->length - 1] == '\r') {
        text->length--;
    }
    text->line[text->length] = '\0';
    text->overlong = text->cut || text->length > POINTS_LINE_MAX;
    text->cut = false;
    input->start = end < input->end ? end + 1 : end;
    text->searched = 0;
    text->number++;
    return LINE_READY;
}

/* Finds the next line, and waits for it if need be and wanted. */
static enum line_state next_line(struct points_text *text, struct input *input, bool wait)
{
    if (text->pending) {
        text->pending = false;
        return LINE_READY;
    }
    for (;;) {
        const size_t unused = input->end - input->start;
        const char *const newline =
            memchr(input->bytes + input->start + text->searched, '\n', unused - text->searched);
        if (newline != NULL) {
            return take_line(text, input, (size_t)(newline - input->bytes));
        }
        text->searched = unused;
        if (unused > POINTS_LINE_MAX + 1) {
            /* One byte stays, to tell whether it is a comment. */
            text->cut = true;
            input->bytes[input->end - 1] = input->bytes[input->start];
            input->start = input->end - 1;
            text->searched = 1;
        }
        if (!wait) {
            return LINE_LATER;
        }
        if (!input_more(input)) {
            return input->end > input->start && input->error == 0
                       ? take_line(text, input, input->end)
                       : LINE_NONE;
        }
    }
}

/* Like next_line, but a line that holds something */
static enum line_state next_row(struct points *points, bool wait)
{
    for (;;) {
        const enum line_state state = next_line(&points->text, &points->input, wait);
        const char *const line = points->text.line;
        if (state != LINE_READY) {
            return state;
        }
        const bool blank = *field_skip_blanks(line) == '\0' && points->text.length == strlen(line);
        if (line[0] != '#' && (!blank || points->text.overlong)) {
            return LINE_READY;
        }
    }
}

/* The line at hand is malformed: notes why, or counts it if such lines are left out. */
#if defined(__clang__) || (defined(__GNUC__) && !defined(_WIN32))
__attribute__((format(printf, 2, 3)))
#endif
static bool
wrong(struct points *points, const char *format, ...)
{
    if (points->skip_bad) {
        points->malformed++;
        return false;
    }
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(points->text.problem, sizeof points->text.problem, format, arguments);
    va_end(arguments);
    return false;
}

static int tell_problem(const struct points *points)
{
    cli_error("--input: %s:%llu: %s", points->input.name, (unsigned long long)points->text.number,
              points->text.problem);
    return CLI_USAGE;
}

/* The precision that shows at most 60 bytes of a field */
static int shown(const struct field *field)
{
    return field->end - field->begin < 60 ? (int)(field->end - field->begin) : 60;
}

/* Whether a field looks as if something else separated columns: a semicolon, or in quotes a decimal
   comma */
static bool has_other_delimiter(const struct points *points, const struct field *field)
{
    const size_t length = (size_t)(field->end - field->begin);
    return points->delimiter == DELIMITER_COMMA &&
           (memchr(field->begin, ';', length) != NULL || memchr(field->begin, ',', length) != NULL);
}

/* Where commas separate nothing, they may be decimal marks, but all numbers have the same mark:
   `1,234` next to `5.6` may be a thousand. *decimal is the mark so far. */
static bool read_coordinate(struct points *points, const struct field *field, size_t column,
                            char *decimal, double *value)
{
    char mark;
    const bool commas = points->delimiter != DELIMITER_COMMA;
    if (field_number(field, commas, value, &mark) && fabs(*value) <= DBL_MAX) {
        if (mark != '\0' && *decimal != '\0' && mark != *decimal) {
            return wrong(points, "column %zu: '%.*s' has a decimal %s, and numbers before a %s",
                         column, shown(field), field->begin, mark == ',' ? "comma" : "point",
                         mark == ',' ? "point" : "comma");
        }
        *decimal = mark != '\0' ? mark : *decimal;
        return true;
    }
    if (field->begin == field->end) {
        return wrong(points, "column %zu is empty", column);
    }
    return wrong(points, "column %zu: '%.*s' is not a finite number%s", column, shown(field),
                 field->begin, has_other_delimiter(points, field) ? " (see --delimiter)" : "");
}

/* Whether blanks can separate the field from others */
static bool is_plain(const struct field *field)
{
    const char *c = field->begin;
    while (c < field->end && *c != ' ' && *c != '\t') {
        c++;
    }
    return c == field->end && c > field->begin;
}

static size_t count_columns(field_fn *next_field, const char *line)
{
    size_t columns = 0;
    while (line != NULL) {
        line = next_field(line).next;
        columns++;
    }
    return columns;
}

/* Whether further columns do not matter. Behind a header row a line with more columns than names,
   or fewer, is malformed: the coordinates may have moved. */
static bool is_ragged(const struct points *points)
{
    return points->told && !points->keep && points->header == NULL;
}

static bool check_columns(struct points *points, size_t columns)
{
    const char *const s = columns == 1 ? "" : "s";
    const char *const line = points->text.line;
    const size_t needed = columns_needed(points->column, points->dims);
    if (points->columns != 0 && columns != points->columns && !is_ragged(points)) {
        return wrong(points, "%zu column%s, but the first line has %zu: '%.60s'", columns, s,
                     points->columns, line);
    }
    if (points->told && columns < needed) {
        return wrong(points, "%zu column%s, but %s %zu: '%.60s'", columns, s,
                     points->chosen.count > 0 ? "--columns takes column" : "--dims is", needed,
                     line);
    }
    if (!points->told && (columns < 2 || columns > 3)) {
        return wrong(points, "%zu column%s, but a point has 2 or 3%s: '%.60s'", columns, s,
                     columns > 3 ? " (see --columns)" : " (see --delimiter)", line);
    }
    return true;
}

/* The axis whose coordinates are in a column, counted from 0; -1: none of the first `dims` */
static int axis_of(const struct points *points, size_t column, int dims)
{
    int axis = dims - 1;
    while (axis >= 0 && points->column[axis] != column) {
        axis--;
    }
    return axis;
}

/* Reads a point from the line at hand. False if that is malformed. */
static bool read_point(struct points *points, double position[3])
{
    const struct points_text *const text = &points->text;
    if (text->overlong) {
        return wrong(points, "longer than %d bytes", POINTS_LINE_MAX);
    }
    if (strlen(text->line) != text->length) {
        return wrong(points, "holds a NUL byte");
    }
    if (points->dims == 0 && !check_columns(points, count_columns(points->field, text->line))) {
        return false;
    }
    const size_t enough =
        is_ragged(points) ? columns_needed(points->column, points->dims) : SIZE_MAX;
    const int dims = points->dims != 0 ? points->dims : 3;
    size_t columns = 0;
    char decimal = points->decimal;
    for (const char *at = text->line; at != NULL && columns < enough;) {
        const struct field field = points->field(at);
        const int axis = axis_of(points, columns++, dims);
        if (field.problem != NULL) {
            return wrong(points, "column %zu %s", columns, field.problem);
        }
        if (axis >= 0 && !read_coordinate(points, &field, columns, &decimal, &position[axis])) {
            return false;
        }
        if (points->plain && !is_plain(&field)) {
            return wrong(points, "column %zu: '%.*s' cannot be a column of text", columns,
                         shown(&field), field.begin);
        }
        at = field.next;
    }
    if (!check_columns(points, columns)) {
        return false;
    }
    points->decimal = decimal;
    return true;
}

static bool is_readable(const struct points_text *text)
{
    return !text->overlong && strlen(text->line) == text->length;
}

/* Whether the row at hand is a header, unless --columns has names: of the fields that it numbers,
   or else the first two, none is a number, not even one that a point cannot have, such as "nan".
   Years may be names too: "1990,2000,x,y" is a header unless --columns says that it is not. */
static bool is_header(const struct points *points)
{
    const struct columns *const chosen = &points->chosen;
    const int dims = chosen->count > 0 ? (int)chosen->count : 2;
    int found = 0;
    const char *at = points->text.line;
    if (!is_readable(&points->text)) {
        return false;
    }
    const struct columns_header header = {points->input.name, at, points->field};
    if (chosen->count == 0 && columns_are_named(chosen, &header)) {
        return true;
    }
    for (size_t column = 0; at != NULL && found < dims; column++) {
        const struct field field = points->field(at);
        if (axis_of(points, column, dims) >= 0) {
            found++;
            if (delimiter_is_number(&field, points->delimiter)) {
                return false;
            }
        }
        at = field.next;
    }
    return chosen->count > 0 ? found > 0 : found == dims;
}

/* Takes the row at hand for a header, whose names tell where the coordinates are. */
static int take_header(struct points *points)
{
    const struct points_text *const text = &points->text;
    const struct columns_header header = {points->input.name, text->line, points->field};
    points->dims = columns_in_header(&points->chosen, &header, points->dims, points->column);
    if (points->dims == 0) {
        return CLI_USAGE;
    }
    points->told = true;
    points->header = malloc(text->length + 1);
    if (points->header == NULL) {
        cli_error("no memory for a line of %zu bytes", text->length);
        return CLI_FAILURE;
    }
    memcpy(points->header, text->line, text->length + 1);
    points->columns = count_columns(points->field, text->line);
    return CLI_SUCCESS;
}

/* Finds out what separates columns, from the first row. Two that both may, or neither, are not
   chosen from. */
static int find_delimiter(struct points *points)
{
    const struct points_text *const text = &points->text;
    if (points->delimiter == DELIMITER_UNKNOWN) {
        points->delimiter = points->format == POINTS_TEXT
                                ? DELIMITER_SPACE
                                : (int)delimiter_of(text->line, &points->chosen, points->format);
    }
    if (points->delimiter == DELIMITER_UNKNOWN) {
        const bool has_semicolon = strchr(text->line, ';') != NULL;
        cli_error("--delimiter: %s:%llu has %s: '%.60s'; which of them separates columns, %s?",
                  points->input.name, (unsigned long long)text->number,
                  has_semicolon ? "commas and semicolons" : "tabs and blanks", text->line,
                  has_semicolon ? "comma or semicolon" : "tab or space");
        return CLI_USAGE;
    }
    points->format = points->delimiter == DELIMITER_SPACE ? POINTS_TEXT : POINTS_CSV;
    points->field = delimiter_field(points->delimiter);
    return CLI_SUCCESS;
}

/* Takes the first row, which is at hand. Where --columns has names, it must be their header. */
static int begin_rows(struct points *points)
{
    struct points_text *const text = &points->text;
    const struct columns *const chosen = &points->chosen;
    const bool named = chosen->count > 0 && !chosen->numbered;
    if (find_delimiter(points) != CLI_SUCCESS) {
        return CLI_USAGE;
    }
    if (named && !is_readable(text)) {
        cli_error("--columns: the header row of %s is longer than %d bytes or holds a NUL byte",
                  points->input.name, POINTS_LINE_MAX);
        return CLI_USAGE;
    }
    if (points->format == POINTS_CSV && (named || is_header(points))) {
        return take_header(points);
    }
    text->pending = true;
    const size_t columns = count_columns(points->field, text->line);
    return columns_nameless(chosen, points->input.name, columns) ? CLI_SUCCESS : CLI_USAGE;
}

/* The first row decides about format and header, the first good point about the dimensions unless
   they are known. */
int points_text_begin(struct points *points)
{
    struct points_text *const text = &points->text;
    columns_by_number(&points->chosen, points->column);
    if (input_begins_with(&points->input, "\xef\xbb\xbf", 3)) {
        points->input.start += 3;
    }
    if (input_begins_with(&points->input, "\xff\xfe", 2) ||
        input_begins_with(&points->input, "\xfe\xff", 2)) {
        cli_error("--input: %s: is UTF-16; UTF-8 and other extensions of ASCII can be read",
                  points->input.name);
        return CLI_USAGE;
    }
    if (next_row(points, true) == LINE_READY) {
        const int status = begin_rows(points);
        if (status != CLI_SUCCESS) {
            return status;
        }
    } else if (points->delimiter == DELIMITER_UNKNOWN) { /* no rows */
        points->delimiter = points->format == POINTS_CSV ? DELIMITER_COMMA : DELIMITER_SPACE;
    }
    points->format = points->delimiter == DELIMITER_SPACE ? POINTS_TEXT : POINTS_CSV;
    points->field = delimiter_field(points->delimiter);
    double position[3];
    while (next_row(points, true) == LINE_READY) {
        if (read_point(points, position)) {
            text->pending = true;
            points->columns = count_columns(points->field, text->line);
            break;
        }
        if (!points->skip_bad) {
            return tell_problem(points);
        }
    }
    if (points->dims == 0) {
        points->dims = points->columns == 3 ? 3 : 2;
    }
    return input_status(&points->input);
}

/* A malformed line waits until the points before it are through, so what is written of them does
   not depend on where batchs happen to end. */
int points_text_read(struct points *points, struct points_batch *batch)
{
    struct points_text *const text = &points->text;
    while (batch->count < POINTS_BATCH && text->problem[0] == '\0' &&
           next_row(points, batch->count == 0) == LINE_READY) {
        double position[3] = {0};
        if (read_point(points, position)) {
            for (int d = 0; d < points->dims; d++) {
                batch->position[d][batch->count] = position[d];
            }
            batch->line[batch->count++] = text->line;
        }
    }
    if (batch->count > 0) {
        return CLI_SUCCESS;
    }
    return text->problem[0] != '\0' ? tell_problem(points) : input_status(&points->input);
}
