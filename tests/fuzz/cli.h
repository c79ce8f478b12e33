/* SPDX-License-Identifier: MIT
 *
 * What fuzz targets of the program's parsers share: files with the bytes of an input, and errors
 * that are counted in place of printed.
 */
#ifndef SCARP_TESTS_FUZZ_CLI_H
#define SCARP_TESTS_FUZZ_CLI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How often the program printed an error since the last fuzz_no_errors */
extern int fuzz_errors;
void fuzz_no_errors(void);

/* A program that fails prints one line about it, and only then. `what` is that of MUST. */
void fuzz_must_tell(bool has_failed, const char *what);

/* The path of a file in a folder of this process only, which has these bytes now. `name` is of at
   most 30 characters. */
const char *fuzz_file(const char *name, const uint8_t *bytes, size_t size);

#endif
