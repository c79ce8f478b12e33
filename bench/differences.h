/* SPDX-License-Identifier: MIT
 *
 * Gradients from differences of values: what a library without derivatives leaves its users to do.
 * Included by subject.c.
 */
#ifndef SCARP_BENCH_DIFFERENCES_H
#define SCARP_BENCH_DIFFERENCES_H

#include <stddef.h>

/* Writes the noise at (x[0][i], x[1][i], x[2][i]) to value[i], for each i < count. */
typedef void bench_values_fn(const void *state, size_t count, const float *const x[3],
                             float *value);

/* A function that gives values, and how many coordinates it takes. */
struct bench_field {
    bench_values_fn *values;
    const void *state; /* its first argument */
    int dimensions;
};

/* Computes the values of the field at `count` points, and its gradient: from central differences,
   or from forward ones if `central` is 0. */
void bench_differences(const struct bench_field *field, int central, size_t count,
                       const float *const x[3], float *value, float *const gradient[3]);

#endif
