/* SPDX-License-Identifier: MIT
 *
 * In place of a file: bytes that come in pieces, with signals between, and perhaps an error at the
 * end
 */
#ifndef SCARP_TESTS_FUZZ_POINTS_INPUT_H
#define SCARP_TESTS_FUZZ_POINTS_INPUT_H

#include <stddef.h>

int fuzz_open(void);
ptrdiff_t fuzz_read(int descriptor, void *bytes, size_t count);

#endif
