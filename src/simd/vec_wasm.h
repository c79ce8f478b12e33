/* SPDX-License-Identifier: MIT
 *
 * The operations of vec.h on the vectors of WebAssembly (SIMD128, not relaxed): 4 lanes. Included
 * by kernels_wasm128.c. Loads, stores and splats are as the compiler makes them of vec.h.
 */
#ifndef SCARP_SIMD_VEC_WASM_H
#define SCARP_SIMD_VEC_WASM_H

#include <wasm_simd128.h>

#define VEC_LANES 4

#include "vec_types.h"

#define VF_LOAD_PART_OWN
VEC_INLINE vf vf_load_part(const float *p, size_t n)
{
    if (n == 1) {
        return (vf)wasm_v128_load32_splat(p);
    }
    const v128_t two = wasm_v128_load64_splat(p);
    return (vf)(n == 2 ? two : wasm_v128_load32_lane(p + 2, two, 2));
}

#define VD_LOAD_PART_OWN
VEC_INLINE vd vd_load_part(const double *p, size_t n)
{
    return (vd)(n == 1 ? wasm_v128_load64_splat(p) : wasm_v128_load(p));
}

#define VF_STORE_PART_OWN
VEC_INLINE void vf_store_part(float *p, vf v, size_t n)
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

#define VU_CHOOSE_OWN
VEC_INLINE vu vu_choose(vu mask, vu a, vu b)
{
    return (vu)wasm_v128_bitselect((v128_t)a, (v128_t)b, (v128_t)mask);
}

#define VU_ANY_OWN
VEC_INLINE int vu_any(vu a)
{
    return wasm_v128_any_true((v128_t)a);
}

#define VF_FLOOR_OWN
VEC_INLINE vf vf_floor(vf a)
{
    return (vf)wasm_f32x4_floor((v128_t)a);
}

#define VD_FLOOR_OWN
VEC_INLINE vd vd_floor(vd a)
{
    return (vd)wasm_f64x2_floor((v128_t)a);
}

/* The conversion saturates; above the range that is 0x7fffffff and must become 0x80000000: one
   more, which is what subtracting a mask of all ones does. */
#define VU_FROM_VF_OWN
VEC_INLINE vu vu_from_vf(vf a)
{
    const vu above = (vu)wasm_f32x4_ge((v128_t)a, wasm_f32x4_const_splat(0x1p31f));
    return (vu)wasm_i32x4_trunc_sat_f32x4((v128_t)a) - above;
}

#define VF_FROM_VD_OWN
VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    return (vf)wasm_i64x2_shuffle(wasm_f32x4_demote_f64x2_zero((v128_t)low),
                                  wasm_f32x4_demote_f64x2_zero((v128_t)high), 0, 2);
}

#define VD_FROM_LOW_OWN
VEC_INLINE vd vd_from_low(vf a)
{
    return (vd)wasm_f64x2_promote_low_f32x4((v128_t)a);
}

#define VD_FROM_HIGH_OWN
VEC_INLINE vd vd_from_high(vf a)
{
    return (vd)wasm_f64x2_promote_low_f32x4(wasm_i64x2_shuffle((v128_t)a, (v128_t)a, 1, 1));
}

#define VU_LOW_BITS_OWN
VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    return (vu)wasm_i32x4_shuffle((v128_t)low, (v128_t)high, 0, 2, 4, 6);
}

/* Engines have one instruction for each of these three on x86. */
#define VF_POSITIVE_OWN
VEC_INLINE vf vf_positive(vf a)
{
    return (vf)wasm_f32x4_pmax(wasm_f32x4_const_splat(0.0f), (v128_t)a);
}

#define VF_LESSER_OWN
VEC_INLINE vf vf_lesser(vf a, vf b)
{
    return (vf)wasm_f32x4_pmin((v128_t)b, (v128_t)a);
}

#define VF_GREATER_OWN
VEC_INLINE vf vf_greater(vf a, vf b)
{
    return (vf)wasm_f32x4_pmax((v128_t)b, (v128_t)a);
}

