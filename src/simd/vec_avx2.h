/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h on AVX2 and FMA: 8 lanes.
 */
#ifndef SCARP_SIMD_VEC_AVX2_H
#define SCARP_SIMD_VEC_AVX2_H

#include <immintrin.h>

#define VEC_LANES 8

#include "vec_types.h"

#define VF_LOAD_NATIVE
VEC_INLINE vf vf_load(const float *p)
{
    return (vf)_mm256_loadu_ps(p);
}

#define VF_STORE_NATIVE
VEC_INLINE void vf_store(float *p, vf v)
{
    _mm256_storeu_ps(p, (__m256)v);
}

#define VEC_STREAMS 1

#define VF_STREAM_NATIVE
VEC_INLINE void vf_stream(float *p, vf v)
{
    _mm256_stream_ps(p, (__m256)v);
}

#define VF_STREAM_END_NATIVE
VEC_INLINE void vf_stream_end(void)
{
    _mm_sfence();
}

#define VF_SET_NATIVE
VEC_INLINE vf vf_set(float a)
{
    return (vf)_mm256_set1_ps(a);
}

#define VU_SET_NATIVE
VEC_INLINE vu vu_set(uint32_t a)
{
    return (vu)_mm256_set1_epi32((int)a);
}

#define VD_SET_NATIVE
VEC_INLINE vd vd_set(double a)
{
    return (vd)_mm256_set1_pd(a);
}

/* Emulators and translators of x86 read all of what a masked load names, and fault. */
VEC_INLINE __m128 vec_load_four(const float *p, size_t n)
{
    if (n >= 4) {
        return _mm_loadu_ps(p);
    }
    if (n == 1) {
        return _mm_broadcast_ss(p);
    }
    const __m128 two = _mm_loadl_pi(_mm_setzero_ps(), (const __m64 *)p);
    return _mm_movelh_ps(two, n == 2 ? two : _mm_broadcast_ss(p + 2));
}

#define VF_LOAD_PART_NATIVE
VEC_INLINE vf vf_load_partial(const float *p, size_t n)
{
    if (n == 1) {
        return (vf)_mm256_broadcast_ss(p);
    }
    const __m128 four = vec_load_four(p, n);
    return (vf)_mm256_set_m128(n > 4 ? vec_load_four(p + 4, n - 4) : four, four);
}

#define VD_LOAD_PART_NATIVE
VEC_INLINE vd vd_load_partial(const double *p, size_t n)
{
    if (n >= 4) {
        return (vd)_mm256_loadu_pd(p);
    }
    if (n == 1) {
        return (vd)_mm256_broadcast_sd(p);
    }
    const __m128d two = _mm_loadu_pd(p);
    return (vd)_mm256_set_m128d(n == 2 ? two : _mm_loaddup_pd(p + 2), two);
}

/* AMD's processors take a masked store apart. */
#define VF_STORE_PART_NATIVE
VEC_INLINE void vf_store_partial(float *p, vf v, size_t n)
{
    __m128 four = _mm256_castps256_ps128((__m256)v);
    if ((n & 4) != 0) {
        _mm_storeu_ps(p, four);
        four = _mm256_extractf128_ps((__m256)v, 1);
        p += 4;
    }
    if ((n & 2) != 0) {
        _mm_storel_pi((__m64 *)p, four);
        four = _mm_movehl_ps(four, four);
        p += 2;
    }
    if ((n & 1) != 0) {
        _mm_store_ss(p, four);
    }
}

#define VU_ANY_NATIVE
VEC_INLINE int vu_any(vu a)
{
    return !_mm256_testz_si256((__m256i)a, (__m256i)a);
}

#define VF_FLOOR_NATIVE
VEC_INLINE vf vf_floor(vf a)
{
    return (vf)_mm256_floor_ps((__m256)a);
}

#define VD_FLOOR_NATIVE
VEC_INLINE vd vd_floor(vd a)
{
    return (vd)_mm256_floor_pd((__m256d)a);
}

#define VU_FROM_VF_NATIVE
VEC_INLINE vu vu_from_vf(vf a)
{
    return (vu)_mm256_cvttps_epi32((__m256)a);
}

#define VF_FROM_VI_NATIVE
VEC_INLINE vf vf_from_vi(vi a)
{
    return (vf)_mm256_cvtepi32_ps((__m256i)a);
}

#define VF_FROM_VD_NATIVE
VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    return (vf)_mm256_set_m128(_mm256_cvtpd_ps((__m256d)high), _mm256_cvtpd_ps((__m256d)low));
}

#define VF_STORE_VD_NATIVE
VEC_INLINE void vf_store_vd(float *p, vd low, vd high)
{
    _mm_storeu_ps(p, _mm256_cvtpd_ps((__m256d)low));
    _mm_storeu_ps(p + 4, _mm256_cvtpd_ps((__m256d)high));
}

#define VD_FROM_LOW_NATIVE
VEC_INLINE vd vd_from_low(vf a)
{
    return (vd)_mm256_cvtps_pd(_mm256_castps256_ps128((__m256)a));
}

#define VD_FROM_HIGH_NATIVE
VEC_INLINE vd vd_from_high(vf a)
{
    return (vd)_mm256_cvtps_pd(_mm256_extractf128_ps((__m256)a, 1));
}

#define VU_LOW_BITS_NATIVE
VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    /* Takes the even words of both, in halves that interleave, and puts the halves in order. */
    const __m256 even = _mm256_shuffle_ps((__m256)low, (__m256)high, _MM_SHUFFLE(2, 0, 2, 0));
    return (vu)_mm256_permute4x64_epi64((__m256i)even, _MM_SHUFFLE(3, 1, 2, 0));
}

