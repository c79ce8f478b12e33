/* SPDX-License-Identifier: MIT
 *
 * Setting floating-point modes, for tests/test_fpmode.c: MXCSR on x86, FPCR on AArch64, the
 * rounding direction elsewhere. Independent of src/dispatch/fpmode.h.
 */
#ifndef SCARP_TESTS_FPMODE_SET_H
#define SCARP_TESTS_FPMODE_SET_H

#include <fenv.h>
#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

struct mode_control {
    uint64_t word;
};

/* The effect of a mode that mode_works looks for: it flushes denormal results or operands to 0, or
   rounds in that direction. */
enum effect { EFFECT_NONE, FLUSHES_RESULTS, FLUSHES_OPERANDS, ROUNDS_UP, ROUNDS_DOWN, ROUNDS_TO_0 };

struct mode {
    const char *name;
    uint64_t word;
    enum effect effect;
};

#if defined(__SSE2__)

#define MODE_IGNORED 0x3fu /* the sticky exception flags */

static const struct mode mode_default = {"default", 0x1f80, EFFECT_NONE};
static const struct mode modes_all[] = {
    {"flush to zero", 0x9f80, FLUSHES_RESULTS},
    {"denormals are zero", 0x1fc0, FLUSHES_OPERANDS},
    {"both", 0x9fc0, FLUSHES_RESULTS},
    {"round up", 0x5f80, ROUNDS_UP},
    {"round down", 0x3f80, ROUNDS_DOWN},
    {"round toward zero", 0x7f80, ROUNDS_TO_0},
    {"round up, both", 0xdfc0, ROUNDS_UP},
    {"unmasked: invalid, division, overflow", 0x1900, EFFECT_NONE},
    {"unmasked: all", 0x0000, EFFECT_NONE},
    {"unmasked: all, with all flags set", 0x003f, EFFECT_NONE},
    {"unmasked: all, round down", 0x2000, EFFECT_NONE},
};

static inline uint64_t mode_word(void)
{
    return _mm_getcsr();
}

static inline void mode_set(uint64_t word)
{
    _mm_setcsr((unsigned)word);
}

#elif defined(__aarch64__)

#define MODE_IGNORED 0u

static const struct mode mode_default = {"default", 0, EFFECT_NONE};
static const struct mode modes_all[] = {
    {"flush to zero", 1u << 24, FLUSHES_RESULTS},
    {"default NaN", 1u << 25, EFFECT_NONE},
    {"round up", 1u << 22, ROUNDS_UP},
    {"round down", 2u << 22, ROUNDS_DOWN},
    {"round toward zero", 3u << 22, ROUNDS_TO_0},
    {"round up, flush to zero, default NaN", 7u << 22 & ~(2u << 22), ROUNDS_UP},
    {"unmasked: invalid, division, overflow", 7u << 8, EFFECT_NONE},
    {"unmasked: all", 0x9f00, EFFECT_NONE},
};

static inline uint64_t mode_word(void)
{
    uint64_t word;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return word;
}

static inline void mode_set(uint64_t word)
{
    __asm__ volatile("msr fpcr, %0" : : "r"(word) : "memory");
}

#else

#define MODE_IGNORED 0u

static const struct mode mode_default = {"default", FE_TONEAREST, EFFECT_NONE};
static const struct mode modes_all[] = {
#ifdef FE_UPWARD
    {"round up", FE_UPWARD, ROUNDS_UP},
#endif
#ifdef FE_DOWNWARD
    {"round down", FE_DOWNWARD, ROUNDS_DOWN},
#endif
#ifdef FE_TOWARDZERO
    {"round toward zero", FE_TOWARDZERO, ROUNDS_TO_0},
#endif
    {"round to nearest", FE_TONEAREST, EFFECT_NONE},
};

static inline uint64_t mode_word(void)
{
    return (uint64_t)fegetround();
}

static inline void mode_set(uint64_t word)
{
    fesetround((int)word);
}

#endif

#define MODES (int)(sizeof modes_all / sizeof modes_all[0])

static inline struct mode_control mode_enter(const struct mode *mode)
{
    const struct mode_control before = {mode_word()};
    mode_set(mode->word);
    return before;
}

/* Restores `before`. Returns the mode that it found. */
static inline struct mode_control mode_leave(struct mode_control before)
{
    const struct mode_control found = {mode_word()};
    mode_set(before.word);
    return found;
}

static inline int mode_is(const struct mode *mode, const struct mode_control *control)
{
    return ((control->word ^ mode->word) & ~(uint64_t)MODE_IGNORED) == 0;
}

static inline struct mode mode_started(void)
{
    const struct mode start = {"the mode at the start", mode_word(), EFFECT_NONE};
    return start;
}

/* The bits of a * b and a + b, in the present mode. */
static __attribute__((noinline)) uint32_t mode_compute(char operation, uint32_t a, uint32_t b)
{
    float x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    volatile float vx = x, vy = y, result;
    result = operation == '*' ? vx * vy : vx + vy;
    const float value = result;
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Whether the mode can be set here and has its effect: valgrind, for one, keeps the bits but
   computes as before. */
static inline int mode_works(const struct mode *mode)
{
    const struct mode_control before = mode_enter(mode);
    const struct mode_control now = {mode_word()};
    int works = 1;
    switch (mode->effect) {
    case FLUSHES_RESULTS: works = mode_compute('*', 0x00800000u, 0x3f000000u) == 0; break;
    case FLUSHES_OPERANDS: works = mode_compute('*', 0x00400000u, 0x40800000u) == 0; break;
    case ROUNDS_UP: works = mode_compute('+', 0x3f800000u, 0x30800000u) == 0x3f800001u; break;
    case ROUNDS_DOWN: works = mode_compute('+', 0xbf800000u, 0xb0800000u) == 0xbf800001u; break;
    case ROUNDS_TO_0: works = mode_compute('+', 0x3f800000u, 0xb0800000u) == 0x3f7fffffu; break;
    case EFFECT_NONE: break;
    }
    mode_leave(before);
    return works && mode_is(mode, &now);
}

static inline int mode_flushes(const struct mode *mode)
{
    const struct mode probe = {mode->name, mode->word, FLUSHES_RESULTS};
    return mode_works(&probe);
}

#endif
