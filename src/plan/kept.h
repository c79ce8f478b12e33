/* SPDX-License-Identifier: MIT
 *
 * The plan that a noise brings: what is in a struct scarp_plan, and whether it fits. Calls of one
 * point take some 25 ns, so this is inlined into them.
 */
#ifndef SCARP_KEPT_H
#define SCARP_KEPT_H

#include <stddef.h>
#include <string.h>

#include "parameters.h"

/* What is in a struct scarp_plan, or, with as many octaves as are needed, in the plan of a recipe:
   the constants of a noise without its warp. */
struct kept {
    uint64_t mark;                 /* the version, and for which calls it is */
    struct scarp_noise noise;      /* without pointers */
    struct scarp_call_plan values; /* of a call that asks for values. It does not point at the
                                      octaves: plans are copied. */
    struct scarp_octave octave[];  /* of all components, one after the other */
};

_Static_assert(sizeof(struct kept) + 50 * sizeof(struct scarp_octave) <=
                       sizeof(struct scarp_plan) &&
                   _Alignof(struct kept) <= _Alignof(struct scarp_plan),
               "a plan has room for 50 octaves, as scarp.h says");

/* "SCRP", the version, since octaves may differ between versions, the dimensions, and whether it
   has a component for each axis. */
static inline uint64_t mark_of(int dimensions, int is_vector)
{
    return UINT64_C(0x53435250) << 32 | SCARP_VERSION_MAJOR << 24 | SCARP_VERSION_MINOR << 16 |
           SCARP_VERSION_PATCH << 8 | (unsigned)dimensions | (is_vector ? 16u : 0u);
}

/* What is compared at once. */
typedef uint64_t pair __attribute__((vector_size(16)));

static inline pair difference_at(const void *a, const void *b, size_t at)
{
    pair x, y;
    memcpy(&x, (const char *)a + at, sizeof x);
    memcpy(&y, (const char *)b + at, sizeof y);
    return x ^ y;
}

/* Ones where bytes from `first` to before `end` differ. The last pair overlaps the one before. */
static inline pair differences(const void *a, const void *b, size_t first, size_t end)
{
    pair different = difference_at(a, b, end - sizeof(pair));
    for (size_t i = first; i + sizeof(pair) < end; i += sizeof(pair)) {
        different |= difference_at(a, b, i);
    }
    return different;
}

/* Whether two noises have the same bytes, but for their pointers. */
static inline int same_noise(const struct scarp_noise *a, const struct scarp_noise *b)
{
    _Static_assert(offsetof(struct scarp_noise, plan) ==
                       offsetof(struct scarp_noise, warp) + sizeof(uintptr_t),
                   "pointers are next to each other");
    const size_t warp = offsetof(struct scarp_noise, warp);
    const pair before = differences(a, b, 0, warp);
    const pair different = before | differences(a, b, warp + 2 * sizeof(uintptr_t), sizeof *a);
    return (different[0] | different[1]) == 0;
}

/* The plan that a noise brings, if it fits, or NULL. What fits needs no check: a plan was made of
   it. Its warp is another matter. */
static inline const struct kept *kept_of(const struct scarp_noise *noise, int dimensions,
                                         int is_vector)
{
    const struct kept *const kept = (const struct kept *)noise->plan;
    return kept != NULL && kept->mark == mark_of(dimensions, is_vector) &&
                   same_noise(noise, &kept->noise)
               ? kept
               : NULL;
}

/* Makes of it the plan of a call that asks for values. */
static inline void plan_of_kept(struct scarp_call_plan *plan, const struct kept *kept)
{
    *plan = kept->values;
    plan->octave = kept->octave;
}

/* Makes the plan of a call of the plan that the noise brings. Returns 0 if that does not fit, if
   the noise has a warp, or if it does not have what is asked for. */
static inline int plan_kept(struct scarp_call_plan *plan, const struct scarp_noise *noise,
                            struct scarp_request request)
{
    const struct kept *const kept = kept_of(noise, request.dimensions, 0);
    if (kept == NULL || noise->warp != NULL || !has_outputs(noise, request)) {
        return 0;
    }
    plan_of_kept(plan, kept);
    plan_ask(plan, request);
    return 1;
}

#endif
