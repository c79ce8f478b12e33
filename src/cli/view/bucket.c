/* SPDX-License-Identifier: MIT
 *
 * Each pixel has one ray through its middle. Where it differs from a neighbour it has more of them,
 * and shows their mean. Pixels around the bucket are computed once more for that, so that no pixel
 * depends on where buckets end.
 */
#include "view/bucket.h"

#include <stdlib.h>

#define SPREAD 0.75f /* in pixels: from the middle of a pixel to its corners, and some more */
#define DIFFERENT                                                                                  \
    0.02f /* from this difference on, of colours from 0 to 1, pixels get more rays                 \
           */

struct bucket *bucket_open(void)
{
    struct bucket *const bucket = calloc(1, sizeof *bucket);
    if (bucket == NULL || !march_open(&bucket->march, BUCKET_RAYS)) {
        free(bucket);
        return NULL;
    }
    bucket->rays = (struct rays){.x = bucket->ray_x,
                                 .y = bucket->ray_y,
                                 .z = bucket->ray_z,
                                 .begin = bucket->begin,
                                 .distance = bucket->distance,
                                 .cliff = bucket->cliff,
                                 .hit = bucket->hit};
    return bucket;
}

void bucket_close(struct bucket *bucket)
{
    if (bucket != NULL) {
        march_close(&bucket->march);
        free(bucket);
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

static void add_ray(struct bucket *bucket, const struct scene *scene, float column, float row,
                    float begin)
{
    const struct vector ray = camera_ray(&scene->camera, column, row);
    const size_t n = bucket->rays.count++;
    bucket->rays.x[n] = ray.x;
    bucket->rays.y[n] = ray.y;
    bucket->rays.z[n] = ray.z;
    bucket->rays.begin[n] = begin;
}

/* A curve like that of film: shadows have a toe, lights a shoulder (Narkowicz 2015, an
   approximation of the Academy Color Encoding System). */
static float film(float light)
{
    const float x = 0.62f * light;
    return clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

static void trace(struct bucket *bucket, const struct scene *scene)
{
    march_rays(&bucket->march, scene, &bucket->rays);
    light_rays(&bucket->light, scene, &bucket->rays, bucket->colour);
    bucket->count += bucket->rays.count;
    for (size_t i = 0; i < bucket->rays.count; i++) {
        const struct colour c = bucket->colour[i];
        bucket->colour[i] = (struct colour){film(c.r), film(c.g), film(c.b)};
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

/* The blocks of pixels that the bucket and the pixels around it touch. They are those of the picture,
   so that no pixel depends on where buckets end. */
struct blocks {
    size_t column, row, across; /* one more than the number of the first, which may be -1 */
};

static struct blocks scout(struct bucket *bucket, const struct scene *scene,
                           const struct bucket_area *area)
{
    const struct blocks blocks = {.column = (area->column + SCOUT - 1) / SCOUT,
                                  .row = (area->row + SCOUT - 1) / SCOUT,
                                  .across = (area->column + area->columns) / SCOUT + 2 -
                                            (area->column + SCOUT - 1) / SCOUT};
    const size_t down = (area->row + area->rows) / SCOUT + 2 - blocks.row;
    bucket->rays.count = 0;
    for (size_t i = 0; i < blocks.across * down; i++) {
        add_ray(bucket, scene, ((float)(blocks.column + i % blocks.across) - 0.5f) * SCOUT,
                ((float)(blocks.row + i / blocks.across) - 0.5f) * SCOUT, 0.0f);
    }
    bucket->rays.spread = SPREAD * SCOUT * scene->camera.pixel;
    bucket->rays.is_scout = true;
    march_rays(&bucket->march, scene, &bucket->rays);
    bucket->rays.is_scout = false;
    for (size_t i = 0; i < bucket->rays.count; i++) {
        bucket->block_begin[i] = bucket->rays.begin[i];
    }
    return blocks;
}

/* Traces one ray through the middle of each pixel, and of those around the bucket. `across` is how
   many of these are side by side. */
static void paint_middles(struct bucket *bucket, const struct scene *scene,
                          const struct bucket_area *area, size_t across, float spread)
{
    const struct blocks blocks = scout(bucket, scene, area);
    bucket->rays.count = 0;
    bucket->rays.spread = spread;
    for (size_t i = 0; i < across * (area->rows + 2); i++) {
        const size_t column = area->column + i % across, row = area->row + i / across;
        const size_t block = ((row + SCOUT - 1) / SCOUT - blocks.row) * blocks.across +
                             (column + SCOUT - 1) / SCOUT - blocks.column;
        add_ray(bucket, scene, (float)column - 0.5f, (float)row - 0.5f, bucket->block_begin[block]);
    }
    trace(bucket, scene);
    for (size_t i = 0; i < bucket->rays.count; i++) {
        bucket->pixel[i] = bucket->colour[i];
        bucket->clear[i] = bucket->begin[i];
    }
}

/* Lists the pixels of the bucket that differ from a neighbour. */
static size_t list_edges(struct bucket *bucket, const struct bucket_area *area, size_t across)
{
    size_t count = 0;
    for (size_t row = 1; row <= area->rows; row++) {
        for (size_t column = 1; column <= area->columns; column++) {
            const size_t i = row * across + column;
            const struct colour here = bucket->pixel[i];
            if (difference(here, bucket->pixel[i - 1]) > DIFFERENT ||
                difference(here, bucket->pixel[i + 1]) > DIFFERENT ||
                difference(here, bucket->pixel[i - across]) > DIFFERENT ||
                difference(here, bucket->pixel[i + across]) > DIFFERENT) {
                bucket->which[count++] = (uint32_t)i;
            }
        }
    }
    return count;
}

/* Traces one more ray through each pixel of the list. */
static void add_sample(struct bucket *bucket, const struct scene *scene,
                       const struct bucket_area *area, size_t edges, size_t sample)
{
    const size_t across = area->columns + 2;
    float u, v;
    place_sample(sample, &u, &v);
    bucket->rays.count = 0;
    for (size_t n = 0; n < edges; n++) {
        const size_t i = bucket->which[n];
        add_ray(bucket, scene, (float)(area->column + i % across - 1) + u,
                (float)(area->row + i / across - 1) + v, bucket->clear[i]);
    }
    trace(bucket, scene);
    for (size_t n = 0; n < edges; n++) {
        struct colour *const pixel = &bucket->pixel[bucket->which[n]];
        *pixel = colour_mix(*pixel, bucket->colour[n], 1.0f / (float)(sample + 1));
    }
}

void bucket_paint(struct bucket *bucket, const struct scene *scene, size_t samples,
                  const struct bucket_area *area)
{
    const size_t across = area->columns + 2;
    const float spread = samples > 1 ? SPREAD * scene->camera.pixel : 0.0f;
    paint_middles(bucket, scene, area, across, spread);
    bucket->rays.spread = 0.0f;
    const size_t edges = samples > 1 ? list_edges(bucket, area, across) : 0;
    for (size_t sample = 1; sample < samples && edges > 0; sample++) {
        add_sample(bucket, scene, area, edges, sample);
    }
    for (size_t row = 0; row < area->rows; row++) {
        for (size_t column = 0; column < area->columns; column++) {
            const struct colour pixel = bucket->pixel[(row + 1) * across + column + 1];
            uint8_t *const to = area->bytes + row * area->stride + 3 * column;
            to[0] = byte_of(pixel.r, area->column + column, area->row + row);
            to[1] = byte_of(pixel.g, area->column + column, area->row + row);
            to[2] = byte_of(pixel.b, area->column + column, area->row + row);
        }
    }
}
