/* SPDX-License-Identifier: MIT
 *
 * A program as Microsoft's compiler would make it, without a C library: links the DLL by scarp.lib,
 * and exits with 42 if calls work. The script .ci/run builds it, as C and as C++.
 */
#define SCARP_SHARED
#include "scarp.h"

#ifdef __cplusplus
extern "C" {
#endif

int start(void);
int _fltused; /* Microsoft's compilers want it of programs with floating-point numbers */

/* The loader fills these with zeros. On the stack the compiler would call memset, of a C library.
 */
static struct scarp_noise noise;
static struct scarp_samples samples;

int start(void)
{
    float x = 0.5f, y = 0.25f, value = 7, dx = 7;
    samples.value = &value;
    samples.dx = &dx;
    const enum scarp_status status = scarp_sample2(&noise, 1, &x, &y, &samples);
    return status == SCARP_OK && value != 7 && dx != 7 && scarp_version()[0] == '0' ? 42 : 1;
}

#ifdef __cplusplus
}
#endif
