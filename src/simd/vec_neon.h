/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h on NEON (AArch64, little endian): 4 lanes.
 */
#ifndef SCARP_SIMD_VEC_NEON_H
#define SCARP_SIMD_VEC_NEON_H

#include <arm_neon.h>

#define VEC_LANES 4

#include "vec_types.h"

#define VF_LOAD_NATIVE
VEC_INLINE vf vf_load(const float *p)
{
    return (vf)vld1q_f32(p);
}

#define VF_STORE_NATIVE
VEC_INLINE void vf_store(float *p, vf v)
{
    vst1q_f32(p, (float32x4_t)v);
}

/* There is no vf_stream: cores recognise memory that is only written, and do not fetch it. */

#define VD_LOAD_NATIVE
VEC_INLINE vd vd_load(const double *p)
{
    return (vd)vld1q_f64(p);
}

#define VF_SET_NATIVE
VEC_INLINE vf vf_set(float a)
{
    return (vf)vdupq_n_f32(a);
}

#define VU_SET_NATIVE
VEC_INLINE vu vu_set(uint32_t a)
{
    return (vu)vdupq_n_u32(a);
}

#define VD_SET_NATIVE
VEC_INLINE vd vd_set(double a)
{
    return (vd)vdupq_n_f64(a);
}

#define VU_ANY_NATIVE
VEC_INLINE int vu_any(vu a)
{
    return vmaxvq_u32((uint32x4_t)a) != 0;
}

#define VF_FLOOR_NATIVE
VEC_INLINE vf vf_floor(vf a)
{
    return (vf)vrndmq_f32((float32x4_t)a);
}

#define VD_FLOOR_NATIVE
VEC_INLINE vd vd_floor(vd a)
{
    return (vd)vrndmq_f64((float64x2_t)a);
}

/* The conversion saturates; above the range that is 0x7fffffff and must become 0x80000000. */
#define VU_FROM_VF_NATIVE
VEC_INLINE vu vu_from_vf(vf a)
{
    const uint32x4_t above = vcgeq_f32((float32x4_t)a, vdupq_n_f32(0x1p31f));
    const uint32x4_t saturated = vreinterpretq_u32_s32(vcvtq_s32_f32((float32x4_t)a));
    return (vu)vbslq_u32(above, vdupq_n_u32(0x80000000u), saturated);
}

#define VF_FROM_VI_NATIVE
VEC_INLINE vf vf_from_vi(vi a)
{
    return (vf)vcvtq_f32_s32((int32x4_t)a);
}

#define VF_FROM_VD_NATIVE
VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    return (vf)vcvt_high_f32_f64(vcvt_f32_f64((float64x2_t)low), (float64x2_t)high);
}

#define VD_FROM_LOW_NATIVE
VEC_INLINE vd vd_from_low(vf a)
{
    return (vd)vcvt_f64_f32(vget_low_f32((float32x4_t)a));
}

#define VD_FROM_HIGH_NATIVE
VEC_INLINE vd vd_from_high(vf a)
{
    return (vd)vcvt_high_f64_f32((float32x4_t)a);
}

#define VU_LOW_BITS_NATIVE
VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    return (vu)vuzp1q_u32((uint32x4_t)low, (uint32x4_t)high);
}

#define VM_CHOOSE_NATIVE
VEC_INLINE vf vm_choose(vu mask, vf a, vf b)
{
    return (vf)vbslq_f32((uint32x4_t)mask, (float32x4_t)a, (float32x4_t)b);
}

#define VF_SQRT_NATIVE
VEC_INLINE vf vf_sqrt(vf a)
{
    return (vf)vsqrtq_f32((float32x4_t)a);
}

#define VD_SQRT_NATIVE
VEC_INLINE vd vd_sqrt(vd a)
{
    return (vd)vsqrtq_f64((float64x2_t)a);
}

#ifndef VEC_UNFUSED
#define VF_EXACT_FMA_NATIVE
VEC_INLINE vf vf_exact_fma(vf a, vf b, vf c)
{
    return (vf)vfmaq_f32((float32x4_t)c, (float32x4_t)a, (float32x4_t)b);
}
#endif

#define VU_TURN8_NATIVE
VEC_INLINE vu vu_turn8(vu a)
{
    return (vu)vsriq_n_u32(vshlq_n_u32((uint32x4_t)a, 24), (uint32x4_t)a, 8);
}

#define VU_TURN16_NATIVE
VEC_INLINE vu vu_turn16(vu a)
{
    return (vu)vrev32q_u16((uint16x8_t)a);
}

#define VU_UPPER_TIMES_NATIVE
VEC_INLINE vu vu_upper_times(vu a, uint32_t factor)
{
    return (vu)vmulq_u16((uint16x8_t)a, (uint16x8_t)vdupq_n_u32(factor << 16));
}

#define VEC_BYTES_NATIVE
VEC_INLINE vu vec_bytes(vu table, vu index)
{
    return (vu)vqtbl1q_u8((uint8x16_t)table, (uint8x16_t)index);
}

/* TBL reads whole bytes: 4 * index + (0 1 2 3) in the bytes of each lane. */
#define VF_LOOKUP_NATIVE
VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    const vu index = table->sign_low ? (hash >> 28) & 7u : hash >> 29;
    const uint8x16_t bytes = (uint8x16_t)(index * 0x04040404u + 0x03020100u);
    const uint8_t *const eight = (const uint8_t *)table->eight;
    const uint8x16x2_t both = {{vld1q_u8(eight), vld1q_u8(eight + 16)}};
    return (vf)vqtbl2q_u8(both, bytes);
}

/* (hash >> 16) * 12, shifted so that its whole part is the top byte; the bytes below ask for 0. */
#define VU_TOP_INDEX_NATIVE
VEC_INLINE vu vu_top_index(vu hash)
{
    return (hash >> 16) * (12u << 8) | 0x00808080u;
}

#define VU_LOAD_NATIVE
VEC_INLINE vu vu_load(const uint32_t *p)
{
    return (vu)vld1q_u32(p);
}

#define VU_STORE_NATIVE
VEC_INLINE void vu_store(uint32_t *p, vu v)
{
    vst1q_u32(p, (uint32x4_t)v);
}

#define VF_SIXTEEN_NATIVE
typedef uint8x16x4_t vf_sixteen;

VEC_INLINE vf_sixteen vf_sixteen_load(const float *entry)
{
    const uint8_t *const bytes = (const uint8_t *)entry;
    const vf_sixteen table = {
        {vld1q_u8(bytes), vld1q_u8(bytes + 16), vld1q_u8(bytes + 32), vld1q_u8(bytes + 48)}};
    return table;
}

VEC_INLINE vf vf_sixteen_of(const vf_sixteen *table, vu index)
{
    const vu bytes = (index & 15u) * 0x04040404u + 0x03020100u;
    return (vf)vqtbl4q_u8(*table, (uint8x16_t)bytes);
}

#include "vec.h"

#endif
