/* SPDX-License-Identifier: MIT
 *
 * The lookups of vec_lookup.h, and the permutation, in sets that look up bytes. Such a set defines
 *
 *     vu vec_bytes(vu table, vu index)   each byte is the one of the table's that the index says,
 *                                        among those of its sixteen; 0 if the index has its top bit
 *
 * and VEC_BYTES_NATIVE. A set of four lanes without a vf_sixteen of its own defines, too,
 *
 *     vu vec_narrow(const vu index[4])     the lowest bytes of all lanes, which are below 128
 *     vu vec_zip_low8(vu a, vu b)          the lower halves of a and b, byte by byte; vec_zip_low16
 *                                          takes two bytes at a time
 *     vu vec_zip_high8(vu a, vu b)         likewise the upper halves; vec_zip_high16
 *
 * (Shuffles of bytes at constant places would do for the latter, but gcc 12 then takes 4 % longer.)
 */
#ifndef SCARP_SIMD_VEC_BYTES_H
#define SCARP_SIMD_VEC_BYTES_H

#ifdef VEC_BYTES_NATIVE

/* vu_top_index has the entry's number in the top byte, and bits below that ask for 0. */
#define VF_LOOKUP_TOP_NATIVE
VEC_INLINE vf vf_lookup_top(const struct lookup_top *table, vu index)
{
    vu top;
    memcpy(&top, table->top, sizeof top);
    return (vf)vec_bytes(top, index);
}

#define VF_TABLE VEC_LANES

typedef vf vf_table;

VEC_INLINE vf_table vf_table_load(const float *p)
{
    return vf_load(p);
}

VEC_INLINE vf_table vf_table_slide(vf_table table, vf next)
{
    (void)table;
    return next;
}

#ifndef VF_PERMUTE_NATIVE
/* Selects the bytes of entry i: 4 * i + (0 1 2 3). */
VEC_INLINE vu vf_index(vu i)
{
    return i * 0x04040404u + 0x03020100u;
}

#define VF_INDEX_NEXT 0x04040404u

VEC_INLINE vf vf_permute(vf_table table, vu index)
{
    return (vf)vec_bytes((vu)table, index);
}
#endif

#ifndef VF_SIXTEEN_NATIVE

/* The bytes of a and b, numbered through, at places that are constants. */
typedef unsigned char vec_u8 __attribute__((vector_size(16)));
#ifdef __clang__
#define VEC_PICK(a, b, ...) (vu) __builtin_shufflevector((vec_u8)(a), (vec_u8)(b), __VA_ARGS__)
#else
#define VEC_PICK(a, b, ...) (vu) __builtin_shuffle((vec_u8)(a), (vec_u8)(b), (vec_u8){__VA_ARGS__})
#endif

/* Bits 29 and 30 of the hash choose among four floats: 4 * index + (0 1 2 3) in the bytes of each
   lane. The compiler shares that selector between the lookups of one hash. */
#define VF_LOOKUP_NATIVE
VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    const vu shifted = hash >> 3; /* index in bits 2 and 3 of the top byte */
    const vu quads =
        VEC_PICK(shifted, shifted, 3, 3, 3, 3, 7, 7, 7, 7, 11, 11, 11, 11, 15, 15, 15, 15);
    const vu bytes = (quads & 0x0c0c0c0cu) | 0x03020100u;
    vu quad;
    memcpy(&quad, table->quad, sizeof quad);
    const vu magnitude = vec_bytes(quad, bytes);
    return (vf)(magnitude ^ ((table->sign_low ? hash << 3 : hash) & 0x80000000u));
}

/* The bytes of all 16 entries: those of bits 0 to 7 first. */
struct vec_planes {
    vu byte[4];
};

/* Looks up four vectors at once. Their indices, of 16 lanes, fit a vector of bytes: each byte of
   the entries is looked up for all of them, and the bytes are put together. */
