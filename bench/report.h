/* SPDX-License-Identifier: MIT
 *
 * The forms in which results are printed, and the reading back of one of them. Included by main.c.
 */
#ifndef SCARP_BENCH_REPORT_H
#define SCARP_BENCH_REPORT_H

#include <stdio.h>

#include "bench.h"

/* Each writes the whole report; ferror tells whether that failed. */
void bench_write_text(FILE *file, const struct bench_report *report);
void bench_write_markdown(FILE *file, const struct bench_report *report);
void bench_write_json(FILE *file, const struct bench_report *report);

/* Likewise, but returns 0 if memory runs out. */
int bench_write_chart(FILE *file, const struct bench_report *report);

/* Adds what bench_write_json wrote to *report: rows that it has not yet and, to an empty report,
   what is above them. report->rows is reallocated. Returns NULL, or what is wrong. */
const char *bench_read_json(FILE *file, struct bench_report *report);

/* The row of a workload by a library with an instruction set; NULL if there is none */
const struct bench_row *bench_find_row(const struct bench_report *report, const char *work,
                                       const char *library, const char *isa);

/* The workload of whose result `work` is a costlier form: "<stem>/+gradient" for a row of
   differences, otherwise `work` itself. */
void bench_group_name(const char *work, char *name, size_t size);

#endif
