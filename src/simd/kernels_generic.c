/* SPDX-License-Identifier: MIT
 *
 * The kernels in vector extensions only, for the processor that the compiler builds for. The
 * compiler finds its instructions, or does without vectors.
 */
#include "../dispatch/kernels.h"
#include "body.h"

#if SCARP_HAS_GENERIC

#include "vec_generic.h"

/* Processors without vectors of 16 bytes: the compiler takes vectors apart, and keeps the pieces in
   frames that are up to three times as large. Parts are smaller there. */
#if !defined(__SSE2__) && !defined(__ARM_NEON) && !defined(__ALTIVEC__)
#define SCRATCH_BYTES (20 * 1024)
#endif

#define KERNELS scarpi_kernels_generic
#define KERNELS_ISA SCARP_ISA_GENERIC
#include KERNELS_BODY

#else
typedef int scarp_no_generic; /* ISO C wants a declaration in every file */
#endif