VEC_INLINE struct vf_four vec_four_of(const struct vec_planes *planes, const vu index[4])
{
    const vu bytes = vec_narrow(index);
    const vu byte0 = vec_bytes(planes->byte[0], bytes), byte1 = vec_bytes(planes->byte[1], bytes);
    const vu byte2 = vec_bytes(planes->byte[2], bytes), byte3 = vec_bytes(planes->byte[3], bytes);
    const vu lower01 = vec_zip_low8(byte0, byte1), lower23 = vec_zip_high8(byte0, byte1);
    const vu upper01 = vec_zip_low8(byte2, byte3), upper23 = vec_zip_high8(byte2, byte3);
    const struct vf_four found = {{
        (vf)vec_zip_low16(lower01, upper01),
        (vf)vec_zip_high16(lower01, upper01),
        (vf)vec_zip_low16(lower23, upper23),
        (vf)vec_zip_high16(lower23, upper23),
    }};
    return found;
}

/* 31 operations for two tables instead of 44. */
#define VF_LOOKUP_FOUR_NATIVE
VEC_INLINE struct vf_four vf_lookup_four(const struct lookup *table, const vu hash[4])
{
    const vu index[4] = {hash[0] >> 28, hash[1] >> 28, hash[2] >> 28, hash[3] >> 28};
    struct vec_planes planes;
    for (int k = 0; k < 4; k++) {
        memcpy(&planes.byte[k], table->byte[k], sizeof planes.byte[k]);
    }
    return vec_four_of(&planes, index);
}

#define VF_SIXTEEN_NATIVE
typedef struct {
    float entry[16];
    struct vec_planes planes;
} vf_sixteen;

VEC_INLINE vu vec_zip_low32(vu a, vu b)
{
    return VEC_PICK(a, b, 0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23);
}

VEC_INLINE vu vec_zip_high32(vu a, vu b)
{
    return VEC_PICK(a, b, 8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31);
}

VEC_INLINE vu vec_low64(vu a, vu b)
{
    return VEC_PICK(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
}

VEC_INLINE vu vec_high64(vu a, vu b)
{
    return VEC_PICK(a, b, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
}

/* Transposes the bytes of four entries in each vector, then the vectors. */
VEC_INLINE vf_sixteen vf_sixteen_load(const float *entry)
{
    vf_sixteen table;
    vu v[4];
    memcpy(table.entry, entry, sizeof table.entry);
    for (int i = 0; i < 4; i++) {
        const vu four = (vu)vf_load(entry + 4 * i);
        v[i] = VEC_PICK(four, four, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
    }
    const vu low01 = vec_zip_low32(v[0], v[1]), high01 = vec_zip_high32(v[0], v[1]);
    const vu low23 = vec_zip_low32(v[2], v[3]), high23 = vec_zip_high32(v[2], v[3]);
    table.planes.byte[0] = vec_low64(low01, low23);
    table.planes.byte[1] = vec_high64(low01, low23);
    table.planes.byte[2] = vec_low64(high01, high23);
    table.planes.byte[3] = vec_high64(high01, high23);
    return table;
}

VEC_INLINE vf vf_sixteen_of(const vf_sixteen *table, vu index)
{
    const float *const entry = table->entry;
    const vf found = {entry[index[0] & 15u], entry[index[1] & 15u], entry[index[2] & 15u],
                      entry[index[3] & 15u]};
    return found;
}

#define VF_SIXTEEN_ODD_FOUR_NATIVE
VEC_INLINE struct vf_four vf_sixteen_odd_four(const vf_sixteen *table, const vu hash[4])
{
    const vu index[4] = {hash[0] >> 28, hash[1] >> 28, hash[2] >> 28, hash[3] >> 28};
    return vec_four_of(&table->planes, index);
}

#define VF_SIXTEEN_FOUR_NATIVE
#define VF_SIXTEEN_FOUR 1
VEC_INLINE struct vf_four vf_sixteen_four(const vf_sixteen *table, const vu index[4])
{
    return vec_four_of(&table->planes, index);
}

#endif
#endif

#endif