#define VM_CHOOSE_NATIVE
VEC_INLINE vf vm_choose(vu mask, vf a, vf b)
{
    return (vf)_mm256_blendv_ps((__m256)b, (__m256)a, (__m256)mask);
}

#define VF_POSITIVE_NATIVE
VEC_INLINE vf vf_positive(vf a)
{
    return (vf)_mm256_max_ps((__m256)a, _mm256_setzero_ps());
}

#define VF_LESSER_NATIVE
VEC_INLINE vf vf_lesser(vf a, vf b)
{
    return (vf)_mm256_min_ps((__m256)a, (__m256)b);
}

#define VF_GREATER_NATIVE
VEC_INLINE vf vf_greater(vf a, vf b)
{
    return (vf)_mm256_max_ps((__m256)a, (__m256)b);
}

#define VF_SQRT_NATIVE
VEC_INLINE vf vf_sqrt(vf a)
{
    return (vf)_mm256_sqrt_ps((__m256)a);
}

#define VD_SQRT_NATIVE
VEC_INLINE vd vd_sqrt(vd a)
{
    return (vd)_mm256_sqrt_pd((__m256d)a);
}

#ifndef VEC_UNFUSED
#define VF_EXACT_FMA_NATIVE
VEC_INLINE vf vf_exact_fma(vf a, vf b, vf c)
{
    return (vf)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
}
#endif

#define VU_TURN8_NATIVE
VEC_INLINE vu vu_turn8(vu a)
{
    const __m128i bytes = _mm_setr_epi8(1, 2, 3, 0, 5, 6, 7, 4, 9, 10, 11, 8, 13, 14, 15, 12);
    return (vu)_mm256_shuffle_epi8((__m256i)a, _mm256_broadcastsi128_si256(bytes));
}

#define VU_TURN16_NATIVE
VEC_INLINE vu vu_turn16(vu a)
{
    const __m128i bytes = _mm_setr_epi8(2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13);
    return (vu)_mm256_shuffle_epi8((__m256i)a, _mm256_broadcastsi128_si256(bytes));
}

#define VU_UPPER_TIMES_NATIVE
VEC_INLINE vu vu_upper_times(vu a, uint32_t factor)
{
    return (vu)_mm256_mullo_epi16((__m256i)a, (__m256i)vu_set(factor << 16));
}

/* The permute reads the low three bits of each index and ignores the others. */
#define VF_LOOKUP_NATIVE
VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    const vu index = table->sign_low ? hash >> 28 : hash >> 29;
    const __m256 eight = _mm256_castsi256_ps(_mm256_load_si256((const __m256i *)table->eight));
    return (vf)_mm256_permutevar8x32_ps(eight, (__m256i)index);
}

#define VEC_DOTS 1
#define VF_AMONG_NATIVE
VEC_INLINE vf vf_among(vf table, vu index)
{
    return (vf)_mm256_permutevar8x32_ps((__m256)table, (__m256i)index);
}

#define VEC_BYTES_NATIVE
VEC_INLINE vu vec_bytes(vu table, vu index)
{
    return (vu)_mm256_shuffle_epi8((__m256i)table, (__m256i)index);
}

/* (hash >> 16) * 12, shifted so that its whole part is the top byte; the bytes below ask for 0. */
#define VU_TOP_INDEX_NATIVE
VEC_INLINE vu vu_top_index(vu hash)
{
    const __m256i twelfths = _mm256_mulhi_epu16((__m256i)hash, _mm256_set1_epi32(12 << 24));
    return (vu)_mm256_or_si256(twelfths, _mm256_set1_epi32(0x00808080));
}

#define VF_SIXTEEN_NATIVE
typedef struct {
    vf low, high;
} vf_sixteen;

VEC_INLINE vf_sixteen vf_sixteen_load(const float *entry)
{
    const vf_sixteen table = {vf_load(entry), vf_load(entry + VEC_LANES)};
    return table;
}

/* The permutes read the low three bits, the blend the sign. */
VEC_INLINE vf vf_sixteen_of(const vf_sixteen *table, vu index)
{
    const __m256 low = _mm256_permutevar8x32_ps((__m256)table->low, (__m256i)index);
    const __m256 high = _mm256_permutevar8x32_ps((__m256)table->high, (__m256i)index);
    return (vf)_mm256_blendv_ps(low, high, (__m256)(index << 28));
}

/* The lower eight entries are enough: bit 3 of the index becomes the sign. */
#define VF_SIXTEEN_ODD_NATIVE
VEC_INLINE vf vf_sixteen_odd(const vf_sixteen *table, vu hash)
{
    const vu index = hash >> 28 ^ hash >> 31;
    const vu entry = (vu)_mm256_permutevar8x32_ps((__m256)table->low, (__m256i)index);
    return (vf)(entry ^ (hash & 0x80000000u));
}

#define VU_TWELFTH_NATIVE
VEC_INLINE vu vu_twelfth(vu hash)
{
    return (vu)_mm256_mulhi_epu16((__m256i)hash, _mm256_set1_epi32(12 << 16)) >> 16;
}

#define VF_PERMUTE_NATIVE
#define VF_INDEX_NEXT 1u

VEC_INLINE vu vf_index(vu i)
{
    return i;
}

VEC_INLINE vf vf_permute(vf table, vu index)
{
    return (vf)_mm256_permutevar8x32_ps((__m256)table, (__m256i)index);
}

#include "vec.h"

#endif
