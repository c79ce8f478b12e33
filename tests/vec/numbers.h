/* SPDX-License-Identifier: MIT
 *
 * The numbers that test_vec.c gives to operations: every exponent of float and double with the
 * mantissas at which rounding changes its mind, both signs, NaN and infinities, and random bits.
 */
#ifndef SCARP_TESTS_VEC_NUMBERS_H
#define SCARP_TESTS_VEC_NUMBERS_H

#include "check.h"

#define NUMBERS_MAX 65536

static uint32_t number_bits32[NUMBERS_MAX];
static float number_f[NUMBERS_MAX];
static double number_d[NUMBERS_MAX];
static size_t numbers32, numbers_f, numbers_d;

static inline float float_of(uint32_t bits)
{
    float a;
    memcpy(&a, &bits, sizeof a);
    return a;
}

static inline double double_of(uint64_t bits)
{
    double a;
    memcpy(&a, &bits, sizeof a);
    return a;
}

static inline uint32_t bits_of_float(float a)
{
    uint32_t bits;
    memcpy(&bits, &a, sizeof bits);
    return bits;
}

static inline uint64_t bits_of_double(double a)
{
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    return bits;
}

/* At each exponent another bit stands for a half; it and those below decide whether a float has a
   fraction. So each bit comes by itself, with all below it, and with all from it on. */
static inline void make_floats(void)
{
    uint64_t state = 1;
    for (uint32_t exponent = 0; exponent < 256; exponent++) {
        for (uint32_t bit = 0; bit < 24; bit++) {
            const uint32_t one = 1u << bit & 0x7fffffu, below = (1u << bit) - 1;
            const uint32_t mantissas[] = {one, below, ~below & 0x7fffffu,
                                          (uint32_t)check_random(&state) & 0x7fffffu};
            for (size_t i = 0; i < 4; i++) {
                const uint32_t bits = exponent << 23 | mantissas[i];
                number_f[numbers_f++] = float_of(bits);
                number_f[numbers_f++] = float_of(bits | 0x80000000u);
            }
        }
    }
}

/* Bit 28 is half a unit in the last place of a float; for denormal floats a higher bit is. */
static inline void make_doubles(void)
{
    static const uint64_t tie = UINT64_C(1) << 28, odd = UINT64_C(1) << 29;
    const uint64_t all = (UINT64_C(1) << 52) - 1;
    uint64_t state = 2;
    for (uint64_t exponent = 0; exponent < 2048; exponent++) {
        const uint64_t mantissas[] = {0,
                                      1,
                                      all,
                                      all - tie,
                                      tie,
                                      tie + 1,
                                      tie - 1,
                                      odd | tie,
                                      all / 2 + 1,
                                      all / 2,
                                      odd,
                                      all - 15,
                                      all - tie + 1,
                                      check_random(&state) & all};
        for (size_t i = 0; i < sizeof mantissas / sizeof mantissas[0]; i++) {
            const uint64_t bits = exponent << 52 | mantissas[i];
            number_d[numbers_d++] = double_of(bits);
            number_d[numbers_d++] = double_of(bits | UINT64_C(1) << 63);
        }
    }
    /* Each bit of a fraction, and the ties of denormal floats. */
    for (uint64_t exponent = 1; exponent < 110; exponent++) {
        for (int bit = 0; bit < 52; bit++) {
            const uint64_t e = exponent < 55 ? 1022 + exponent : 870 + exponent - 55;
            number_d[numbers_d++] = double_of(e << 52 | UINT64_C(1) << bit);
        }
    }
}

static inline void make_numbers32(void)
{
    uint64_t state = 3;
    for (int bit = 0; bit < 32; bit++) {
        const uint32_t one = 1u << bit;
        const uint32_t near[] = {one - 2, one - 1, one, one + 1, one + 2};
        for (size_t i = 0; i < 5; i++) {
            number_bits32[numbers32++] = near[i];
            number_bits32[numbers32++] = 0u - near[i];
        }
        /* Ties of integers above 2^24. */
        for (uint32_t i = 0; i < 64; i++) {
            number_bits32[numbers32++] = one | i << (bit > 8 ? bit - 8 : 0);
            number_bits32[numbers32++] = (one | i << (bit > 25 ? bit - 25 : 0)) + (i & 1);
        }
    }
    while (numbers32 < 16384) {
        number_bits32[numbers32++] = (uint32_t)check_random(&state);
    }
}

static inline void make_numbers(void)
{
    make_floats();
    make_doubles();
    make_numbers32();
}

#endif
