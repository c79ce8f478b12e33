/* SPDX-License-Identifier: MIT
 *
 * Points of CSV, text and .npy: they are finite, the same in whatever pieces they come, and the
 * same when they are written as text and read again.
 *
 * The first three bytes say how they are read. A line with --columns may follow, and then the file.
 */
#include <errno.h>
#include <math.h>
#include <string.h>

#include "cli.h"
#include "draw.h"
#include "fuzz.h"
#include "points_input.h"
#include "sample/points.h"
#include "shared/error.h"
#include "shared/number.h"

#define TOLD_MOST 4096 /* points that are kept */

/* The file at hand */
static struct {
    const uint8_t *bytes;
    size_t size, at, piece, zeros; /* zeros follow the bytes */
    bool fails, interrupts;
} file;

int fuzz_open(void)
{
    return 100;
}

ptrdiff_t fuzz_read(int descriptor, void *bytes, size_t count)
{
    (void)descriptor;
    if (file.interrupts && file.at % 2 == 1) {
        file.interrupts = false;
        errno = EINTR;
        return -1;
    }
    const size_t left = file.size + file.zeros - file.at;
    size_t most = left < count ? left : count;
    if (most > file.piece) {
        most = file.piece;
    }
    MUST(count > 0, "no room to read to");
    if (left == 0 && file.fails) {
        errno = EIO;
        return -1;
    }
    memset(bytes, 0, most);
    if (file.at < file.size) {
        const size_t some = file.size - file.at;
        memcpy(bytes, file.bytes + file.at, some < most ? some : most);
    }
    file.at += most;
    return (ptrdiff_t)most;
}

/* What was read */
struct told {
    int status, format, dims, errors;
    size_t count, columns, total;
    uint64_t malformed;
    double position[TOLD_MOST][3];
};

static struct points_batch batch;

static void keep(struct told *told, const struct points *points)
{
    for (size_t i = 0; i < batch.count; i++, told->count++) {
        for (int d = 0; d < points->dims; d++) {
            MUST(isfinite(batch.position[d][i]), "coordinate %d of point %zu", d, told->count);
            if (told->count < TOLD_MOST) {
                told->position[told->count][d] = batch.position[d][i];
            }
        }
        if (points->format != POINTS_NPY) {
            MUST(strlen(batch.line[i]) <= POINTS_LINE_MAX, "a long line is a point");
        }
    }
}

static void read_all(struct points *points, struct told *told)
{
    do {
        told->status = points_read(points, &batch);
        MUST(batch.count <= POINTS_BATCH, "%zu points of a batch", batch.count);
        MUST(told->status == CLI_SUCCESS || batch.count == 0, "points, and an error");
        keep(told, points);
    } while (batch.count > 0);
}

static void read_file(struct points points, size_t piece, struct told *told)
{
    file.at = 0;
    file.piece = piece;
    memset(told, 0, sizeof *told);
    fuzz_no_errors();
    told->status = points_open(&points, "file");
    if (told->status == CLI_SUCCESS) {
        told->status = points_begin(&points);
    }
    if (told->status == CLI_SUCCESS) {
        MUST(points.dims == 2 || points.dims == 3, "%d dimensions", points.dims);
        read_all(&points, told);
    }
    told->format = points.format;
    told->dims = points.dims;
    told->columns = points.columns;
    told->total = points.total;
    told->malformed = points.malformed;
    told->errors = fuzz_errors;
    fuzz_must_tell(told->status != CLI_SUCCESS, "points");
    MUST(told->status != CLI_SUCCESS || told->format != POINTS_NPY ||
             told->count + told->malformed == told->total,
         "%zu points and %d malformed ones of %zu", told->count, (int)told->malformed, told->total);
    points_close(&points);
}

static bool is_same(const struct told *a, const struct told *b)
{
    const size_t count = a->count < TOLD_MOST ? a->count : TOLD_MOST;
    return a->status == b->status && a->format == b->format && a->dims == b->dims &&
           a->count == b->count && a->columns == b->columns && a->total == b->total &&
           a->malformed == b->malformed &&
           memcmp(a->position, b->position, count * sizeof a->position[0]) == 0;
}

/* Writes points as text, and reads them. */
static void write_again(const struct told *told)
{
    static struct told again;
    const size_t count = told->count < 100 ? told->count : 100;
    char *const text = malloc(count * 3 * NUMBER_SIZE + 1);
    MUST(text != NULL, "no memory");
    char *end = text;
    for (size_t i = 0; i < count; i++) {
        for (int d = 0; d < told->dims; d++) {
            end = number_write_double(end, told->position[i][d]);
            *end++ = d + 1 < told->dims ? ' ' : '\n';
        }
    }
    file.bytes = (const uint8_t *)text;
    file.size = (size_t)(end - text);
    file.zeros = 0;
    file.fails = false;
    read_file((struct points){.format = POINTS_TEXT, .delimiter = DELIMITER_UNKNOWN}, file.size,
              &again);
    MUST(again.status == CLI_SUCCESS && again.count == count && again.dims == told->dims,
         "%zu points of %zu are read again", again.count, count);
    MUST(memcmp(again.position, told->position, count * sizeof again.position[0]) == 0,
         "other points are read again");
    free(text);
}

/* Reads what --columns would say. False if it is not valid. */
static bool read_columns(struct draw *bytes, struct points *points, char **text)
{
    const uint8_t *const end = bytes->left > 0 ? memchr(bytes->at, '\n', bytes->left) : NULL;
    const size_t length = end != NULL ? (size_t)(end - bytes->at) : bytes->left;
    const struct option option = {.name = "--columns"};
    *text = fuzz_text(bytes->at, length);
    bytes->at += length + (end != NULL ? 1 : 0);
    bytes->left -= length + (end != NULL ? 1 : 0);
    return option_columns(&option, *text, &points->chosen) == OPTION_VALID;
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    static struct told at_once, in_pieces;
    struct draw bytes = {input, size};
    const unsigned how = (unsigned)draw_bits(&bytes, 1), more = (unsigned)draw_bits(&bytes, 1);
    const size_t piece = 1 + (size_t)draw_bits(&bytes, 1);
    struct points points = {.format = (int)(how % 4),
                            .delimiter = DELIMITER_UNKNOWN,
                            .dims = (how >> 2) % 4 == 1 ? 0 : (int)((how >> 2) % 4),
                            .skip_bad = (how & 16) != 0,
                            .keep = (how & 32) != 0,
                            .plain = (how & 64) != 0};
    char *columns = NULL;
    if (points.format == POINTS_CSV ||
        points.format == POINTS_UNKNOWN) { /* from 16 on: one of them */
        points.delimiter =
            (more >> 4) % 8 == 0 ? DELIMITER_UNKNOWN : (int)((more >> 4) % 8 - 1) % 3;
    }
    if ((how & 128) == 0 || read_columns(&bytes, &points, &columns)) {
        file.bytes = bytes.at;
        file.size = bytes.left;
        file.fails = (more & 1) != 0;
        file.interrupts = (more & 2) != 0;
        file.zeros = (more & 12) == 12 ? 2 * INPUT_SIZE : 0;
        read_file(points, SIZE_MAX, &at_once);
        file.interrupts = (more & 2) != 0;
        read_file(points, file.zeros > 0 ? 512 * piece : piece, &in_pieces);
        MUST(is_same(&at_once, &in_pieces), "%zu points, and %zu in pieces of %zu bytes",
             at_once.count, in_pieces.count, piece);
        if (at_once.count > 0) {
            write_again(&at_once);
        }
    }
    free(columns);
    return 0;
}
