/* SPDX-License-Identifier: MIT */
#include "recipes.h"

#include <stdlib.h>
#include <string.h>

#include "presets/presets.h"

#define CHUNK 1024 /* points that go through the steps of a recipe together */

/* As in src/examples/recipes, but for `fade`, which FastNoise2 can do, too. */
static const struct {
    const char *title, *text;
} texts[] = {
    {"fade", "recipe 1\n"
             "soft  = noise(size=400, octaves=6)\n"
             "hard  = noise(size=250, octaves=8, seed=1)\n"
             "where = smoothstep(noise(size=900, octaves=3, seed=2), -0.2, 0.2)\n"
             "fade  = 100 * mix(soft, hard, where)\n"},
    {"alps",
     "recipe 1\n"
     "param height = 110 [0, 10000]\n"
     "bend   = noise(frequency=0.0035, octaves=5, amplitude=75)\n"
     "ridges = warp(noise(swiss, rotate, frequency=0.005, octaves=9, gain=0.45), bend)\n"
     "ground = noise(hybrid, rotate, frequency=0.0016, octaves=8, gain=0.42, amplitude=1.4)\n"
     "high   = smoothstep(noise(rotate, frequency=0.0016, octaves=3), -0.5, 0.25)\n"
     "alps   = height * (ridges * high + ground)\n"},
    {"overworld", "recipe 1\n"
                  "drift      = noise(size=600, octaves=3, amplitude=120, seed=1)\n"
                  "continents = warp(noise(size=2400, octaves=6, rotate, seed=2), drift)\n"
                  "erosion    = warp(noise(size=1500, octaves=4, rotate, seed=3), drift)\n"
                  "weird      = noise(size=700, octaves=5, rotate, seed=4)\n"
                  "peaks      = 1 - abs(3 * abs(weird) - 2)\n"
                  "shelf  = curve(continents, -1: -60, -0.45: -55, -0.2: -18, -0.1: 2, 0.05: 8, "
                  "0.3: 30, 0.7: 60)\n"
                  "rugged = curve(erosion, -0.7: 1, -0.3: 0.6, 0: 0.2, 0.4: 0.05)\n"
                  "inland = smoothstep(continents, -0.12, 0.3)\n"
                  "rough  = noise(ridged, size=260, octaves=6, rotate, gain=0.45, seed=5)\n"
                  "bumps  = 6 * noise(size=40, octaves=3, seed=6)\n"
                  "overworld = shelf + bumps + inland * rugged * (70 * peaks + 90 * rough)\n"},
    {"marble", "recipe 1\n"
               "rough  = noise(turbulence, size=0.7, octaves=6, seed=1)\n"
               "coarse = (sine(turn(5 * x, 25) + 1.8 * rough) + 1) / 2\n"
               "fine   = (sine(turn(20 * x, -50) + 3.6 * rough) + 1) / 2\n"
               "marble = 1 - (1 - coarse)^3 * (0.8 + 0.2 * fine)\n"},
    {"cloud", "recipe 1\n"
              "space 3\n"
              "drift   = noise(size=900, octaves=2, amplitude=150, seed=1)\n"
              "shape   = warp(noise(size=1400, octaves=5, seed=2), drift)\n"
              "puffs   = 1 - noise(cell_f1, size=300, octaves=3, seed=3)\n"
              "weather = flat(noise(size=6000, octaves=3, seed=4))\n"
              "ramp    = curve((z - 1200) / 1200, 0: 0, 0.15: 1, 0.6: 0.8, 1: 0)\n"
              "density = max(ramp * (shape + weather / 2 + 0.3) - puffs / 5, 0, smooth=0.05)\n"},
};

struct bench_recipe {
    struct scarp_recipe recipe;
    struct scarp_scratch scratch;
};

/* The text of a title: of a preset, with "terrain-" before its name, or of those above. NULL if
   there is none. */
static const char *find_text(const char *title, size_t *length)
{
    static const char terrain[] = "terrain-";
    const size_t prefix = strlen(terrain);
    if (strncmp(title, terrain, prefix) == 0) {
        for (int i = 1; preset_name(i) != NULL; i++) {
            if (strcmp(preset_name(i), title + prefix) == 0) {
                *length = preset_list[i].length;
                return preset_list[i].text;
            }
        }
    }
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        if (strcmp(texts[i].title, title) == 0) {
            *length = strlen(texts[i].text);
            return texts[i].text;
        }
    }
    return NULL;
}

struct bench_recipe *bench_recipe_make(const struct bench_work *work)
{
    size_t length = 0;
    const char *const text = find_text(work->title, &length);
    struct bench_recipe *const made = text != NULL ? calloc(1, sizeof *made) : NULL;
    if (made != NULL &&
        scarp_recipe_parse(text, length, &made->recipe, NULL, 0, NULL) == SCARP_OK) {
        made->scratch.size = scarp_recipe_scratch_size(&made->recipe, 1, CHUNK);
        made->scratch.memory = malloc(made->scratch.size);
    }
    if (made == NULL || made->scratch.memory == NULL) {
        free(made);
        return NULL;
    }
    return made;
}

void bench_recipe_free(struct bench_recipe *recipe)
{
    if (recipe != NULL) {
        free(recipe->scratch.memory);
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
