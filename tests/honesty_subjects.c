/* SPDX-License-Identifier: MIT
 *
 * The noises, recipes and gullies of the table: each as the library has it and as the oracle has
 * it.
 */
#include "honesty.h"

#include "../src/plan/traits.h"
#include "check.h"
#include "oracle_gullies.h"
#include "oracle_recipe.h"
#include "oracle_warp.h"
#include "presets/presets.h"

#define OCTAVES 4

/* What the subject at hand consists of: there is one at a time. */
static struct scarp_noise noise;
static struct oracle_warped warped;
static struct scarp_recipe recipe;
static struct oracle_recipe *interpreter;
static char text[16385];
static struct scarp_gullies gullies;
static struct oracle_gullies eroded;

static void must(enum scarp_status status)
{
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
}

/*
 * Noise, with warps
 */

static struct scarp_samples samples_of(float *const out[4])
{
    const struct scarp_samples samples = {
        .value = out[0], .dx = out[1], .dy = out[2], .dz = out[3]};
    return samples;
}

static void sample_noise(const struct subject *subject, size_t count, const double *const x[3],
                         float *const out[4])
{
    const struct scarp_samples samples = samples_of(out);
    must(subject->dimensions == 2 ? scarp_sample2_f64(&noise, count, x[0], x[1], &samples)
                                  : scarp_sample3_f64(&noise, count, x[0], x[1], x[2], &samples));
}

static double noise_value(const struct subject *subject, const double x[3])
{
    struct oracle_sample n;
    (void)subject;
    oracle_warped_at(&warped, x, &n);
    return n.value;
}

static void make_noise(struct subject *subject)
{
    float lowest, highest;
    must(scarp_range(&noise, subject->dimensions, &lowest, &highest));
    oracle_warped_make(&warped, &noise, subject->dimensions);
    subject->lowest = (double)lowest;
    subject->highest = (double)highest;
    subject->sample = sample_noise;
    subject->value = noise_value;
    subject->span = 16.0;
    subject->step = 0x1p-22;
    subject->cell = 1.0 / warped.level[0][0].octave[warped.level[0][0].octaves - 1].of.frequency;
}

static void make_plain(int number, struct subject *subject)
{
    const int basis = number / 2 % honesty_bases(), fractal = number / 2 / honesty_bases();
    noise = (struct scarp_noise){.seed = 1,
                                 .octaves = OCTAVES,
                                 .basis = (enum scarp_basis)basis,
                                 .fractal = (enum scarp_fractal)fractal};
    snprintf(subject->name[0], sizeof subject->name[0], "%s", scarp_fractal_name(noise.fractal));
    snprintf(subject->name[1], sizeof subject->name[1], "%s", scarp_basis_name(noise.basis));
    subject->kind = fractal_bends(noise.fractal)                 ? HONESTY_BENT
                    : fractal_has(noise.fractal, FRACTAL_SLOPES) ? HONESTY_EROSION
                                                                 : HONESTY_NOISE;
    subject->dimensions = 2 + number % 2;
    make_noise(subject);
}

static void make_warped(int number, struct subject *subject)
{
    static const struct scarp_noise bends[] = {
        {.seed = 5, .octaves = 2.0f, .frequency = 0.5, .amplitude = 0.5f},
        {.seed = 4, .octaves = 2.0f, .frequency = 0.5, .amplitude = 0.5f, .warp = &bends[0]},
        {.seed = 3, .frequency = 0.5, .amplitude = 0.5f, .basis = SCARP_VALUE},
    };
    static const struct {
        const char *name[2];
        struct scarp_noise noise;
    } of[] = {
        {{"warped", "gradient, by gradient"}, {.warp = &bends[0]}},
        {{"warped twice", "gradient, by gradient"}, {.warp = &bends[1]}},
        {{"warped", "simplex, by value"}, {.basis = SCARP_SIMPLEX, .warp = &bends[2]}},
        {{"warped", "ridged gradient, by gradient"}, {.fractal = SCARP_RIDGED, .warp = &bends[0]}},
    };
    noise = of[number / 2].noise;
    noise.seed = 1;
    noise.octaves = OCTAVES;
    noise.rotate = 1;
    for (int i = 0; i < 2; i++) {
        snprintf(subject->name[i], sizeof subject->name[i], "%s", of[number / 2].name[i]);
    }
    subject->kind = HONESTY_WARP;
    subject->dimensions = 2 + number % 2;
    make_noise(subject);
}

#define WARPED 8

/*
 * Recipes
 */

