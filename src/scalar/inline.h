/* SPDX-License-Identifier: MIT
 *
 * How the functions of the reference are inlined. Left to itself clang 19 calls the basis for every
 * octave, with its results in memory, and needs twice the time; gcc 12 inlines it all anyway.
 */
#ifndef SCARP_SCALAR_INLINE_H
#define SCARP_SCALAR_INLINE_H

#define SCALAR_INLINE static inline __attribute__((always_inline))

#endif
