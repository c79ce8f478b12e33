/* SPDX-License-Identifier: MIT
 *
 * The command line of scarp-bench. Included by main.c.
 */
#ifndef SCARP_BENCH_OPTIONS_H
#define SCARP_BENCH_OPTIONS_H

#include <stddef.h>

#define BENCH_MOST_SCRATCH 8

struct bench_options {
    const char *work; /* patterns between commas; NULL: everything */
    unsigned isas;    /* a bit for each enum scarp_isa */
    double min_time;
    int repeat;
    size_t scratch[BENCH_MOST_SCRATCH]; /* further sizes of the scratch memory of recipes */
    int scratch_count;
    int peers, list, markdown, quiet; /* flags */
    const char *json, *svg;           /* files to write, or NULL */
    const char *from;                 /* files to read, between commas, or NULL */
};

enum bench_outcome {
    BENCH_RUN,
    BENCH_HELP, /* the help was asked for and printed */
    BENCH_BAD   /* one line on stderr says why */
};

/* Fills *options with the defaults, then with what the command line holds. */
enum bench_outcome bench_options_parse(struct bench_options *options, int argc, char **argv);

/* Copies the part of a list between commas that begins at *list to part[size], and moves *list
   behind it. Returns 0 at the end of the list. */
int bench_next_part(const char **list, char *part, size_t size);

#endif
