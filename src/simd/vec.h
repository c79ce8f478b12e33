/* SPDX-License-Identifier: MIT
 *
 * The vector operations that src/kernel is written in: the contract of each, and a definition in
 * the vector extensions of gcc and clang that serves any processor, of either byte order.
 *
 * A vec_<isa>.h defines VEC_LANES, includes vec_types.h, writes what its processor does better, and
 * includes this file last, which adds what is left. To say that an operation is there it defines a
 * macro: VF_FLOOR_NATIVE for vf_floor, and so on. Some go together: vf_lookup_top takes what
 * vu_top_index makes, and vf_table has a group of its own at the end.
 *
 * Everything is inlined into the functions of a kernels_<isa>.c, so this file must be included
 * inside its target region. tests/test_vec.c compares each operation of each set with plain C.
 */
#ifndef SCARP_SIMD_VEC_H
#define SCARP_SIMD_VEC_H

/* Whether the set is to be small rather than fast: passes for points branch where others have a
   loop for each case, all passes share the code for lattice columns, and rows compute columns for
   each sample. A build may say so for all sets. */
#ifndef VEC_SMALL
#define VEC_SMALL 0
#endif

/* Whether a table of products that one vector holds is looked up as fast as one of the factors: the
   set has at least eight lanes, and vf_among in one instruction. */
#ifndef VEC_DOTS
#define VEC_DOTS 0
#endif

/* Initialisers: a number for every lane of a vf, one for every lane of a vd, the lanes' numbers. */
#if VEC_LANES == 4
#define VEC_EACH(a) a, a, a, a
#define VEC_EACH_DOUBLE(a) a, a
#define VEC_NUMBERS 0, 1, 2, 3
#elif VEC_LANES == 8
#define VEC_EACH(a) a, a, a, a, a, a, a, a
#define VEC_EACH_DOUBLE(a) a, a, a, a
#define VEC_NUMBERS 0, 1, 2, 3, 4, 5, 6, 7
#elif VEC_LANES == 16
#define VEC_EACH(a) a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a
#define VEC_EACH_DOUBLE(a) a, a, a, a, a, a, a, a
#define VEC_NUMBERS 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
#else
#error "VEC_LANES must be 4, 8 or 16"
#endif

typedef uint64_t vec_u64 __attribute__((vector_size(VEC_BYTES)));

/*
 * Memory. Addresses need no alignment beyond that of the element, but for vf_stream.
 */

/* p[0 .. VEC_LANES) */
#ifndef VF_LOAD_NATIVE
VEC_INLINE vf vf_load(const float *p)
{
    vf v;
    memcpy(&v, p, sizeof v);
    return v;
}
#endif

#ifndef VU_LOAD_NATIVE
VEC_INLINE vu vu_load(const uint32_t *p)
{
    vu v;
    memcpy(&v, p, sizeof v);
    return v;
}
#endif

/* p[0 .. VEC_LANES / 2) */
#ifndef VD_LOAD_NATIVE
VEC_INLINE vd vd_load(const double *p)
{
    vd v;
    memcpy(&v, p, sizeof v);
    return v;
}
#endif

#ifndef VF_STORE_NATIVE
VEC_INLINE void vf_store(float *p, vf v)
{
    memcpy(p, &v, sizeof v);
}
#endif

#ifndef VU_STORE_NATIVE
VEC_INLINE void vu_store(uint32_t *p, vu v)
{
    memcpy(p, &v, sizeof v);
}
#endif

/* Whether vf_stream writes past the caches, which pays for rows that are only written. */
#ifndef VEC_STREAMS
#define VEC_STREAMS 0
#endif

/* p[0 .. VEC_LANES), aligned to a vf. */
#ifndef VF_STREAM_NATIVE
VEC_INLINE void vf_stream(float *p, vf v)
{
    vf_store(p, v);
}
#endif

/* Call this before other threads may learn that streamed data is there: on x86 later stores, even
   those that release, overtake it. */
