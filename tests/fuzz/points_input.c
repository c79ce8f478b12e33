/* SPDX-License-Identifier: MIT
 *
 * sample/input.c as it is, but what it reads is an input of the fuzz target, in pieces.
 */
#include "shared/posix.h"

#include "points_input.h"

#define open(path, flags) fuzz_open()
#define read fuzz_read
#define close(descriptor) ((void)(descriptor))
#include "sample/input.c"
