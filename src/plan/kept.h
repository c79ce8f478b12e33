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

/* What is in a struct scarp_plan. */
struct kept {
    uint64_t mark; /* the version, and for how many dimensions it is */
    struct scarp_noise noise;
    struct scarp_octave octave[SCARP_MAX_OCTAVES];
    struct scarp_call_plan values; /* of a call that asks for values. It does not point at the
                                      octaves: plans are copied. */
};

_Static_assert(sizeof(struct kept) <= sizeof(struct scarp_plan) &&
                   _Alignof(struct kept) <= _Alignof(struct scarp_plan),
               "a plan has room for what is kept");

/* "SCRP", the version, since octaves may differ between versions, and the dimensions. */
static inline uint64_t mark_of(int dimensions)
{
    return UINT64_C(0x53435250) << 32 | SCARP_VERSION_MAJOR << 24 | SCARP_VERSION_MINOR << 16 |
           SCARP_VERSION_PATCH << 8 | (unsigned)dimensions;
}

/* What is compared at once. */
typedef uint64_t pair __attribute__((vector_size(16)));

static inline pair difference(const void *a, const void *b, size_t at)
{
    pair x, y;
    memcpy(&x, (const char *)a + at, sizeof x);
    memcpy(&y, (const char *)b + at, sizeof y);
    return x ^ y;
}

/* Ones where bytes from `first` to before `end` differ. The last pair overlaps the one before. */
static inline pair differences(const void *a, const void *b, size_t first, size_t end)
{
    pair different = difference(a, b, end - sizeof(pair));
    for (size_t i = first; i + sizeof(pair) < end; i += sizeof(pair)) {
        different |= difference(a, b, i);
    }
    return different;
}

/* Whether two noises have the same bytes, but for `plan`. */
static inline int same_noise(const struct scarp_noise *a, const struct scarp_noise *b)
{
    const size_t plan = offsetof(struct scarp_noise, plan);
    const pair before = differences(a, b, 0, plan);
    const pair different = before | differences(a, b, plan + sizeof(uintptr_t), sizeof *a);
    return (different[0] | different[1]) == 0;
}

/* Makes the plan of a call of the plan that the noise brings. Returns 0 if that does not fit, or if
   the noise does not have what is asked for. No plan fits a noise with a warp, which may have
   changed. */
static inline int plan_kept(struct scarp_call_plan *plan, const struct scarp_noise *noise,
                            struct scarp_request request)
{
    const struct kept *const kept = (const struct kept *)noise->plan;
    /* A noise that a plan was made of needs no check. */
    if (kept == NULL || kept->mark != mark_of(request.dimensions) ||
        !same_noise(noise, &kept->noise) || !has_outputs(noise, request)) {
        return 0;
    }
    *plan = kept->values;
    plan->octave = kept->octave;
    plan_ask(plan, request);
    return 1;
}

#endif
