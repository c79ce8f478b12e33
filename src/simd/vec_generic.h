/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h as they are there, for any processor: 4 lanes, which most processors
 * have registers for.
 */
#ifndef SCARP_SIMD_VEC_GENERIC_H
#define SCARP_SIMD_VEC_GENERIC_H

#ifndef VEC_LANES
#define VEC_LANES 4
#endif

/* On x86 it serves processors only from before 2008: all others have a set of their own. */
#if SCARP_X86 && !defined(VEC_SMALL)
#define VEC_SMALL 1
#endif

#include "vec_types.h"

#include "vec.h"

#endif
