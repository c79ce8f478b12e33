/* SPDX-License-Identifier: MIT
 *
 * src/simd/kernels_neon.c with a mistake.
 */
#include "../../src/kernels.h"

#include "../../src/simd/vec_neon.h"

#define KERNELS scarp_kernels_neon
#define KERNELS_ISA SCARP_ISA_NEON
#include "mistakes.h"