static void sample_recipe(const struct subject *subject, size_t count, const double *const x[3],
                          float *const out[4])
{
    static uint64_t memory[1 << 16];
    const struct scarp_samples samples = samples_of(out);
    const struct scarp_recipe_outputs outputs = {.out = &samples, .count = 1};
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    (void)subject;
    must(scarp_recipe_sample_f64(&recipe, count, x[0], x[1], NULL, &outputs, &scratch));
}

static double recipe_value(const struct subject *subject, const double x[3])
{
    (void)subject;
    return oracle_recipe_at(interpreter, x).value;
}

static void make_recipe(int number, struct subject *subject)
{
    const uint64_t seed = 1;
    float lowest, highest;
    memcpy(text, preset_list[number].text, preset_list[number].length);
    text[preset_list[number].length] = '\0';
    must(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL));
    must(scarp_recipe_seed(&recipe, seed));
    must(scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest));
    interpreter = oracle_recipe_make(text, &recipe, seed);
    snprintf(subject->name[0], sizeof subject->name[0], "recipe");
    snprintf(subject->name[1], sizeof subject->name[1], "%s", preset_name(number));
    subject->kind = HONESTY_RECIPE;
    subject->dimensions = 2;
    subject->cell = 1.0;
    subject->span = 2048.0;
    subject->step = 0x1p-17;
    subject->lowest = (double)lowest;
    subject->highest = (double)highest;
    subject->sample = sample_recipe;
    subject->value = recipe_value;
}

/*
 * Gullies on fBm of three octaves
 */

static void sample_gullies(const struct subject *subject, size_t count, const double *const x[3],
                           float *const out[4])
{
    static float base[6][HONESTY_BLOCK];
    const struct scarp_samples in = {.value = base[0],
                                     .dx = base[1],
                                     .dy = base[2],
                                     .dxx = base[3],
                                     .dxy = base[4],
                                     .dyy = base[5]};
    const struct scarp_eroded of = {.value = out[0], .dx = out[1], .dy = out[2]};
    (void)subject;
    must(scarp_sample2_f64(&noise, count, x[0], x[1], &in));
    must(scarp_gullies2_f64(&gullies, count, x[0], x[1], &in, &of));
}

static double gullies_value(const struct subject *subject, const double x[3])
{
    struct oracle_sample n;
    (void)subject;
    oracle_warped_at(&warped, x, &n);
    return n.value + oracle_gullies_at(&eroded, x, n.value, n.gradient);
}

static void make_gullies(int number, struct subject *subject)
{
    static const struct {
        const char *name;
        double cell;
        struct scarp_gullies gullies;
    } of[] = {
        {"defaults", 0x1p-6, {.seed = 7}},
        {"turned, 8 octaves", 0x1p-9, {.seed = 8, .octaves = 8.0f, .rotate = 1}},
        {"sharp crests",
         0x1p-6,
         {.seed = 14, .floor = -1.0f, .stripes = 2.5f, .branch = 1.4f, .round = 0.02f}},
    };
    float lowest, highest;
    noise = (struct scarp_noise){.seed = 1, .octaves = 3.0f};
    gullies = of[number].gullies;
    subject->dimensions = 2;
    make_noise(subject);
    must(scarp_gullies_range(&gullies, (float)subject->lowest, (float)subject->highest, &lowest,
                             &highest));
    oracle_gullies_make(&eroded, &gullies);
    snprintf(subject->name[0], sizeof subject->name[0], "gullies");
    snprintf(subject->name[1], sizeof subject->name[1], "%s", of[number].name);
    subject->kind = gullies.round != 0.0f ? HONESTY_SHARP : HONESTY_GULLIES;
    subject->cell = of[number].cell;
    subject->span = 4.0;
    subject->step = subject->cell * 0x1p-17;
    subject->lowest = (double)lowest;
    subject->highest = (double)highest;
    subject->sample = sample_gullies;
    subject->value = gullies_value;
}

int honesty_bases(void)
{
    return count_names(basis_name);
}

int honesty_fractals(void)
{
    return count_names(fractal_name);
}

int honesty_subject(int number, struct subject *subject)
{
    int recipes = 0;
    while (preset_name(recipes + 1) != NULL) { /* number 0 is none */
        recipes++;
    }
    const int last[4] = {2 * honesty_bases() * honesty_fractals(), WARPED, recipes, 3};
    *subject = (struct subject){.dimensions = 2};
    for (int kind = 0; kind < 4; kind++) {
        if (number < last[kind]) {
            kind == 0   ? make_plain(number, subject)
            : kind == 1 ? make_warped(number, subject)
            : kind == 2 ? make_recipe(number + 1, subject)
                        : make_gullies(number, subject);
            return 1;
        }
        number -= last[kind];
    }
    return 0;
}

void honesty_forget(void)
{
    if (interpreter != NULL) {
        oracle_recipe_free(interpreter);
        interpreter = NULL;
    }
}
