/* SPDX-License-Identifier: MIT
 *
 * The kernels for AVX-512. The target pragma switches the instructions on for this file only, so
 * no compiler flag is needed; everything but the table is static, so none of this code leaks.
 */
#include "../dispatch/kernels.h"
#include "body.h"

#if SCARP_HAS_AVX512

#include <immintrin.h> /* before the region: its functions carry their own targets */

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))),        \
                             apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl")
#endif

#include "vec_avx512.h"

#define KERNELS scarpi_kernels_avx512
#define KERNELS_ISA SCARP_ISA_AVX512
/* On Zen 4, with 4 blocks 64 points of gradient noise take 4 to 14 % more, with 2 blocks 48 points
   of value noise 10 to 14 %. */
#define ONE_BLOCKS 3
/* On Zen 4, a block of 16 points of eight octaves takes 220 to 360 ns, one of 8 points in AVX2 170
   to 260. (In AVX2, one point takes no longer than in SSE4.1.) */
#if SCARP_HAS_AVX2
#define KERNELS_NARROWER scarpi_kernels_avx2
#define FEW_ORDER 0 /* few points with gradients are AVX2's, too */
#endif
#ifdef __clang__ /* whose frames are larger still; gradients of fBm on grids take up to 15 %       \
                    longer */
#define TILE_ROWS 32
#define SCRATCH_BYTES (25 * 1024)
#else
#define TILE_ROWS 48 /* frames are large */
#endif
#include KERNELS_BODY

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#else
typedef int scarp_no_avx; /* ISO C wants a declaration in every file */
#endif
