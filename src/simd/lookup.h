/* SPDX-License-Identifier: MIT
 *
 * The table types of vf_lookup and vf_lookup_top (vec.h). Included by vec_types.h and by tests.
 */
#ifndef SCARP_SIMD_LOOKUP_H
#define SCARP_SIMD_LOOKUP_H

/*
 * Four numbers and a sign, looked up by the top four bits i of a hash. entry[i] is
 * +-quad[(i >> 1) & 3], negative if the sign bit is set: bit 3 of i, or bit 0 if sign_low. Every
 * instruction set reads what suits it: the 16 entries, the 8 that the number and the sign choose
 * (by the upper or the lower three bits of i), or the four and the sign.
 */
struct lookup {
    _Alignas(64) float entry[16];
    _Alignas(32) float eight[8];
    _Alignas(16) float quad[4];
    int sign_low;
};

#define LOOKUP_TABLE_HIGH(a, b, c, d)                                                              \
    {                                                                                              \
        {a, a, b, b, c, c, d, d, -(a), -(a), -(b), -(b), -(c), -(c), -(d), -(d)},                  \
            {a, b, c, d, -(a), -(b), -(c), -(d)}, {a, b, c, d}, 0                                  \
    }
#define LOOKUP_TABLE_LOW(a, b, c, d)                                                               \
    {                                                                                              \
        {a, -(a), b, -(b), c, -(c), d, -(d), a, -(a), b, -(b), c, -(c), d, -(d)},                  \
            {a, -(a), b, -(b), c, -(c), d, -(d)}, {a, b, c, d}, 1                                  \
    }

/* The top bytes of twelve floats whose other bytes are 0, repeated in each 16 bytes. */
struct lookup_top {
    _Alignas(64) unsigned char top[64];
};

#define LOOKUP_PLUS_2 0x40
#define LOOKUP_MINUS_2 0xc0
#define LOOKUP_TOP_16(...) __VA_ARGS__, 0, 0, 0, 0
#define LOOKUP_TOP(...)                                                                            \
    {                                                                                              \
        {                                                                                          \
            LOOKUP_TOP_16(__VA_ARGS__), LOOKUP_TOP_16(__VA_ARGS__), LOOKUP_TOP_16(__VA_ARGS__),    \
                LOOKUP_TOP_16(__VA_ARGS__)                                                         \
        }                                                                                          \
    }

#endif
