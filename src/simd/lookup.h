/* SPDX-License-Identifier: MIT
 *
 * The table type of vf_lookup (vec.h). Included by each vec_<isa>.h.
 */
#ifndef SCARP_SIMD_LOOKUP_H
#define SCARP_SIMD_LOOKUP_H

/*
 * 16 floats, looked up by the top four bits of a hash. Instruction sets with small tables use what
 * is known of the entries; tables are compile-time constants, so asking costs nothing:
 *
 *   LOOKUP_QUAD_HIGH  entry[i] is +-part[(i >> 1) & 3], negative if bit 3 of i is set
 *   LOOKUP_QUAD_LOW   entry[i] is +-part[(i >> 1) & 3], negative if bit 0 of i is set
 *   LOOKUP_EIGHT      entry[i] is part[i & 7]
 *   LOOKUP_MIRROR     entry[i] is +-part[i & 7], negative if bit 3 of i is set
 *
 * For the first two, part[4..7] continue so that one table of 8 serves bits 1 to 3, or 0 to 2.
 */
enum lookup_kind { LOOKUP_QUAD_HIGH, LOOKUP_QUAD_LOW, LOOKUP_EIGHT, LOOKUP_MIRROR };

struct lookup {
    _Alignas(64) float entry[16];
    _Alignas(32) float part[8];
    enum lookup_kind kind;
};

#define LOOKUP_TABLE_QUAD_HIGH(a, b, c, d)                                                         \
    {                                                                                              \
        {a, a, b, b, c, c, d, d, -a, -a, -b, -b, -c, -c, -d, -d}, {a, b, c, d, -a, -b, -c, -d},    \
            LOOKUP_QUAD_HIGH                                                                       \
    }
#define LOOKUP_TABLE_QUAD_LOW(a, b, c, d)                                                          \
    {                                                                                              \
        {a, -a, b, -b, c, -c, d, -d, a, -a, b, -b, c, -c, d, -d}, {a, -a, b, -b, c, -c, d, -d},    \
            LOOKUP_QUAD_LOW                                                                        \
    }
#define LOOKUP_TABLE_EIGHT(a, b, c, d, e, f, g, h)                                                 \
    {                                                                                              \
        {a, b, c, d, e, f, g, h, a, b, c, d, e, f, g, h}, {a, b, c, d, e, f, g, h}, LOOKUP_EIGHT   \
    }
#define LOOKUP_TABLE_MIRROR(a, b, c, d, e, f, g, h)                                                \
    {                                                                                              \
        {a, b, c, d, e, f, g, h, -(a), -(b), -(c), -(d), -(e), -(f), -(g), -(h)},                  \
            {a, b, c, d, e, f, g, h}, LOOKUP_MIRROR                                                \
    }

#endif
