/* SPDX-License-Identifier: MIT
 *
 * The kernels for AVX2 and FMA, which all but a few processors have together; those few take
 * SSE4.1. The target pragma switches the instructions on for this file only, so no compiler flag
 * is needed; everything but the table is static, so none of this code leaks.
 */
#include "../dispatch/kernels.h"
#include "body.h"

#if SCARP_HAS_AVX2

#include <immintrin.h> /* before the region: its functions carry their own targets */

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif

#include "vec_avx2.h"

#define KERNELS scarpi_kernels_avx2
#define KERNELS_ISA SCARP_ISA_AVX2
#include KERNELS_BODY

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#else
typedef int scarp_no_avx; /* ISO C wants a declaration in every file */
#endif
