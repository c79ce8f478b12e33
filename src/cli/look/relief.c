/* SPDX-License-Identifier: MIT
 *
 * Colours of samples, RUN at a time, in passes over arrays:
 *
 *     1. ramp    the palette's ramp at the height
 *     2. ground  mixed with sand, rock and snow
 *     3. water   where the ground lies below the sea
 *     4. light   of the sun and the sky
 *
 * Masks are the shares of step 2 and the water of step 3.
 *
 * Mixed is a + (b - a) t, with t = u u (3 - 2 u) of u, which grows from 0 to 1 between two numbers.
 * All is the same on every machine, to the bit.
 */
#include "look/relief.h"

#include <math.h>

#include "shared/sine.h"

#define RUN 256

/* Level ground under the usual light is nearly as bright as its colour in the palette. The sun is a
   little yellow, the sky a little blue, as in paintings of relief. */
static const float sun[3] = {1.06f, 1.00f, 0.90f};
static const float sky[3] = {0.27f, 0.30f, 0.36f};

/* Light of pixels, squares of sRGB */
struct pixels {
    float c[3][RUN];
};

/* Written so that compilers make vector code of it */
static inline float max_of(float a, float b)
{
    return a > b ? a : b;
}

static inline float min_of(float a, float b)
{
    return a < b ? a : b;
}

static inline float mixed(float a, float b, float t)
{
    return a + (b - a) * t;
}

/* Grows from 0 to 1 between two numbers, of which the second may be the lower one. */
struct step {
    float from, per;
};

static struct step step_of(const float pair[2])
{
    return (struct step){pair[0], 1.0f / (pair[1] - pair[0])};
}

static inline float smooth(float x, struct step step)
{
    const float u = min_of(max_of((x - step.from) * step.per, 0.0f), 1.0f);
    return u * u * (3.0f - 2.0f * u);
}

static void put(struct pixels *to, size_t i, struct colour colour)
{
    to->c[0][i] = colour.r * colour.r;
    to->c[1][i] = colour.g * colour.g;
    to->c[2][i] = colour.b * colour.b;
}

/* Neighbours lie between the same stops, mostly: the search begins where the last one ended. */
static void take_ramp(const struct palette *palette, const float *height, size_t count,
                      struct pixels *to)
{
    const struct palette_stop *const stops = palette->stops;
    size_t next = 0; /* the first stop above the height */
    for (size_t i = 0; i < count; i++) {
        while (next < palette->count && stops[next].height <= height[i]) {
            next++;
        }
        while (next > 0 && stops[next - 1].height > height[i]) {
            next--;
        }
        if (next == 0 || next == palette->count) {
            put(to, i, next == 0 ? palette->below : palette->above);
            continue;
        }
        const struct palette_stop *const a = &stops[next - 1], *const b = &stops[next];
        const float t = (height[i] - a->height) / (b->height - a->height);
        put(to, i,
            (struct colour){mixed(a->colour.r, b->colour.r, t), mixed(a->colour.g, b->colour.g, t),
                            mixed(a->colour.b, b->colour.b, t)});
    }
}

/* Mixes the pixels with a colour. */
static void mix(struct pixels *to, const float *share, size_t count, struct colour colour)
{
    const float squares[3] = {colour.r * colour.r, colour.g * colour.g, colour.b * colour.b};
    for (size_t c = 0; c < 3; c++) {
        const float square = squares[c];
        for (size_t i = 0; i < count; i++) {
            to->c[c][i] = mixed(to->c[c][i], square, share[i]);
        }
    }
}

/* How much of each ground covers those before it */
struct shares {
    float sand[RUN], rock[RUN], high_rock[RUN], snow[RUN];
};

/* Sand lies at the sea, rock shows where it is steep, and snow lies on both where it is high and
   not steep, higher up where the sun shines. */
