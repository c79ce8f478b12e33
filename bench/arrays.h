/* SPDX-License-Identifier: MIT
 *
 * The arrays that workloads read and write.
 */
#ifndef SCARP_BENCH_ARRAYS_H
#define SCARP_BENCH_ARRAYS_H

#include "work.h"

/* Where the samples of a grid are, for the workloads that read them as points. */
struct bench_coordinates {
    size_t grid[3];
    float step;
    double *axis[3]; /* each coordinate of each sample, x innermost */
    struct bench_coordinates *next;
};

/* Arrays for the largest workloads, shared by all subjects */
struct bench_arrays {
    float *points[3][3];   /* by pattern, then axis */
    double *points_f64[3]; /* random */
    float *outputs[10];    /* in the order of struct scarp_samples */
    struct bench_coordinates *coordinates;
};

/* How many elements the arrays need: grids read no points, and few workloads write all outputs. */
struct bench_sizes {
    size_t points, outputs[10];
};

/* Counts the output arrays up to the last one that the workload writes. */
int bench_count_outputs(const struct bench_work *work);

/* Raises the sizes to what the workload needs. */
void bench_sizes_raise(struct bench_sizes *sizes, const struct bench_work *work);

/* Makes an array that begins with a cache line (not on Windows), by which large grids gain. It is
   zeroed, so that its pages exist before anything is timed, and never empty, so that NULL always
   means an error. free() takes it. */
void *bench_array_make(size_t count, size_t element);

/* Makes and fills arrays. Returns 0 without memory; bench_arrays_free is needed anyway. */
int bench_arrays_make(struct bench_arrays *arrays, const struct bench_sizes *sizes);
void bench_arrays_free(struct bench_arrays *arrays);

/* The coordinates of the samples of a workload's grid, which are made once for all workloads with
   that grid. Returns NULL without memory. */
const struct bench_coordinates *bench_arrays_samples(struct bench_arrays *arrays,
                                                     const struct bench_work *work);

#endif