#ifndef VF_STREAM_END_NATIVE
VEC_INLINE void vf_stream_end(void)
{
}
#endif

/*
 * The same number in every lane.
 */

#ifndef VF_SET_NATIVE
VEC_INLINE vf vf_set(float a)
{
    const vf v = {VEC_EACH(a)};
    return v;
}
#endif

#ifndef VU_SET_NATIVE
VEC_INLINE vu vu_set(uint32_t a)
{
    const vu v = {VEC_EACH(a)};
    return v;
}
#endif

#ifndef VD_SET_NATIVE
VEC_INLINE vd vd_set(double a)
{
    const vd v = {VEC_EACH_DOUBLE(a)};
    return v;
}
#endif

/*
 * The first n lanes only, 0 < n < VEC_LANES, or n <= VEC_LANES / 2 for doubles: nothing behind p[n
 * - 1] is touched. Lanes that are not loaded repeat some that are.
 */

/* p[0 .. n) */
#ifndef VF_LOAD_PART_NATIVE
VEC_INLINE vf vf_load_partial(const float *p, size_t n)
{
    vf v = vf_set(p[0]);
    for (size_t i = 1; i < VEC_LANES - 1; i++) {
        v[i] = p[i < n ? i : 0];
    }
    return v;
}
#endif

#ifndef VD_LOAD_PART_NATIVE
VEC_INLINE vd vd_load_partial(const double *p, size_t n)
{
    vd v = vd_set(p[0]);
    for (size_t i = 1; i < VEC_LANES / 2; i++) {
        v[i] = p[i < n ? i : 0];
    }
    return v;
}
#endif

#ifndef VF_STORE_PART_NATIVE
VEC_INLINE void vf_store_partial(float *p, vf v, size_t n)
{
    for (size_t i = 0; i < VEC_LANES - 1; i++) {
        if (i < n) {
            p[i] = v[i];
        }
    }
}
#endif

/*
 * Bits.
 */

/* In each lane a where the mask is all ones, b where it is 0. */
#ifndef VU_CHOOSE_NATIVE
VEC_INLINE vu vu_choose(vu mask, vu a, vu b)
{
    return b ^ ((a ^ b) & mask);
}
#endif

/* Whether any bit is set. */
#ifndef VU_ANY_NATIVE
VEC_INLINE int vu_any(vu a)
{
    uint32_t any = 0;
    for (int i = 0; i < VEC_LANES; i++) {
        any |= a[i];
    }
    return any != 0;
}
#endif

/* A mask: whether bit `bit` of a is set. */
#ifndef VU_BIT_NATIVE
VEC_INLINE vu vu_bit(vu a, int bit)
{
    return (vu)((vi)(a << (31 - bit)) >> 31);
}
#endif

/* Each lane's bits turned right by 8. */
#ifndef VU_TURN8_NATIVE
VEC_INLINE vu vu_turn8(vu a)
{
    return a >> 8 | a << 24;
}
#endif

/* Each lane's halves, with their places changed. */
#ifndef VU_TURN16_NATIVE
VEC_INLINE vu vu_turn16(vu a)
{
    return a >> 16 | a << 16;
}
#endif

/* ((a >> 16) * factor) << 16 */
#ifndef VU_UPPER_TIMES_NATIVE
VEC_INLINE vu vu_upper_times(vu a, uint32_t factor)
{
    return (a & vu_set(0xffff0000u)) * vu_set(factor);
}
#endif

/* a in a register: a compiler may load an operand anew wherever it is used. */
#ifndef VU_IN_REGISTER_NATIVE
VEC_INLINE vu vu_in_register(vu a)
{
    return a;
}
#endif

/* a ^ b ^ c. */
#ifndef VU_XOR3_NATIVE
VEC_INLINE vu vu_xor3(vu a, vu b, vu c)
{
    return a ^ (b ^ c); /* callers share b ^ c */
}
#endif

/*
 * Rounding and conversion.
 */

