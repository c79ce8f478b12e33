/* SPDX-License-Identifier: MIT
 *
 * Writes the values of options as JSON, each kind as it reads best.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "shared/json.h"
#include "shared/number.h"
#include "shared/options.h"

static void add_number(struct text *text, double value, int single)
{
    char number[NUMBER_SIZE] = "null"; /* JSON has no infinity */
    if (isfinite(value)) {
        number_write_shortest(number, value, single);
    }
    text_add(text, "%s", number);
}

static void add_value(const struct option *option, const void *field, struct text *text)
{
    option_parse_fn *const kind = option->parse;
    if (kind == NULL) {
        text_add(text, "%s", *(const int *)field != 0 ? "true" : "false");
    } else if (kind == option_choice) {
        json_add_string(text, option->choice(*(const int *)field));
    } else if (kind == option_count) {
        text_add(text, "%zu", *(const size_t *)field);
    } else if (kind == option_double) {
        add_number(text, *(const double *)field, 0);
    } else if (kind == option_epsg) {
        const unsigned number = *(const unsigned *)field;
        text_add(text, number != 0 ? "%u" : "null", number);
    } else if (kind == option_float || kind == option_magnitude || kind == option_positive) {
        add_number(text, (double)*(const float *)field, 1);
    } else if (kind == option_point) {
        const struct option_point *const point = field;
        text_add(text, "[");
        add_number(text, point->x, 0);
        text_add(text, ", ");
        add_number(text, point->y, 0);
        text_add(text, "]");
    } else if (kind == option_seed) {
        text_add(text, "%llu", (unsigned long long)*(const uint64_t *)field);
    } else if (kind == option_size) {
        const struct option_size *const size = field;
        text_add(text, "[%zu, %zu]", size->width, size->height);
    } else if (kind == option_text || kind == option_stem) {
        json_add_string(text, *(const char *const *)field);
    } else {
        abort(); /* a kind that is missing above */
    }
}

void options_describe(const struct option_table *table, const void *values, struct text *text)
{
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        for (size_t i = 0; i < group->count; i++) {
            const struct option *const option = &group->options[i];
            if (!option->of_run) {
                text_add(text, "  \"%s\": ", option->name + 2);
                add_value(option, (const char *)values + group->offset + option->offset, text);
                text_add(text, ",\n");
            }
        }
    }
}
