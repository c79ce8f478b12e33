/* SPDX-License-Identifier: MIT
 *
 * The one list of instruction sets, and where each is compiled. The tables of dispatch.c, the names
 * of calls/names.c, the declarations in kernels.h and the operations that tests/test_vec.c tests
 * are made from it.
 */
#ifndef SCARP_ISAS_H
#define SCARP_ISAS_H

/*
 * X(enumerator after SCARP_ISA_, table after scarpi_kernels_, name, whether this build has it), best
 * first: of those that the processor can run, the first one serves the calls.
 */
#define SCARP_ISA_VECTORS(X)                                                                       \
    X(AVX512, avx512, "avx512", SCARP_HAS_AVX512)                                                  \
    X(AVX2, avx2, "avx2", SCARP_HAS_AVX2)                                                          \
    X(SSE41, sse41, "sse4.1", SCARP_HAS_SSE41)                                                     \
    X(NEON, neon, "neon", SCARP_HAS_NEON)                                                          \
    X(WASM128, wasm128, "wasm128", SCARP_HAS_WASM128)                                              \
    X(GENERIC, generic, "generic", SCARP_HAS_GENERIC)

/* All sets: the vector ones, and the reference, which runs everywhere. */
#define SCARP_ISA_LIST(X) SCARP_ISA_VECTORS(X) X(SCALAR, scalar, "scalar", SCARP_SCALAR)

/*
 * A build leaves out a vector set where one of these macros is 0. Without a definition, a build has
 * the sets that its processors can use. The CMake variable SCARP_SETS defines the macros; the
 * modules of web/ and users of the single file do so by hand. SCARP_SCALAR=0 leaves out the
 * reference, where the build has another set that runs everywhere.
 */
#ifndef SCARP_AVX512
#define SCARP_AVX512 1
#endif
#ifndef SCARP_AVX2
#define SCARP_AVX2 1
#endif
#ifndef SCARP_SSE41
#define SCARP_SSE41 1
#endif
#ifndef SCARP_NEON
#define SCARP_NEON 1
#endif
#ifndef SCARP_WASM128
#define SCARP_WASM128 1
#endif
#ifndef SCARP_GENERIC /* x86-64 without SSE4.1, from before 2008, takes scalar */
#ifdef __x86_64__
#define SCARP_GENERIC 0
#else
#define SCARP_GENERIC 1
#endif
#endif
#ifndef SCARP_SCALAR
#define SCARP_SCALAR 1
#endif

/* How many enumerators of sets scarp.h has: SCARP_ISA_NONE and the sets of the list. */
#define SCARP_ISA_COUNT(ISA, table, name, here) +1
#define SCARP_ISAS (1 SCARP_ISA_LIST(SCARP_ISA_COUNT))

/* SCARP_WHERE(condition, text) gives the text if the condition is 1, nothing if it is 0. */
#define SCARP_WHERE(condition, ...) SCARP_WHERE_EXPANDED(condition, __VA_ARGS__)
#define SCARP_WHERE_EXPANDED(condition, ...) SCARP_WHERE_##condition(__VA_ARGS__)
#define SCARP_WHERE_0(...)
#define SCARP_WHERE_1(...) __VA_ARGS__

#if defined(__x86_64__) || defined(__i386__)
#define SCARP_X86 1
#else
#define SCARP_X86 0
#endif

/* gcc for Windows spills wider vectors to a stack that is aligned to 16 bytes (GCC bug 54412). */
#if SCARP_X86 && (!defined(_WIN32) || defined(__clang__))
#define SCARP_X86_AVX 1
#else
#define SCARP_X86_AVX 0
#endif

#if SCARP_X86_AVX && SCARP_AVX512
#define SCARP_HAS_AVX512 1
#else
#define SCARP_HAS_AVX512 0
#endif

#if SCARP_X86_AVX && SCARP_AVX2
#define SCARP_HAS_AVX2 1
#else
#define SCARP_HAS_AVX2 0
#endif

#if SCARP_X86 && SCARP_SSE41
#define SCARP_HAS_SSE41 1
#else
#define SCARP_HAS_SSE41 0
#endif

#if defined(__aarch64__) && defined(__ARM_NEON) && defined(__BYTE_ORDER__) &&                      \
    __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ && SCARP_NEON
#define SCARP_HAS_NEON 1
#else
#define SCARP_HAS_NEON 0
#endif

/* -msimd128 makes a module of vectors, which an engine without them rejects as a whole. */
#if defined(__wasm_simd128__) && SCARP_WASM128
#define SCARP_HAS_WASM128 1
#else
#define SCARP_HAS_WASM128 0
#endif

/* The generic set needs vector extensions with conversions between them (gcc 9). It is left out
   where vectors flush denormals in every floating-point mode: 32-bit Arm with NEON, PowerPC with
   AltiVec only. */
#if !SCARP_GENERIC || (defined(__ARM_NEON) && !defined(__aarch64__)) ||                            \
    (defined(__ALTIVEC__) && !defined(__VSX__))
#define SCARP_HAS_GENERIC 0
#elif defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 9)
#define SCARP_HAS_GENERIC 1
#else
#define SCARP_HAS_GENERIC 0
#endif

#endif
