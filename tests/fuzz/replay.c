/* SPDX-License-Identifier: MIT
 *
 * In place of libFuzzer: runs a target on nothing, and on the files that a list names, one a line.
 */
#include <string.h>

#include "check.h"
#include "fuzz.h"

#define BYTES_MOST (1 << 20)

static void replay(const char *path)
{
    static uint8_t bytes[BYTES_MOST];
    FILE *const file = fopen(path, "rb");
    const size_t size = file != NULL ? fread(bytes, 1, sizeof bytes, file) : 0;
    const int is_read = file != NULL && !ferror(file) && size < sizeof bytes;
    CHECK(is_read, "%s cannot be read", path);
    if (file != NULL) {
        fclose(file);
    }
    if (is_read) {
        /* A copy of just that size, so that tools notice what reads beyond it */
        uint8_t *const input = malloc(size > 0 ? size : 1);
        CHECK(input != NULL, "no memory");
        if (input != NULL) {
            memcpy(input, bytes, size);
            CHECK(LLVMFuzzerTestOneInput(input, size) == 0, "%s", path);
        }
        free(input);
    }
}

int main(int argc, char **argv)
{
    char path[4096];
    FILE *const list = argc == 2 ? fopen(argv[1], "r") : NULL;
    if (list == NULL) {
        fprintf(stderr, "usage: %s LIST\n", argv[0]);
        return EXIT_FAILURE;
    }
    CHECK(LLVMFuzzerTestOneInput((const uint8_t *)path, 0) == 0, "the empty input");
    while (fgets(path, sizeof path, list) != NULL) {
        path[strcspn(path, "\r\n")] = '\0';
        if (*path != '\0') {
            const long failures = check_failures;
            replay(path);
            if (check_failures > failures) {
                break;
            }
        }
    }
    fclose(list);
    return check_done();
}
