/* SPDX-License-Identifier: MIT
 *
 * The timing of subjects. Each is calibrated first: how many iterations fill its slice, min_time /
 * repeat. Then all subjects are timed in turn, and again, `repeat` times over (A B C A B C ...), so
 * that a machine that slows down or is disturbed for a while does so to all alike. Every slice is
 * preceded by a tenth of it that is not timed: it refills the caches, teaches the branch predictors
 * and gives the processor time to change its clock for wide vectors. A call that is longer than its
 * slice has no need of that; and it is left out of some passes, so that min_time still holds or
 * only three slices are timed.
 */
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LEAST_TURNS 3

static double time_slice(const struct bench_subject *subject, unsigned long iterations)
{
    const double start = bench_seconds();
    bench_subject_run(subject, iterations);
    return bench_seconds() - start;
}

/* Finds how many calls fill a slice. Doubles them until a run is long enough to measure, then
   scales up. The first run does not count unless it fills the slice by itself. */
static void calibrate(const struct bench_method *method, struct bench_subject *subject)
{
    const double slice = method->min_time / method->repeat;
    const double trial = slice < 0.001 ? slice : 0.001;
    unsigned long iterations = 1;
    double elapsed = time_slice(subject, 1);
    if (elapsed < slice) {
        elapsed = time_slice(subject, 1);
    }
    while (elapsed < trial && iterations < (1ul << 30)) {
        iterations *= 2;
        elapsed = time_slice(subject, iterations);
    }
    const double scaled = (double)iterations * (slice / elapsed);
    subject->iterations = scaled < 1 ? 1 : scaled > 1e9 ? 1000000000ul : (unsigned long)scaled;
    subject->turns = method->repeat;
    if (scaled < 1 && method->repeat > LEAST_TURNS) {
        const int fitting = (int)(scaled * method->repeat);
        subject->turns = fitting > LEAST_TURNS ? fitting : LEAST_TURNS;
    }
    subject->timed = 0;
}

/* Whether the subject is timed in this pass: its turns are spread evenly over all passes. */
static int has_turn(const struct bench_subject *subject, int pass, int repeat)
{
    return (pass + 1) * subject->turns / repeat > pass * subject->turns / repeat;
}

static void time_turn(struct bench_subject *subject)
{
    if (subject->iterations > 1) {
        bench_subject_run(subject, subject->iterations / 10 + 1);
    }
    const double elapsed = time_slice(subject, subject->iterations);
    subject->samples[subject->timed++] =
        elapsed * 1e9 / (double)subject->iterations / (double)subject->work.points;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The q-quantile of sorted values, linear between neighbours */
static double quantile(const double *sorted, int count, double q)
{
    const double at = q * (count - 1);
    const int i = (int)at;
    const int next = i + 1 < count ? i + 1 : i;
    return sorted[i] + (at - i) * (sorted[next] - sorted[i]);
}

static void summarise(struct bench_subject *subject)
{
    struct bench_row *const row = subject->row;
    double *const samples = subject->samples;
    qsort(samples, (size_t)subject->timed, sizeof *samples, compare_doubles);
    row->median = quantile(samples, subject->timed, 0.5);
    row->minimum = samples[0];
    row->spread =
        (quantile(samples, subject->timed, 0.75) - quantile(samples, subject->timed, 0.25)) /
        row->median;
}

/* How far a measurement is, and when that was last said */
struct progress {
    enum bench_progress to;
    int passes; /* including the one that calibrates */
    size_t subjects;
    double start, said;
};

/* What is left takes as long per pass as the passes so far; calibrating takes about as long as one.
 */
static void say_progress(struct progress *p, int pass, size_t i)
{
    const double now = bench_seconds(), done = pass + (double)i / (double)p->subjects;
    const double left = done > 0 ? (now - p->start) * (p->passes - done) / done : 0;
    if (p->to == BENCH_PROGRESS_TERMINAL) {
        fprintf(stderr, "\rpass %d of %d: %3.0f %%, %.0f s left ", pass, p->passes - 1,
                (double)i * 100 / (double)p->subjects, left);
        fflush(stderr);
    } else if (p->to == BENCH_PROGRESS_LINES && now - p->said >= BENCH_PROGRESS_SECONDS) {
        fprintf(stderr, "scarp-bench: %3.0f %%, %.0f s left\n", done * 100 / p->passes, left);
        p->said = now;
    }
}

static void end_progress(const struct progress *p)
{
    if (p->to == BENCH_PROGRESS_TERMINAL) {
        fprintf(stderr, "\r%50s\r", "");
    }
}

void bench_measure(const struct bench_method *method, struct bench_subject *subjects, size_t count)
{
    const double start = bench_seconds();
    struct progress progress = {method->progress, method->repeat + 1, count, start, start};
    for (size_t i = 0; i < count; i++) {
        say_progress(&progress, 0, i);
        calibrate(method, &subjects[i]);
    }
    for (int pass = 0; pass < method->repeat; pass++) {
        for (size_t i = 0; i < count; i++) {
            say_progress(&progress, pass + 1, i);
            if (has_turn(&subjects[i], pass, method->repeat)) {
                time_turn(&subjects[i]);
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        summarise(&subjects[i]);
    }
    end_progress(&progress);
}
