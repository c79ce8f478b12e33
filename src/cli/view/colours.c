/* SPDX-License-Identifier: MIT
 *
 * Colours as the eye finds them in the mountains, a little brighter than measured.
 */
#include "view/colours.h"

const struct colours colours_alpine = {
    .meadow = {0.085f, 0.125f, 0.030f},
    .dry_grass = {0.165f, 0.150f, 0.055f},
    .forest = {0.022f, 0.042f, 0.016f},
    .earth = {0.150f, 0.115f, 0.075f},
    .rock = {0.235f, 0.205f, 0.175f},
    .dark_rock = {0.120f, 0.108f, 0.098f},
    .snow = {0.88f, 0.90f, 0.94f},
    .sand = {0.42f, 0.34f, 0.22f},
    .shallows = {0.055f, 0.190f, 0.185f},
    .depths = {0.006f, 0.030f, 0.050f},
};
