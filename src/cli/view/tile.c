/* SPDX-License-Identifier: MIT
 *
 * Each pixel has one ray through its middle. Where it differs from a neighbour it has more of them,
 * and shows their mean. Pixels around the tile are computed once more for that, so that no pixel
 * depends on where tiles end.
 */
#include "view/tile.h"

#include <stdlib.h>

#define SPREAD 0.75f /* in pixels: from the middle of a pixel to its corners, and some more */
#define DIFFERENT                                                                                  \
    0.02f /* from this difference on, of colours from 0 to 1, pixels get more rays                 \
           */

struct tile *tile_open(void)
{
    struct tile *const tile = calloc(1, sizeof *tile);
    if (tile == NULL || !march_open(&tile->march, TILE_RAYS)) {
        free(tile);
        return NULL;
    }
    tile->rays = (struct rays){.x = tile->ray_x,
                               .y = tile->ray_y,
                               .z = tile->ray_z,
                               .begin = tile->begin,
                               .distance = tile->distance,
                               .cliff = tile->cliff,
                               .hit = tile->hit};
    return tile;
}

void tile_close(struct tile *tile)
{
    if (tile != NULL) {
        march_close(&tile->march);
        free(tile);
    }
}

/* Where rays of a pixel go through it: multiples of the inverse of the plastic number and of its
   square fill a square evenly, however many there are (Roberts 2018). The first is the middle. */
static void place_sample(size_t sample, float *column, float *row)
{
    const float u = 0.5f + 0.75487767f * (float)sample, v = 0.5f + 0.56984029f * (float)sample;
    *column = u - floorf(u);
    *row = v - floorf(v);
}

static void add_ray(struct tile *tile, const struct scene *scene, float column, float row,
                    float begin)
{
    const struct vector ray = camera_ray(&scene->camera, column, row);
    const size_t n = tile->rays.count++;
    tile->rays.x[n] = ray.x;
    tile->rays.y[n] = ray.y;
    tile->rays.z[n] = ray.z;
    tile->rays.begin[n] = begin;
}

/* A curve like that of film: shadows have a toe, lights a shoulder (Narkowicz 2015, an
   approximation of the Academy Color Encoding System). */
