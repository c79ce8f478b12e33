/* SPDX-License-Identifier: MIT
 *
 * The text of a recipe: compares words, finds statements by name, and adds errors with their lines
 * and columns.
 */
#include "text.h"

#include <string.h>

void scarpi_recipe_fail(struct recipe_errors *errors, const struct recipe *recipe,
                        struct recipe_span span, const char *text, const char *member)
{
    struct scarp_recipe_error error = {.from = span.from,
                                       .to = span.to,
                                       .line = 1,
                                       .column = 1,
                                       .text = text,
                                       .member = member,
                                       .nearest = errors->nearest};
    errors->nearest = 0.0;
    for (size_t i = 0; i < span.from; i++) {
        const bool is_end = recipe->text[i] == '\n';
        error.line += is_end;
        error.column = is_end ? 1 : error.column + 1;
    }
    /* The list is in the order of the text. If it is too short, it has the first errors. */
    size_t at = errors->found < errors->capacity ? errors->found : errors->capacity;
    for (; at > 0 && errors->list[at - 1].from > error.from; at--) {
        if (at < errors->capacity) {
            errors->list[at] = errors->list[at - 1];
        }
    }
    if (at < errors->capacity) {
        errors->list[at] = error;
    }
    errors->found++;
}

bool scarpi_recipe_is(const struct recipe *recipe, struct recipe_span span, const char *word)
{
    const char *const text = recipe->text + span.from;
    const size_t length = (size_t)(span.to - span.from);
    return text[0] == word[0] && strncmp(text, word, length) == 0 && word[length] == '\0';
}

int scarpi_recipe_find(const struct recipe *recipe, struct recipe_span name, int count)
{
    const size_t length = (size_t)(name.to - name.from);
    for (int i = count - 1; i >= 0; i--) {
        const struct recipe_span other = recipe->statement[i].name;
        if ((size_t)(other.to - other.from) == length &&
            memcmp(recipe->text + other.from, recipe->text + name.from, length) == 0) {
            return i;
        }
    }
    return -1;
}
