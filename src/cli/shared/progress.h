/* SPDX-License-Identifier: MIT
 *
 * Progress in GDAL's manner, on stderr and only if that is a terminal:
 * 0...10...20...30...40...50...60...70...80...90...100 - done.
 *
 * From ten seconds on, a number is followed by how long the rest will take: 20 (3 min left).
 */
#ifndef SCARP_CLI_PROGRESS_H
#define SCARP_CLI_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    bool shown;
    uint64_t done, total;
    uint64_t skipped; /* of what is done */
    double start;
    int ticks;      /* that are on the terminal */
    bool told_left; /* how long it will take, once at least */
};

void progress_start(struct progress *progress, uint64_t total, bool quiet);
void progress_add(struct progress *progress, uint64_t count);

/* What was there already: it took no time. */
void progress_skip(struct progress *progress, uint64_t count);

/* Ends the line, so that something else can be printed. */
void progress_end(struct progress *progress, bool succeeded);

#endif
