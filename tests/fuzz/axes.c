/* SPDX-License-Identifier: MIT
 *
 * The text of --sheet: what is read is written as a list and read again as it was.
 */
#include "sheet/axes.h"

#include <string.h>

#include "cli.h"
#include "fuzz.h"
#include "shared/text.h"

static struct axes axes, again;

static bool has_range(void)
{
    for (size_t a = 0; a < axes.count; a++) {
        if (strstr(axes.list[a].values[0], "..") != NULL) {
            return true;
        }
    }
    return false;
}

static void write_again(void)
{
    struct text text = {0};
    for (size_t a = 0; a < axes.count; a++) {
        text_add(&text, "%s%s=", a > 0 ? "," : "", axes.list[a].name);
        for (size_t i = 0; i < axes.list[a].count; i++) {
            text_add(&text, "%s%s", i > 0 ? "|" : "", axes.list[a].values[i]);
        }
    }
    memset(&again, 0, sizeof again);
    MUST(axes_parse(text.bytes, &again), "'%s' is not read", text.bytes);
    MUST(again.count == axes.count, "%zu parameters of %zu", again.count, axes.count);
    for (size_t a = 0; a < axes.count; a++) {
        MUST(again.list[a].count == axes.list[a].count, "%zu values of %zu", again.list[a].count,
             axes.list[a].count);
        for (size_t i = 0; i < axes.list[a].count; i++) {
            MUST(strcmp(again.list[a].values[i], axes.list[a].values[i]) == 0, "value %zu", i);
        }
    }
    free(text.bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *const text = fuzz_text(bytes, size);
    memset(&axes, 0, sizeof axes);
    fuzz_no_errors();
    const bool is_read = axes_parse(text, &axes);
    fuzz_must_tell(!is_read, "a sheet");
    if (is_read) {
        MUST(axes.count >= 1 && axes.count <= AXES_MAX, "%zu parameters", axes.count);
        for (size_t a = 0; a < axes.count; a++) {
            const struct axis *const axis = &axes.list[a];
            MUST(axis->count >= 1 && axis->count <= CELLS_MAX, "%zu values", axis->count);
            MUST(memchr(axis->name, '\0', sizeof axis->name) != NULL && *axis->name != '\0',
                 "parameter %zu has no name", a);
            for (size_t i = 0; i < axis->count; i++) {
                MUST(axis->values[i][0] != '\0', "value %zu is empty", i);
            }
        }
        if (!has_range()) {
            write_again();
        }
    }
    free(text);
    return 0;
}
