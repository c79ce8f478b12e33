/* SPDX-License-Identifier: MIT
 *
 * What fuzz targets share.
 */
#include "fuzz.h"

#include <string.h>

uint64_t fuzz_take(struct fuzz_bytes *bytes, int count)
{
    uint64_t number = 0;
    for (int i = 0; i < count && bytes->left > 0; i++, bytes->left--) {
        number |= (uint64_t)*bytes->at++ << (8 * i);
    }
    return number;
}

char *fuzz_text(const uint8_t *bytes, size_t size)
{
    char *const text = malloc(size + 1);
    if (text == NULL) {
        fprintf(stderr, "no memory\n");
        exit(EXIT_FAILURE);
    }
    if (size > 0) {
        memcpy(text, bytes, size);
    }
    text[size] = '\0';
    return text;
}
