/* SPDX-License-Identifier: MIT
 *
 * Points from a .npy file: the rows of an array of two dimensions. Coordinates that are not finite
 * are malformed, as they are in text. An array in Fortran order has one column after the other: it
 * is read as a whole before the first point.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "formats/npy.h"
#include "sample/points.h"
#include "shared/error.h"
#include "shared/number.h"

/* Rows are read whole, so the input's buffer must hold one. */
#define COLUMNS_MAX (INPUT_SIZE / sizeof(double))

#define WHOLE_FIRST                                                                                \
    ((size_t)1 << 20) /* bytes that are kept of an array in Fortran order at first */

static int refuse(const struct points *points, const char *what)
{
    cli_error("--input: %s: %s", points->input.name, what);
    return CLI_USAGE;
}

/* The input ended, or failed, before what its header says. */
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
        const bool is_turned = array->shape[0] == 2 || array->shape[0] == 3;
        cli_error("--input: %s: the shape (%zu, %zu) is not %s%s", name, array->shape[0], columns,
                  points->dims == 3   ? "(n, 3), or (n, 4) and so on"
                  : points->dims == 2 ? "(n, 2), or (n, 3) and so on"
                                      : "(n, 2) or (n, 3); --columns chooses from more",
                  is_turned ? "; NumPy's .T turns it" : "");
        return CLI_USAGE;
    }
    return CLI_SUCCESS;
}

static int check_array(struct points *points, const struct npy_array *array)
{
    struct npy_type *const type = &points->npy.type;
    if (!npy_read_type(array->descr, type)) {
        cli_error(
            "--input: %s: the type '%s' is not one of floats or integers: f2, f4, f8, i1 to i8 "
            "and u1 to u8, behind < or >",
            points->input.name, array->descr);
        return CLI_USAGE;
    }
    if (array->dimensions != 2) {
        cli_error("--input: %s: an array of %d dimensions instead of the shape (n, 2) or (n, 3)",
                  points->input.name, array->dimensions);
        return CLI_USAGE;
    }
    points->single = type->kind == 'f' && type->size < 8;
    points->npy.row = array->shape[1] * (size_t)type->size;
    points->npy.is_fortran = array->fortran;
    return check_columns(points, array);
}

/* How many points an array in Fortran order has, of which `size` bytes are kept, of the last column
   that is needed at least */
static size_t count_whole(const struct points *points, size_t size)
{
    const size_t element = (size_t)points->npy.type.size;
    const size_t before = (columns_needed(points->column, points->dims) - 1) * element;
    const size_t start = points->total <= SIZE_MAX / before ? points->total * before : SIZE_MAX;
    return size > start ? (size - start) / element : 0;
}

/* Takes what the input has at hand, up to `wanted` bytes in all. False without memory */
static bool keep_more(struct points *points, size_t wanted, size_t *size, size_t *room)
{
    struct input *const input = &points->input;
    const size_t there = input->end - input->start;
    const size_t some = there < wanted - *size ? there : wanted - *size;
    if (some > *room - *size) {
        const size_t twice = *room <= SIZE_MAX / 2 ? 2 * *room : SIZE_MAX;
        unsigned char *const more = realloc(points->npy.whole, twice);
        if (more == NULL) {
            return false;
        }
        points->npy.whole = more;
        *room = twice;
    }
    memcpy(points->npy.whole + *size, input->bytes + input->start, some);
    input->start += some;
    *size += some;
    return true;
}

/* Keeps an array in Fortran order, up to the last column that is needed: as much memory as there
   are bytes, whatever the header says. */
static int read_whole(struct points *points)
{
    const size_t column = (size_t)points->npy.type.size;
    const size_t needed = columns_needed(points->column, points->dims);
    const size_t wanted =
        points->total <= SIZE_MAX / column / needed ? points->total * column * needed : SIZE_MAX;
    size_t size = 0, room = WHOLE_FIRST;
    points->npy.whole = malloc(room);
    bool has_memory = points->npy.whole != NULL;
    while (has_memory && size < wanted && input_need(&points->input, 1)) {
        has_memory = keep_more(points, wanted, &size, &room);
    }
    if (!has_memory) {
        cli_error("--input: %s: no memory for an array in Fortran order", points->input.name);
        return CLI_FAILURE;
    }
    if (size < wanted) {
        points->npy.left = points->total - count_whole(points, size);
        return cut_short(points);
    }
    return CLI_SUCCESS;
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
    return points->npy.is_fortran ? read_whole(points) : CLI_SUCCESS;
}

/* Where a coordinate of the next point is */
static const unsigned char *element_at(const struct points *points, size_t column)
{
    const struct points_npy *const npy = &points->npy;
    const size_t size = (size_t)npy->type.size;
    if (npy->is_fortran) {
        return npy->whole + (column * points->total + points->total - npy->left) * size;
    }
    return (const unsigned char *)points->input.bytes + points->input.start + column * size;
}

/* Reads the coordinates of the next point. Returns the axis of the first that is not finite, -1 if
   all are. */
static int read_row(const struct points *points, double position[3])
{
    int bad = -1;
    for (int d = points->dims - 1; d >= 0; d--) {
        position[d] = npy_get(element_at(points, points->column[d]), points->npy.type);
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
static int read_rows(struct points *points, struct points_batch *batch)
{
    struct points_npy *const npy = &points->npy;
    struct input *const input = &points->input;
    const size_t row = npy->is_fortran ? 0 : npy->row; /* bytes of the input */
    for (; npy->left > 0 && batch->count < POINTS_BATCH && input->end - input->start >= row;
         npy->left--) {
        double position[3] = {0};
        const int bad = read_row(points, position);
        if (bad >= 0 && !points->skip_bad) {
            return batch->count > 0 ? CLI_SUCCESS : tell_malformed(points, bad, position[bad]);
        }
        input->start += row;
        if (bad >= 0) {
            points->malformed++;
            continue;
        }
        for (int d = 0; d < points->dims; d++) {
            batch->position[d][batch->count] = position[d];
        }
        batch->count++;
    }
    return CLI_SUCCESS;
}

int points_npy_read(struct points *points, struct points_batch *batch)
{
    int status = CLI_SUCCESS;
    while (status == CLI_SUCCESS && batch->count == 0 && points->npy.left > 0) {
        const bool is_there = points->npy.is_fortran || input_need(&points->input, points->npy.row);
        status = is_there ? read_rows(points, batch) : cut_short(points);
    }
    return status;
}
