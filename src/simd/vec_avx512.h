/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h on AVX-512 (F, BW, DQ, VL): 16 lanes.
 */
#ifndef SCARP_SIMD_VEC_AVX512_H
#define SCARP_SIMD_VEC_AVX512_H

#include <immintrin.h>

#define VEC_LANES 16

#include "vec_types.h"

#define VF_LOAD_NATIVE
VEC_INLINE vf vf_load(const float *p)
{
    return (vf)_mm512_loadu_ps(p);
}

#define VF_STORE_NATIVE
VEC_INLINE void vf_store(float *p, vf v)
{
    _mm512_storeu_ps(p, (__m512)v);
}

#define VEC_STREAMS 1

#define VF_STREAM_NATIVE
VEC_INLINE void vf_stream(float *p, vf v)
{
    _mm512_stream_ps(p, (__m512)v);
}

#define VF_STREAM_END_NATIVE
VEC_INLINE void vf_stream_end(void)
{
    _mm_sfence();
}

#define VF_SET_NATIVE
VEC_INLINE vf vf_set(float a)
{
    return (vf)_mm512_set1_ps(a);
}

#define VU_SET_NATIVE
VEC_INLINE vu vu_set(uint32_t a)
{
    return (vu)_mm512_set1_epi32((int)a);
}

#define VD_SET_NATIVE
VEC_INLINE vd vd_set(double a)
{
    return (vd)_mm512_set1_pd(a);
}

#define VF_LOAD_PART_NATIVE
VEC_INLINE vf vf_load_partial(const float *p, size_t n)
{
    const __mmask16 lanes = (__mmask16)((1u << n) - 1);
    return (vf)_mm512_mask_loadu_ps(_mm512_set1_ps(p[0]), lanes, p);
}

#define VD_LOAD_PART_NATIVE
VEC_INLINE vd vd_load_partial(const double *p, size_t n)
{
    const __mmask8 lanes = (__mmask8)((1u << n) - 1);
    return (vd)_mm512_mask_loadu_pd(_mm512_set1_pd(p[0]), lanes, p);
}

#define VF_STORE_PART_NATIVE
VEC_INLINE void vf_store_partial(float *p, vf v, size_t n)
{
    _mm512_mask_storeu_ps(p, (__mmask16)((1u << n) - 1), (__m512)v);
}

#define VU_ANY_NATIVE
VEC_INLINE int vu_any(vu a)
{
    return _mm512_test_epi32_mask((__m512i)a, (__m512i)a) != 0;
}

#define VF_FLOOR_NATIVE
VEC_INLINE vf vf_floor(vf a)
{
    return (vf)_mm512_floor_ps((__m512)a);
}

#define VD_FLOOR_NATIVE
VEC_INLINE vd vd_floor(vd a)
{
    return (vd)_mm512_floor_pd((__m512d)a);
}

#define VU_FROM_VF_NATIVE
VEC_INLINE vu vu_from_vf(vf a)
{
    return (vu)_mm512_cvttps_epi32((__m512)a);
}

#define VF_FROM_VI_NATIVE
VEC_INLINE vf vf_from_vi(vi a)
{
    return (vf)_mm512_cvtepi32_ps((__m512i)a);
}

#define VF_FROM_VD_NATIVE
VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    return (vf)_mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps((__m512d)low)),
                                  _mm512_cvtpd_ps((__m512d)high), 1);
}

#define VF_STORE_VD_NATIVE
VEC_INLINE void vf_store_vd(float *p, vd low, vd high)
{
    _mm256_storeu_ps(p, _mm512_cvtpd_ps((__m512d)low));
    _mm256_storeu_ps(p + 8, _mm512_cvtpd_ps((__m512d)high));
}

#define VD_FROM_LOW_NATIVE
VEC_INLINE vd vd_from_low(vf a)
{
    return (vd)_mm512_cvtps_pd(_mm512_castps512_ps256((__m512)a));
}

#define VD_FROM_HIGH_NATIVE
VEC_INLINE vd vd_from_high(vf a)
{
    return (vd)_mm512_cvtps_pd(_mm512_extractf32x8_ps((__m512)a, 1));
}

#define VU_LOW_BITS_NATIVE
VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    const __m512i even =
        _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    return (vu)_mm512_permutex2var_epi32((__m512i)low, even, (__m512i)high);
}

#define VD_SQRT_NATIVE
VEC_INLINE vd vd_sqrt(vd a)
{
    return (vd)_mm512_sqrt_pd((__m512d)a);
}

#define VEC_MASK_NATIVE
typedef __mmask16 vm;

VEC_INLINE vm vm_less(vf a, vf b)
{
    return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_LT_OQ);
}

VEC_INLINE vm vm_equal(vu a, vu b)
{
    return _mm512_cmpeq_epi32_mask((__m512i)a, (__m512i)b);
}

VEC_INLINE vm vm_bit(vu a, int bit)
{
    return _mm512_test_epi32_mask((__m512i)a, _mm512_set1_epi32((int)(1u << bit)));
}

VEC_INLINE vf vf_add_where(vm mask, vf a, vf b)
{
    return (vf)_mm512_mask_add_ps((__m512)a, mask, (__m512)a, (__m512)b);
}

VEC_INLINE vf vf_subtract_where(vm mask, vf a, vf b)
{
    return (vf)_mm512_mask_sub_ps((__m512)a, mask, (__m512)a, (__m512)b);
}

