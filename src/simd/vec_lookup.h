/* SPDX-License-Identifier: MIT
 *
 * The vector operations that look up floats in small tables: contracts and portable definitions, as
 * in vec.h, which includes this.
 */
#ifndef SCARP_SIMD_VEC_LOOKUP_H
#define SCARP_SIMD_VEC_LOOKUP_H

/*
 * Tables that are constants in the kernels; lookup.h has their types. The portable forms choose
 * between entries bit by bit: where two entries are alike or differ only in the sign, the compiler
 * has little left to do.
 */

/* Chooses one of four entries by masks of the two bits of the index. */
VEC_INLINE vu vec_four(vu bit0, vu bit1, vu e0, vu e1, vu e2, vu e3)
{
    return vu_choose(bit1, vu_choose(bit0, e3, e2), vu_choose(bit0, e1, e0));
}

/* The float with the bits table->entry[hash >> 28] in each lane. */
#ifndef VF_LOOKUP_NATIVE
VEC_INLINE vf vf_lookup(const struct lookup *table, vu hash)
{
    const uint32_t *const quad = table->quad;
    const vu magnitude = vec_four(vu_bit(hash, 29), vu_bit(hash, 30), vu_set(quad[0]),
                                  vu_set(quad[1]), vu_set(quad[2]), vu_set(quad[3]));
    return (vf)(magnitude ^ ((table->sign_low ? hash << 3 : hash) & 0x80000000u));
}
#endif

/* vf_lookup for four vectors of hashes. */
#ifndef VF_LOOKUP_FOUR_NATIVE
VEC_INLINE struct vf_four vf_lookup_four(const struct lookup *table, const vu hash[4])
{
    const struct vf_four found = {{vf_lookup(table, hash[0]), vf_lookup(table, hash[1]),
                                   vf_lookup(table, hash[2]), vf_lookup(table, hash[3])}};
    return found;
}
#endif

/* The lane of a table that the lowest bits of the index say: as many bits as number VEC_LANES
   lanes. */
#ifndef VF_AMONG_NATIVE
VEC_INLINE vf vf_among(vf table, vu index)
{
    vf found;
    for (int i = 0; i < VEC_LANES; i++) {
        found[i] = table[index[i] % VEC_LANES];
    }
    return found;
}
#endif

/* Sixteen floats that are known at run time only. */
#ifndef VF_SIXTEEN_NATIVE
typedef struct {
    float entry[16];
} vf_sixteen;

VEC_INLINE vf_sixteen vf_sixteen_load(const float *entry)
{
    vf_sixteen table;
    memcpy(table.entry, entry, sizeof table.entry);
    return table;
}

/* In each lane the entry that the lowest four bits of the index say. */
VEC_INLINE vf vf_sixteen_of(const vf_sixteen *table, vu index)
{
    vf found;
    for (int i = 0; i < VEC_LANES; i++) {
        found[i] = table->entry[index[i] & 15u];
    }
    return found;
}
#endif

/* The entry that the top four bits of the hash say, where entry i ^ 9 is the negative of entry i.
 */
#ifndef VF_SIXTEEN_ODD_NATIVE
VEC_INLINE vf vf_sixteen_odd(const vf_sixteen *table, vu hash)
{
    return vf_sixteen_of(table, hash >> 28);
}
#endif

/* vf_sixteen_odd for four vectors of hashes. */
#ifndef VF_SIXTEEN_ODD_FOUR_NATIVE
VEC_INLINE struct vf_four vf_sixteen_odd_four(const vf_sixteen *table, const vu hash[4])
{
    const struct vf_four found = {{vf_sixteen_odd(table, hash[0]), vf_sixteen_odd(table, hash[1]),
                                   vf_sixteen_odd(table, hash[2]), vf_sixteen_odd(table, hash[3])}};
    return found;
}
#endif

/* What vf_sixteen_of says for four vectors of indices below 16. VF_SIXTEEN_FOUR is 1 in a set where
   that takes less than four single ones. */
#ifndef VF_SIXTEEN_FOUR_NATIVE
#define VF_SIXTEEN_FOUR 0
VEC_INLINE struct vf_four vf_sixteen_four(const vf_sixteen *table, const vu index[4])
{
    const struct vf_four found = {{vf_sixteen_of(table, index[0]), vf_sixteen_of(table, index[1]),
                                   vf_sixteen_of(table, index[2]), vf_sixteen_of(table, index[3])}};
    return found;
}
#endif

/* (hash >> 16) * 12 >> 16 */
#ifndef VU_TWELFTH_NATIVE
VEC_INLINE vu vu_twelfth(vu hash)
{
    const vu high = hash >> 16;
    return ((high << 3) + (high << 2)) >> 16;
}
#endif

/* What vf_lookup_top takes as the index of entry (hash >> 16) * 12 >> 16. The portable one has this
   number in its upper half. */
#ifndef VU_TOP_INDEX_NATIVE
VEC_INLINE vu vu_top_index(vu hash)
{
    const vu high = hash >> 16;
    return (high << 3) + (high << 2);
}
#endif

/* In each lane the float with the top byte table->top[i], i being the entry, and 0 below. */
#ifndef VF_LOOKUP_TOP_NATIVE
VEC_INLINE vu vec_top(const struct lookup_top *table, int i)
{
    return vu_set((uint32_t)table->top[i] << 24);
}

VEC_INLINE vf vf_lookup_top(const struct lookup_top *table, vu index)
{
    const vu bit0 = vu_bit(index, 16), bit1 = vu_bit(index, 17);
    const vu low = vec_four(bit0, bit1, vec_top(table, 0), vec_top(table, 1), vec_top(table, 2),
                            vec_top(table, 3));
    const vu middle = vec_four(bit0, bit1, vec_top(table, 4), vec_top(table, 5), vec_top(table, 6),
                               vec_top(table, 7));
    const vu high = vec_four(bit0, bit1, vec_top(table, 8), vec_top(table, 9), vec_top(table, 10),
                             vec_top(table, 11));
    return (vf)vu_choose(vu_bit(index, 19), high, vu_choose(vu_bit(index, 18), middle, low));
}
#endif

#endif
