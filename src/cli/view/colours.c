/* SPDX-License-Identifier: MIT
 *
 * Colours as the eye finds them outdoors. Palettes, which are made for maps, are paler.
 */
#include "view/colours.h"

#include <string.h>

#define NEVER 100.0f

static const struct colours sets[] = {
    {.name = "alpine",
     .meadow = {0.078f, 0.104f, 0.030f},
     .dry = {0.165f, 0.146f, 0.066f},
     .forest = {0.026f, 0.044f, 0.017f},
     .earth = {0.145f, 0.112f, 0.076f},
     .rock = {0.225f, 0.198f, 0.170f},
     .dark_rock = {0.088f, 0.081f, 0.076f},
     .snow = {0.80f, 0.82f, 0.86f},
     .sand = {0.42f, 0.34f, 0.22f},
     .shallows = {0.055f, 0.190f, 0.185f},
     .depths = {0.006f, 0.030f, 0.050f},
     .meadow_rough = 0.45f,
     .bare = {0.45f, 1.0f},
     .meadow_end = 0.78f,
     .woods = 0.05f,
     .snow_line = 0.70f,
     .snow_least = 60.0f},
    {.name = "temperate",
     .meadow = {0.080f, 0.112f, 0.030f},
     .dry = {0.150f, 0.142f, 0.058f},
     .forest = {0.028f, 0.050f, 0.018f},
     .earth = {0.150f, 0.118f, 0.078f},
     .rock = {0.230f, 0.205f, 0.172f},
     .dark_rock = {0.096f, 0.087f, 0.076f},
     .snow = {0.80f, 0.82f, 0.86f},
     .sand = {0.46f, 0.38f, 0.26f},
     .shallows = {0.055f, 0.210f, 0.195f},
     .depths = {0.006f, 0.034f, 0.052f},
     .meadow_rough = 0.45f,
     .bare = {0.45f, 1.0f},
     .meadow_end = 1.3f,
     .woods = -0.02f,
     .snow_line = NEVER},
    {.name = "desert",
     .meadow = {0.470f, 0.295f, 0.145f},
     .dry = {0.430f, 0.245f, 0.122f},
     .forest = {0.060f, 0.066f, 0.030f},
     .earth = {0.350f, 0.195f, 0.105f},
     .rock = {0.370f, 0.190f, 0.110f},
     .dark_rock = {0.190f, 0.086f, 0.054f},
     .snow = {0.80f, 0.82f, 0.86f},
     .sand = {0.54f, 0.42f, 0.27f},
     .shallows = {0.050f, 0.230f, 0.190f},
     .depths = {0.006f, 0.045f, 0.060f},
     .meadow_rough = 0.12f,
     .bare = {0.80f, 1.0f},
     .meadow_end = NEVER,
     .woods = NEVER,
     .snow_line = NEVER},
    {.name = "arctic",
     .meadow = {0.120f, 0.108f, 0.070f},
     .dry = {0.180f, 0.168f, 0.140f},
     .forest = {0.030f, 0.040f, 0.020f},
     .earth = {0.150f, 0.138f, 0.122f},
     .rock = {0.150f, 0.150f, 0.155f},
     .dark_rock = {0.055f, 0.056f, 0.062f},
     .snow = {0.80f, 0.82f, 0.86f},
     .sand = {0.20f, 0.195f, 0.18f},
     .shallows = {0.070f, 0.150f, 0.165f},
     .depths = {0.006f, 0.022f, 0.038f},
     .meadow_rough = 0.5f,
     .bare = {0.45f, 1.0f},
     .meadow_end = 0.5f,
     .woods = NEVER,
     .snow_line = 0.16f},
    {.name = "grey",
     .meadow = {0.30f, 0.30f, 0.295f},
     .dry = {0.30f, 0.30f, 0.295f},
     .forest = {0.30f, 0.30f, 0.295f},
     .earth = {0.28f, 0.28f, 0.275f},
     .rock = {0.28f, 0.277f, 0.27f},
     .dark_rock = {0.23f, 0.227f, 0.222f},
     .snow = {0.30f, 0.30f, 0.295f},
     .sand = {0.32f, 0.32f, 0.31f},
     .shallows = {0.16f, 0.19f, 0.20f},
     .depths = {0.05f, 0.065f, 0.08f},
     .meadow_rough = 0.3f,
     .bare = {0.45f, 1.0f},
     .meadow_end = NEVER,
     .woods = NEVER,
     .snow_line = NEVER},
};

void colours_make(const struct palette *palette, struct colours *colours)
{
    *colours = sets[0];
    for (size_t i = 0; palette->name != NULL && i < sizeof sets / sizeof sets[0]; i++) {
        if (strcmp(sets[i].name, palette->name) == 0) {
            *colours = sets[i];
        }
    }
    colours->file = palette->name == NULL ? palette : NULL;
}