#define VF_SQRT_OWN
VEC_INLINE vf vf_sqrt(vf a)
{
    return (vf)wasm_f32x4_sqrt((v128_t)a);
}

#define VD_SQRT_OWN
VEC_INLINE vd vd_sqrt(vd a)
{
    return (vd)wasm_f64x2_sqrt((v128_t)a);
}

#define VU_TURN8_OWN
VEC_INLINE vu vu_turn8(vu a)
{
    return (vu)wasm_i8x16_shuffle((v128_t)a, (v128_t)a, 1, 2, 3, 0, 5, 6, 7, 4, 9, 10, 11, 8, 13,
                                  14, 15, 12);
}

/* As on SSE4.1: a byte shuffle chooses among four floats by bits 29 and 30 of the hash. */
#define VF_LOOKUP_OWN
VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    const v128_t shifted = (v128_t)(hash >> 3); /* index in bits 2 and 3 of the top byte */
    const v128_t quads = wasm_i8x16_shuffle(shifted, shifted, 3, 3, 3, 3, 7, 7, 7, 7, 11, 11, 11,
                                            11, 15, 15, 15, 15);
    const vu bytes = ((vu)quads & 0x0c0c0c0cu) | 0x03020100u;
    const vu magnitude = (vu)wasm_i8x16_swizzle(wasm_v128_load(table->quad), (v128_t)bytes);
    return (vf)(magnitude ^ ((table->sign_low ? hash << 3 : hash) & 0x80000000u));
}

/* The bytes of all 16 entries: those of bits 0 to 7 first. */
struct vec_planes {
    v128_t byte[4];
};

