/* SPDX-License-Identifier: MIT
 *
 * What the ground is covered with in each palette, in one place.
 */
#ifndef SCARP_CLI_VIEW_COLOURS_H
#define SCARP_CLI_VIEW_COLOURS_H

#include "look/palette.h"

/* Colours are the part of the light that is given back, and not sRGB as in palettes. Heights are 0
   at the lower end of usual heights, or at the sea, and 1 at their upper end. */
struct colours {
    const char *name;              /* of the palette */
    struct colour meadow, dry;     /* what covers level ground, and what does so higher up */
    struct colour forest;          /* trees */
    struct colour earth;           /* between that and rock */
    struct colour rock, dark_rock; /* layers of it */
    struct colour snow;
    struct colour sand;             /* along the shore */
    struct colour shallows, depths; /* of the sea */
    float meadow_rough;             /* how rough level ground is; rock has 1 */
    float bare[2];                  /* the slopes between which rock begins */
    float meadow_end;               /* the height where it is too cold for it */
    float woods;                    /* trees stand where patches are higher; none are above 1 */
    float snow_line, snow_least;    /* the height where snow begins, and how many units above 0 it
                                       must be */
    const struct palette *file;     /* all land has the colours of its heights; NULL: it has not */
};

/* The colours of a palette that was resolved */
void colours_make(const struct palette *palette, struct colours *colours);

#endif
