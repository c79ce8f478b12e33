/* SPDX-License-Identifier: MIT
 *
 * Sampling a block, and the light. All of it is the same on every machine, to the bit.
 */
#include "terrain/surface.h"

#include <stdlib.h>

static float within(float value, const struct surface *surface)
{
    return value < surface->lowest    ? surface->lowest
           : value > surface->highest ? surface->highest
                                      : value;
}

void surface_set_range(struct surface *surface, float sea_level, float plateau)
{
    scarp_range(surface->noise, 2, &surface->lowest, &surface->highest);
    surface->floor = within(sea_level, surface);
    surface->ceiling = within(plateau, surface);
    const double left = (double)surface->ceiling - (double)surface->floor;
    surface->steps_per_value = left > 0.0 ? 65535.0 / left : 0.0;
    /* Adding 0 leaves no zero negative: these numbers are for readers. */
    surface->zero_height = surface->height_scale * surface->floor + 0.0f;
    surface->full_height = surface->height_scale * surface->ceiling + 0.0f;
}

bool block_open(struct block *block, const struct surface *surface, unsigned needs)
{
    float **const arrays[] = {&block->value,
                              &block->dx,
                              &block->dy,
                              &block->nx,
                              &block->ny,
                              &block->nz,
                              &block->shade_x,
                              &block->shade_y,
                              &block->shade_z,
                              &block->differences_x,
                              &block->differences_y,
                              &block->differences_z};
    const bool own_shade = (needs & SURFACE_SHADE) != 0 && surface->z_factor != 1.0f;
    const bool normals =
        (needs & SURFACE_NORMALS) != 0 || ((needs & SURFACE_SHADE) != 0 && !own_shade);
    const bool differences = (needs & SURFACE_DIFFERENCES) != 0;
    const bool gradient = needs != 0;
    const bool wanted[] = {true,      gradient,  gradient,  normals,     normals,     normals,
                           own_shade, own_shade, own_shade, differences, differences, differences};
    const size_t most = sizeof arrays / sizeof arrays[0];
    size_t count = 0;
    for (size_t i = 0; i < most; i++) {
        count += wanted[i] ? 1 : 0;
    }
    block->memory = malloc(count * BLOCK_SAMPLES * sizeof *block->memory);
    if (block->memory == NULL) {
        return false;
    }
    float *next = block->memory;
    for (size_t i = 0; i < most; i++) {
        *arrays[i] = wanted[i] ? next : NULL;
        next += wanted[i] ? BLOCK_SAMPLES : 0;
    }
    if (!own_shade) {
        block->shade_x = block->nx;
        block->shade_y = block->ny;
        block->shade_z = block->nz;
    }
    return true;
}

void block_close(struct block *block)
{
    free(block->memory);
    *block = (struct block){0};
}

/* What the sea covers or the plateau cuts off is flat: its gradient is that of what is returned. */
static void clamp(const struct surface *surface, size_t count, const struct scarp_samples *out)
{
    for (size_t i = 0; i < count; i++) {
        const float value = out->value[i];
        if (value >= surface->floor && value <= surface->ceiling) {
            continue;
        }
        out->value[i] = value < surface->floor ? surface->floor : surface->ceiling;
        if (out->dx != NULL) {
            out->dx[i] = out->dy[i] = 0.0f;
        }
    }
}

/* Rows go down and y goes up, so the grid's step along them is negative. Its origin and step are
   those of the whole raster whatever the block: samples have the same bits in every tile. */
static void sample(const struct surface *surface, const struct block *block, int right, int up,
                   const struct scarp_samples *out)
{
    const struct scarp_grid grid = {
        .origin = {surface->x0, surface->y0, 0.0},
        .step = {surface->step, -surface->step, 0.0},
        .first = {(int64_t)block->column + right,
                  (int64_t)block->row - up - (int64_t)(surface->height - 1), 0},
        .count = {block->columns, block->rows, 1},
    };
    /* Cannot fail: the noise was checked, and what the options allow of places lies within 2^53. */
    scarp_grid2(surface->noise, &grid, out);
    if (surface->floor > surface->lowest || surface->ceiling < surface->highest) {
        clamp(surface, block->columns * block->rows, out);
    }
}

void surface_values(const struct surface *surface, const struct block *block, int right, int up,
                    float *value)
{
    sample(surface, block, right, up, &(struct scarp_samples){.value = value});
}

void surface_sample(const struct surface *surface, struct block *block)
{
    sample(surface, block, 0, 0,
           &(struct scarp_samples){.value = block->value, .dx = block->dx, .dy = block->dy});
    const size_t count = block->columns * block->rows;
    if (block->nx != NULL) {
        scarp_normals(count, block->dx, block->dy, surface->height_scale, block->nx, block->ny,
                      block->nz);
    }
    if (block->shade_x != block->nx) {
        scarp_normals(count, block->dx, block->dy, surface->height_scale * surface->z_factor,
                      block->shade_x, block->shade_y, block->shade_z);
    }
}

/* sin(degrees), of 0 to 540. The C library's sine is not the same everywhere; this one is, and
   within 2^-52 of the exact one. */
static double sine(double degrees)
{
    const int quarters = (int)(degrees / 90.0 + 0.5);
    const double rest = degrees - 90.0 * quarters; /* exact: in [-45, 45] */
    const double x = rest * 0.017453292519943295;  /* pi / 180 */
    /* Taylor's series from its smallest term on: of the sine, of the cosine after odd quarters */
    const bool odd = quarters % 2 != 0;
    double sum = 1.0;
    for (int n = odd ? 18 : 19; n > 1; n -= 2) {
        sum = 1.0 - x * x / (double)(n * (n - 1)) * sum;
    }
    const double magnitude = odd ? sum : x * sum;
    return quarters % 4 < 2 ? magnitude : -magnitude;
}

void surface_light(double azimuth, double altitude, double light[3])
{
    const double horizontal = sine(90.0 - altitude);
    light[0] = sine(azimuth) * horizontal;
    light[1] = sine(azimuth + 90.0) * horizontal;
    light[2] = sine(altitude);
}
