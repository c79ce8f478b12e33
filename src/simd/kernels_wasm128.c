/* SPDX-License-Identifier: MIT
 *
 * The kernels for the vectors of WebAssembly, which -msimd128 switches on for a whole module.
 */
#include "../dispatch/kernels.h"
#include "body.h"

#if SCARP_HAS_WASM128

#include "vec_wasm.h"

#define KERNELS scarpi_kernels_wasm128
#define KERNELS_ISA SCARP_ISA_WASM128
#include KERNELS_BODY

#else
typedef int scarp_no_wasm128; /* ISO C wants a declaration in every file */
#endif
