/* SPDX-License-Identifier: MIT
 *
 * The origin is a place like any other: over many seeds, values of recipes there have the mean and
 * the spread that they have elsewhere. The presets, and a text for each thing that has octaves.
 *
 *     test_recipe_origin SEEDS            that many seeds of the world
 *     test_recipe_origin SEEDS --print    prints the figures, too
 */
#include "check.h"
#include "presets/presets.h"
#include "scarp.h"

#define PLACES 25 /* the first is the origin */
#define POINTS 61
#define WORLD UINT64_C(0x123456789abcdef0)
#define MOST 4.0 /* standard errors that the origin may differ by */

static struct scarp_recipe recipe;
static double x[POINTS], y[POINTS];
static uint64_t memory[1 << 14];

/* Values of the first output at all places, for a seed of the world. */
static void sample(uint64_t seed, double values[PLACES])
{
    static float value[PLACES];
    static double position[3][PLACES];
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    const struct scarp_samples out = {.value = value};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    for (int i = 0; i < PLACES; i++) { /* along the ranges of a preset, which are not of a seed */
        position[0][i] = 7919.317 * i * 0.9396926207859084;
        position[1][i] = 7919.317 * i * 0.3420201433256687;
        position[2][i] = 1299.709 * i;
    }
    CHECK(scarp_recipe_seed(&recipe, seed) == SCARP_OK &&
              scarp_recipe_sample_f64(&recipe, PLACES, position[0], position[1], position[2],
                                      &outputs, &scratch) == SCARP_OK,
          "no samples");
    for (int i = 0; i < PLACES; i++) {
        values[i] = (double)value[i];
    }
}

/* Values at a place, or at many: their sums, and sums of powers around `middle` */
struct moments {
    double middle, count, sum[4];
};

static void add(struct moments *of, double value)
{
    double power = 1.0;
    of->count += 1.0;
    for (int i = 0; i < 4; i++) {
        power *= value - of->middle;
        of->sum[i] += power;
    }
}

static double mean_of(const struct moments *of)
{
    return of->middle + of->sum[0] / of->count;
}

static double spread_of(const struct moments *of)
{
    const double mean = of->sum[0] / of->count;
    return sqrt(fmax(of->sum[1] / of->count - mean * mean, 0.0));
}

/* The fourth central moment over the square of the second */
static double kurtosis_of(const struct moments *of)
{
    const double n = of->count, m = of->sum[0] / n, spread = spread_of(of);
    const double fourth = of->sum[3] / n - 4.0 * m * of->sum[2] / n + 6.0 * m * m * of->sum[1] / n -
                          3.0 * m * m * m * m;
    return fourth / (spread * spread * spread * spread);
}

static void check(const char *name, const char *text, size_t length, int seeds, int prints)
{
    struct scarp_recipe_error error = {.text = NULL};
    struct moments origin = {.count = 0.0}, others = {.count = 0.0};
    CHECK(scarp_recipe_parse(text, length, &recipe, &error, 1, NULL) == SCARP_OK, "%s, line %d: %s",
          name, (int)error.line, error.text);
    for (int seed = 1; seed <= seeds; seed++) {
        double values[PLACES];
        sample((uint64_t)seed, values);
        origin.middle = others.middle = seed == 1 ? values[1] : others.middle;
        add(&origin, values[0]);
        for (int i = 1; i < PLACES; i++) {
            add(&others, values[i]);
        }
    }
    const double spread = spread_of(&others), ratio = spread_of(&origin) / spread;
    const double off = (mean_of(&origin) - mean_of(&others)) / spread;
    const double of_mean = MOST / sqrt(seeds);
    const double of_spread = of_mean * sqrt((kurtosis_of(&others) - 1.0) / 4.0);
    if (prints) {
        printf("%-40.40s mean %.4g (elsewhere %.4g), spread %.4g (%.4g): %.2f, within %.2f\n", name,
               mean_of(&origin), mean_of(&others), spread_of(&origin), spread, ratio, of_spread);
    }
    CHECK(fabs(ratio - 1.0) <= of_spread, "%s: the spread at the origin is %g of %g", name,
          spread_of(&origin), spread);
    CHECK(fabs(off) <= of_mean, "%s: the mean at the origin is %g, elsewhere %g", name,
          mean_of(&origin), mean_of(&others));
}

