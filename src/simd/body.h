/* SPDX-License-Identifier: MIT
 *
 * Names what a kernels_<isa>.c compiles: the kernels. In its place tests/bits.cmake names a file
 * that offers the operations of vec.h one by one, in the same target region.
 */
#ifndef KERNELS_BODY
#define KERNELS_BODY "../kernel/table.h"
#endif
