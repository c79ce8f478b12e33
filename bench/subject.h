/* SPDX-License-Identifier: MIT
 *
 * A subject: one workload by one library with one instruction set, ready to be run and timed.
 * Included by main.c and measure.c.
 */
#ifndef SCARP_BENCH_SUBJECT_H
#define SCARP_BENCH_SUBJECT_H

#include "arrays.h"
#include "bench.h"
#include "peer.h"
#include "work.h"

struct bench_subject {
    struct bench_work work;
    const struct bench_peer *peer; /* NULL: scarp itself */
    enum scarp_isa isa;
    struct scarp_noise noise;
    void *state;    /* the peer's, or scarp's plan */
    size_t scratch; /* of a recipe by scarp: bytes, or BENCH_BEST_SCRATCH */
    char note[40];  /* how what the peer does differs from a workload with a title */
    const struct bench_arrays *arrays;
    const struct bench_coordinates *samples_at; /* of a grid as points */
    unsigned long iterations;                   /* of one timed slice */
    int turns;             /* how many slices are timed: as many as repeats, or fewer */
    int timed;             /* how many have been */
    double *samples;       /* nanoseconds per point, one per timed slice */
    struct bench_row *row; /* where the result goes */
};

/* Whether scarp, or the peer, can do the workload with the instruction set; if so, *subject is
   ready but for `arrays`, `samples_at`, `samples` and `row`. `scratch` is for recipes: how many
   bytes they get, or BENCH_BEST_SCRATCH. */
int bench_subject_make(struct bench_subject *subject, const struct bench_work *work,
                       const struct bench_peer *peer, enum scarp_isa isa, size_t scratch);
void bench_subject_free(struct bench_subject *subject);

/* Says how the gradient is made: "central differences" for example, or "" for a closed form; and
   what else a peer does where it has not the same. */
const char *bench_subject_note(const struct bench_subject *subject);

/* Makes the call once, to see whether it works. A peer that has several ways finds the fastest,
   which is then named in the row. Ask this before anything is timed. */
enum scarp_status bench_subject_try(const struct bench_subject *subject);

/* Runs the workload that many times. */
void bench_subject_run(const struct bench_subject *subject, unsigned long iterations);

#endif
