/* SPDX-License-Identifier: MIT
 *
 * Sampling block by block, and the encodings. Their formulas are in the help of `scarp
 * terrain`; all of them are exact enough in double that every platform writes the same samples.
 */
#include "render.h"

#include <stdlib.h>
#include <time.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#define PART_SAMPLES 131072 /* of a thread, at least a row: 3 MB of buffers */

/* The direction to the light, azimuth 315 degrees (north-west), altitude 45: x, y and z are
   sin(az) cos(alt), cos(az) cos(alt), sin(alt), with the azimuth clockwise from north. */
#define LIGHT_X (-0.5)
#define LIGHT_Y 0.5
#define LIGHT_Z 0.70710678118654752

/* Rows of a block: `count` samples from index `first` of the buffers on. */
struct part {
    size_t first, rows, count;
};

bool render_open(struct render *render)
{
    const size_t width = render->size.width;
    const size_t rows_of_part = PART_SAMPLES / width;
    render->rows = (rows_of_part == 0 ? 1 : rows_of_part) * render->threads;
    const size_t count = render->rows * width;
    const size_t arrays = render->compare != 0 ? 9 : 6;
    render->value = malloc(arrays * count * sizeof *render->value);
    render->samples = malloc(3 * width * (render->compare == 0 ? 1 : 2 * render->compare));
    if (render->value == NULL || render->samples == NULL) {
        return false;
    }
    render->dx = render->value + count;
    render->dy = render->dx + count;
    render->nx = render->dy + count;
    render->ny = render->nx + count;
    render->nz = render->ny + count;
    if (render->compare != 0) {
        render->differences_x = render->nz + count;
        render->differences_y = render->differences_x + count;
        render->differences_z = render->differences_y + count;
    }
    return true;
}

void render_close(struct render *render)
{
    free(render->value);
    free(render->samples);
}

double render_seconds(void)
{
    struct timespec now = {0, 0}; /* stays so without a clock */
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

/* Samples rows of the block, `right` columns and `up` rows from their place: to the bit what those
   columns and rows have themselves. */
static void sample(const struct render *render, size_t row, size_t rows, int right, int up,
                   const struct scarp_samples *out)
{
    const int64_t above = (int64_t)(render->size.height - 1 - row) + up;
    const struct scarp_grid grid = {
        .origin = {render->origin.x, render->origin.y, 0.0},
        .step = {render->step, -render->step, 0.0}, /* rows go down, y goes up */
        .first = {right, -above, 0},
        .count = {render->size.width, rows, 1},
    };
    scarp_grid2(&render->noise, &grid, out);
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
static void difference(const struct render *render, size_t row, const struct part *part, int right,
                       int up, float *slope)
{
    float *const before = render->differences_x + part->first;
    float *const after = render->differences_y + part->first;
    sample(render, row, part->rows, -right, -up, &(struct scarp_samples){.value = before});
    sample(render, row, part->rows, right, up, &(struct scarp_samples){.value = after});
    const double lowest = (double)render->lowest;
    const double scale = steps_per_value(render);
    const double distance = 2.0 * render->step * scale;
    for (size_t i = 0; i < part->count; i++) {
        const int steps = quantise(after[i], lowest, scale) - quantise(before[i], lowest, scale);
        slope[part->first + i] = (float)(steps / distance);
    }
}

/* Normals as a program makes them that has nothing but the heights. Neighbours are sampled again
   instead of looked up, so that the outermost samples have theirs too. */
static void make_differences(const struct render *render, size_t row, const struct part *part)
{
    const size_t i = part->first;
    difference(render, row, part, 1, 0, render->dx);
    difference(render, row, part, 0, 1, render->dy);
    scarp_normals(part->count, render->dx + i, render->dy + i, render->height_scale,
                  render->differences_x + i, render->differences_y + i, render->differences_z + i);
}

/* `row` is the first row of the part in the picture. */
static void render_part(const struct render *render, size_t row, const struct part *part)
{
    const size_t i = part->first;
    const struct scarp_samples out = {
        .value = render->value + i, .dx = render->dx + i, .dy = render->dy + i};
    sample(render, row, part->rows, 0, 0, &out);
    scarp_normals(part->count, out.dx, out.dy, render->height_scale, render->nx + i, render->ny + i,
                  render->nz + i);
    if (render->compare != 0) {
        make_differences(render, row, part);
    }
}

/* A part for each thread. Samples do not depend on which part they are in. */
void render_block(struct render *render, size_t row, size_t rows)
{
    const size_t width = render->size.width;
    const size_t rows_of_part = (rows + render->threads - 1) / render->threads;
    const int parts = (int)((rows + rows_of_part - 1) / rows_of_part);
    const double start = render_seconds();
#ifdef _OPENMP
#pragma omp parallel for num_threads(parts) schedule(static, 1)
#endif
    for (int n = 0; n < parts; n++) {
        const size_t begin = (size_t)n * rows_of_part;
        const size_t end = begin + rows_of_part < rows ? begin + rows_of_part : rows;
        const struct part part = {begin * width, end - begin, (end - begin) * width};
        render_part(render, row + begin, &part);
    }
    render->sampling_seconds += render_seconds() - start;
}

size_t render_threads(void)
{
#ifdef _OPENMP
    const int most = omp_get_max_threads();
    return most < 1 ? 1 : most > RENDER_THREADS_MAX ? RENDER_THREADS_MAX : (size_t)most;
#else
    return 1;
#endif
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
