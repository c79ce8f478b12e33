/* SPDX-License-Identifier: MIT
 *
 * The encodings. All of them are exact enough in double that every platform writes the same bytes.
 */
#include "terrain/layers.h"

#include <string.h>

#include "formats/npy.h"

static uint8_t *put_float(uint8_t *to, float value)
{
    npy_put_float(to, value);
    return to + 4;
}

static void encode_heights(const struct surface *surface, const struct strip *strip,
                           enum sample_kind kind, uint8_t *to)
{
    const size_t count = strip->count;
    const float *const value = strip->block->value + strip->first;
    if (kind == SAMPLE_F32) {
        for (size_t i = 0; i < count; i++) {
            to = put_float(to, surface->height_scale * value[i]);
        }
        return;
    }
    const size_t high = kind == SAMPLE_U16_HIGH ? 0 : 1;
    for (size_t i = 0; i < count; i++) {
        const unsigned height = surface_quantise(surface, value[i]);
        to[2 * i + high] = (uint8_t)(height >> 8);
        to[2 * i + 1 - high] = (uint8_t)height;
    }
}

/* From [-1, 1] to 0 ... 255; 0 becomes 128, as in every flat normal map. */
static uint8_t component(float n)
{
    return (uint8_t)((double)n * 127.5 + 128.0);
}

static void encode_normals(const struct surface *surface, const struct strip *strip,
                           enum sample_kind kind, uint8_t *to)
{
    const struct block *const block = strip->block;
    const size_t first = strip->first, end = first + strip->count;
    for (size_t i = first; i < end; i++) {
        const float y = surface->normal_y * block->ny[i];
        if (kind == SAMPLE_F32) {
            to = put_float(to, block->nx[i]);
            to = put_float(to, y);
            to = put_float(to, block->nz[i]);
        } else {
            *to++ = component(block->nx[i]);
            *to++ = component(y);
            *to++ = component(block->nz[i]);
        }
    }
}

static void encode_hillshade(const struct surface *surface, const struct strip *strip,
                             enum sample_kind kind, uint8_t *to)
{
    (void)kind;
    const size_t count = strip->count;
    const float *const x = strip->block->shade_x + strip->first;
    const float *const y = strip->block->shade_y + strip->first;
    const float *const z = strip->block->shade_z + strip->first;
    for (size_t i = 0; i < count; i++) {
        const double light = surface->light[0] * (double)x[i] + surface->light[1] * (double)y[i] +
                             surface->light[2] * (double)z[i];
        /* Beyond 1 by rounding, at most */
        const double shade = light < 0.0 ? 0.0 : light > 1.0 ? 1.0 : light;
        to[i] = (uint8_t)(shade * 255.0 + 0.5);
    }
}

static void encode_gradient(const struct surface *surface, const struct strip *strip,
                            enum sample_kind kind, uint8_t *to)
{
    (void)kind;
    const struct block *const block = strip->block;
    const size_t first = strip->first, end = first + strip->count;
    for (size_t i = first; i < end; i++) {
        to = put_float(to, surface->height_scale * block->dx[i]);
        to = put_float(to, surface->height_scale * block->dy[i]);
    }
}

/* The normals of a strip, each pixel as often as the comparison enlarges it */
static void put_normals(const struct surface *surface, const struct strip *strip,
                        const float *const normals[3], uint8_t *to)
{
    for (size_t i = strip->first; i < strip->first + strip->count; i++) {
        const uint8_t pixel[3] = {component(normals[0][i]),
                                  component(surface->normal_y * normals[1][i]),
                                  component(normals[2][i])};
        for (size_t n = 0; n < surface->zoom; n++) {
            memcpy(to, pixel, sizeof pixel);
            to += sizeof pixel;
        }
    }
}

static void encode_compare(const struct surface *surface, const struct strip *strip,
                           enum sample_kind kind, uint8_t *to)
{
    (void)kind;
    const struct block *const block = strip->block;
    const float *const exact[3] = {block->nx, block->ny, block->nz};
    const float *const differences[3] = {block->differences_x, block->differences_y,
                                         block->differences_z};
    put_normals(surface, strip, exact, to);
    put_normals(surface, strip, differences, to + 3 * surface->zoom * strip->width);
}

const struct layer layers[LAYER_COUNT] = {
    [LAYER_HEIGHTS] = {.option = "--heights",
                       .name = "height",
                       .content = "heights",
                       .channels = 1,
                       .kinds = {SAMPLE_F32, SAMPLE_U16_LOW, SAMPLE_U16_HIGH},
                       .encode = encode_heights},
    [LAYER_NORMALS] = {.option = "--normals",
                       .name = "normal",
                       .content = "normals",
                       .channels = 3,
                       .kinds = {SAMPLE_F32, SAMPLE_U8},
                       .needs = SURFACE_GRADIENT | SURFACE_NORMALS,
                       .encode = encode_normals},
    [LAYER_HILLSHADE] = {.option = "--hillshade",
                         .name = "hillshade",
                         .content = "hillshade",
                         .channels = 1,
                         .kinds = {SAMPLE_U8},
                         .needs = SURFACE_GRADIENT | SURFACE_SHADE,
                         .encode = encode_hillshade},
    [LAYER_GRADIENT] = {.option = "--gradient",
                        .name = "gradient",
                        .content = "gradient",
                        .channels = 2,
                        .kinds = {SAMPLE_F32},
                        .needs = SURFACE_GRADIENT,
                        .encode = encode_gradient},
    [LAYER_COMPARE] = {.option = "--compare",
                       .name = "compare",
                       .content = "comparison",
                       .channels = 3,
                       .kinds = {SAMPLE_U8},
                       .needs = SURFACE_GRADIENT | SURFACE_NORMALS | SURFACE_DIFFERENCES,
                       .encode = encode_compare},
};