/* The greatest integer that is not above a. A zero keeps its sign; NaN and infinities stay. Adding
   2^23 rounds the magnitude to an integer; where that went up, 1 is subtracted. Larger magnitudes
   are integers. */
#ifndef VF_FLOOR_NATIVE
VEC_INLINE vf vf_floor(vf a)
{
    const vu sign = (vu)a & 0x80000000u;
    const vf magnitude = (vf)((vu)a ^ sign);
    const vf nearest = (vf)((vu)((magnitude + 0x1p23f) - 0x1p23f) | sign);
    const vf lower = nearest - (vf)((vu)(nearest > a) & (vu)vf_set(1.0f));
    return (vf)vu_choose((vu)(magnitude < vf_set(0x1p23f)), (vu)lower, (vu)a);
}
#endif

#ifndef VD_FLOOR_NATIVE
VEC_INLINE vd vd_floor(vd a)
{
    const vec_u64 sign = (vec_u64)a & UINT64_C(0x8000000000000000);
    const vd magnitude = (vd)((vec_u64)a ^ sign);
    const vd nearest = (vd)((vec_u64)((magnitude + 0x1p52) - 0x1p52) | sign);
    const vd lower = nearest - (vd)((vec_u64)(nearest > a) & (vec_u64)vd_set(1.0));
    const vec_u64 fraction = (vec_u64)(magnitude < vd_set(0x1p52));
    return (vd)((vec_u64)a ^ (((vec_u64)lower ^ (vec_u64)a) & fraction));
}
#endif

/* The two's complement of an integral float in [-2^31, 2^31), 0x80000000 of those beyond and of
   infinities, anything of NaN and fractions. C converts only what is inside. */
#ifndef VU_FROM_VF_NATIVE
VEC_INLINE vu vu_from_vf(vf a)
{
    const vf magnitude = (vf)((vu)a & 0x7fffffffu);
    const vu inside = (vu)(magnitude < vf_set(0x1p31f));
    const vi whole = __builtin_convertvector((vf)((vu)a & inside), vi);
    return (vu)whole | (~inside & 0x80000000u);
}
#endif

/* Rounded to nearest. */
#ifndef VF_FROM_VI_NATIVE
VEC_INLINE vf vf_from_vi(vi a)
{
    return __builtin_convertvector(a, vf);
}
#endif

/* Rounded to nearest. */
#ifndef VF_FROM_VD_NATIVE
VEC_INLINE vf vf_from_vd(vd low, vd high)
{
    vf v = vf_set(0.0f);
    for (int i = 0; i < VEC_LANES / 2; i++) {
        v[i] = (float)low[i];
        v[i + VEC_LANES / 2] = (float)high[i];
    }
    return v;
}
#endif

/* Stores both at p, rounded to nearest. */
#ifndef VF_STORE_VD_NATIVE
VEC_INLINE void vf_store_vd(float *p, vd low, vd high)
{
    vf_store(p, vf_from_vd(low, high));
}
#endif

/* The lanes below VEC_LANES / 2, exactly. */
#ifndef VD_FROM_LOW_NATIVE
VEC_INLINE vd vd_from_low(vf a)
{
    vd v = vd_set(0.0);
    for (int i = 0; i < VEC_LANES / 2; i++) {
        v[i] = (double)a[i];
    }
    return v;
}
#endif

/* The lanes from VEC_LANES / 2, exactly. */
#ifndef VD_FROM_HIGH_NATIVE
VEC_INLINE vd vd_from_high(vf a)
{
    vd v = vd_set(0.0);
    for (int i = 0; i < VEC_LANES / 2; i++) {
        v[i] = (double)a[i + VEC_LANES / 2];
    }
    return v;
}
#endif

/* Bits 0 to 31 of each double's representation. */
#ifndef VU_LOW_BITS_NATIVE
VEC_INLINE vu vu_low_bits(vd low, vd high)
{
    vu v = vu_set(0);
    for (int i = 0; i < VEC_LANES / 2; i++) {
        v[i] = (uint32_t)((vec_u64)low)[i];
        v[i + VEC_LANES / 2] = (uint32_t)((vec_u64)high)[i];
    }
    return v;
}
#endif

