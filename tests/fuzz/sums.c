/* SPDX-License-Identifier: MIT
 *
 * Files of checksums: every line that is read is found.
 */
#include "terrain/sums.h"

#include <string.h>

#include "cli.h"
#include "fuzz.h"
#include "shared/text.h"

/* The path lies behind the digits of the checksum, all of them. */
static void check_digits(const struct sums_line *line)
{
    char digits[17];
    snprintf(digits, sizeof digits, "%016llx", (unsigned long long)line->hash);
    for (int i = 0; i < 16; i++) {
        const char c = (line->path - 18)[i];
        const char small = c >= 'A' && c <= 'F' ? (char)(c - 'A' + 'a') : c;
        MUST(small == digits[i], "%s is read from '%.16s'", digits, line->path - 18);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct sums_list list = {.count = 0};
    const char *const path = fuzz_file("w.0-1.sums", bytes, size);
    char *const manifest = text_join_part(path, strlen(path) - strlen(".0-1.sums"), ".json");
    MUST(manifest != NULL && sums_read(&list, manifest), "checksums are not read");
    MUST(list.text_count == 1, "%zu files", list.text_count);
    for (size_t i = 0; i < list.count; i++) {
        const struct sums_line *const line = &list.lines[i];
        MUST(i == 0 || strcmp(list.lines[i - 1].path, line->path) <= 0, "line %zu", i);
        check_digits(line);
        MUST(sums_find(&list, line->path, line->hash) == SUMS_SAME, "line %zu is not found", i);
        MUST(sums_find(&list, line->path, line->hash ^ 1) != SUMS_NONE, "line %zu has no path", i);
    }
    sums_free(&list);
    free(manifest);
    return 0;
}
