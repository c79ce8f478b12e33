/* SPDX-License-Identifier: MIT
 *
 * What public functions have in common: points and their checks, and a plan on the stack.
 */
#ifndef SCARP_RUN_H
#define SCARP_RUN_H

#include <stddef.h>

#include "../dispatch/kernels.h"

/* Arithmetic in the default floating-point mode is in functions of this kind, so that none of
   it (comparisons trap too) can be moved across the change of mode in their caller. */
#define NOINLINE __attribute__((noinline))
#define ALWAYS_INLINE inline __attribute__((always_inline))

/* The points of a call. `doubles` says what `position` has. */
struct scarp_at {
    size_t count;
    const void *position[3];
    int dimensions, doubles;
};

/* Makes the checks of points, whose coordinates have so many bytes. */
static ALWAYS_INLINE enum scarp_status
scarpi_check_points(size_t count, const void *const position[3], int dimensions, size_t bytes)
{
    for (int i = 0; i < dimensions; i++) {
        if (position[i] == NULL) {
            return SCARP_ERROR_NULL;
        }
    }
    return count > PTRDIFF_MAX / bytes ? SCARP_ERROR_SIZE : SCARP_OK;
}

/* Whether reserved members are set. */
static inline int spare_in_use(const struct scarp_samples *samples)
{
    int used = 0;
    for (size_t i = 0; i < sizeof samples->spare / sizeof samples->spare[0]; i++) {
        used |= samples->spare[i] != NULL;
    }
    return used;
}

/* The order of a call that asks for something that does not exist: in 2D for derivatives along z,
   for reserved members. */
#define SCARP_UNSUPPORTED_ORDER 3

/* What is asked for by a call for samples. */
struct scarp_request scarpi_request_of_samples(int dimensions, const struct scarp_samples *out);

/* The arrays of `out` as a list. */
const struct scarp_outputs *scarpi_outputs_of(const struct scarp_samples *out);

/* What a call does with its plan. */
typedef void scarpi_run_fn(const struct scarp_call_plan *plan, const void *call);

/* Makes the plan of a call, whose octaves need some KiB of stack, and runs what the call does. */
NOINLINE enum scarp_status scarpi_run(const struct scarp_noise *noise, struct scarp_request request,
                                      scarpi_run_fn *compute, const void *call);

/* What is computed at points: cells, velocities, vectors. */
struct scarp_computation {
    int (*refuses)(const void *out, int dimensions); /* what does not exist */
    struct scarp_request (*request)(const void *out, int dimensions);
    scarpi_run_fn *compute; /* takes a struct scarp_arguments */
};

struct scarp_arguments {
    const struct scarp_kernels *kernels;
    const struct scarp_noise *noise;
    const struct scarp_at *at;
    const void *out;
};

/* Makes such a call, with all checks. */
enum scarp_status scarpi_run_at_points(const struct scarp_computation *computation,
                                       const struct scarp_noise *noise, const struct scarp_at *at,
                                       const void *out);

#endif
