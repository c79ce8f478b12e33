/* SPDX-License-Identifier: MIT
 *
 * The timing of subjects. Included by main.c.
 */
#ifndef SCARP_BENCH_MEASURE_H
#define SCARP_BENCH_MEASURE_H

#include "subject.h"

/* Where on stderr progress is written */
enum bench_progress {
    BENCH_PROGRESS_NONE,
    BENCH_PROGRESS_TERMINAL, /* on one line, which is written over */
    BENCH_PROGRESS_LINES     /* a line every BENCH_PROGRESS_SECONDS */
};

#define BENCH_PROGRESS_SECONDS 10

struct bench_method {
    double min_time; /* seconds for which each subject is timed, over all repeats */
    int repeat;
    enum bench_progress progress;
};

/* Times `count` subjects, and fills their rows with median, minimum and spread. */
void bench_measure(const struct bench_method *method, struct bench_subject *subjects, size_t count);

#endif