VEC_INLINE vu vu_add_where(vm mask, vu a, vu b)
{
    return (vu)_mm512_mask_add_epi32((__m512i)a, mask, (__m512i)a, (__m512i)b);
}

VEC_INLINE vm vm_and(vm a, vm b)
{
    return (vm)(a & b);
}

VEC_INLINE vm vm_or(vm a, vm b)
{
    return (vm)(a | b);
}

VEC_INLINE vm vm_without(vm a, vm b)
{
    return (vm)(a & ~b);
}

VEC_INLINE int vm_any(vm a)
{
    return a != 0;
}

VEC_INLINE vu vm_keep(vm mask, vu a)
{
    return (vu)_mm512_maskz_mov_epi32(mask, (__m512i)a);
}

VEC_INLINE vf vm_choose(vm mask, vf a, vf b)
{
    return (vf)_mm512_mask_blend_ps(mask, (__m512)b, (__m512)a);
}

#define VF_POSITIVE_NATIVE
VEC_INLINE vf vf_positive(vf a)
{
    return (vf)_mm512_max_ps((__m512)a, _mm512_setzero_ps());
}

#define VF_LESSER_NATIVE
VEC_INLINE vf vf_lesser(vf a, vf b)
{
    return (vf)_mm512_min_ps((__m512)a, (__m512)b);
}

#define VF_GREATER_NATIVE
VEC_INLINE vf vf_greater(vf a, vf b)
{
    return (vf)_mm512_max_ps((__m512)a, (__m512)b);
}

#define VF_TERM_NATIVE
VEC_INLINE vf vf_term(vf a, vf b)
{
    const __m512 zero = _mm512_setzero_ps();
    const __mmask16 some = _mm512_cmp_ps_mask((__m512)a, zero, _CMP_NEQ_UQ);
    return (vf)_mm512_maskz_mul_ps(_mm512_mask_cmp_ps_mask(some, (__m512)b, zero, _CMP_NEQ_UQ),
                                   (__m512)a, (__m512)b);
}

#define VF_SQRT_NATIVE
VEC_INLINE vf vf_sqrt(vf a)
{
    return (vf)_mm512_sqrt_ps((__m512)a);
}

#ifndef VEC_UNFUSED
#define VF_EXACT_FMA_NATIVE
VEC_INLINE vf vf_exact_fma(vf a, vf b, vf c)
{
    return (vf)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
}
#endif

#define VU_TURN8_NATIVE
VEC_INLINE vu vu_turn8(vu a)
{
    return (vu)_mm512_ror_epi32((__m512i)a, 8);
}

#define VU_TURN16_NATIVE
VEC_INLINE vu vu_turn16(vu a)
{
    return (vu)_mm512_ror_epi32((__m512i)a, 16);
}

#define VU_UPPER_TIMES_NATIVE
VEC_INLINE vu vu_upper_times(vu a, uint32_t factor)
{
    return (vu)_mm512_mullo_epi16((__m512i)a, (__m512i)vu_set(factor << 16));
}

/* gcc 12 loads the index of four permutes three times, which takes 3 to 6 % of a row's time. */
#define VU_IN_REGISTER_NATIVE
VEC_INLINE vu vu_in_register(vu a)
{
    __asm__("" : "+v"(a));
    return a;
}

#define VU_XOR3_NATIVE
VEC_INLINE vu vu_xor3(vu a, vu b, vu c)
{
    return (vu)_mm512_ternarylogic_epi32((__m512i)a, (__m512i)b, (__m512i)c, 0x96);
}

#define VF_LOOKUP_NATIVE
VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    const __m512 entries = _mm512_castsi512_ps(_mm512_load_si512(table->entry));
    return (vf)_mm512_permutexvar_ps((__m512i)(hash >> 28), entries);
}

#define VEC_DOTS 1
#define VF_AMONG_NATIVE
VEC_INLINE vf vf_among(vf table, vu index)
{
    return (vf)_mm512_permutexvar_ps((__m512i)index, (__m512)table);
}

/* (hash >> 16) * 12, shifted so that its whole part is the top byte. */
#define VU_TOP_INDEX_NATIVE
VEC_INLINE vu vu_top_index(vu hash)
{
    return (vu)_mm512_mulhi_epu16((__m512i)hash, _mm512_set1_epi32(12 << 24));
}

#define VF_LOOKUP_TOP_NATIVE
VEC_INLINE vf vf_lookup_top(const struct lookup_top *table, vu index)
{
    __mmask64 top_bytes = 0x8888888888888888u;
#ifdef __clang__
    __asm__("" : "+Yk"(top_bytes)); /* clang makes an `and` of a mask that it knows */
#endif
    return (vf)_mm512_maskz_shuffle_epi8(top_bytes, _mm512_load_si512(table->top), (__m512i)index);
}

#define VF_SIXTEEN_NATIVE
typedef vf vf_sixteen;

VEC_INLINE vf_sixteen vf_sixteen_load(const float *entry)
{
    return vf_load(entry);
}

VEC_INLINE vf vf_sixteen_of(const vf_sixteen *table, vu index)
{
    return (vf)_mm512_permutexvar_ps((__m512i)index, (__m512)*table);
}

#define VU_TWELFTH_NATIVE
VEC_INLINE vu vu_twelfth(vu hash)
{
    return (vu)_mm512_mulhi_epu16((__m512i)hash, _mm512_set1_epi32(12 << 16)) >> 16;
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

#include "vec.h"

#endif
