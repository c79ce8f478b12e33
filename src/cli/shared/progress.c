/* SPDX-License-Identifier: MIT
 *
 * Prints progress on the terminal: a tick every 2.5 %, of which every fourth is a number.
 */
#include "shared/progress.h"

#include <stdio.h>

#include "shared/posix.h"
#include "shared/running.h"

#ifdef _WIN32
#define STDERR_IS_TERMINAL() windows_is_console()
#else
#define STDERR_IS_TERMINAL() (isatty(STDERR_FILENO) != 0)
#endif

#define TICKS 40
#define PATIENCE 10.0 /* seconds after which the time left is printed */

/* How long what is left will take: as long in proportion as what this run did. 0: that is not known
   yet, or there is nothing left */
static double seconds_left(const struct progress *progress)
{
    const double elapsed = running_seconds() - progress->start;
    const uint64_t own = progress->done - progress->skipped;
    const uint64_t left = progress->total - progress->done;
    return elapsed < PATIENCE || own == 0 ? 0.0 : elapsed * (double)left / (double)own;
}

static void print_left(double seconds)
{
    if (seconds < 90.0) {
        fprintf(stderr, " (%.0f s left)", seconds < 1.0 ? 1.0 : seconds);
    } else if (seconds < 5400.0) {
        fprintf(stderr, " (%.0f min left)", seconds / 60.0);
    } else {
        fprintf(stderr, " (%.1f h left)", seconds / 3600.0);
    }
}

/* Prints the ticks up to what is done. The last of them may come with the time. */
static void print(struct progress *progress)
{
    if (!progress->shown) {
        return;
    }
    const double share = (double)progress->done / (double)progress->total;
    const int ticks = (int)(TICKS * share);
    const bool is_number = ticks % 4 == 0;
    if (progress->ticks > ticks) {
        return;
    }
    for (; progress->ticks <= ticks; progress->ticks++) {
        if (progress->ticks % 4 == 0) {
            fprintf(stderr, "%d", progress->ticks / 4 * 10);
        } else {
            fputc('.', stderr);
        }
    }
    const double left = is_number || !progress->told_left ? seconds_left(progress) : 0.0;
    if (left > 0.0) {
        print_left(left);
        progress->told_left = true;
    }
    fflush(stderr);
}

void progress_start(struct progress *progress, uint64_t total, bool quiet)
{
    *progress = (struct progress){
        .shown = !quiet && STDERR_IS_TERMINAL(), .total = total, .start = running_seconds()};
    print(progress);
}

void progress_add(struct progress *progress, uint64_t count)
{
    const uint64_t left = progress->total - progress->done;
    progress->done += count < left ? count : left;
    print(progress);
}

void progress_skip(struct progress *progress, uint64_t count)
{
    const uint64_t before = progress->done;
    progress_add(progress, count);
    progress->skipped += progress->done - before;
}

void progress_end(struct progress *progress, bool succeeded)
{
    if (progress->shown) {
        fputs(succeeded ? " - done.\n" : "\n", stderr);
    }
    progress->shown = false;
}
