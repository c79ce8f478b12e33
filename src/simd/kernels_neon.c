/* SPDX-License-Identifier: MIT
 *
 * The kernels for NEON, which is part of the AArch64 baseline and needs no switching on.
 */
#include "../dispatch/kernels.h"
#include "body.h"

#if SCARP_HAS_NEON

#include "vec_neon.h"

#define KERNELS scarpi_kernels_neon
#define KERNELS_ISA SCARP_ISA_NEON
#include KERNELS_BODY

#else
typedef int scarp_not_aarch64; /* ISO C wants a declaration in every file */
#endif
