/* SPDX-License-Identifier: MIT
 *
 * The table types of vf_lookup and vf_lookup_top (vec_lookup.h).
 */
#ifndef SCARP_SIMD_LOOKUP_H
#define SCARP_SIMD_LOOKUP_H

#include <stdint.h>

/*
 * The bits of four floats and a sign, looked up by the top four bits i of a hash. entry[i] is
 * +-quad[(i >> 1) & 3], negative if the sign bit is set: bit 3 of i, or bit 0 if sign_low. Every
 * instruction set reads what suits it: the 16 entries, the 8 that the number and the sign choose
 * (by the upper or the lower three bits of i), the four and the sign, or the bytes of the entries,
 * bits 0 to 7 first.
 */
struct lookup {
    _Alignas(64) uint32_t entry[16];
    _Alignas(32) uint32_t eight[8];
    _Alignas(16) uint32_t quad[4];
    _Alignas(16) unsigned char byte[4][16];
    int sign_low;
};

#define LOOKUP_MINUS(a) ((a) ^ 0x80000000u)
#define LOOKUP_ENTRIES_HIGH(f, a, b, c, d)                                                         \
    {                                                                                              \
        f(a), f(a), f(b), f(b), f(c), f(c), f(d), f(d), f(LOOKUP_MINUS(a)), f(LOOKUP_MINUS(a)),    \
            f(LOOKUP_MINUS(b)), f(LOOKUP_MINUS(b)), f(LOOKUP_MINUS(c)), f(LOOKUP_MINUS(c)),        \
            f(LOOKUP_MINUS(d)), f(LOOKUP_MINUS(d))                                                 \
    }
#define LOOKUP_ENTRIES_LOW(f, a, b, c, d)                                                          \
    {                                                                                              \
        f(a), f(LOOKUP_MINUS(a)), f(b), f(LOOKUP_MINUS(b)), f(c), f(LOOKUP_MINUS(c)), f(d),        \
            f(LOOKUP_MINUS(d)), f(a), f(LOOKUP_MINUS(a)), f(b), f(LOOKUP_MINUS(b)), f(c),          \
            f(LOOKUP_MINUS(c)), f(d), f(LOOKUP_MINUS(d))                                           \
    }
#define LOOKUP_WHOLE(a) (a)
#define LOOKUP_BYTE_0(a) ((a)&0xffu)
#define LOOKUP_BYTE_1(a) ((a) >> 8 & 0xffu)
#define LOOKUP_BYTE_2(a) ((a) >> 16 & 0xffu)
#define LOOKUP_BYTE_3(a) ((a) >> 24)
#define LOOKUP_BYTES(entries, ...)                                                                 \
    {                                                                                              \
        entries(LOOKUP_BYTE_0, __VA_ARGS__), entries(LOOKUP_BYTE_1, __VA_ARGS__),                  \
            entries(LOOKUP_BYTE_2, __VA_ARGS__), entries(LOOKUP_BYTE_3, __VA_ARGS__)               \
    }
#define LOOKUP_TABLE_HIGH(a, b, c, d)                                                              \
    {                                                                                              \
        LOOKUP_ENTRIES_HIGH(LOOKUP_WHOLE, a, b, c, d),                                             \
            {a, b, c, d, LOOKUP_MINUS(a), LOOKUP_MINUS(b), LOOKUP_MINUS(c), LOOKUP_MINUS(d)},      \
            {a, b, c, d}, LOOKUP_BYTES(LOOKUP_ENTRIES_HIGH, a, b, c, d), 0                         \
    }
#define LOOKUP_TABLE_LOW(a, b, c, d)                                                               \
    {                                                                                              \
        LOOKUP_ENTRIES_LOW(LOOKUP_WHOLE, a, b, c, d),                                              \
            {a, LOOKUP_MINUS(a), b, LOOKUP_MINUS(b), c, LOOKUP_MINUS(c), d, LOOKUP_MINUS(d)},      \
            {a, b, c, d}, LOOKUP_BYTES(LOOKUP_ENTRIES_LOW, a, b, c, d), 1                          \
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
