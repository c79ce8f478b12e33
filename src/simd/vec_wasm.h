/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h on the vectors of WebAssembly (SIMD128, not relaxed): 4 lanes. Loads,
 * stores and splats are as the compiler makes them of vec.h.
 */
#ifndef SCARP_SIMD_VEC_WASM_H
#define SCARP_SIMD_VEC_WASM_H

#include <wasm_simd128.h>

#define VEC_LANES 4

#include "vec_types.h"

#define VF_LOAD_PART_NATIVE
VEC_INLINE vf vf_load_partial(const float *p, size_t n)
{
    if (n == 1) {
        return (vf)wasm_v128_load32_splat(p);
    }
    const v128_t two = wasm_v128_load64_splat(p);
    return (vf)(n == 2 ? two : wasm_v128_load32_lane(p + 2, two, 2));
}

#define VD_LOAD_PART_NATIVE
VEC_INLINE vd vd_load_partial(const double *p, size_t n)
{
    return (vd)(n == 1 ? wasm_v128_load64_splat(p) : wasm_v128_load(p));
}

#define VF_STORE_PART_NATIVE
VEC_INLINE void vf_store_partial(float *p, vf v, size_t n)
{
    if (n == 1) {
        wasm_v128_store32_lane(p, (v128_t)v, 0);
        return;
    }
    wasm_v128_store64_lane(p, (v128_t)v, 0);
    if (n == 3) {
        wasm_v128_store32_lane(p + 2, (v128_t)v, 2);
    }
}

#define VU_CHOOSE_NATIVE
VEC_INLINE vu vu_choose(vu mask, vu a, vu b)
{
    return (vu)wasm_v128_bitselect((v128_t)a, (v128_t)b, (v128_t)mask);
}

#define VU_ANY_NATIVE
VEC_INLINE int vu_any(vu a)
{
    return wasm_v128_any_true((v128_t)a);
}

#define VF_FLOOR_NATIVE
VEC_INLINE vf vf_floor(vf a)
{
    return (vf)wasm_f32x4_floor((v128_t)a);
}

#define VD_FLOOR_NATIVE
VEC_INLINE vd vd_floor(vd a)
{
    return (vd)wasm_f64x2_floor((v128_t)a);
}

/* The conversion saturates; above the range that is 0x7fffffff and must become 0x80000000: one
   more, which is what subtracting a mask of all ones does. */
#define VU_FROM_VF_NATIVE
VEC_INLINE vu vu_from_vf(vf a)
{
    const vu above = (vu)wasm_f32x4_ge((v128_t)a, wasm_f32x4_const_splat(0x1p31f));
    return (vu)wasm_i32x4_trunc_sat_f32x4((v128_t)a) - above;
}

#define VF_FROM_VD_NATIVE
VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    return (vf)wasm_i64x2_shuffle(wasm_f32x4_demote_f64x2_zero((v128_t)low),
                                  wasm_f32x4_demote_f64x2_zero((v128_t)high), 0, 2);
}

#define VD_FROM_LOW_NATIVE
VEC_INLINE vd vd_from_low(vf a)
{
    return (vd)wasm_f64x2_promote_low_f32x4((v128_t)a);
}

#define VD_FROM_HIGH_NATIVE
VEC_INLINE vd vd_from_high(vf a)
{
    return (vd)wasm_f64x2_promote_low_f32x4(wasm_i64x2_shuffle((v128_t)a, (v128_t)a, 1, 1));
}

#define VU_LOW_BITS_NATIVE
VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    return (vu)wasm_i32x4_shuffle((v128_t)low, (v128_t)high, 0, 2, 4, 6);
}

/* Engines have one instruction for each of these three on x86. */
#define VF_POSITIVE_NATIVE
VEC_INLINE vf vf_positive(vf a)
{
    return (vf)wasm_f32x4_pmax(wasm_f32x4_const_splat(0.0f), (v128_t)a);
}

#define VF_LESSER_NATIVE
VEC_INLINE vf vf_lesser(vf a, vf b)
{
    return (vf)wasm_f32x4_pmin((v128_t)b, (v128_t)a);
}

#define VF_GREATER_NATIVE
VEC_INLINE vf vf_greater(vf a, vf b)
{
    return (vf)wasm_f32x4_pmax((v128_t)b, (v128_t)a);
}

#define VF_SQRT_NATIVE
VEC_INLINE vf vf_sqrt(vf a)
{
    return (vf)wasm_f32x4_sqrt((v128_t)a);
}

#define VD_SQRT_NATIVE
VEC_INLINE vd vd_sqrt(vd a)
{
    return (vd)wasm_f64x2_sqrt((v128_t)a);
}

#define VU_TURN8_NATIVE
VEC_INLINE vu vu_turn8(vu a)
{
    return (vu)wasm_i8x16_shuffle((v128_t)a, (v128_t)a, 1, 2, 3, 0, 5, 6, 7, 4, 9, 10, 11, 8, 13,
                                  14, 15, 12);
}

#define VU_TURN16_NATIVE
VEC_INLINE vu vu_turn16(vu a)
{
    return (vu)wasm_i8x16_shuffle((v128_t)a, (v128_t)a, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14,
                                  15, 12, 13);
}

#define VU_UPPER_TIMES_NATIVE
VEC_INLINE vu vu_upper_times(vu a, uint32_t factor)
{
    return (vu)wasm_i16x8_mul((v128_t)a, wasm_u32x4_splat(factor << 16));
}

#define VEC_BYTES_NATIVE
VEC_INLINE vu vec_bytes(vu table, vu index)
{
    return (vu)wasm_i8x16_swizzle((v128_t)table, (v128_t)index);
}

VEC_INLINE vu vec_narrow(const vu index[4])
{
    const v128_t low = wasm_i16x8_narrow_i32x4((v128_t)index[0], (v128_t)index[1]);
    const v128_t high = wasm_i16x8_narrow_i32x4((v128_t)index[2], (v128_t)index[3]);
    return (vu)wasm_u8x16_narrow_i16x8(low, high);
}

VEC_INLINE vu vec_zip_low8(vu a, vu b)
{
    return (vu)wasm_i8x16_shuffle((v128_t)a, (v128_t)b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6,
                                  22, 7, 23);
}

VEC_INLINE vu vec_zip_high8(vu a, vu b)
{
    return (vu)wasm_i8x16_shuffle((v128_t)a, (v128_t)b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13,
                                  29, 14, 30, 15, 31);
}

VEC_INLINE vu vec_zip_low16(vu a, vu b)
{
    return (vu)wasm_i16x8_shuffle((v128_t)a, (v128_t)b, 0, 8, 1, 9, 2, 10, 3, 11);
}

VEC_INLINE vu vec_zip_high16(vu a, vu b)
{
    return (vu)wasm_i16x8_shuffle((v128_t)a, (v128_t)b, 4, 12, 5, 13, 6, 14, 7, 15);
}

/* (hash >> 16) * 12, shifted so that its whole part is the top byte; the bytes below ask for 0. */
#define VU_TOP_INDEX_NATIVE
VEC_INLINE vu vu_top_index(vu hash)
{
    const vu high = hash >> 16;
    return ((high << 11) + (high << 10)) | 0x00808080u;
}

#include "vec.h"

#endif
