/* SPDX-License-Identifier: MIT
 *
 * Colours as the eye finds them in the mountains, a little brighter than measured.
 */
#include "view/colours.h"

const struct colours colours_alpine = {
    .meadow = {0.078f, 0.104f, 0.030f},
    .dry_grass = {0.165f, 0.146f, 0.066f},
    .forest = {0.026f, 0.044f, 0.017f},
    .earth = {0.145f, 0.112f, 0.076f},
    .rock = {0.225f, 0.198f, 0.170f},
    .dark_rock = {0.088f, 0.081f, 0.076f},
    .snow = {0.88f, 0.90f, 0.94f},
    .sand = {0.42f, 0.34f, 0.22f},
    .shallows = {0.055f, 0.190f, 0.185f},
    .depths = {0.006f, 0.030f, 0.050f},
};