static void check_same(const char *text, const float *by_hand)
{
    float value[POINTS];
    const struct scarp_samples out = {.value = value};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    CHECK(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL) == SCARP_OK &&
              scarp_recipe_seed(&recipe, WORLD) == SCARP_OK &&
              scarp_recipe_sample_f64(&recipe, POINTS, x, y, NULL, &outputs, NULL) == SCARP_OK,
          "no samples of %s", text);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "%s is not what calls give: %g and %g", text,
          (double)value[0], (double)by_hand[0]);
}

/* What recipes set is the member offset_first, of every noise and of gullies. */
static void check_calls(void)
{
    static float v[POINTS], dx[POINTS], dy[POINTS], w[POINTS];
    const struct scarp_noise deep = {.seed = WORLD, .frequency = 0.5, .offset_first = 1};
    const struct scarp_noise warp = {
        .seed = WORLD, .amplitude = 3, .frequency = 0.25, .warp = &deep, .offset_first = 1};
    const struct scarp_noise noise = {.seed = WORLD,
                                      .fractal = SCARP_RIDGED,
                                      .octaves = 4,
                                      .rotate = 1,
                                      .warp = &warp,
                                      .offset_first = 1};
    const struct scarp_noise base = {.seed = WORLD, .frequency = 0.125, .offset_first = 1};
    const struct scarp_gullies gullies = {.seed = WORLD, .frequency = 0.5, .offset_first = 1};
    const struct scarp_samples all = {.value = v, .dx = dx, .dy = dy};
    const struct scarp_cells cells = {.f1 = v, .f2 = w};
    const struct scarp_eroded eroded = {.value = v};
    for (int i = 0; i < POINTS; i++) {
        x[i] = 0.375 * i - 7.0;
        y[i] = 5.0 - 0.8125 * (i % 7);
    }
    (void)scarp_sample2_f64(&noise, POINTS, x, y, &all);
    check_same("recipe 1\na = warp(noise(ridged, octaves=4, rotate),"
               " warp(noise(amplitude=3, size=4), noise(size=2)))",
               v);
    (void)scarp_cells2_f64(&base, POINTS, x, y, &cells);
    check_same("recipe 1\na = cell(noise(size=8), f1)", v);
    check_same("recipe 1\na = cell(noise(size=8), f2)", w);
    (void)scarp_sample2_f64(&base, POINTS, x, y, &all);
    (void)scarp_gullies2_f64(&gullies, POINTS, x, y, &all, &eroded);
    check_same("recipe 1\na = gullies(noise(size=8), size=2)", v);
}

int main(int argc, char **argv)
{
    static const char *const texts[] = {
        "noise()",
        "noise(value)",
        "noise(simplex)",
        "noise(cell_edge)",
        "noise(cell_soft)",
        "noise(ridged, octaves=6)",
        "noise(swiss, rotate, size=7, octaves=5, seed=3)",
        "warp(noise(value), noise(size=3, seed=1))",
        "warp(x, noise(size=9, amplitude=4)) - x",
        "warp(x, warp(noise(size=9, amplitude=4), noise(size=3, seed=1))) - x",
        "cell(noise(), f1)",
        "cell(noise(size=5), f2)",
        "displacement(noise(octaves=2, size=20, seed=1), size=8, depth=0.5, octaves=3)",
        "gullies(noise(octaves=2, size=20, seed=1), size=8, depth=0.5, rotate)",
    };
    const int seeds = argc > 1 ? atoi(argv[1]) : 0, prints = argc > 2;
    char text[256];
    if (seeds < 2) {
        fprintf(stderr, "usage: test_recipe_origin SEEDS [--print]\n");
        return 2;
    }
    check_calls();
    for (int i = 1; preset_name(i) != NULL; i++) {
        check(preset_name(i), preset_list[i].text, preset_list[i].length, seeds, prints);
    }
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        snprintf(text, sizeof text, "recipe 1\na = %s\n", texts[i]);
        check(texts[i], text, strlen(text), seeds, prints);
        snprintf(text, sizeof text, "recipe 1\nspace 3\na = %s%s%s\n", i < 12 ? "" : "flat(",
                 texts[i], i < 12 ? "" : ")");
        check(texts[i], text, strlen(text), seeds, prints);
    }
    return check_done();
}
