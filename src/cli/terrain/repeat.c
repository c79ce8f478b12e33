/* SPDX-License-Identifier: MIT
 *
 * Both sides of a period are whole numbers of cells if their largest common divisor is.
 */
#include "terrain/repeat.h"

#include <math.h>
#include <string.h>

#include "shared/error.h"
#include "terrain/presets.h"

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

/* What repeats: the noise, or its warp */
struct repeating {
    const char *name;          /* the option that asks for it */
    struct option_size period; /* in samples */
    double step;               /* between samples */
    const char *rotate, *of;   /* its --rotate; what names of its options have behind the dashes */
    struct noise_options *noise; /* gets the period and the frequency, and straight axes */
};

static bool make_straight(const struct repeating *r, int preset)
{
    if (r->noise->rotate && !preset_has(preset, r->rotate)) {
        cli_error("%s: axes that are turned do not repeat; leave it out with %s", r->rotate,
                  r->name);
        return false;
    }
    r->noise->rotate = 0;
    return true;
}

/* Takes the nearest frequency that has whole cells in a period. */
static bool make_whole(const struct repeating *r)
{
    struct noise_options *const noise = r->noise;
    const struct option_size period = r->period;
    const size_t common = common_divisor(period.width, period.height);
    const double cells = nearest_cells(noise->frequency, r->step, common);
    const double frequency = cells / ((double)common * r->step);
    if (frequency > FACTOR_MAX * noise->frequency && common < period.width &&
        common < period.height) {
        cli_error("%s: %zux%zu samples have whole cells at multiples of the frequency %.9g only; "
                  "sides with a common divisor of at least %.9g come near the --%sfrequency %.9g",
                  r->name, period.width, period.height, 1.0 / ((double)common * r->step),
                  ceil(1.0 / (FACTOR_MAX * noise->frequency * r->step)), r->of, noise->frequency);
        return false;
    }
    const double most = 0x1p30;
    const double along[2] = {cells * (double)(period.width / common),
                             cells * (double)(period.height / common)};
    for (int i = 0; i < 2; i++) {
        if (along[i] > most) {
            cli_error("%s: has more than 2^30 cells of the first octave; a lower --%sfrequency or "
                      "--step will do",
                      r->name, r->of);
            return false;
        }
        noise->period[i] = (uint32_t)along[i];
    }
    noise->frequency = frequency;
    return true;
}

bool terrain_repeat(struct terrain_options *options)
{
    struct repeating r = {
        .name = options->tileable ? "--tileable" : "--period",
        .period = options->tileable ? options->size : options->period,
        .step = options->step,
        .rotate = "--rotate",
        .of = "",
        .noise = &options->noise,
    };
    if (options->tileable && options->period.width != 0) {
        cli_error("--tileable: is --period %zux%zu; leave one of them out", r.period.width,
                  r.period.height);
        return false;
    }
    if (r.period.width == 0) {
        return true;
    }
    if (!make_straight(&r, options->preset) || !make_whole(&r)) {
        return false;
    }
    r.rotate = "--warp-rotate";
    r.of = "warp-";
    r.noise = &options->warp.noise;
    return options->warp.reach == 0.0f || (make_straight(&r, options->preset) && make_whole(&r));
}
