/* SPDX-License-Identifier: MIT
 *
 * The types of the vector operations, made from VEC_LANES. Each vec_<isa>.h includes this first,
 * then writes its own operations with these types, then includes vec.h.
 *
 * They are vectors of gcc and clang: + - * / << >> ^ & | ~ work on them lane by lane, and
 * comparisons give all ones or 0 in each lane.
 */
#ifndef SCARP_SIMD_VEC_TYPES_H
#define SCARP_SIMD_VEC_TYPES_H

#include <stdint.h>
#include <string.h>

#include "lookup.h"

#define VEC_BYTES (4 * VEC_LANES)
#define VEC_INLINE static inline __attribute__((always_inline))

/* VEC_LANES floats. */
typedef float vf __attribute__((vector_size(VEC_BYTES)));

struct vf_four {
    vf v[4];
};

/* VEC_LANES unsigned integers; + - * wrap, >> shifts in zeros. */
typedef uint32_t vu __attribute__((vector_size(VEC_BYTES)));

/* VEC_LANES signed integers, for conversion; >> shifts in the sign. */
typedef int32_t vi __attribute__((vector_size(VEC_BYTES)));

/* VEC_LANES / 2 doubles: a vf's worth of doubles is a pair (low lanes, high lanes). */
typedef double vd __attribute__((vector_size(VEC_BYTES)));

#endif
