/* SPDX-License-Identifier: MIT
 *
 * The kernels in vector extensions alone, for the processor that the compiler builds for. The
 * compiler finds its instructions, or does without vectors.
 */
#include "../kernels.h"
#include "body.h"

#if SCARP_GENERIC

#include "vec_generic.h"

#define KERNELS scarp_kernels_generic
#define KERNELS_ISA SCARP_ISA_GENERIC
#include KERNELS_BODY

#else
typedef int scarp_no_generic; /* ISO C wants a declaration in every file */
#endif
