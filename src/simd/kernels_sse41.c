/* SPDX-License-Identifier: MIT
 *
 * The kernels for SSE4.1. The target pragma switches the instructions on for this file only, so no
 * compiler flag is needed; everything but the table is static, so none of this code leaks.
 */
#include "../dispatch/kernels.h"
#include "body.h"

#if SCARP_HAS_SSE41

#include <immintrin.h> /* before the region: its functions carry their own targets */

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("sse4.1"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("sse4.1")
#endif

#include "vec_sse41.h"

#define KERNELS scarpi_kernels_sse41
#define KERNELS_ISA SCARP_ISA_SSE41
#include KERNELS_BODY

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#else
typedef int scarp_not_x86; /* ISO C wants a declaration in every file */
#endif
