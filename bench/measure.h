/* SPDX-License-Identifier: MIT
 *
 * The timing of subjects. Included by main.c.
 */
#ifndef SCARP_BENCH_MEASURE_H
#define SCARP_BENCH_MEASURE_H

#include "subject.h"

struct bench_method {
    double min_time; /* seconds for which each subject is timed, over all repeats */
    int repeat;
    int progress; /* tell stderr how far it is */
};

/* Times `count` subjects, and fills their rows with median, minimum and spread. */
void bench_measure(const struct bench_method *method, struct bench_subject *subjects, size_t count);

#endif
