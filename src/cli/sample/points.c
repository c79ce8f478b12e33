/* SPDX-License-Identifier: MIT
 *
 * Which reader serves an input.
 */
#include "sample/points.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "formats/npy.h"
#include "shared/error.h"

int points_open(struct points *points, const char *path)
{
    points->dims_given = points->dims != 0;
    points->told = points->dims_given || points->chosen.count > 0;
    if (points->chosen.count > 0) {
        points->dims = (int)points->chosen.count;
    }
    errno = 0;
    if (!input_open(&points->input, path)) {
        cli_error("--input: %s: %s", points->input.name,
                  errno != 0 ? strerror(errno) : "cannot be read");
        return CLI_USAGE;
    }
    return CLI_SUCCESS;
}

int points_begin(struct points *points)
{
    if (points->format == POINTS_UNKNOWN &&
        input_begins_with(&points->input, NPY_MAGIC, NPY_MAGIC_SIZE)) {
        points->format = POINTS_NPY;
    }
    if (points->format == POINTS_NPY && points->delimiter != DELIMITER_UNKNOWN) {
        cli_error("--delimiter: is for text, and %s is .npy", points->input.name);
        return CLI_USAGE;
    }
    return points->format == POINTS_NPY ? points_npy_begin(points) : points_text_begin(points);
}

int points_read(struct points *points, struct points_batch *batch)
{
    batch->count = 0;
    return points->format == POINTS_NPY ? points_npy_read(points, batch)
                                        : points_text_read(points, batch);
}

void points_close(struct points *points)
{
    free(points->header);
    points->header = NULL;
    free(points->npy.whole);
    points->npy.whole = NULL;
    input_close(&points->input);
}