/*
 * Arithmetic that no operator does. It rounds correctly, as IEEE 754 asks.
 */

#ifndef VD_SQRT_NATIVE
VEC_INLINE vd vd_sqrt(vd a)
{
    vd v = a;
    for (int i = 0; i < VEC_LANES / 2; i++) {
        v[i] = __builtin_sqrt(a[i]);
    }
    return v;
}
#endif

/*
 * The only operation that may be fused: a b + c where a b is exact, so that rounding it changes no
 * bit. Use it only where one of a and b is 0 or a power of two that is at least 1 (of either sign),
 * and a b does not overflow; NaN and infinities are as in a b + c. VEC_UNFUSED makes it a * b + c
 * in every set: the audit of tests/package demands that no fused instruction is left then.
 */
#ifndef VF_EXACT_FMA_NATIVE
VEC_INLINE vf vf_exact_fma(vf a, vf b, vf c)
{
    return a * b + c;
}
#endif

#include "vec_choose.h"

#include "vec_bytes.h"

#include "vec_lookup.h"

/*
 * Permutation: a table has VF_TABLE floats, which is VEC_LANES or twice that, and no operators. A
 * set that has its own defines VF_TABLE, VF_INDEX_NEXT, vf_table and all these operations.
 *
 *   vf_table vf_table_load(const float *p)         p[0 .. VF_TABLE)
 *   vf_table vf_table_slide(vf_table t, vf next)   t without its first VEC_LANES entries, and next
 *   vu vf_index(vu i)   what vf_permute wants for these entries, each below VF_TABLE; VF_INDEX_NEXT
 *                       added to it asks for the entries after them (also below VF_TABLE)
 *   vf vf_permute(vf_table table, vu index)        table[i] in each lane
 */

/* 0, 1, 2, ... VEC_LANES - 1 */
#ifndef VU_LANES_NATIVE
VEC_INLINE vu vu_lanes(void)
{
    const vu lanes = {VEC_NUMBERS};
    return lanes;
}
#endif

#ifndef VF_TABLE
#define VF_TABLE VEC_LANES

/* Each entry fills all lanes of a vector. */
typedef struct {
    vu entry[VEC_LANES];
} vf_table;

VEC_INLINE vf_table vf_table_load(const float *p)
{
    vf_table table;
    for (int i = 0; i < VEC_LANES; i++) {
        table.entry[i] = (vu)vf_set(p[i]);
    }
    return table;
}

VEC_INLINE vf_table vf_table_slide(vf_table table, vf next)
{
    for (int i = 0; i < VEC_LANES; i++) {
        table.entry[i] = (vu)vf_set(next[i]);
    }
    return table;
}

VEC_INLINE vu vf_index(vu i)
{
    return i;
}

#define VF_INDEX_NEXT 1u

/* Each bit of the index halves what is left of the table. */
VEC_INLINE vf vf_permute(vf_table table, vu index)
{
    for (int bit = 0, left = VEC_LANES / 2; left > 0; bit++, left /= 2) {
        const vu odd = vu_bit(index, bit);
        for (int i = 0; i < left; i++) {
            table.entry[i] = vu_choose(odd, table.entry[2 * i + 1], table.entry[2 * i]);
        }
    }
    return (vf)table.entry[0];
}
#endif

/* Stands in front of a loop of a dozen operations, and unrolls it where that helps. */
#ifndef VEC_SHORT_LOOP
#define VEC_SHORT_LOOP
#endif

/* Stands in front of a loop that must stay one, whatever its count. */
#ifdef __clang__
#define VEC_ROLLED_LOOP _Pragma("clang loop unroll(disable)")
#else
#define VEC_ROLLED_LOOP _Pragma("GCC unroll 1")
#endif

#endif
