/* SPDX-License-Identifier: MIT
 *
 * Runs kernels in the default floating-point mode (round to nearest, denormals kept, exceptions
 * masked) whatever the caller's is: a program linked with -ffast-math starts with denormals
 * flushed, and some hosts unmask traps. Public functions call functions that are not inlined in
 * between, so that no arithmetic moves out of the mode.
 */
#ifndef SCARP_FPMODE_H
#define SCARP_FPMODE_H

#include <stdint.h>

#if defined(__SSE2__)

#include <xmmintrin.h>

struct fpmode {
    unsigned control;
};

#define MXCSR_STICKY 0x3fu /* exception flags: not part of the mode */
#define MXCSR_DEFAULT 0x1f80u

static inline struct fpmode fpmode_enter(void)
{
    const struct fpmode caller = {_mm_getcsr()};
    if ((caller.control & ~MXCSR_STICKY) != MXCSR_DEFAULT) {
        _mm_setcsr(MXCSR_DEFAULT);
    }
    return caller;
}

static inline void fpmode_leave(struct fpmode caller)
{
    if ((caller.control & ~MXCSR_STICKY) != MXCSR_DEFAULT) {
        _mm_setcsr(caller.control);
    }
}

#elif defined(__aarch64__)

struct fpmode {
    uint64_t control;
};

/* FPCR holds trap enables, flushing, rounding, default NaNs and alternative behaviours; 0 is the
   mode of IEEE 754. */
static inline struct fpmode fpmode_enter(void)
{
    struct fpmode caller;
    __asm__ volatile("mrs %0, fpcr" : "=r"(caller.control));
    if (caller.control != 0) {
        __asm__ volatile("msr fpcr, xzr" ::: "memory");
    }
    return caller;
}

static inline void fpmode_leave(struct fpmode caller)
{
    if (caller.control != 0) {
        __asm__ volatile("msr fpcr, %0" : : "r"(caller.control) : "memory");
    }
}

#else

#include <fenv.h>

struct fpmode {
    int rounding;
};

/* Standard C knows the rounding direction only. */
static inline struct fpmode fpmode_enter(void)
{
    const struct fpmode caller = {fegetround()};
    if (caller.rounding != FE_TONEAREST) {
        fesetround(FE_TONEAREST);
    }
    return caller;
}

static inline void fpmode_leave(struct fpmode caller)
{
    if (caller.rounding != FE_TONEAREST) {
        fesetround(caller.rounding);
    }
}

#endif

#endif
