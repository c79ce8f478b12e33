/* SPDX-License-Identifier: MIT
 *
 * What fuzz targets share.
 */
#include "fuzz.h"

#include <string.h>

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
