/* SPDX-License-Identifier: MIT
 *
 * What the files of scarp-bench share: exit statuses, errors, rows of results, and what is known
 * about the machine. Included by nearly all of them.
 */
#ifndef SCARP_BENCH_BENCH_H
#define SCARP_BENCH_BENCH_H

#include <stddef.h>

#include "work.h"

enum bench_exit {
    BENCH_SUCCESS = 0,
    BENCH_FAILURE = 1, /* something went wrong on the way: a full disk, no memory */
    BENCH_USAGE = 2    /* the command line asks for what is not possible; nothing was written */
};

/* Prints "scarp-bench: ", the message and a newline on stderr. It stays one line whatever the
   arguments hold: control characters become '?'. */
#if defined(__clang__) || (defined(__GNUC__) && !defined(_WIN32))
__attribute__((format(printf, 1, 2)))
#endif
void bench_error(const char *format, ...);

/* One result: a workload by a library with an instruction set. */
struct bench_row {
    char work[BENCH_NAME_SIZE], library[32], isa[16];
    char note[40]; /* empty, or how the result came about */
    char way[24];  /* empty, or which way of several was the fastest, and was measured */
    size_t points;
    double median, minimum; /* nanoseconds per point */
    double spread;          /* distance of the quartiles over the median */
};

struct bench_report {
    char version[32], cpu[128], compiler[160], flags[256], isas[64], date[32];
    double min_time;
    int repeat;
    struct bench_row *rows;
    size_t count;
};

/* platform.c asks the operating system. */
double bench_seconds(void); /* processor time of this thread */
int bench_is_terminal_stderr(void);
void bench_cpu_name(char *name, size_t size);
void bench_utc_date(char *date, size_t size);

#endif