static void find_shares(const struct relief *relief, const struct relief_samples *samples,
                        const float *height, size_t count, struct shares *to)
{
    const struct palette p = *relief->palette;
    const float *const nx = samples->normal[0], *const ny = samples->normal[1];
    const float *const nz = samples->normal[2];
    const float east = p.snow_sun * (float)relief->light[0];
    const float north = p.snow_sun * (float)relief->light[1];
    const struct step rock = step_of(p.rock_slope), high_rock = step_of(p.rock_height);
    const struct step snow = step_of(p.snow_height), hold = step_of(p.snow_slope);
    if (samples->bed != NULL) {
        const struct step sand = step_of(p.sand_height);
        for (size_t i = 0; i < count; i++) {
            to->sand[i] = smooth(height[i], sand);
        }
    }
    for (size_t i = 0; i < count; i++) {
        to->rock[i] = smooth(nz[i], rock);
    }
    for (size_t i = 0; i < count; i++) {
        to->high_rock[i] = to->rock[i] * smooth(height[i], high_rock);
    }
    for (size_t i = 0; i < count; i++) {
        const float lower = east * nx[i] + north * ny[i] + p.snow_steep * (1.0f - nz[i]);
        to->snow[i] = smooth(height[i] - lower, snow) * smooth(nz[i], hold);
    }
}

static void take_ground(const struct relief *relief, const struct relief_samples *samples,
                        const float *height, size_t count, struct pixels *to)
{
    const struct palette *const p = relief->palette;
    struct shares shares;
    find_shares(relief, samples, height, count, &shares);
    if (samples->bed != NULL) {
        mix(to, shares.sand, count, p->sand);
    }
    mix(to, shares.rock, count, p->rock);
    mix(to, shares.high_rock, count, p->high_rock);
    mix(to, shares.snow, count, p->snow);
}

/* Light shallows that fade fast, then slowly. The ground at the shore is a hard edge. */
static void take_water(const struct relief *relief, const float *bed, size_t count,
                       struct pixels *to)
{
    const struct colour a = relief->palette->shallow, b = relief->palette->deep;
    const float from[3] = {a.r, a.g, a.b}, into[3] = {b.r, b.g, b.b};
    const float per_depth = 1.0f / (relief->sea - relief->deep);
    const float sea = relief->sea;
    for (size_t c = 0; c < 3; c++) {
        const float shallow = from[c], deep = into[c];
        float *const light = to->c[c];
        for (size_t i = 0; i < count; i++) {
            const float depth = max_of((sea - bed[i]) * per_depth, 0.0f);
            const float t = min_of(1.25f * depth / (depth + 0.25f), 1.0f);
            const float colour = mixed(shallow, deep, t);
            light[i] = bed[i] < sea ? colour * colour : light[i];
        }
    }
}

/* Leaves what is up to 3/4, and brings all that is brighter below 1: snow in the sun has shades. */
static inline float shoulder(float x)
{
    const float over = max_of(4.0f * x - 3.0f, 0.0f);
    return min_of(x, 0.75f) + 0.25f * (over / (1.0f + over));
}

static void take_light(const struct relief *relief, const struct relief_samples *samples,
                       size_t count, const struct pixels *ground, uint8_t *rgb)
{
    const float east = (float)relief->light[0], north = (float)relief->light[1];
    const float up = (float)relief->light[2];
    const float *const x = samples->shade[0], *const y = samples->shade[1];
    const float *const z = samples->shade[2];
    for (size_t c = 0; c < 3; c++) {
        uint8_t bytes[RUN];
        for (size_t i = 0; i < count; i++) {
            const float direct = max_of(east * x[i] + north * y[i] + up * z[i], 0.0f);
            const float light = sun[c] * direct + sky[c] * (0.5f + 0.5f * z[i]);
            const float square = shoulder(ground->c[c][i] * light);
            bytes[i] = (uint8_t)(int)(sqrtf(square) * 255.0f + 0.5f);
        }
        for (size_t i = 0; i < count; i++) {
            rgb[3 * i + c] = bytes[i];
        }
    }
}

/* The fraction of usual heights that each height is */
static void find_fractions(const struct relief *relief, const float *value, size_t count,
                           float *height)
{
    const float middle = relief->middle;
    const float below = 0.4f / (middle - relief->low), above = 0.6f / (relief->high - middle);
    for (size_t i = 0; i < count; i++) {
        const float over = value[i] - middle;
        height[i] = 0.4f + over * (over < 0.0f ? below : above);
    }
}

