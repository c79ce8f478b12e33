/* SPDX-License-Identifier: MIT
 *
 * The encodings. All of them are exact enough in double that every platform writes the same bytes.
 * Their loops are such as compilers turn into vector code.
 */
#include "raster/layers.h"

#include <string.h>

#include "raster/slope.h"
#include "shared/bounds.h"

/* Known when this is compiled, though only the preprocessors of some compilers know it */
static inline bool is_low_byte_first(void)
{
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    return first == 1;
}

/* The low byte first: as it is in memory on most machines */
static inline void put_bits(uint8_t *to, uint32_t bits)
{
    if (!is_low_byte_first()) {
        bits = bits >> 24 | (bits >> 8 & 0xff00) | (bits << 8 & 0xff0000) | bits << 24;
    }
    memcpy(to, &bits, sizeof bits);
}

static inline void put_float(uint8_t *to, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_bits(to, bits);
}

static inline void put_integer(uint8_t *to, unsigned value, bool low_byte_first)
{
    const uint16_t bits =
        (uint16_t)(low_byte_first == is_low_byte_first() ? value : value >> 8 | value << 8);
    memcpy(to, &bits, sizeof bits);
}

/* Floats as they are, or as integers of a scale */
static void put_values(const float *value, size_t count, struct surface_scale scale,
                       enum sample_type type, uint8_t *to)
{
    if (type == SAMPLE_F32) {
        for (size_t i = 0; i < count; i++) {
            put_float(to + 4 * i, value[i]);
        }
        return;
    }
    if (type == SAMPLE_U16_LOW) {
        for (size_t i = 0; i < count; i++) {
            put_integer(to + 2 * i, surface_quantise(scale, value[i]), true);
        }
        return;
    }
    for (size_t i = 0; i < count; i++) {
        put_integer(to + 2 * i, surface_quantise(scale, value[i]), false);
    }
}

static void encode_heights(const struct surface *surface, const struct span *span,
                           enum sample_type type, uint8_t *to)
{
    put_values(span->window->value + span->first, span->count, surface->scale, type, to);
}

static void encode_field(const struct surface *surface, const struct span *span,
                         enum sample_type type, uint8_t *to)
{
    const struct ground_field *const field = &surface->ground.fields[span->part];
    put_values(span->window->fields[span->part] + span->first, span->count,
               surface_scale_of((double)field->lowest, (double)field->highest), type, to);
}

#define RUN 256 /* samples that are computed at once */

static void encode_slope(const struct surface *surface, const struct span *span,
                         enum sample_type type, uint8_t *to)
{
    (void)surface;
    const float *const dx = span->window->dx + span->first;
    const float *const dy = span->window->dy + span->first;
    for (size_t first = 0; first < span->count; first += RUN) {
        float degrees[RUN];
        const size_t count = smaller(span->count - first, RUN);
        slope_degrees(count, dx + first, dy + first, degrees);
        put_values(degrees, count, surface_scale_of(0.0, 90.0), type,
                   to + first * sample_bytes(type));
    }
}

static void encode_curvature(const struct surface *surface, const struct span *span,
                             enum sample_type type, uint8_t *to)
{
    (void)surface;
    (void)type;
    const struct window *const window = span->window;
    for (size_t first = 0; first < span->count; first += RUN) {
        float curvature[RUN];
        const size_t count = smaller(span->count - first, RUN), at = span->first + first;
        const struct scarp_samples samples = {.dx = window->dx + at,
                                              .dy = window->dy + at,
                                              .dxx = window->dxx + at,
                                              .dxy = window->dxy + at,
                                              .dyy = window->dyy + at};
        slope_curvature(count, &samples, curvature);
        put_values(curvature, count, surface_scale_of(0.0, 0.0), SAMPLE_F32, to + 4 * first);
    }
}

/* From [-1, 1] to 0 ... 255; 0 becomes 128, as in every flat normal map. */
static inline uint32_t component(float n)
{
    return (uint32_t)(int)((double)n * 127.5 + 128.0);
}

static inline uint32_t colour(float x, float y, float z)
{
    return component(x) | component(y) << 8 | component(z) << 16;
}

/* Puts four bytes at a time, the last of which belongs to the next pixel: no compiler has vector
   code for three. */
