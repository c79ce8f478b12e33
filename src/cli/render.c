/* SPDX-License-Identifier: MIT
 *
 * Sampling block by block, and the three encodings. Their formulas are in the help of `scarp
 * terrain`; all of them are exact enough in double that every platform writes the same samples.
 */
#include "render.h"

#include <stdlib.h>
#include <time.h>

#define BLOCK_SAMPLES 16384 /* 1 MB of buffers: stays in the second-level cache */

/* The direction to the light, azimuth 315 degrees (north-west), altitude 45: x, y and z are
   sin(az) cos(alt), cos(az) cos(alt), sin(alt), with the azimuth clockwise from north. */
#define LIGHT_X (-0.5)
#define LIGHT_Y 0.5
#define LIGHT_Z 0.70710678118654752

bool render_open(struct render *render)
{
    const size_t width = render->size.width;
    const size_t rows = BLOCK_SAMPLES / width;
    render->rows = rows == 0 ? 1 : rows;
    const size_t count = render->rows * width;
    render->x = malloc(2 * count * sizeof *render->x);
    render->value = malloc(6 * count * sizeof *render->value);
    render->samples = malloc(3 * width);
    if (render->x == NULL || render->value == NULL || render->samples == NULL) {
        return false;
    }
    render->y = render->x + count;
    render->dx = render->value + count;
    render->dy = render->dx + count;
    render->nx = render->dy + count;
    render->ny = render->nx + count;
    render->nz = render->ny + count;
    return true;
}

void render_close(struct render *render)
{
    free(render->x);
    free(render->value);
    free(render->samples);
}

double render_seconds(void)
{
    struct timespec now = {0, 0}; /* stays so without a clock */
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void render_block(struct render *render, size_t row, size_t rows)
{
    const size_t width = render->size.width;
    for (size_t r = 0; r < rows; r++) {
        const size_t up = render->size.height - 1 - (row + r);
        const double y = render->origin.y + (double)up * render->step;
        for (size_t c = 0; c < width; c++) {
            render->x[r * width + c] = render->origin.x + (double)c * render->step;
            render->y[r * width + c] = y;
        }
    }
    const struct scarp_samples out = {.value = render->value, .dx = render->dx, .dy = render->dy};
    const double start = render_seconds();
    scarp_sample2_f64(&render->noise, rows * width, render->x, render->y, &out);
    render->sampling_seconds += render_seconds() - start;
    scarp_normals(rows * width, render->dx, render->dy, render->height_scale, render->nx,
                  render->ny, render->nz);
}

const uint8_t *render_heights(const struct render *render, size_t row)
{
    const size_t width = render->size.width;
    const float *const value = render->value + row * width;
    const double lowest = (double)render->lowest;
    const double scale = 65535.0 / ((double)render->highest - lowest);
    for (size_t c = 0; c < width; c++) {
        const unsigned height = (unsigned)(((double)value[c] - lowest) * scale + 0.5);
        render->samples[2 * c] = (uint8_t)(height >> 8);
        render->samples[2 * c + 1] = (uint8_t)height;
    }
    return render->samples;
}

/* From [-1, 1] to 0 ... 255; 0 becomes 128, as in every flat normal map. */
static uint8_t component(float n)
{
    return (uint8_t)((double)n * 127.5 + 128.0);
}

const uint8_t *render_normals(const struct render *render, size_t row)
{
    const size_t width = render->size.width;
    for (size_t c = 0; c < width; c++) {
        const size_t i = row * width + c;
        render->samples[3 * c] = component(render->nx[i]);
        render->samples[3 * c + 1] = component(render->ny[i]);
        render->samples[3 * c + 2] = component(render->nz[i]);
    }
    return render->samples;
}

const uint8_t *render_hillshade(const struct render *render, size_t row)
{
    const size_t width = render->size.width;
    for (size_t c = 0; c < width; c++) {
        const size_t i = row * width + c;
        const double light = LIGHT_X * (double)render->nx[i] + LIGHT_Y * (double)render->ny[i] +
                             LIGHT_Z * (double)render->nz[i];
        /* Beyond 1 by rounding, at most */
        const double shade = light < 0.0 ? 0.0 : light > 1.0 ? 1.0 : light;
        render->samples[c] = (uint8_t)(shade * 255.0 + 0.5);
    }
    return render->samples;
}
