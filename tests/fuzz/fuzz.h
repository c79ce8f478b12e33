/* SPDX-License-Identifier: MIT
 *
 * What fuzz targets share. A target defines LLVMFuzzerTestOneInput, which calls MUST for all that
 * has to hold.
 */
#ifndef SCARP_TESTS_FUZZ_H
#define SCARP_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Returns 0. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* MUST(condition, "printf format", ...) ends the program with the text if the condition is false.
 */
#define MUST(condition, ...)                                                                       \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: failed: %s\n    ", __FILE__, __LINE__, #condition);            \
            fprintf(stderr, __VA_ARGS__);                                                          \
            fputc('\n', stderr);                                                                   \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/* A copy as a text: with a 0 behind it, of which reads beyond are noticed. Free it. */
char *fuzz_text(const uint8_t *bytes, size_t size);

#endif
