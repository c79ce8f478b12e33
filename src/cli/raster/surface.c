/* SPDX-License-Identifier: MIT
 *
 * How a terrain is scaled, lit and coloured, and windows of samples. All of it is the same on every
 * machine, to the bit.
 */
#include "raster/surface.h"

#include <stdlib.h>
#include <string.h>

#include "ground/spread.h"
#include "shared/interrupt.h"

struct surface_scale surface_height_scale(const struct ground *ground)
{
    return surface_scale_of((double)ground->floor, (double)ground->highest);
}

/* Rows are counted from the top, so the top left samples of all levels stand for what begins at the
   top left corner. */
void surface_set_level(const struct surface *surface, unsigned level, bool is_limited,
                       struct surface *to)
{
    const size_t side = (size_t)1 << level;
    const double step = surface->step * (double)side;
    const double inward = 0.5 * (step - surface->step);
    const double top = surface->y0 + (double)(surface->height - 1) * surface->step - inward;
    *to = *surface;
    if (level > 0 || is_limited) {
        ground_limit(&surface->ground, 2.0 * step, &to->ground);
    }
    if (level > 0) {
        to->width = (surface->width + side - 1) >> level;
        to->height = (surface->height + side - 1) >> level;
        to->step = step;
        to->x0 = surface->x0 + inward;
        to->y0 = top - (double)(to->height - 1) * step;
    }
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

#define ARRAYS_MOST (20 + GROUND_FIELDS_MOST)

/* The arrays that a window is to have */
struct wanted_arrays {
    float **list[ARRAYS_MOST];
    size_t count;
};

static void want(struct wanted_arrays *wanted, bool is_wanted, float **array)
{
    *array = NULL;
    if (is_wanted) {
        wanted->list[wanted->count++] = array;
    }
}

static void want_all(struct wanted_arrays *wanted, bool is_wanted, float **x, float **y, float **z)
{
    want(wanted, is_wanted, x);
    want(wanted, is_wanted, y);
    want(wanted, is_wanted, z);
}

bool window_open(struct window *window, const struct surface *surface, unsigned needs)
{
    struct wanted_arrays wanted = {.count = 0};
    const bool shade = (needs & SURFACE_SHADE) != 0;
    const bool own_shade = shade && surface->z_factor != 1.0f;
    const bool gradient = (needs & SURFACE_GRADIENT) != 0;
    const bool bed = (needs & SURFACE_BED) != 0 && ground_has_sea(&surface->ground);
    want(&wanted, true, &window->value);
    want(&wanted, gradient, &window->dx);
    want(&wanted, gradient, &window->dy);
    want(&wanted, bed, &window->bed);
    want_all(&wanted, (needs & SURFACE_CURVATURE) != 0, &window->dxx, &window->dxy, &window->dyy);
    want_all(&wanted, (needs & SURFACE_NORMALS) != 0 || (shade && !own_shade), &window->nx,
             &window->ny, &window->nz);
    want_all(&wanted, own_shade, &window->shade_x, &window->shade_y, &window->shade_z);
    want_all(&wanted, (needs & SURFACE_DIFFERENCES) != 0, &window->differences_x,
             &window->differences_y, &window->differences_z);
    for (size_t i = 0; i < surface->ground.field_count; i++) {
        want(&wanted, (needs & SURFACE_FIELDS) != 0, &window->fields[i]);
    }
    window->memory = malloc(wanted.count * WINDOW_SAMPLES * sizeof *window->memory);
    if (window->memory == NULL) {
        return false;
    }
    for (size_t i = 0; i < wanted.count; i++) {
        *wanted.list[i] = window->memory + i * WINDOW_SAMPLES;
    }
    if (!own_shade) {
        window->shade_x = window->nx;
        window->shade_y = window->ny;
        window->shade_z = window->nz;
    }
    return true;
}

void window_close(struct window *window)
{
    free(window->memory);
    *window = (struct window){0};
}

/* Rows go down and y goes up, so the grid's step along them is negative. Its origin and step are
   those of the whole raster whatever the window: samples have the same bits in every tile. */
static struct scarp_grid grid_of(const struct surface *surface, const struct window *window,
                                 int right, int up)
{
    return (struct scarp_grid){
        .origin = {surface->x0, surface->y0, 0.0},
        .step = {surface->step, -surface->step, 0.0},
        .first = {(int64_t)window->column + right,
                  (int64_t)window->row - up - (int64_t)(surface->height - 1), 0},
        .count = {window->columns, window->rows, 1},
    };
}

void surface_values(const struct surface *surface, const struct window *window, int right, int up,
                    float *value)
{
    const struct scarp_grid grid = grid_of(surface, window, right, up);
    interrupt_unless(ground_grid(&surface->ground, &grid, &(struct scarp_samples){.value = value}));
}

void surface_sample(const struct surface *surface, struct window *window)
{
    const struct scarp_grid grid = grid_of(surface, window, 0, 0);
    const struct scarp_samples out = {.value = window->value,
                                      .dx = window->dx,
                                      .dy = window->dy,
                                      .dxx = window->dxx,
                                      .dxy = window->dxy,
                                      .dyy = window->dyy};
    const size_t count = window->columns * window->rows;
    interrupt_unless(ground_fields_grid(&surface->ground, &grid, &out,
                                        window->fields[0] != NULL ? window->fields : NULL));
    if (window->bed != NULL) {
        memcpy(window->bed, window->value, count * sizeof *window->bed);
    }
    ground_cover(&surface->ground, count, &out);
    if (window->nx != NULL) {
        interrupt_unless(scarp_normals(count, window->dx, window->dy, 1.0f, window->nx, window->ny,
                                       window->nz) == SCARP_OK);
    }
    if (window->shade_x != window->nx) {
        interrupt_unless(scarp_normals(count, window->dx, window->dy, surface->z_factor,
                                       window->shade_x, window->shade_y,
                                       window->shade_z) == SCARP_OK);
    }
}
