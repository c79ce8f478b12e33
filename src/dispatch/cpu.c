/* SPDX-License-Identifier: MIT
 *
 * Asks CPUID what the processor has, and XGETBV which registers the operating system saves. A set
 * can run only if every feature that it is compiled for is there.
 */
#include "cpu.h"

#include "kernels.h"

#if SCARP_X86

#include <cpuid.h>

/* CPUID leaf 1 */
#define ECX_SSE3 (1u << 0)
#define ECX_SSSE3 (1u << 9)
#define ECX_FMA (1u << 12)
#define ECX_SSE41 (1u << 19)
#define ECX_OSXSAVE (1u << 27)
#define ECX_AVX (1u << 28)
/* CPUID leaf 7, subleaf 0 */
#define EBX_AVX2 (1u << 5)
#define EBX_AVX512F (1u << 16)
#define EBX_AVX512DQ (1u << 17)
#define EBX_AVX512BW (1u << 30)
#define EBX_AVX512VL (1u << 31)
/* XCR0 */
#define XCR0_AVX 0x6u     /* xmm, ymm */
#define XCR0_AVX512 0xe6u /* xmm, ymm, opmask, upper halves of zmm0-15, zmm16-31 */

#define GROUP_SSE41 (ECX_SSE3 | ECX_SSSE3 | ECX_SSE41)
#define GROUP_AVX (ECX_OSXSAVE | ECX_AVX)
#define GROUP_AVX512 (EBX_AVX512F | EBX_AVX512DQ | EBX_AVX512BW | EBX_AVX512VL)

static unsigned xcr0(void)
{
    unsigned low, high;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return low;
}

int scarpi_cpu_has(enum scarp_isa isa)
{
    unsigned eax, ebx = 0, ecx = 0, edx;
    if (isa == SCARP_ISA_SCALAR || isa == SCARP_ISA_GENERIC) {
        return 1;
    }
    if (!__get_cpuid(1, &eax, &ebx, &ecx, &edx)) {
        return 0;
    }
    if (isa == SCARP_ISA_SSE41) {
        return (ecx & GROUP_SSE41) == GROUP_SSE41;
    }
    if (isa != SCARP_ISA_AVX2 && isa != SCARP_ISA_AVX512) {
        return 0;
    }
    const unsigned ecx1 = ecx;
    /* __get_cpuid_count checks that leaf 7 exists. */
    if ((ecx & GROUP_AVX) != GROUP_AVX || !__get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx)) {
        return 0;
    }
    const unsigned saved = xcr0();
    if (isa == SCARP_ISA_AVX2) {
        return (saved & XCR0_AVX) == XCR0_AVX && (ecx1 & ECX_FMA) != 0 && (ebx & EBX_AVX2) != 0;
    }
    return (saved & XCR0_AVX512) == XCR0_AVX512 && (ebx & GROUP_AVX512) == GROUP_AVX512;
}

#else

/* NEON is part of the AArch64 baseline, and is built nowhere else. Where a module of WebAssembly
   runs, all that it was built with does. */
int scarpi_cpu_has(enum scarp_isa isa)
{
    return isa == SCARP_ISA_SCALAR || isa == SCARP_ISA_GENERIC || isa == SCARP_ISA_NEON ||
           isa == SCARP_ISA_WASM128;
}

#endif
