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

static bool preset_turns(int preset)
{
    for (const char *const *word = preset_words[preset]; *word != NULL; word++) {
        if (strcmp(*word, "--rotate") == 0) {
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

bool terrain_repeat(struct terrain_options *options)
{
    const struct option_size period = options->tileable ? options->size : options->period;
    const char *const name = options->tileable ? "--tileable" : "--period";
    struct noise_options *const noise = &options->noise;
    if (options->tileable && options->period.width != 0) {
        cli_error("--tileable: is --period %zux%zu; leave one of them out", period.width,
                  period.height);
        return false;
    }
    if (period.width == 0) {
        return true;
    }
    if (noise->rotate && !preset_turns(options->preset)) {
        cli_error("--rotate: axes that are turned do not repeat; leave it out with %s", name);
        return false;
    }
    noise->rotate = 0;
    const size_t common = common_divisor(period.width, period.height);
    const double cells = nearest_cells(noise->frequency, options->step, common);
    const double frequency = cells / ((double)common * options->step);
    if (frequency > FACTOR_MAX * noise->frequency && common < period.width &&
        common < period.height) {
        cli_error("%s: %zux%zu samples have whole cells at multiples of the frequency %.9g only; "
                  "sides with a common divisor of at least %.9g come near %.9g",
                  name, period.width, period.height, 1.0 / ((double)common * options->step),
                  ceil(1.0 / (FACTOR_MAX * noise->frequency * options->step)), noise->frequency);
        return false;
    }
    const double most = 0x1p30;
    const double along[2] = {cells * (double)(period.width / common),
                             cells * (double)(period.height / common)};
    for (int i = 0; i < 2; i++) {
        if (along[i] > most) {
            cli_error("%s: has more than 2^30 cells of the first octave; a lower --frequency or "
                      "--step will do",
                      name);
            return false;
        }
        noise->period[i] = (uint32_t)along[i];
    }
    noise->frequency = frequency;
    return true;
}
