/* SPDX-License-Identifier: MIT
 *
 * Rows of results: formatted into a buffer, which goes to the file in large pieces.
 */
#include "sample/results.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/npy.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/number.h"
#include "shared/posix.h"

#define BUFFER_SIZE ((size_t)1 << 16)

static int tell_failure(const struct results *results, int status)
{
    if (interrupted()) {
        cli_error("interrupted: not all results were written");
        return CLI_FAILURE;
    }
    cli_error("--output: %s: %s", file_name(results->path), file_reason(errno));
    return status;
}

int results_open(struct results *results, const char *path)
{
    results->path = path;
    errno = 0;
    results->bytes = malloc(BUFFER_SIZE);
    if (results->bytes == NULL || !file_open(&results->file, path)) {
        return tell_failure(results, CLI_USAGE);
    }
    return CLI_SUCCESS;
}

/* After a failure nothing more is written, and errno is again what it was then. */
static bool flush_bytes(struct results *results)
{
    if (!results->failed) {
        errno = 0;
        results->failed = !file_write(&results->file, results->bytes, results->used);
        results->reason = errno;
    }
    errno = results->reason;
    results->used = 0;
    return !results->failed;
}

/* Room for `size` bytes, of which results->used counts those that are filled */
static char *reserve(struct results *results, size_t size)
{
    if (results->used + size > BUFFER_SIZE) {
        flush_bytes(results);
    }
    return results->bytes + results->used;
}

static void put_char(struct results *results, char c)
{
    *reserve(results, 1) = c;
    results->used++;
}

static void put_text(struct results *results, const char *text)
{
    for (size_t left = strlen(text); left > 0;) {
        const size_t size = left < BUFFER_SIZE ? left : BUFFER_SIZE;
        memcpy(reserve(results, size), text, size);
        results->used += size;
        text += size;
        left -= size;
    }
}

/* Takes a number that was written at `to`. */
static void take_number(struct results *results, char *to, size_t length)
{
    char *const point = results->has_commas ? memchr(to, '.', length) : NULL;
    if (point != NULL) {
        *point = ',';
    }
    results->used += length;
}

static void put_float(struct results *results, float value)
{
    char *const to = reserve(results, NUMBER_SIZE);
    take_number(results, to, (size_t)(number_write_float(to, value) - to));
}

static void put_double(struct results *results, double value)
{
    char *const to = reserve(results, NUMBER_SIZE);
    take_number(results, to, (size_t)(number_write_double(to, value) - to));
}

/* A field of text as CSV takes it: in quotes, each quote doubled, if it has a delimiter or a quote
 */
static void put_csv_field(struct results *results, const struct field *field)
{
    const size_t length = (size_t)(field->end - field->begin);
    const bool quotes = memchr(field->begin, results->separator, length) != NULL ||
                        memchr(field->begin, '"', length) != NULL;
    if (quotes) {
        put_char(results, '"');
    }
    for (const char *c = field->begin; c < field->end; c++) {
        put_char(results, *c);
        if (*c == '"') {
            put_char(results, '"');
        }
    }
    if (quotes) {
        put_char(results, '"');
    }
}

static void put_text_field(struct results *results, const struct field *field)
{
    for (const char *c = field->begin; c < field->end; c = field_after(field, c)) {
        put_char(results, *c);
    }
}

/* The input's columns of a point from a line, with a separator behind each. CSV for CSV stays as
   it is. */
static void put_line(struct results *results, const struct points *points, const char *line)
{
    const char separator = results->separator;
    const bool csv = results->format == POINTS_CSV;
    if (csv && points->format == POINTS_CSV) {
        put_text(results, line);
        put_char(results, separator);
        return;
    }
    for (const char *at = line; at != NULL;) {
        const struct field field = points->field(at);
        if (csv) {
            put_csv_field(results, &field);
        } else {
            put_text_field(results, &field);
        }
        put_char(results, separator);
        at = field.next;
    }
}

static void put_position(struct results *results, const struct points *points,
                         const struct points_batch *batch, size_t i)
{
    for (int d = 0; d < points->dims; d++) {
        const double coordinate = batch->position[d][i];
        if (points->single) {
            put_float(results, (float)coordinate);
        } else {
            put_double(results, coordinate);
        }
        put_char(results, results->separator);
    }
}

static void put_rows(struct results *results, const struct points *points,
                     const struct points_batch *batch)
{
    for (size_t i = 0; i < batch->count; i++) {
        if (results->keep && points->format == POINTS_NPY) {
            put_position(results, points, batch, i);
        } else if (results->keep) {
            put_line(results, points, batch->line[i]);
        }
        for (size_t c = 0; c < results->columns; c++) {
            put_float(results, results->values[c][i]);
            put_char(results, c + 1 < results->columns ? results->separator : '\n');
        }
    }
}