static void put_colours(const float *const n[3], float normal_y, size_t count, uint8_t *to)
{
    uint32_t colours[RUN];
    for (size_t i = 0; i < count; i++) {
        colours[i] = colour(n[0][i], normal_y * n[1][i], n[2][i]);
    }
    for (size_t i = 0; i + 1 < count; i++) {
        put_bits(to + 3 * i, colours[i]);
    }
    for (size_t c = 0; c < 3; c++) { /* what follows may be of a window that another thread makes */
        to[3 * (count - 1) + c] = (uint8_t)(colours[count - 1] >> 8 * c);
    }
}

static void encode_normals(const struct surface *surface, const struct span *span,
                           enum sample_type type, uint8_t *to)
{
    const size_t count = span->count;
    const float *const x = span->window->nx + span->first;
    const float *const y = span->window->ny + span->first;
    const float *const z = span->window->nz + span->first;
    const float normal_y = surface->normal_y;
    if (type == SAMPLE_F32) {
        for (size_t i = 0; i < count; i++) {
            put_float(to + 12 * i, x[i]);
            put_float(to + 12 * i + 4, normal_y * y[i]);
            put_float(to + 12 * i + 8, z[i]);
        }
        return;
    }
    for (size_t i = 0; i < count; i += RUN) {
        const float *const n[3] = {x + i, y + i, z + i};
        put_colours(n, normal_y, count - i < RUN ? count - i : RUN, to + 3 * i);
    }
}

static void encode_hillshade(const struct surface *surface, const struct span *span,
                             enum sample_type type, uint8_t *to)
{
    (void)type;
    const size_t count = span->count;
    const float *const x = span->window->shade_x + span->first;
    const float *const y = span->window->shade_y + span->first;
    const float *const z = span->window->shade_z + span->first;
    const double east = surface->light[0], north = surface->light[1], up = surface->light[2];
    for (size_t i = 0; i < count; i++) {
        const double light = east * (double)x[i] + north * (double)y[i] + up * (double)z[i];
        const int shade = (int)(light * 255.0 + 0.5); /* light is beyond 1 by rounding, at most */
        to[i] = (uint8_t)(shade < 0 ? 0 : shade);
    }
}

/* What the relief looks at, from sample `first` of the span on */
static struct relief_samples relief_samples_of(const struct span *span, size_t first)
{
    const struct window *const window = span->window;
    const size_t at = span->first + first;
    return (struct relief_samples){
        .value = window->value + at,
        .bed = window->bed != NULL ? window->bed + at : NULL,
        .normal = {window->nx + at, window->ny + at, window->nz + at},
        .shade = {window->shade_x + at, window->shade_y + at, window->shade_z + at},
    };
}

static void encode_relief(const struct surface *surface, const struct span *span,
                          enum sample_type type, uint8_t *to)
{
    (void)type;
    const struct relief_samples samples = relief_samples_of(span, 0);
    relief_colours(&surface->relief, &samples, span->count, to);
}

/* The `channels` grounds of the span's part, interleaved; 0 beyond the last ground */
static void encode_grounds(const struct surface *surface, const struct span *span, size_t channels,
                           uint8_t *to)
{
    for (size_t first = 0; first < span->count; first += RUN) {
        uint8_t masks[RUN * PALETTE_GROUNDS];
        const size_t count = smaller(span->count - first, RUN);
        const struct relief_samples samples = relief_samples_of(span, first);
        relief_masks(&surface->relief, &samples, count, masks);
        for (size_t i = 0; i < count; i++) {
            for (size_t c = 0; c < channels; c++) {
                const size_t ground = channels * span->part + c;
                to[channels * (first + i) + c] =
                    ground < PALETTE_GROUNDS ? masks[i * PALETTE_GROUNDS + ground] : 0;
            }
        }
    }
}

/* One ground of five */
static void encode_mask(const struct surface *surface, const struct span *span,
                        enum sample_type type, uint8_t *to)
{
    (void)type;
    encode_grounds(surface, span, 1, to);
}

/* Four grounds as red, green, blue and alpha */
static void encode_masks(const struct surface *surface, const struct span *span,
                         enum sample_type type, uint8_t *to)
{
    (void)type;
    encode_grounds(surface, span, 4, to);
}

static void encode_gradient(const struct surface *surface, const struct span *span,
                            enum sample_type type, uint8_t *to)
{
    (void)type;
    const size_t count = span->count;
    const float *const dx = span->window->dx + span->first;
    const float *const dy = span->window->dy + span->first;
    (void)surface;
    for (size_t i = 0; i < count; i++) {
        put_float(to + 8 * i, dx[i]);
        put_float(to + 8 * i + 4, dy[i]);
    }
}

