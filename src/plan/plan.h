/* SPDX-License-Identifier: MIT
 *
 * Makes plans (call.h) of descriptions: on the stack of a call, or in a struct scarp_plan, which
 * the caller keeps. check.c checks the noise, octaves.c computes the constants.
 */
#ifndef SCARP_PLAN_H
#define SCARP_PLAN_H

#include "call.h"

/* The bytes that scarpi_plan_keep() needs for a checked noise. */
size_t scarpi_plan_bytes(const struct scarp_noise *noise, int dimensions, int is_vector);

/* Checks a noise and makes the plan that callers keep (kept.h), in memory of at least
   sizeof(struct kept) bytes that has the alignment of a uint64_t. If the memory is too small for
   all octaves, that is a plan which fits no noise. */
enum scarp_status scarpi_plan_keep(void *memory, size_t size, const struct scarp_noise *noise,
                                   int dimensions, int is_vector);

/* Whether the plan of a call that asks for this needs levels: those of a noise with warps, and of potentials. */
static inline int scarpi_has_levels(const struct scarp_noise *noise, struct scarp_request request)
{
    return noise->warp != NULL || request.vector;
}

/* Checks the noise and makes the plan of a call. `octave`, with room for all of them, or
   for SCARP_MAX_OCTAVES with levels, and `levels` belong to the plan. A plan with levels has no
   octaves, but its levels have them; one without needs no `levels`. Plans that the noise and its
   warps bring are taken where they fit. */
enum scarp_status scarpi_plan_call(struct scarp_call_plan *plan, struct scarp_octave *octave,
                                   struct scarp_levels *levels, const struct scarp_noise *noise,
                                   struct scarp_request request);

#endif
