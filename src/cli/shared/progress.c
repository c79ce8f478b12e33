/* SPDX-License-Identifier: MIT
 *
 * Prints progress on the terminal: a tick every 2.5 %, of which every fourth is a number.
 */
#include "shared/progress.h"

#include <stdio.h>

#include "shared/posix.h"

#ifdef _WIN32
#define STDERR_IS_TERMINAL() windows_is_console()
#else
#define STDERR_IS_TERMINAL() (isatty(STDERR_FILENO) != 0)
#endif

#define TICKS 40

/* Prints the ticks up to what is done. */
static void print(struct progress *progress)
{
    if (!progress->shown) {
        return;
    }
    const double share = (double)progress->done / (double)progress->total;
    const int ticks = (int)(TICKS * share);
    for (; progress->ticks <= ticks; progress->ticks++) {
        if (progress->ticks % 4 == 0) {
            fprintf(stderr, "%d", progress->ticks / 4 * 10);
        } else {
            fputc('.', stderr);
        }
    }
    fflush(stderr);
}

void progress_start(struct progress *progress, uint64_t total, bool quiet)
{
    *progress = (struct progress){.shown = !quiet && STDERR_IS_TERMINAL(), .total = total};
    print(progress);
}

void progress_add(struct progress *progress, uint64_t count)
{
    const uint64_t left = progress->total - progress->done;
    progress->done += count < left ? count : left;
    print(progress);
}

void progress_end(struct progress *progress, bool succeeded)
{
    if (progress->shown) {
        fputs(succeeded ? " - done.\n" : "\n", stderr);
    }
    progress->shown = false;
}