static float film(float light)
{
    const float x = 0.62f * light;
    return clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

static void trace(struct tile *tile, const struct scene *scene)
{
    march_rays(&tile->march, scene, &tile->rays);
    light_rays(&tile->light, scene, &tile->rays, tile->colour);
    tile->count += tile->rays.count;
    for (size_t i = 0; i < tile->rays.count; i++) {
        const struct colour c = tile->colour[i];
        tile->colour[i] = (struct colour){film(c.r), film(c.g), film(c.b)};
    }
}

static float difference(struct colour a, struct colour b)
{
    const float r = fabsf(a.r - b.r), g = fabsf(a.g - b.g), blue = fabsf(a.b - b.b);
    const float most = r > g ? r : g;
    return most > blue ? most : blue;
}

/* sRGB's curve: its definition has a power of 1/2.4, of which this is an approximation by roots
   that differs by less than one of 255. */
static float screen(float light)
{
    const float root2 = sqrtf(light), root4 = sqrtf(root2), root8 = sqrtf(root4);
    return clamp(0.662002687f * root2 + 0.684122060f * root4 - 0.323583601f * root8 -
                     0.0225411470f * light,
                 0.0f, 1.0f);
}

/* Rounds to a byte, some pixels up and others down, so that slow changes have no steps. */
static uint8_t byte_of(float light, size_t column, size_t row)
{
    static const uint8_t order[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    const float threshold = ((float)order[row % 4 * 4 + column % 4] + 0.5f) * 0.0625f;
    return (uint8_t)(255.0f * screen(light) * 0.99999f + threshold);
}

/* The blocks of pixels that the tile and the pixels around it touch. They are those of the picture,
   so that no pixel depends on where tiles end. */
struct blocks {
    size_t column, row, across; /* one more than the number of the first, which may be -1 */
};

static struct blocks scout(struct tile *tile, const struct scene *scene,
                           const struct tile_area *area)
{
    const struct blocks blocks = {.column = (area->column + SCOUT - 1) / SCOUT,
                                  .row = (area->row + SCOUT - 1) / SCOUT,
                                  .across = (area->column + area->columns) / SCOUT + 2 -
                                            (area->column + SCOUT - 1) / SCOUT};
    const size_t down = (area->row + area->rows) / SCOUT + 2 - blocks.row;
    tile->rays.count = 0;
    for (size_t i = 0; i < blocks.across * down; i++) {
        add_ray(tile, scene, ((float)(blocks.column + i % blocks.across) - 0.5f) * SCOUT,
                ((float)(blocks.row + i / blocks.across) - 0.5f) * SCOUT, 0.0f);
    }
    tile->rays.spread = SPREAD * SCOUT * scene->camera.pixel;
    tile->rays.is_scout = true;
    march_rays(&tile->march, scene, &tile->rays);
    tile->rays.is_scout = false;
    for (size_t i = 0; i < tile->rays.count; i++) {
        tile->block_begin[i] = tile->rays.begin[i];
    }
    return blocks;
}

/* Traces one ray through the middle of each pixel, and of those around the tile. `across` is how
   many of these are side by side. */
static void paint_middles(struct tile *tile, const struct scene *scene,
                          const struct tile_area *area, size_t across, float spread)
{
    const struct blocks blocks = scout(tile, scene, area);
    tile->rays.count = 0;
    tile->rays.spread = spread;
    for (size_t i = 0; i < across * (area->rows + 2); i++) {
        const size_t column = area->column + i % across, row = area->row + i / across;
        const size_t block = ((row + SCOUT - 1) / SCOUT - blocks.row) * blocks.across +
                             (column + SCOUT - 1) / SCOUT - blocks.column;
        add_ray(tile, scene, (float)column - 0.5f, (float)row - 0.5f, tile->block_begin[block]);
    }
    trace(tile, scene);
    for (size_t i = 0; i < tile->rays.count; i++) {
        tile->pixel[i] = tile->colour[i];
        tile->clear[i] = tile->begin[i];
    }
}

/* Lists the pixels of the tile that differ from a neighbour. */
static size_t list_edges(struct tile *tile, const struct tile_area *area, size_t across)
{
    size_t count = 0;
    for (size_t row = 1; row <= area->rows; row++) {
        for (size_t column = 1; column <= area->columns; column++) {
            const size_t i = row * across + column;
            const struct colour here = tile->pixel[i];
            if (difference(here, tile->pixel[i - 1]) > DIFFERENT ||
                difference(here, tile->pixel[i + 1]) > DIFFERENT ||
                difference(here, tile->pixel[i - across]) > DIFFERENT ||
                difference(here, tile->pixel[i + across]) > DIFFERENT) {
                tile->which[count++] = (uint32_t)i;
            }
        }
    }
    return count;
}

/* Traces one more ray through each pixel of the list. */
static void add_sample(struct tile *tile, const struct scene *scene, const struct tile_area *area,
                       size_t edges, size_t sample)
{
    const size_t across = area->columns + 2;
    float u, v;
    place_sample(sample, &u, &v);
    tile->rays.count = 0;
    for (size_t n = 0; n < edges; n++) {
        const size_t i = tile->which[n];
        add_ray(tile, scene, (float)(area->column + i % across - 1) + u,
                (float)(area->row + i / across - 1) + v, tile->clear[i]);
    }
    trace(tile, scene);
    for (size_t n = 0; n < edges; n++) {
        struct colour *const pixel = &tile->pixel[tile->which[n]];
        *pixel = colour_mix(*pixel, tile->colour[n], 1.0f / (float)(sample + 1));
    }
}

void tile_paint(struct tile *tile, const struct scene *scene, size_t samples,
                const struct tile_area *area)
{
    const size_t across = area->columns + 2;
    const float spread = samples > 1 ? SPREAD * scene->camera.pixel : 0.0f;
    paint_middles(tile, scene, area, across, spread);
    tile->rays.spread = 0.0f;
    const size_t edges = samples > 1 ? list_edges(tile, area, across) : 0;
    for (size_t sample = 1; sample < samples && edges > 0; sample++) {
        add_sample(tile, scene, area, edges, sample);
    }
    for (size_t row = 0; row < area->rows; row++) {
        for (size_t column = 0; column < area->columns; column++) {
            const struct colour pixel = tile->pixel[(row + 1) * across + column + 1];
            uint8_t *const to = area->bytes + row * area->stride + 3 * column;
            to[0] = byte_of(pixel.r, area->column + column, area->row + row);
            to[1] = byte_of(pixel.g, area->column + column, area->row + row);
            to[2] = byte_of(pixel.b, area->column + column, area->row + row);
        }
    }
}
