/* SPDX-License-Identifier: MIT
 *
 * Headers of .npy files: what is read is written and read again as it was.
 */
#include <string.h>

#include "formats/npy.h"
#include "fuzz.h"

/* Whether the type can be in quotes, as the program's own do, and was not cut off */
static int is_plain(const struct npy_array *array)
{
    const size_t length = strlen(array->descr);
    return length + 1 < sizeof array->descr && strcspn(array->descr, "'\"\\\n") == length &&
           strcmp(array->descr, "[...]") != 0;
}

static void write_again(const struct npy_array *array)
{
    char *bytes = NULL;
    size_t size = 0, text, length;
    struct npy_array again;
    FILE *const stream = open_memstream(&bytes, &size);
    MUST(stream != NULL && npy_write_header(stream, array->descr, array->shape, array->dimensions),
         "a header is not written");
    fclose(stream);
    MUST(size % 64 == 0 && size >= NPY_HEADER_SIZE, "a header of %zu bytes", size);
    MUST(npy_preamble(bytes, &text, &length) && text + length == size, "%zu + %zu of %zu bytes",
         text, length, size);
    const char *const problem = npy_parse_header(bytes + text, length, &again);
    MUST(problem == NULL, "a header that was written %s", problem);
    MUST(strcmp(again.descr, array->descr) == 0 && !again.fortran &&
             again.dimensions == array->dimensions &&
             memcmp(again.shape, array->shape, sizeof again.shape) == 0,
         "another array is read");
    free(bytes);
}

/* A text has the digits of each size: none is too large to be held. */
static void find_sizes(const struct npy_array *array, const char *text)
{
    for (int d = 0; d < array->dimensions; d++) {
        char digits[32];
        snprintf(digits, sizeof digits, "%zu", array->shape[d]);
        MUST(strstr(text, digits) != NULL, "no %s in '%s'", digits, text);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct npy_array array;
    size_t text, length;
    char *const copy = malloc(size > 0 ? size : 1); /* without a 0 behind it */
    MUST(copy != NULL, "no memory");
    memcpy(copy, bytes, size);
    if (size >= NPY_PREAMBLE_SIZE && npy_preamble(copy, &text, &length)) {
        MUST(text == 10 || text == 12, "the text begins at %zu", text);
        MUST(text == 12 || length < 65536, "%zu bytes of text", length);
        const char *const at = copy + text;
        const size_t most = size - text;
        (void)npy_parse_header(at, length < most ? length : most, &array);
    }
    if (npy_parse_header(copy, size, &array) == NULL) {
        MUST(array.dimensions >= 0 && array.dimensions <= NPY_DIMENSIONS_MAX, "%d dimensions",
             array.dimensions);
        MUST(memchr(array.descr, '\0', sizeof array.descr) != NULL, "a type without an end");
        char *const whole = fuzz_text(bytes, size);
        find_sizes(&array, whole);
        free(whole);
        if (is_plain(&array)) {
            write_again(&array);
        }
    }
    free(copy);
    return 0;
}
