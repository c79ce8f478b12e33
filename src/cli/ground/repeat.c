/* SPDX-License-Identifier: MIT
 *
 * Both sides of a period are whole numbers of cells if their largest common divisor is.
 */
#include "ground/repeat.h"

#include <math.h>

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

/* A square that both sides are a multiple of has a side of so many samples. */
bool repeat_noise(struct noise_options *noise, struct option_size period, double step)
{
    const size_t side = common_divisor(period.width, period.height);
    const size_t unit[2] = {period.width / side, period.height / side};
    const double wanted = noise->frequency, length = (double)side * step;
    const double nearest = floor(wanted * length + 0.5);
    const double times = nearest < 1.0 ? 1.0 : nearest;
    if (noise->rotate) {
        cli_error("--rotate: turned axes cannot repeat; leave it out with --period");
        return false;
    }
    if (times / length > FACTOR_MAX * wanted && unit[0] > 1 && unit[1] > 1) {
        cli_error("--period: %zux%zu samples have whole cells at multiples of the frequency %.9g "
                  "only; sides with a common divisor of at least %.9g come near the --frequency "
                  "%.9g",
                  period.width, period.height, 1.0 / length,
                  ceil(1.0 / (FACTOR_MAX * wanted * step)), wanted);
        return false;
    }
    for (int i = 0; i < 2; i++) {
        const double cells = times * (double)unit[i];
        if (cells > 0x1p30) {
            cli_error("--period: has more than 2^30 cells of the first octave; a lower --frequency "
                      "or --step will do");
            return false;
        }
        noise->period[i] = (uint32_t)cells;
    }
    noise->frequency = times / length;
    return true;
}