/* The normals of a span, each pixel as often as the comparison enlarges it */
static void put_normals(const struct surface *surface, const struct span *span,
                        const float *const normals[3], uint8_t *to)
{
    for (size_t i = span->first; i < span->first + span->count; i++) {
        const uint32_t bits =
            colour(normals[0][i], surface->normal_y * normals[1][i], normals[2][i]);
        const uint8_t pixel[3] = {(uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16)};
        for (size_t n = 0; n < surface->zoom; n++) {
            memcpy(to, pixel, sizeof pixel);
            to += sizeof pixel;
        }
    }
}

static void encode_compare(const struct surface *surface, const struct span *span,
                           enum sample_type type, uint8_t *to)
{
    (void)type;
    const struct window *const window = span->window;
    const float *const exact[3] = {window->nx, window->ny, window->nz};
    const float *const differences[3] = {window->differences_x, window->differences_y,
                                         window->differences_z};
    put_normals(surface, span, exact, to);
    put_normals(surface, span, differences, to + 3 * surface->zoom * span->width);
}

const struct layer layers[LAYER_COUNT] = {
    [LAYER_HEIGHTS] = {.option = "--heights",
                       .name = "height",
                       .content = "heights",
                       .channels = 1,
                       .types = {SAMPLE_F32, SAMPLE_U16_LOW, SAMPLE_U16_HIGH},
                       .encode = encode_heights},
    [LAYER_NORMALS] = {.option = "--normals",
                       .name = "normal",
                       .content = "normals",
                       .channels = 3,
                       .types = {SAMPLE_F32, SAMPLE_U8},
                       .needs = SURFACE_GRADIENT | SURFACE_NORMALS,
                       .encode = encode_normals},
    [LAYER_HILLSHADE] = {.option = "--hillshade",
                         .name = "hillshade",
                         .content = "hillshade",
                         .channels = 1,
                         .types = {SAMPLE_U8},
                         .needs = SURFACE_GRADIENT | SURFACE_SHADE,
                         .encode = encode_hillshade},
    [LAYER_RELIEF] = {.option = "--relief",
                      .name = "relief",
                      .content = "relief",
                      .channels = 3,
                      .types = {SAMPLE_U8},
                      .needs = SURFACE_GRADIENT | SURFACE_NORMALS | SURFACE_SHADE | SURFACE_BED,
                      .encode = encode_relief},
    [LAYER_GRADIENT] = {.option = "--gradient",
                        .name = "gradient",
                        .content = "gradient",
                        .channels = 2,
                        .types = {SAMPLE_F32},
                        .needs = SURFACE_GRADIENT,
                        .encode = encode_gradient},
    [LAYER_SLOPE] = {.option = "--slope",
                     .name = "slope",
                     .content = "slope",
                     .channels = 1,
                     .types = {SAMPLE_F32, SAMPLE_U16_LOW, SAMPLE_U16_HIGH},
                     .needs = SURFACE_GRADIENT,
                     .encode = encode_slope},
    [LAYER_CURVATURE] = {.option = "--curvature",
                         .name = "curvature",
                         .content = "curvature",
                         .channels = 1,
                         .types = {SAMPLE_F32},
                         .needs = SURFACE_GRADIENT | SURFACE_CURVATURE,
                         .encode = encode_curvature},
    [LAYER_FIELD] = {.option = "--out",
                     .channels = 1,
                     .types = {SAMPLE_F32, SAMPLE_U16_LOW, SAMPLE_U16_HIGH},
                     .needs = SURFACE_FIELDS,
                     .encode = encode_field},
    [LAYER_MASK] = {.option = "--masks",
                    .channels = 1,
                    .types = {SAMPLE_U8},
                    .needs = SURFACE_GRADIENT | SURFACE_NORMALS | SURFACE_BED,
                    .encode = encode_mask},
    [LAYER_MASKS] = {.option = "--masks",
                     .channels = 4,
                     .types = {SAMPLE_U8},
                     .needs = SURFACE_GRADIENT | SURFACE_NORMALS | SURFACE_BED,
                     .encode = encode_masks},
    [LAYER_COMPARE] = {.option = "--compare",
                       .name = "compare",
                       .content = "comparison",
                       .channels = 3,
                       .types = {SAMPLE_U8},
                       .needs = SURFACE_GRADIENT | SURFACE_NORMALS | SURFACE_DIFFERENCES,
                       .encode = encode_compare},
};
