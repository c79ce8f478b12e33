/* SPDX-License-Identifier: MIT
 *
 * Both sides of a period are whole numbers of cells if their largest common divisor is.
 */
#include "terrain/repeat.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ground/presets.h"
#include "shared/error.h"

/* How much higher than asked for a frequency may become, unless it is that of one cell along the
   shorter side. */
#define FACTOR_MAX 1.5

static size_t common_divisor(size_t a, size_t b)
{
    while (b != 0) {
        const size_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static bool preset_has(int preset, const char *option)
{
    for (const char *const *word = preset_words[preset]; *word != NULL; word++) {
        if (strcmp(*word, option) == 0) {
            return true;
        }
    }
    return false;
}

/* The whole cells along `samples` samples that come nearest to the frequency, at least one. */
static double nearest_cells(double frequency, double step, size_t samples)
{
    const double cells = floor(frequency * step * (double)samples + 0.5);
    return cells < 1.0 ? 1.0 : cells;
}

/* What repeats: one of the noises */
struct repeating {
    const char *name;          /* the option that asks for it */
    struct option_size period; /* in samples */
    size_t unit[2];            /* cells along its sides, of which there are a multiple */
    double step;               /* between samples */
    int preset;
    const char *of;              /* what names of its options have behind the dashes */
    struct noise_options *noise; /* gets the period and the frequency, and straight axes */
};

static bool make_straight(const struct repeating *r)
{
    char rotate[OPTION_NAME_SIZE];
    snprintf(rotate, sizeof rotate, "--%srotate", r->of);
    if (r->noise->rotate && !preset_has(r->preset, rotate)) {
        cli_error("%s: axes that are turned do not repeat; leave it out with %s", rotate, r->name);
        return false;
    }
    r->noise->rotate = 0;
    return true;
}

/* The side of a unit, in samples */
static double side_of(const struct repeating *r)
{
    return (double)r->period.width / (double)r->unit[0];
}

/* Sets the period of a noise to so many times its unit. */
static bool set_period(const struct repeating *r, double times)
{
    const double most = 0x1p30;
    for (int i = 0; i < 2; i++) {
        const double cells = times * (double)r->unit[i];
        if (cells > most) {
            cli_error("%s: has more than 2^30 cells of the first octave; a lower --%sfrequency or "
                      "--step will do",
                      r->name, r->of);
            return false;
        }
        r->noise->period[i] = (uint32_t)cells;
    }
    r->noise->frequency = times / (side_of(r) * r->step);
    return true;
}

/* Takes the nearest frequency that has whole cells in a period. */
static bool make_whole(const struct repeating *r)
{
    const double wanted = r->noise->frequency;
    const struct option_size period = r->period;
    const double side = side_of(r);
    const double times = nearest_cells(wanted, r->step * side, 1);
    const double frequency = times / (side * r->step);
    if (frequency > FACTOR_MAX * wanted && r->unit[0] > 1 && r->unit[1] > 1) {
        cli_error("%s: %zux%zu samples have whole cells at multiples of the frequency %.9g only; "
                  "sides with a common divisor of at least %.9g come near the --%sfrequency %.9g",
                  r->name, period.width, period.height, 1.0 / (side * r->step),
                  ceil(1.0 / (FACTOR_MAX * wanted * r->step)), r->of, wanted);
        return false;
    }
    return set_period(r, times);
}

/* A stretched noise has a frequency of its own along each side, so any side has whole cells. */
static bool make_stretched_whole(struct repeating *r, struct ground_options *ground)
{
    const double frequency = r->noise->frequency;
    if (ground->wind != 270.0 && !preset_has(r->preset, "--wind")) {
        cli_error("--wind: a stretched terrain repeats with 270 only; leave it out with %s",
                  r->name);
        return false;
    }
    ground->wind = 270.0;
    const double across = nearest_cells(frequency, r->step, r->period.width);
    const double down = nearest_cells(frequency / ground->stretch, r->step, r->period.height);
    if (across > 0x1p30 || down > 0x1p30) {
        r->unit[0] = r->unit[1] = 1;
        return set_period(r, across > down ? across : down);
    }
    const size_t common = common_divisor((size_t)across, (size_t)down);
    r->unit[0] = (size_t)across / common;
    r->unit[1] = (size_t)down / common;
    if (!set_period(r, (double)common)) {
        return false;
    }
    ground->stretch = (double)r->period.height * r->step * r->noise->frequency / down;
    return true;
}

static bool repeat_noise(struct repeating *r, const char *of, struct noise_options *noise)
{
    r->of = of;
    r->noise = noise;
    return make_straight(r) && make_whole(r);
}

bool terrain_repeat(struct terrain_options *options)
{
    struct ground_options *const ground = &options->ground;
    struct repeating r = {
        .name = options->tileable ? "--tileable" : "--period",
        .period = options->tileable ? options->size : options->period,
        .step = options->step,
        .preset = ground->preset,
        .of = "",
        .noise = &ground->noise,
    };
    if (options->tileable && options->period.width != 0) {
        cli_error("--tileable: is --period %zux%zu; leave one of them out", r.period.width,
                  r.period.height);
        return false;
    }
    if (r.period.width == 0) {
        return true;
    }
    const size_t common = common_divisor(r.period.width, r.period.height);
    struct repeating plain = r; /* what is not stretched */
    plain.unit[0] = r.unit[0] = r.period.width / common;
    plain.unit[1] = r.unit[1] = r.period.height / common;
    const bool is_whole = ground->stretch != 1.0
                              ? make_straight(&r) && make_stretched_whole(&r, ground)
                              : repeat_noise(&r, "", &ground->noise);
    return is_whole &&
           (ground->warp.reach == 0.0f || repeat_noise(&r, "warp-", &ground->warp.noise)) &&
           (ground->base.amplitude == 0.0f || repeat_noise(&plain, "base-", &ground->base.noise)) &&
           (ground->mask.band.x == ground->mask.band.y ||
            repeat_noise(&plain, "mask-", &ground->mask.noise));
}
