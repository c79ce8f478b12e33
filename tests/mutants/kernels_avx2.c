/* SPDX-License-Identifier: MIT
 *
 * src/simd/kernels_avx2.c with a mistake.
 */
#include <immintrin.h>

#include "../../src/kernels.h"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

#include "../../src/simd/vec_avx2.h"

#define KERNELS scarp_kernels_avx2
#define KERNELS_ISA SCARP_ISA_AVX2
#include "mistakes.h"

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
