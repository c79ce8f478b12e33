/* SPDX-License-Identifier: MIT
 *
 * How a terrain is scaled, lit and coloured, and blocks of samples. All of it is the same on every
 * machine, to the bit.
 */
#include "raster/surface.h"

#include <stdlib.h>
#include <string.h>

#include "ground/spread.h"

void surface_set_scale(struct surface *surface)
{
    const struct ground *const ground = &surface->ground;
    const double left = (double)ground->highest - (double)ground->floor;
    surface->steps_per_unit = left > 0.0 ? 65535.0 / left : 0.0;
}

void surface_set_light(struct surface *surface, const struct look_options *look)
{
    surface->z_factor = look->z_factor;
    relief_light(look->azimuth, look->altitude, surface->light);
}

void surface_set_relief(struct surface *surface, struct palette *palette)
{
    struct spread spread;
    ground_spread(&surface->ground, &spread);
    palette_resolve(palette, spread.low, spread.high);
    surface->relief = (struct relief){
        .palette = palette,
        .low = spread.low,
        .middle = spread.middle,
        .high = spread.high,
        .sea = spread.sea,
        .deep = spread.deep,
        .light = {surface->light[0], surface->light[1], surface->light[2]},
    };
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
                              &block->differences_z,
                              &block->bed};
    const bool own_shade = (needs & SURFACE_SHADE) != 0 && surface->z_factor != 1.0f;
    const bool normals =
        (needs & SURFACE_NORMALS) != 0 || ((needs & SURFACE_SHADE) != 0 && !own_shade);
    const bool differences = (needs & SURFACE_DIFFERENCES) != 0;
    const bool gradient = needs != 0;
    const bool bed = (needs & SURFACE_BED) != 0 && ground_has_sea(&surface->ground);
    const bool wanted[] = {true,        gradient,    gradient,  normals,   normals,
                           normals,     own_shade,   own_shade, own_shade, differences,
                           differences, differences, bed};
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

/* Rows go down and y goes up, so the grid's step along them is negative. Its origin and step are
   those of the whole raster whatever the block: samples have the same bits in every tile. */
static struct scarp_grid grid_of(const struct surface *surface, const struct block *block,
                                 int right, int up)
{
    return (struct scarp_grid){
        .origin = {surface->x0, surface->y0, 0.0},
        .step = {surface->step, -surface->step, 0.0},
        .first = {(int64_t)block->column + right,
                  (int64_t)block->row - up - (int64_t)(surface->height - 1), 0},
        .count = {block->columns, block->rows, 1},
    };
}

void surface_values(const struct surface *surface, const struct block *block, int right, int up,
                    float *value)
{
    const struct scarp_grid grid = grid_of(surface, block, right, up);
    (void)ground_grid(&surface->ground, &grid, &(struct scarp_samples){.value = value});
}

void surface_sample(const struct surface *surface, struct block *block)
{
    const struct scarp_grid grid = grid_of(surface, block, 0, 0);
    const struct scarp_samples out = {.value = block->value, .dx = block->dx, .dy = block->dy};
    const size_t count = block->columns * block->rows;
    (void)ground_dry_grid(&surface->ground, &grid, &out);
    if (block->bed != NULL) {
        memcpy(block->bed, block->value, count * sizeof *block->bed);
    }
    ground_cover(&surface->ground, count, &out);
    if (block->nx != NULL) {
        scarp_normals(count, block->dx, block->dy, 1.0f, block->nx, block->ny, block->nz);
    }
    if (block->shade_x != block->nx) {
        scarp_normals(count, block->dx, block->dy, surface->z_factor, block->shade_x,
                      block->shade_y, block->shade_z);
    }
}
