/* SPDX-License-Identifier: MIT
 *
 * What the tests of recipes as a language share: a recipe, points, and the values of a text at
 * them. Header only; included by test_recipe.c and its like.
 */
#ifndef SCARP_TESTS_RECIPE_VALUES_H
#define SCARP_TESTS_RECIPE_VALUES_H

#include "recipes.h"

#define POINTS 64

static struct scarp_recipe recipe;
static struct scarp_recipe_error errors[8];
static double x[POINTS], y[POINTS], z[POINTS];
static float value[POINTS];
static uint64_t memory[1 << 14];
static const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};

static inline size_t parse(const char *text)
{
    size_t found = 0;
    memset(errors, 0, sizeof errors);
    (void)scarp_recipe_parse(text, strlen(text), &recipe, errors, 8, &found);
    return found;
}

static inline int parses(const char *text)
{
    const size_t found = parse(text);
    CHECK(found == 0, "%d:%d: %s in\n%s", (int)errors[0].line, (int)errors[0].column,
          errors[0].text, text);
    return found == 0;
}

static inline enum scarp_status sample(const struct scarp_recipe *of,
                                       const struct scarp_samples *out, const int32_t *which)
{
    const struct scarp_recipe_outputs outputs = {.out = out, .count = 1, .which = which};
    return scarp_recipe_sample_f64(of, POINTS, x, y, z, &outputs, &scratch);
}

static inline void set_positions(void)
{
    for (int i = 0; i < POINTS; i++) {
        x[i] = 0.37 * (double)(i % 8) - 1.0;
        y[i] = 0.41 * (double)(i / 8) + 0.25;
        z[i] = 0.1 * (double)i;
    }
}

#define ONE "recipe 1\nn = noise()\n"

/* Values of a text at the points; the text must be right. */
static inline const float *values(const char *text)
{
    const struct scarp_samples out = {.value = value};
    if (parses(text)) {
        const enum scarp_status status = sample(&recipe, &out, NULL);
        CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    }
    return value;
}

static inline void check_same_values(const char *text, const char *as)
{
    float kept[POINTS];
    memcpy(kept, values(text), sizeof kept);
    (void)values(as);
    CHECK(memcmp(kept, value, sizeof kept) == 0, "differ: %s and %s, %g and %g", text, as,
          (double)kept[0], (double)value[0]);
}

static inline void check_different_values(const char *text, const char *as)
{
    float kept[POINTS];
    memcpy(kept, values(text), sizeof kept);
    (void)values(as);
    CHECK(memcmp(kept, value, sizeof kept) != 0, "are the same: %s and %s", text, as);
}

#endif
