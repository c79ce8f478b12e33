/* SPDX-License-Identifier: MIT
 *
 * The benchmark's rows called preset-NAME measure what `scarp terrain --preset NAME` samples: the
 * same noise, found by comparing values, at the same distance of samples. Every preset that is a
 * noise and nothing else has them.
 */
#include "../bench/work.h"
#include "check.h"
#include "ground/presets.h"
#include "shared/error.h"
#include "terrain/terrain_options.h"

/* Replaces the program's function; no test here leads to a message. */
void cli_error(const char *format, ...)
{
    (void)format;
    CHECK(0, "a message was written");
}

#define POINTS 256

static void sample(const struct scarp_noise *noise, float value[POINTS], float dx[POINTS])
{
    float x[POINTS], y[POINTS];
    for (int i = 0; i < POINTS; i++) {
        x[i] = (float)i * 0.37f - 50.0f;
        y[i] = (float)(i % 17) * 0.83f - 3.0f;
    }
    const struct scarp_samples out = {.value = value, .dx = dx};
    CHECK(scarp_sample2(noise, POINTS, x, y, &out) == SCARP_OK, "scarp_sample2 failed");
}

/* Whether both are the same noise but for the seed and the frequency */
static bool is_same(struct scarp_noise a, const struct scarp_noise *b)
{
    float value[2][POINTS], dx[2][POINTS];
    a.seed = b->seed;
    a.frequency = b->frequency;
    sample(&a, value[0], dx[0]);
    sample(b, value[1], dx[1]);
    return memcmp(value[0], value[1], sizeof value[0]) == 0 &&
           memcmp(dx[0], dx[1], sizeof dx[0]) == 0;
}

/* Compares the rows of a preset, and returns how many there are. */
static int check_rows(const char *preset, const struct terrain_options *options)
{
    char title[64];
    int rows = 0;
    struct scarp_noise noise[2];
    struct bench_work work;
    snprintf(title, sizeof title, "preset-%s", preset);
    CHECK(noise_make(&options->ground.noise, &options->ground.warp, 2, noise), "%s: no noise",
          preset);
    for (size_t i = 0; bench_work_get(i, &work); i++) {
        if (work.title == NULL || strcmp(work.title, title) != 0) {
            continue;
        }
        const struct scarp_noise measured = bench_work_noise(&work);
        rows++;
        CHECK(work.layout == BENCH_GRID && work.dimensions == 2, "%s: no terrain", work.name);
        CHECK(is_same(noise[0], &measured), "%s: another noise than the preset's", work.name);
        CHECK(work.step == (float)(options->step * noise->frequency),
              "%s: the preset's step is %g cells", work.name, options->step * noise->frequency);
    }
    return rows;
}

/* Whether the terrain is one noise, and nothing else */
static bool is_plain(const struct ground_options *options)
{
    return options->warp.reach == 0.0f && options->base.amplitude == 0.0f &&
           options->mask.band.x == options->mask.band.y && options->stretch == 1.0 &&
           options->terraces == 0.0f;
}

int main(void)
{
    for (int i = 0; preset_names[i] != NULL; i++) {
        char option[] = "--preset", name[32];
        snprintf(name, sizeof name, "%s", preset_names[i]);
        char *argv[] = {option, name, NULL};
        struct terrain_options options = {.ground = GROUND_OPTIONS_UNSET};
        CHECK(options_parse(&terrain_table, argv, &options) == OPTIONS_RUN, "--preset %s", name);
        const int rows = check_rows(preset_names[i], &options);
        CHECK(rows == (is_plain(&options.ground) ? 2 : 0),
              "%d rows of preset-%s, not value and +gradient, or none if it is more than a noise",
              rows, name);
    }
    return check_done();
}
