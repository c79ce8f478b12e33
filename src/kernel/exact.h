/* SPDX-License-Identifier: MIT
 *
 * Whether a compiler kept to the operations of the kernels (dispatch/exact.h), which has to be
 * asked for each set: AVX2 has fused operations, SSE4.1 has none.
 */
#ifndef SCARP_KERNEL_EXACT_H
#define SCARP_KERNEL_EXACT_H

#include "../dispatch/exact.h"
#include "../simd/vec.h"

static int is_exact(void)
{
    static const volatile float number[] = {EXACT_ROOT, EXACT_SQUARE, EXACT_LARGE, 1.0f};
    static const volatile double number64[] = {EXACT_ROOT64, EXACT_SQUARE64};
    const vf root = vf_set(number[0]), large = vf_set(number[2]);
    const vd root64 = vd_set(number64[0]);
    const vf fused = root * root + vf_set(number[1]);
    const vd fused64 = root64 * root64 + vd_set(number64[1]);
    const vf reordered = (large + vf_set(number[3])) - large;
    int exact = scarpi_is_exact();
    for (int i = 0; i < VEC_LANES; i++) {
        exact &= fused[i] == 0.0f && reordered[i] == 0.0f && fused64[i / 2] == 0.0;
    }
    return exact;
}

#endif
