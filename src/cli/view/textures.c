/* SPDX-License-Identifier: MIT
 *
 * The noise of each texture.
 */
#include "view/textures.h"

#include <string.h>

#include "shared/interrupt.h"

static const struct scarp_noise noises[TEXTURE_COUNT] = {
    [TEXTURE_PATCHES] =
        {.seed = 101, .frequency = 1.0 / 128, .octaves = 8, .gain = 0.62f, .rotate = 1},
    [TEXTURE_ROUGH] = {.seed = 102,
                       .fractal = SCARP_RIDGED,
                       .frequency = 1.0 / 14,
                       .octaves = 9,
                       .gain = 0.56f,
                       .rotate = 1},
    [TEXTURE_TREES] = {.seed = 103, .basis = SCARP_CELL_F1, .frequency = 1.0 / 5, .octaves = 1},
    [TEXTURE_LAYERS] = {.seed = 104, .frequency = 1.0 / 16, .octaves = 5, .gain = 0.7f},
    [TEXTURE_WAVES] = {.seed = 105, .frequency = 1.0 / 24, .octaves = 8, .gain = 0.5f, .rotate = 1},
    [TEXTURE_CLOUDS] =
        {.seed = 106, .frequency = 1.0 / 4000, .octaves = 8, .gain = 0.52f, .rotate = 1},
};

void texture_sample(enum texture texture, float finest, size_t count, const double *x,
                    const double *y, const struct scarp_samples *out)
{
    struct scarp_noise noise = noises[texture];
    noise.offset_first = 1;
    double cell = 1.0 / noise.frequency;
    noise.of_octaves = noise.octaves;
    noise.octaves = 0.0f;
    while (noise.octaves < noise.of_octaves && cell >= (double)finest) {
        noise.octaves += 1.0f;
        cell *= 0.5;
    }
    if (noise.octaves > 0.0f) {
        interrupt_unless(scarp_sample2_f64(&noise, count, x, y, out) == SCARP_OK);
        return;
    }
    memset(out->value, 0, count * sizeof *out->value);
    if (out->dx != NULL) {
        memset(out->dx, 0, count * sizeof *out->dx);
        memset(out->dy, 0, count * sizeof *out->dy);
    }
}
