/* SPDX-License-Identifier: MIT
 *
 * The header of NumPy's .npy files, format version 1.0.
 */
#ifndef SCARP_CLI_NPY_H
#define SCARP_CLI_NPY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Writes the header of an array in C order of 1 to 3 dimensions, of the type `descr`: "<f4", "|u1".
   It takes 128 bytes whatever the shape. Returns whether it succeeded. */
bool npy_write_header(FILE *stream, const char *descr, const size_t *shape, int dimensions);

#endif
