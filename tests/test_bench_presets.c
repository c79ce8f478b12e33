/* SPDX-License-Identifier: MIT
 *
 * Every preset of the program has two rows in the benchmark, for values and with the gradient, and
 * there are none of what is no preset.
 */
#include "../bench/work.h"
#include "check.h"
#include "presets/presets.h"

static int count_rows(const char *title)
{
    struct bench_work work;
    int rows = 0;
    for (size_t i = 0; bench_work_get(i, &work); i++) {
        rows += work.layout == BENCH_RECIPE_GRID && strcmp(work.title, title) == 0;
    }
    return rows;
}

static int is_preset(const char *name)
{
    for (int i = 1; preset_name(i) != NULL; i++) {
        if (strcmp(preset_name(i), name) == 0) {
            return 1;
        }
    }
    return 0;
}

int main(void)
{
    struct bench_work work;
    for (int i = 1; preset_name(i) != NULL; i++) {
        char title[64];
        snprintf(title, sizeof title, "terrain-%s", preset_name(i));
        CHECK(count_rows(title) == 2, "%d rows of %s, not value and +gradient", count_rows(title),
              title);
    }
    for (size_t i = 0; bench_work_get(i, &work); i++) {
        if (work.layout == BENCH_RECIPE_GRID && strncmp(work.title, "terrain-", 8) == 0) {
            CHECK(is_preset(work.title + 8), "%s: there is no such preset", work.name);
        }
    }
    return check_done();
}
