/* SPDX-License-Identifier: MIT
 *
 * Gradients from differences of values: what a library without derivatives leaves its users to do.
 * Included by subject.c.
 */
#ifndef SCARP_BENCH_DIFFERENCES_H
#define SCARP_BENCH_DIFFERENCES_H

#include <stddef.h>

/* The noise at (x[0][i], x[1][i], x[2][i]), for each i < count, into value[i] */
typedef void bench_values_fn(const void *state, size_t count, const float *const x[3],
                             float *value);

/* What gives values, and for how many coordinates */
struct bench_field {
    bench_values_fn *values;
    const void *state; /* its first argument */
    int dimensions;
};

/* The values of the field at `count` points, and its gradient from central differences, from
   forward ones if `central` is 0. */
void bench_differences(const struct bench_field *field, int central, size_t count,
                       const float *const x[3], float *value, float *const gradient[3]);

#endif
