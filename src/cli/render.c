/* SPDX-License-Identifier: MIT
 *
 * Sampling block by block, and the encodings. Their formulas are in the help of `scarp
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
    render->value = malloc(9 * count * sizeof *render->value);
    render->samples = malloc(3 * width * (render->compare == 0 ? 1 : 2 * render->compare));
    if (render->x == NULL || render->value == NULL || render->samples == NULL) {
        return false;
    }
    render->y = render->x + count;
    render->dx = render->value + count;
    render->dy = render->dx + count;
    render->nx = render->dy + count;
    render->ny = render->nx + count;
    render->nz = render->ny + count;
    render->differences_x = render->nz + count;
    render->differences_y = render->differences_x + count;
    render->differences_z = render->differences_y + count;
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

/* Positions of the block, or of the samples `right` columns and `up` rows from it: to the bit those
   that these columns and rows have themselves. */
static void place(struct render *render, size_t row, size_t rows, double right, double up)
{
    const size_t width = render->size.width;
    for (size_t r = 0; r < rows; r++) {
        const double above = (double)(render->size.height - 1 - (row + r)) + up;
        const double y = render->origin.y + above * render->step;
        for (size_t c = 0; c < width; c++) {
            render->x[r * width + c] = render->origin.x + ((double)c + right) * render->step;
            render->y[r * width + c] = y;
        }
    }
}

/* How many steps of the 16-bit heights make up 1 in the values of the noise */
static double steps_per_value(const struct render *render)
{
    return 65535.0 / ((double)render->highest - (double)render->lowest);
}

static int quantise(float value, double lowest, double scale)
{
    return (int)(((double)value - lowest) * scale + 0.5);
}

/* slope[i] = the central difference of 16-bit heights along (right, up) */
static void difference(struct render *render, size_t row, size_t rows, double right, double up,
                       float *slope)
{
    const size_t count = rows * render->size.width;
    float *const before = render->differences_x, *const after = render->differences_y;
    place(render, row, rows, -right, -up);
    scarp_sample2_f64(&render->noise, count, render->x, render->y,
                      &(struct scarp_samples){.value = before});
    place(render, row, rows, right, up);
    scarp_sample2_f64(&render->noise, count, render->x, render->y,
                      &(struct scarp_samples){.value = after});
    const double lowest = (double)render->lowest;
    const double scale = steps_per_value(render);
    const double distance = 2.0 * render->step * scale;
    for (size_t i = 0; i < count; i++) {
        const int steps = quantise(after[i], lowest, scale) - quantise(before[i], lowest, scale);
        slope[i] = (float)(steps / distance);
    }
}

/* Normals as a program makes them that has nothing but the heights. Neighbours are sampled again
   instead of looked up, so that the outermost samples have theirs too. */
static void make_differences(struct render *render, size_t row, size_t rows)
{
    difference(render, row, rows, 1.0, 0.0, render->dx);
    difference(render, row, rows, 0.0, 1.0, render->dy);
    scarp_normals(rows * render->size.width, render->dx, render->dy, render->height_scale,
                  render->differences_x, render->differences_y, render->differences_z);
}

void render_block(struct render *render, size_t row, size_t rows)
{
    const size_t width = render->size.width;
    place(render, row, rows, 0.0, 0.0);
    const struct scarp_samples out = {.value = render->value, .dx = render->dx, .dy = render->dy};
    const double start = render_seconds();
    scarp_sample2_f64(&render->noise, rows * width, render->x, render->y, &out);
    render->sampling_seconds += render_seconds() - start;
    scarp_normals(rows * width, render->dx, render->dy, render->height_scale, render->nx,
                  render->ny, render->nz);
    if (render->compare != 0) {
        make_differences(render, row, rows);
    }
}

const uint8_t *render_heights(const struct render *render, size_t row)
{
    const size_t width = render->size.width;
    const float *const value = render->value + row * width;
    const double lowest = (double)render->lowest;
    const double scale = steps_per_value(render);
    for (size_t c = 0; c < width; c++) {
        const unsigned height = (unsigned)quantise(value[c], lowest, scale);
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

/* Each sample `times` times. Returns where the samples end. */
static uint8_t *put_normals(uint8_t *samples, const float *x, const float *y, const float *z,
                            size_t count, size_t times)
{
    for (size_t i = 0; i < count; i++) {
        const uint8_t red = component(x[i]), green = component(y[i]), blue = component(z[i]);
        for (size_t n = 0; n < times; n++) {
            *samples++ = red;
            *samples++ = green;
            *samples++ = blue;
        }
    }
    return samples;
}

const uint8_t *render_normals(const struct render *render, size_t row)
{
    const size_t width = render->size.width, i = row * width;
    put_normals(render->samples, render->nx + i, render->ny + i, render->nz + i, width, 1);
    return render->samples;
}

const uint8_t *render_compare(const struct render *render, size_t row)
{
    const size_t width = render->size.width, i = row * width;
    uint8_t *const middle = put_normals(render->samples, render->nx + i, render->ny + i,
                                        render->nz + i, width, render->compare);
    put_normals(middle, render->differences_x + i, render->differences_y + i,
                render->differences_z + i, width, render->compare);
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