/* A NaN is always the same one, as it is in text. */
static void put_npy_rows(struct results *results, const struct points *points,
                         const struct points_batch *batch)
{
    for (size_t i = 0; i < batch->count; i++) {
        for (int d = 0; d < points->dims && results->keep; d++) {
            npy_put_double((unsigned char *)reserve(results, 8), batch->position[d][i]);
            results->used += 8;
        }
        for (size_t c = 0; c < results->columns; c++) {
            const float value = isnan(results->values[c][i]) ? NAN : results->values[c][i];
            unsigned char *const to = (unsigned char *)reserve(results, 8);
            if (results->keep) {
                npy_put_double(to, (double)value);
            } else {
                npy_put_float(to, value);
            }
            results->used += results->keep ? 8 : 4;
        }
    }
}

/* Names of kept columns that have none: x, y, z, and for the others their numbers */
static void put_made_names(struct results *results, const struct points *points)
{
    static const char *const axes[] = {"x", "y", "z"};
    const bool npy = points->format == POINTS_NPY; /* keeps only the coordinates, in their order */
    const size_t dims = (size_t)points->dims;
    const size_t needed = columns_needed(points->column, points->dims);
    const size_t columns = npy ? dims : points->columns < needed ? needed : points->columns;
    for (size_t i = 0; i < columns; i++) {
        char name[32];
        snprintf(name, sizeof name, "column%zu", i + 1);
        size_t axis = 0;
        while (axis < dims && (npy ? axis : points->column[axis]) != i) {
            axis++;
        }
        put_text(results, axis < dims ? axes[axis] : name);
        put_char(results, results->separator);
    }
}

static void put_names(struct results *results, const struct points *points)
{
    if (results->keep && points->header != NULL) {
        put_text(results, points->header);
        put_char(results, results->separator);
    } else if (results->keep) {
        put_made_names(results, points);
    }
    for (size_t c = 0; c < results->columns; c++) {
        put_text(results, results->names[c]);
        put_char(results, c + 1 < results->columns ? results->separator : '\n');
    }
}

static bool write_npy_header(const struct results *results, const struct points *points,
                             size_t count)
{
    const size_t kept = results->keep ? (size_t)points->dims : 0;
    const size_t shape[] = {count, kept + results->columns};
    errno = 0;
    return npy_write_header(results->file.stream, results->keep ? "<f8" : "<f4", shape, 2);
}

/* Whether the header of .npy can say at once how many points there will be */
static bool is_counted(const struct points *points)
{
    return points->format == POINTS_NPY && !points->skip_bad;
}

/* Whether the start of the output can be written again at the end: not in a pipe, not where the
   shell appends, and not behind what others wrote. */
static bool can_rewind(struct file *file)
{
    const int flags = fcntl(fileno(file->stream), F_GETFL);
    if (flags != -1 && (flags & O_APPEND) != 0) {
        return false;
    }
    return ftell(file->stream) == 0 && file_seek(file, 0);
}

/* CSV has the delimiter and the decimal mark of the points, so far as those are known with the
   first of them, or may have them: commas are either the one or the other. */
static void choose_marks(struct results *results, const struct points *points)
{
    const bool has_commas = points->format != POINTS_NPY && points->decimal == ',';
    results->separator = results->format != POINTS_CSV  ? ' '
                         : points->format == POINTS_CSV ? delimiter_character(points->delimiter)
                                                        : (has_commas ? ';' : ',');
    results->has_commas = has_commas && results->separator != ',';
}

int results_begin(struct results *results, const struct points *points)
{
    choose_marks(results, points);
    if (results->format == POINTS_NPY) {
        if (!is_counted(points) && !can_rewind(&results->file)) {
            cli_error("--output: %s: the header of .npy says how many points there are; to write "
                      "that at the end, the output must be a file of its own",
                      file_name(results->path));
            return CLI_USAGE;
        }
        return write_npy_header(results, points, points->total)
                   ? CLI_SUCCESS
                   : tell_failure(results, CLI_FAILURE);
    }
    const bool headless =
        points->format == POINTS_CSV && points->header == NULL && points->columns > 0;
    if (results->format == POINTS_CSV && !headless) {
        put_names(results, points);
    }
    return CLI_SUCCESS;
}

int results_write(struct results *results, const struct points *points,
                  const struct points_batch *batch)
{
    if (results->format == POINTS_NPY) {
        put_npy_rows(results, points, batch);
    } else {
        put_rows(results, points, batch);
    }
    results->points += batch->count;
    if (!flush_bytes(results) || fflush(results->file.stream) != 0) {
        return tell_failure(results, CLI_FAILURE);
    }
    return CLI_SUCCESS;
}

int results_end(struct results *results, const struct points *points)
{
    bool written = flush_bytes(results); /* the header row, if there was no point */
    if (written && results->format == POINTS_NPY && !is_counted(points)) {
        written =
            file_seek(&results->file, 0) && write_npy_header(results, points, results->points);
    }
    if (!written || !file_close(&results->file) || !file_publish(&results->file) ||
        !file_settle(&results->file)) {
        return tell_failure(results, CLI_FAILURE);
    }
    return CLI_SUCCESS;
}

void results_close(struct results *results)
{
    file_discard(&results->file);
    free(results->bytes);
    results->bytes = NULL;
}