/* What the first and the last two halves of a and b are, byte by byte or pair by pair. */
VEC_INLINE v128_t vec_zip_low8(v128_t a, v128_t b)
{
    return wasm_i8x16_shuffle(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}

VEC_INLINE v128_t vec_zip_high8(v128_t a, v128_t b)
{
    return wasm_i8x16_shuffle(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
}

VEC_INLINE v128_t vec_zip_low16(v128_t a, v128_t b)
{
    return wasm_i16x8_shuffle(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}

VEC_INLINE v128_t vec_zip_high16(v128_t a, v128_t b)
{
    return wasm_i16x8_shuffle(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}

/* Looks up four vectors at once, as on SSE4.1: their indices fit a vector of bytes, each byte of
   the entries is looked up for all of them, and the bytes are put together. */
VEC_INLINE struct vf_four vec_four_of(const struct vec_planes *planes, const vu index[4])
{
    const v128_t low = wasm_i16x8_narrow_i32x4((v128_t)index[0], (v128_t)index[1]);
    const v128_t high = wasm_i16x8_narrow_i32x4((v128_t)index[2], (v128_t)index[3]);
    const v128_t bytes = wasm_u8x16_narrow_i16x8(low, high);
    const v128_t byte0 = wasm_i8x16_swizzle(planes->byte[0], bytes);
    const v128_t byte1 = wasm_i8x16_swizzle(planes->byte[1], bytes);
    const v128_t byte2 = wasm_i8x16_swizzle(planes->byte[2], bytes);
    const v128_t byte3 = wasm_i8x16_swizzle(planes->byte[3], bytes);
    const v128_t lower01 = vec_zip_low8(byte0, byte1), lower23 = vec_zip_high8(byte0, byte1);
    const v128_t upper01 = vec_zip_low8(byte2, byte3), upper23 = vec_zip_high8(byte2, byte3);
    const struct vf_four found = {{
        (vf)vec_zip_low16(lower01, upper01),
        (vf)vec_zip_high16(lower01, upper01),
        (vf)vec_zip_low16(lower23, upper23),
        (vf)vec_zip_high16(lower23, upper23),
    }};
    return found;
}

#define VF_LOOKUP_FOUR_OWN
VEC_INLINE struct vf_four vf_lookup_four(const struct lookup *table, const vu hash[4])
{
    const vu index[4] = {hash[0] >> 28, hash[1] >> 28, hash[2] >> 28, hash[3] >> 28};
    struct vec_planes planes;
    for (int k = 0; k < 4; k++) {
        planes.byte[k] = wasm_v128_load(table->byte[k]);
    }
    return vec_four_of(&planes, index);
}

#define VF_SIXTEEN_OWN
typedef struct {
    float entry[16];
    struct vec_planes planes;
} vf_sixteen;

/* Transposes the bytes of four entries in each vector, then the vectors. */
VEC_INLINE vf_sixteen vf_sixteen_load(const float *entry)
{
    vf_sixteen table;
    v128_t v[4];
    memcpy(table.entry, entry, sizeof table.entry);
    for (int i = 0; i < 4; i++) {
        const v128_t four = wasm_v128_load(entry + 4 * i);
        v[i] = wasm_i8x16_shuffle(four, four, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
    }
    const v128_t low01 = wasm_i32x4_shuffle(v[0], v[1], 0, 4, 1, 5);
    const v128_t high01 = wasm_i32x4_shuffle(v[0], v[1], 2, 6, 3, 7);
    const v128_t low23 = wasm_i32x4_shuffle(v[2], v[3], 0, 4, 1, 5);
    const v128_t high23 = wasm_i32x4_shuffle(v[2], v[3], 2, 6, 3, 7);
    table.planes.byte[0] = wasm_i64x2_shuffle(low01, low23, 0, 2);
    table.planes.byte[1] = wasm_i64x2_shuffle(low01, low23, 1, 3);
    table.planes.byte[2] = wasm_i64x2_shuffle(high01, high23, 0, 2);
    table.planes.byte[3] = wasm_i64x2_shuffle(high01, high23, 1, 3);
    return table;
}

VEC_INLINE vf vf_sixteen_of(const vf_sixteen *table, vu index)
{
    const float *const entry = table->entry;
    const vf found = {entry[index[0] & 15u], entry[index[1] & 15u], entry[index[2] & 15u],
                      entry[index[3] & 15u]};
    return found;
}

#define VF_SIXTEEN_ODD_FOUR_OWN
VEC_INLINE struct vf_four vf_sixteen_odd_four(const vf_sixteen *table, const vu hash[4])
{
    const vu index[4] = {hash[0] >> 28, hash[1] >> 28, hash[2] >> 28, hash[3] >> 28};
    return vec_four_of(&table->planes, index);
}

#define VF_SIXTEEN_FOUR_OWN
#define VF_SIXTEEN_FOUR 1
VEC_INLINE struct vf_four vf_sixteen_four(const vf_sixteen *table, const vu index[4])
{
    return vec_four_of(&table->planes, index);
}

/* (hash >> 16) * 12, shifted so that its whole part is the top byte; the bytes below ask for 0. */
#define VU_TOP_INDEX_OWN
VEC_INLINE vu vu_top_index(vu hash)
{
    const vu high = hash >> 16;
    return ((high << 11) + (high << 10)) | 0x00808080u;
}

#define VF_LOOKUP_TOP_OWN
VEC_INLINE vf vf_lookup_top(const struct lookup_top *table, vu index)
{
    return (vf)wasm_i8x16_swizzle(wasm_v128_load(table->top), (v128_t)index);
}

/* Selects the bytes of entry i: 4 * i + (0 1 2 3). */
VEC_INLINE vu vf_index(vu i)
{
    return i * 0x04040404u + 0x03020100u;
}

#define VF_INDEX_NEXT 0x04040404u

#define VF_TABLE VEC_LANES

typedef vf vf_table;

VEC_INLINE vf_table vf_table_load(const float *p)
{
    return (vf)wasm_v128_load(p);
}

VEC_INLINE vf_table vf_table_slide(vf_table table, vf next)
{
    (void)table;
    return next;
}

VEC_INLINE vf vf_permute(vf_table table, vu index)
{
    return (vf)wasm_i8x16_swizzle((v128_t)table, (v128_t)index);
}

#include "vec.h"

#endif
