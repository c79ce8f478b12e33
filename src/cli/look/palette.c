/* SPDX-License-Identifier: MIT
 *
 * The named palettes, and finding one.
 */
#include "look/palette.h"

#include <stdlib.h>
#include <string.h>

#define RGB(red, green, blue)                                                                      \
    {                                                                                              \
        (red) / 255.0f, (green) / 255.0f, (blue) / 255.0f                                          \
    }
#define STOPS(array) .stops = (array), .count = sizeof(array) / sizeof(array)[0]

/* Forest, meadow, dry grass, scree */
static const struct palette_stop alpine_stops[] = {
    {0.00f, RGB(82, 104, 70), false},   {0.18f, RGB(104, 122, 74), false},
    {0.36f, RGB(140, 144, 92), false},  {0.54f, RGB(168, 156, 114), false},
    {0.72f, RGB(162, 146, 124), false}, {1.00f, RGB(176, 168, 160), false},
};

/* Woods, meadow, heath, bare tops */
static const struct palette_stop temperate_stops[] = {
    {0.00f, RGB(86, 110, 70), false},   {0.20f, RGB(104, 126, 74), false},
    {0.40f, RGB(136, 148, 90), false},  {0.60f, RGB(164, 162, 108), false},
    {0.80f, RGB(176, 162, 122), false}, {1.00f, RGB(192, 182, 156), false},
};

/* Sand that gets redder, then strata of rock */
static const struct palette_stop desert_stops[] = {
    {0.00f, RGB(222, 192, 142), false}, {0.25f, RGB(216, 180, 126), false},
    {0.45f, RGB(206, 163, 108), false}, {0.62f, RGB(197, 149, 102), false},
    {0.80f, RGB(199, 152, 111), false}, {1.00f, RGB(222, 186, 148), false},
};

/* Tundra, frozen ground, ice */
static const struct palette_stop arctic_stops[] = {
    {0.00f, RGB(118, 122, 104), false}, {0.15f, RGB(146, 148, 136), false},
    {0.32f, RGB(190, 198, 202), false}, {0.55f, RGB(216, 226, 234), false},
    {1.00f, RGB(240, 245, 250), false},
};

static const struct palette_stop grey_stops[] = {
    {0.00f, RGB(150, 150, 148), false},
    {1.00f, RGB(232, 231, 228), false},
};

static const struct palette palettes[] = {
    {.name = "alpine",
     STOPS(alpine_stops),
     .ground = PALETTE_VEGETATION,
     .rock = RGB(122, 114, 102),
     .high_rock = RGB(142, 136, 130),
     .snow = RGB(232, 238, 246),
     .sand = RGB(206, 190, 146),
     .shallow = RGB(112, 166, 172),
     .deep = RGB(24, 56, 92),
     .rock_slope = {0.90f, 0.78f},
     .rock_height = {0.3f, 0.7f},
     .snow_height = {0.70f, 0.77f},
     .snow_slope = {0.55f, 0.75f},
     .snow_sun = 0.3f,
     .snow_steep = 0.7f,
     .sand_height = {0.05f, 0.015f}},
    {.name = "temperate",
     STOPS(temperate_stops),
     .ground = PALETTE_VEGETATION,
     .rock = RGB(124, 116, 100),
     .high_rock = RGB(144, 136, 122),
     .snow = RGB(232, 238, 246),
     .sand = RGB(214, 198, 154),
     .shallow = RGB(112, 172, 172),
     .deep = RGB(24, 64, 98),
     .rock_slope = {0.88f, 0.74f},
     .rock_height = {0.3f, 0.8f},
     .snow_height = {100.0f, 101.0f},
     .snow_slope = {0.5f, 0.8f},
     .sand_height = {0.05f, 0.015f}},
    {.name = "desert",
     STOPS(desert_stops),
     .ground = PALETTE_SAND,
     .rock = RGB(158, 104, 76),
     .high_rock = RGB(178, 122, 90),
     .snow = RGB(255, 255, 255),
     .sand = RGB(232, 208, 160),
     .shallow = RGB(96, 172, 160),
     .deep = RGB(22, 82, 104),
     .rock_slope = {0.86f, 0.72f},
     .rock_height = {0.3f, 0.8f},
     .snow_height = {100.0f, 101.0f},
     .snow_slope = {0.5f, 0.8f},
     .sand_height = {0.08f, 0.02f}},
    {.name = "arctic",
     STOPS(arctic_stops),
     .ground = PALETTE_SNOW,
     .rock = RGB(84, 86, 92),
     .high_rock = RGB(104, 106, 112),
     .snow = RGB(234, 240, 247),
     .sand = RGB(140, 140, 130),
     .shallow = RGB(124, 160, 176),
     .deep = RGB(24, 48, 74),
     .rock_slope = {0.86f, 0.72f},
     .rock_height = {0.2f, 0.7f},
     .snow_height = {0.1f, 0.22f},
     .snow_slope = {0.50f, 0.72f},
     .snow_sun = 0.3f,
     .snow_steep = 0.7f,
     .sand_height = {0.04f, 0.01f}},
    {.name = "grey",
     STOPS(grey_stops),
     .ground = PALETTE_VEGETATION,
     .rock = RGB(168, 167, 164),
     .high_rock = RGB(192, 191, 188),
     .snow = RGB(255, 255, 255),
     .sand = RGB(200, 198, 192),
     .shallow = RGB(176, 188, 196),
     .deep = RGB(96, 112, 126),
     .rock_slope = {0.84f, 0.64f},
     .rock_height = {0.3f, 0.8f},
     .snow_height = {100.0f, 101.0f},
     .snow_slope = {0.5f, 0.8f},
     .sand_height = {0.03f, 0.01f}},
};

const char *const palette_names[] = {"alpine", "temperate", "desert", "arctic", "grey", NULL};

const struct palette *palette_find(const char *name)
{
    for (size_t i = 0; i < sizeof palettes / sizeof palettes[0]; i++) {
        if (strcmp(palettes[i].name, name) == 0) {
            return &palettes[i];
        }
    }
    return NULL;
}

bool palette_open(struct palette *palette, const char *option, const char *text)
{
    const struct palette *const named = palette_find(text);
    if (named == NULL) {
        return palette_read(palette, option, text);
    }
    *palette = *named;
    return true;
}

void palette_free(struct palette *palette)
{
    free(palette->memory);
    *palette = (struct palette){.name = NULL};
}

/* Stops of one height keep their order: they are a step. Files are short or sorted. */
void palette_resolve(struct palette *palette, float low, float high)
{
    struct palette_stop *const stops = palette->memory;
    for (size_t i = 0; stops != NULL && i < palette->count; i++) {
        struct palette_stop stop = stops[i];
        if (stop.is_fraction) {
            stop.height = low + stop.height * (high - low);
            stop.is_fraction = false;
        }
        size_t at = i;
        for (; at > 0 && stops[at - 1].height > stop.height; at--) {
            stops[at] = stops[at - 1];
        }
        stops[at] = stop;
    }
    if (!palette->has_below) {
        palette->below = palette->stops[0].colour;
    }
    if (!palette->has_above) {
        palette->above = palette->stops[palette->count - 1].colour;
    }
}
