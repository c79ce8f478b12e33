/* SPDX-License-Identifier: MIT
 *
 * Everything in src/kernel, and the table that offers it. Included once by each
 * simd/kernels_<isa>.c, which defines beforehand
 *
 *     KERNELS           the name of the table
 *     KERNELS_ISA       the instruction set
 *     KERNELS_NARROWER  the table of the set with half as many lanes, if calls that fill no more
 *                       of a vector take less time there
 *
 * and includes the vec_<isa>.h that gives the operations of simd/vec.h.
 */
#include "cells.h"
#include "chain.h"
#include "curl.h"
#include "normals.h"

const struct scarp_kernels KERNELS = {
    .isa = KERNELS_ISA,
#ifdef KERNELS_NARROWER
    .narrower = &KERNELS_NARROWER,
    .narrower_most = VEC_LANES / 2,
#endif
    .points2_f32 = points2_f32,
    .points2_f64 = points2_f64,
    .points3_f32 = points3_f32,
    .points3_f64 = points3_f64,
    .grid2 = grid2,
    .grid3 = grid3,
    .normals = normals,
    .cells = cells,
    .chain = chain,
    .curl = curl,
};

#undef KERNELS
#undef KERNELS_ISA
#undef KERNELS_NARROWER
