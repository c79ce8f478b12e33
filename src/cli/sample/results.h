/* SPDX-License-Identifier: MIT
 *
 * Results as CSV, text or .npy, a row per point: what `scarp sample` writes.
 */
#ifndef SCARP_CLI_RESULTS_H
#define SCARP_CLI_RESULTS_H

#include <stdbool.h>
#include <stddef.h>

#include "sample/points.h"
#include "shared/file.h"

#define RESULTS_COLUMNS_MAX 11

struct results {
    /* Set before opening, the rest zero */
    int format; /* an enum points_format; may be set as late as before results_begin */
    bool keep;  /* the input's columns go first */
    size_t columns;
    const char *names[RESULTS_COLUMNS_MAX];
    float *values[RESULTS_COLUMNS_MAX]; /* POINTS_BATCH of each, the batch's when it is written */

    /* Private to results.c: */
    const char *path;
    struct file file;
    size_t points; /* written so far */
    char *bytes;   /* what is to be written next */
    size_t used;
    char separator;
    bool has_commas; /* decimal ones */
    bool failed;
    int reason; /* the errno of the failure */
};

/* All return an exit status, after a line on stderr if it is not CLI_SUCCESS. `points` is where the
   points came from, begun. */

int results_open(struct results *results, const char *path);

/* Writes what comes before the first row. */
int results_begin(struct results *results, const struct points *points);

/* Writes a row per point and hands them on at once: someone may be waiting at a pipe's end. */
int results_write(struct results *results, const struct points *points,
                  const struct points_batch *batch);

/* Completes the output, which then takes its name. */
int results_end(struct results *results, const struct points *points);

/* Leaves nothing behind unless results_end succeeded. May be called at any time after
   zero-initialisation. */
void results_close(struct results *results);

#endif