static void take_run(const struct relief *relief, const struct relief_samples *samples,
                     size_t count, uint8_t *rgb)
{
    struct pixels pixels;
    float height[RUN];
    if (relief->palette->in_units) {
        for (size_t i = 0; i < count; i++) {
            height[i] = samples->bed != NULL ? samples->bed[i] : samples->value[i];
        }
        take_ramp(relief->palette, height, count, &pixels);
    } else {
        find_fractions(relief, samples->value, count, height);
        take_ramp(relief->palette, height, count, &pixels);
        take_ground(relief, samples, height, count, &pixels);
        if (samples->bed != NULL) {
            take_water(relief, samples->bed, count, &pixels);
        }
    }
    take_light(relief, samples, count, &pixels, rgb);
}

static struct relief_samples samples_at(const struct relief_samples *samples, size_t first)
{
    return (struct relief_samples){
        .value = samples->value + first,
        .bed = samples->bed != NULL ? samples->bed + first : NULL,
        .normal = {samples->normal[0] + first, samples->normal[1] + first,
                   samples->normal[2] + first},
        .shade = {samples->shade[0] + first, samples->shade[1] + first, samples->shade[2] + first},
    };
}

void relief_colours(const struct relief *relief, const struct relief_samples *samples, size_t count,
                    uint8_t *rgb)
{
    for (size_t first = 0; first < count; first += RUN) {
        const struct relief_samples run = samples_at(samples, first);
        take_run(relief, &run, count - first < RUN ? count - first : RUN, rgb + 3 * first);
    }
}

const char *const relief_names[PALETTE_GROUNDS] = {"rock", "snow", "sand", "vegetation", "water"};

/* What covers the others has its whole share, they have what it leaves, and the ramp what they all
   leave. Sums are rounded and not the shares, so that these are 255 together. */
static void mask_run(const struct relief *relief, const struct relief_samples *samples,
                     size_t count, uint8_t *masks)
{
    float height[RUN];
    struct shares shares;
    find_fractions(relief, samples->value, count, height);
    find_shares(relief, samples, height, count, &shares);
    for (size_t i = 0; i < count; i++) {
        uint8_t *const to = masks + i * PALETTE_GROUNDS;
        const bool is_water = samples->bed != NULL && samples->bed[i] < relief->sea;
        const float bare = 1.0f - (1.0f - shares.rock[i]) * (1.0f - shares.high_rock[i]);
        const float dry = (1.0f - shares.snow[i]) * (1.0f - bare);
        const float sand = samples->bed != NULL ? shares.sand[i] : 0.0f;
        float share[PALETTE_WATER] = {[PALETTE_ROCK] = (1.0f - shares.snow[i]) * bare,
                                      [PALETTE_SNOW] = shares.snow[i],
                                      [PALETTE_SAND] = dry * sand};
        share[relief->palette->ground] += dry * (1.0f - sand);
        const float land = is_water ? 0.0f : 255.0f;
        float sum = 0.0f;
        int before = 0;
        for (size_t g = 0; g < PALETTE_VEGETATION; g++) {
            sum = min_of(sum + share[g], 1.0f);
            const int rounded = (int)(sum * land + 0.5f);
            to[g] = (uint8_t)(rounded - before);
            before = rounded;
        }
        to[PALETTE_VEGETATION] = (uint8_t)((int)land - before);
        to[PALETTE_WATER] = (uint8_t)(255 - (int)land);
    }
}

void relief_masks(const struct relief *relief, const struct relief_samples *samples, size_t count,
                  uint8_t *masks)
{
    for (size_t first = 0; first < count; first += RUN) {
        const struct relief_samples run = samples_at(samples, first);
        mask_run(relief, &run, count - first < RUN ? count - first : RUN,
                 masks + first * PALETTE_GROUNDS);
    }
}

void relief_light(double azimuth, double altitude, double light[3])
{
    const double horizontal = sine(90.0 - altitude);
    light[0] = sine(azimuth) * horizontal;
    light[1] = sine(azimuth + 90.0) * horizontal;
    light[2] = sine(altitude);
}
