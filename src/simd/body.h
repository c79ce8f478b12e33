/* SPDX-License-Identifier: MIT
 *
 * What a kernels_<isa>.c compiles: the kernels. tests/vec.cmake compiles the same files with the
 * operations of vec.h one by one instead, in the target region that the kernels have.
 */
#ifndef KERNELS_BODY
#define KERNELS_BODY "../kernel/table.h"
#endif
