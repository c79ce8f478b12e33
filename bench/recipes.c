/* SPDX-License-Identifier: MIT */
#include "recipes.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "presets/presets.h"

struct bench_recipe {
    struct scarp_recipe recipe;
    struct scarp_scratch scratch;
    void *plan; /* of few points */
};

/* Whether `title` begins with `prefix`; if so, *rest is what is behind it. */
static int begins_with(const char *title, const char *prefix, const char **rest)
{
    const size_t length = strlen(prefix);
    *rest = title + length;
    return strncmp(title, prefix, length) == 0;
}

/* Writes the text of a recipe that is one noise, or with "scaled-" before its title, one times and
   plus numbers. Returns 0 if the title is of something else. */
static int write_noise(const struct bench_work *work, char *text, size_t size)
{
    static const struct {
        const char *title, *noise;
    } noises[] = {{"noise1", "noise(size=50)"},
                  {"noise4", "noise(size=50, octaves=4)"},
                  {"warped", "warp(noise(size=50), noise(size=50, amplitude=25, seed=1))"}};
    const char *rest;
    const int is_scaled = begins_with(work->title, "scaled-", &rest);
    const char *const title = is_scaled ? rest : work->title;
    for (size_t i = 0; i < sizeof noises / sizeof noises[0]; i++) {
        if (strcmp(title, noises[i].title) == 0) {
            snprintf(text, size, "recipe 1\n%sn = %s\nout f = %s\n",
                     work->dimensions == 3 ? "space 3\n" : "", noises[i].noise,
                     is_scaled ? "100 * n + 3" : "n");
            return 1;
        }
    }
    return 0;
}

/* The text of a workload: of a preset, with "terrain-" before its name, or of a file. `made` is
   for those that are in neither. NULL if there is none. */
static const char *find_text(const struct bench_work *work, char *made, size_t size, size_t *length)
{
    const char *preset;
    if (write_noise(work, made, size)) {
        *length = strlen(made);
        return made;
    }
    if (begins_with(work->title, "terrain-", &preset)) {
        for (int i = 1; preset_name(i) != NULL; i++) {
            if (strcmp(preset_name(i), preset) == 0) {
                *length = preset_list[i].length;
                return preset_list[i].text;
            }
        }
    }
    for (const struct bench_text *t = bench_texts; t->title != NULL; t++) {
        if (strcmp(t->title, work->title) == 0) {
            *length = t->length;
            return t->text;
        }
    }
    return NULL;
}

/* Makes scratch memory, and for few points a plan. Returns 0 without memory. */
static int make_memory(struct bench_recipe *r, const struct bench_work *work, size_t bytes)
{
    const int order = work->output == BENCH_PLUS_GRADIENT;
    const size_t plan_bytes = scarp_recipe_plan_size(&r->recipe);
    r->scratch.size =
        bytes != BENCH_BEST_SCRATCH ? bytes : scarp_recipe_scratch_size(&r->recipe, order, 0);
    r->scratch.memory = r->scratch.size > 0 ? malloc(r->scratch.size) : NULL;
    if (work->points <= BENCH_FEW_POINTS) {
        r->scratch.plan = r->plan = malloc(plan_bytes);
        if (r->plan == NULL ||
            scarp_recipe_plan_make(&r->recipe, r->plan, plan_bytes) != SCARP_OK) {
            return 0;
        }
    }
    return r->scratch.memory != NULL || r->scratch.size == 0;
}

struct bench_recipe *bench_recipe_make(const struct bench_work *work, size_t scratch)
{
    char made_text[256];
    size_t length = 0;
    const char *const text = find_text(work, made_text, sizeof made_text, &length);
    struct bench_recipe *const made = text != NULL ? calloc(1, sizeof *made) : NULL;
    if (made != NULL &&
        (scarp_recipe_parse(text, length, &made->recipe, NULL, 0, NULL) != SCARP_OK ||
         !make_memory(made, work, scratch))) {
        bench_recipe_free(made);
        return NULL;
    }
    return made;
}

void bench_recipe_free(struct bench_recipe *recipe)
{
    if (recipe != NULL) {
        free(recipe->scratch.memory);
        free(recipe->plan);
        free(recipe);
    }
}

struct scarp_grid bench_work_grid(const struct bench_work *work)
{
    struct scarp_grid grid = {.row_stride = 0};
    for (int d = 0; d < 3; d++) {
        grid.origin[d] = (double)work->origin[d];
        grid.step[d] = (double)work->step;
        grid.count[d] = work->grid[d];
    }
    return grid;
}

enum scarp_status bench_recipe_run(struct bench_recipe *recipe, const struct bench_work *work,
                                   const void *const x[3], const struct scarp_samples *out)
{
    const struct scarp_recipe_outputs outputs = {.out = out, .count = 1};
    if (work->layout == BENCH_RECIPE_GRID) {
        const struct scarp_grid grid = bench_work_grid(work);
        return scarp_recipe_grid(&recipe->recipe, &grid, &outputs, &recipe->scratch);
    }
    return work->f64 ? scarp_recipe_sample_f64(&recipe->recipe, work->points, x[0], x[1], x[2],
                                               &outputs, &recipe->scratch)
                     : scarp_recipe_sample(&recipe->recipe, work->points, x[0], x[1], x[2],
                                           &outputs, &recipe->scratch);
}
