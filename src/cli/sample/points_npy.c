/* SPDX-License-Identifier: MIT
 *
 * Points from a .npy file: the rows of an array of two dimensions. Coordinates that are not finite
 * are malformed, as they are in text.
 */
#include <math.h>
#include <string.h>

#include "formats/npy.h"
#include "sample/points.h"
#include "shared/error.h"
#include "shared/number.h"

/* Rows are read whole, so the input's buffer must hold one. */
#define COLUMNS_MAX (INPUT_SIZE / sizeof(double))

static int refuse(const struct points *points, const char *what)
{
    cli_error("--input: %s: %s", points->input.name, what);
    return CLI_USAGE;
}

/* The input ended, or failed, before what its header tells. */
static int cut_short(const struct points *points)
{
    if (points->input.error != 0) {
        return input_status(&points->input);
    }
    cli_error("--input: %s: ends after %zu of %zu points", points->input.name,
              points->total - points->npy.left, points->total);
    return CLI_USAGE;
}

static int read_header(struct points *points, struct npy_array *array)
{
    struct input *const input = &points->input;
    size_t text, length;
    const bool begun = input_need(input, NPY_PREAMBLE_SIZE);
    if (input->error != 0) {
        return input_status(input);
    }
    if (!begun || memcmp(input->bytes + input->start, NPY_MAGIC, NPY_MAGIC_SIZE) != 0) {
        return refuse(points, "not a .npy file");
    }
    if (!npy_preamble(input->bytes + input->start, &text, &length)) {
        return refuse(points, "a .npy file of an unknown version");
    }
    if (length > INPUT_SIZE - text) {
        return refuse(points, "the .npy header is too long");
    }
    if (!input_need(input, text + length)) {
        return input->error != 0 ? input_status(input) : refuse(points, "ends in its .npy header");
    }
    const char *const problem = npy_parse_header(input->bytes + input->start + text, length, array);
    if (problem != NULL) {
        cli_error("--input: %s: the .npy header %s", input->name, problem);
        return CLI_USAGE;
    }
    input->start += text + length;
    return CLI_SUCCESS;
}

/* Whether the rows of an array have the columns that are wanted */
static int check_columns(const struct points *points, const struct npy_array *array)
{
    const struct columns *const chosen = &points->chosen;
    const char *const name = points->input.name;
    const size_t columns = array->shape[1];
    if (!columns_nameless(chosen, name, columns)) {
        return CLI_USAGE;
    }
    for (size_t i = 0; i < chosen->count; i++) {
        if (chosen->index[i] >= columns) {
            cli_error("--columns: %s has no column %zu; choose from 1 to %zu", name,
                      chosen->index[i] + 1, columns);
            return CLI_USAGE;
        }
    }
    if (columns > COLUMNS_MAX) {
        cli_error("--input: %s: the shape (%zu, %zu) has more than %zu columns", name,
                  array->shape[0], columns, COLUMNS_MAX);
        return CLI_USAGE;
    }
    if (points->told ? columns < (size_t)points->dims : columns < 2 || columns > 3) {
        cli_error("--input: %s: the shape (%zu, %zu) is not %s", name, array->shape[0], columns,
                  points->dims == 3   ? "(n, 3), or (n, 4) and so on"
                  : points->dims == 2 ? "(n, 2), or (n, 3) and so on"
                                      : "(n, 2) or (n, 3); --columns chooses from more");
        return CLI_USAGE;
    }
    return CLI_SUCCESS;
}

static int check_array(struct points *points, const struct npy_array *array)
{
    static const char *const types[] = {"<f4", "<f8", ">f4", ">f8"};
    int type = 0;
    while (type < 4 && strcmp(array->descr, types[type]) != 0) {
        type++;
    }
    if (type == 4) {
        cli_error("--input: %s: the type '%s' is not <f4, <f8, >f4 or >f8", points->input.name,
                  array->descr);
        return CLI_USAGE;
    }
    if (array->dimensions != 2) {
        cli_error("--input: %s: an array of %d dimensions instead of the shape (n, 2) or (n, 3)",
                  points->input.name, array->dimensions);
        return CLI_USAGE;
    }
    if (array->fortran) {
        return refuse(points, "the array is in Fortran order; numpy.ascontiguousarray mends that");
    }
    points->single = type % 2 == 0;
    points->npy.big_endian = type >= 2;
    points->npy.row = array->shape[1] * (points->single ? 4 : 8);
    return check_columns(points, array);
}

int points_npy_begin(struct points *points)
{
    struct npy_array array;
    int status = read_header(points, &array);
    if (status == CLI_SUCCESS) {
        status = check_array(points, &array);
    }
    if (status != CLI_SUCCESS) {
        return status;
    }
    if (!points->told) {
        points->dims = (int)array.shape[1];
    }
    columns_by_number(&points->chosen, points->column);
    points->columns = array.shape[1];
    points->total = array.shape[0];
    points->npy.left = array.shape[0];
    return CLI_SUCCESS;
}

/* Reads the coordinates of a row. Returns the axis of the first that is not finite, -1 if all are.
 */
static int read_row(const struct points *points, const unsigned char *row, double position[3])
{
    int bad = -1;
    for (int d = points->dims - 1; d >= 0; d--) {
        const size_t column = points->column[d];
        const bool big_endian = points->npy.big_endian;
        position[d] = points->single ? (double)npy_get_float(row + 4 * column, big_endian)
                                     : npy_get_double(row + 8 * column, big_endian);
        bad = isfinite(position[d]) ? bad : d;
    }
    return bad;
}

static int tell_malformed(const struct points *points, int axis, double coordinate)
{
    char number[NUMBER_SIZE];
    number_write_double(number, coordinate);
    cli_error("--input: %s: point %zu of %zu: column %zu: '%s' is not a finite number",
              points->input.name, points->total - points->npy.left + 1, points->total,
              points->column[axis] + 1, number);
    return CLI_USAGE;
}

/* Reads what the input has at hand, as much of it as fits. A malformed point waits until those
   before it are through, as a malformed line does. */
static int read_rows(struct points *points, struct points_block *block)
{
    struct points_npy *const npy = &points->npy;
    struct input *const input = &points->input;
    for (; npy->left > 0 && block->count < POINTS_BLOCK && input->end - input->start >= npy->row;
         npy->left--) {
        double position[3] = {0};
        const int bad =
            read_row(points, (const unsigned char *)input->bytes + input->start, position);
        if (bad >= 0 && !points->skip_bad) {
            return block->count > 0 ? CLI_SUCCESS : tell_malformed(points, bad, position[bad]);
        }
        input->start += npy->row;
        if (bad >= 0) {
            points->malformed++;
            continue;
        }
        for (int d = 0; d < points->dims; d++) {
            block->position[d][block->count] = position[d];
        }
        block->count++;
    }
    return CLI_SUCCESS;
}

int points_npy_read(struct points *points, struct points_block *block)
{
    int status = CLI_SUCCESS;
    while (status == CLI_SUCCESS && block->count == 0 && points->npy.left > 0) {
        status = input_need(&points->input, points->npy.row) ? read_rows(points, block)
                                                             : cut_short(points);
    }
    return status;
}
