/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h on AVX-512 (F, BW, DQ, VL): 16 lanes. Included by kernels_avx512.c inside
 * its target region.
 */
#ifndef SCARP_SIMD_VEC_AVX512_H
#define SCARP_SIMD_VEC_AVX512_H

#include <immintrin.h>
#include <stdint.h>

#include "lookup.h"

#define VEC_LANES 16
#define VEC_INLINE static inline __attribute__((always_inline))

typedef float vf __attribute__((vector_size(64)));
typedef uint32_t vu __attribute__((vector_size(64)));
typedef int32_t vi __attribute__((vector_size(64)));
typedef double vd __attribute__((vector_size(64)));

VEC_INLINE vf vf_load(const float *p)
{
    return (vf)_mm512_loadu_ps(p);
}

VEC_INLINE void vf_store(float *p, vf v)
{
    _mm512_storeu_ps(p, (__m512)v);
}

#define VEC_STREAMS 1

VEC_INLINE void vf_stream(float *p, vf v)
{
    _mm512_stream_ps(p, (__m512)v);
}

VEC_INLINE void vf_stream_end(void)
{
    _mm_sfence();
}

VEC_INLINE vd vd_load(const double *p)
{
    return (vd)_mm512_loadu_pd(p);
}

VEC_INLINE vf vf_set(float a)
{
    return (vf)_mm512_set1_ps(a);
}

VEC_INLINE vu vu_set(uint32_t a)
{
    return (vu)_mm512_set1_epi32((int)a);
}

VEC_INLINE vd vd_set(double a)
{
    return (vd)_mm512_set1_pd(a);
}

VEC_INLINE vf vf_floor(vf a)
{
    return (vf)_mm512_floor_ps((__m512)a);
}

VEC_INLINE vd vd_floor(vd a)
{
    return (vd)_mm512_floor_pd((__m512d)a);
}

VEC_INLINE vu vu_from_vf(vf a)
{
    return (vu)_mm512_cvttps_epi32((__m512)a);
}

VEC_INLINE vf vf_from_vi(vi a)
{
    return (vf)_mm512_cvtepi32_ps((__m512i)a);
}

VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    return (vf)_mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps((__m512d)low)),
                                  _mm512_cvtpd_ps((__m512d)high), 1);
}

VEC_INLINE vd vd_from_low(vf a)
{
    return (vd)_mm512_cvtps_pd(_mm512_castps512_ps256((__m512)a));
}

VEC_INLINE vd vd_from_high(vf a)
{
    return (vd)_mm512_cvtps_pd(_mm512_extractf32x8_ps((__m512)a, 1));
}

VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    return (vu)_mm512_inserti32x8(_mm512_castsi256_si512(_mm512_cvtepi64_epi32((__m512i)low)),
                                  _mm512_cvtepi64_epi32((__m512i)high), 1);
}

VEC_INLINE vd vd_sqrt(vd a)
{
    return (vd)_mm512_sqrt_pd((__m512d)a);
}

VEC_INLINE vu vu_turn8(vu a)
{
    return (vu)_mm512_ror_epi32((__m512i)a, 8);
}

VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    return (vf)_mm512_permutexvar_ps((__m512i)(hash >> 28), _mm512_load_ps(table->entry));
}

/* (hash >> 16) * 12, shifted so that its whole part is the top byte. */
VEC_INLINE vu vu_top_index(vu hash)
{
    return (vu)_mm512_mulhi_epu16((__m512i)hash, _mm512_set1_epi32(12 << 24));
}

VEC_INLINE vf vf_lookup_top(const struct lookup_top *table, vu index)
{
    const __mmask64 top_bytes = 0x8888888888888888u;
    return (vf)_mm512_maskz_shuffle_epi8(top_bytes, _mm512_load_si512(table->top), (__m512i)index);
}

VEC_INLINE vu vu_load(const uint32_t *p)
{
    return (vu)_mm512_loadu_si512(p);
}

VEC_INLINE void vu_store(uint32_t *p, vu v)
{
    _mm512_storeu_si512(p, (__m512i)v);
}

VEC_INLINE vu vu_lanes(void)
{
    const vu lanes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    return lanes;
}

VEC_INLINE vu vf_index(vu i)
{
    return i;
}

#define VF_INDEX_NEXT 1u

/* A permute of two vectors takes no longer than one of one (measured on Zen 5). */
#define VF_TABLE 32

typedef struct {
    __m512 low, high;
} vf_table;

VEC_INLINE vf_table vf_table_load(const float *p)
{
    const vf_table table = {_mm512_loadu_ps(p), _mm512_loadu_ps(p + 16)};
    return table;
}

VEC_INLINE vf_table vf_table_slide(vf_table table, vf next)
{
    const vf_table slid = {table.high, (__m512)next};
    return slid;
}

VEC_INLINE vf vf_permute(vf_table table, vu index)
{
    return (vf)_mm512_permutex2var_ps(table.low, (__m512i)index, table.high);
}

#define VEC_SHORT_LOOP

#endif
