/* SPDX-License-Identifier: MIT
 *
 * One deliberate mistake in otherwise unchanged kernels: MISTAKE_FMA, MISTAKE_LANE, MISTAKE_TAIL or
 * MISTAKE_STREAM. Included by kernels_<isa>.c of this folder where the original includes
 * kernel/table.h. test_bits must notice each of them, but test_grid the last.
 */
#if defined(MISTAKE_FMA)

/* One fused multiply-add, in the interpolation that some second derivatives use. */
#define mix mix_exact
#include "../../src/kernel/fade.h"
#undef mix

static inline vf mix(vf a, vf b, vf u)
{
    vf result = a;
    for (int lane = 0; lane < VEC_LANES; lane++) {
        result[lane] = __builtin_fmaf(u[lane], b[lane] - a[lane], a[lane]);
    }
    return result;
}

#include "../../src/kernel/table.h"

#elif defined(MISTAKE_LANE) || defined(MISTAKE_STREAM)

/* Two lanes swapped in every store, or in those of large grids. */
static inline void store_swapped(float *p, vf v)
{
    const float first = v[0];
    v[0] = v[1];
    v[1] = first;
    vf_store(p, v);
}

#ifdef MISTAKE_LANE
#define vf_store store_swapped
#else
#define vf_stream store_swapped
#endif
#include "../../src/kernel/table.h"

#elif defined(MISTAKE_TAIL)

/* The last, incomplete block forgotten in one entry of the table. */
#define points3_f32 points3_f32_whole
#include "../../src/kernel/points.h"
#undef points3_f32

static void points3_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points3_f32_whole(plan, count - count % VEC_LANES, position, out);
}

#include "../../src/kernel/table.h"

#endif
