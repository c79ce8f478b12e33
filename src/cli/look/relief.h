/* SPDX-License-Identifier: MIT
 *
 * The colours of a terrain seen from above: samples become pixels.
 *
 *     pixel = sqrt(ground light),  ground = colours of the palette, squared
 *     light = sun max(0, n.l) + sky (1 + n_z) / 2
 *
 * Both are written out in relief.c, and in the help of `scarp terrain`.
 */
#ifndef SCARP_CLI_RELIEF_H
#define SCARP_CLI_RELIEF_H

#include <stddef.h>
#include <stdint.h>

#include "look/palette.h"

/* What all samples of a terrain share */
struct relief {
    const struct palette *palette; /* resolved */
    float low, middle, high;       /* heights that are the fractions 0, 0.4 and 1 */
    float sea, deep;               /* of the sea, and where water is deep; no sea: equal */
    double light[3];               /* unit vector to the light: east, north, up */
};

/* Arrays with one number per pixel */
struct relief_samples {
    const float *value;
    const float *bed;       /* heights below the sea, too; NULL: there is no sea */
    const float *normal[3]; /* of the ground */
    const float *shade[3];  /* of the ground, exaggerated: these are lit */
};

/* Writes red, green and blue of `count` samples. */
void relief_colours(const struct relief *relief, const struct relief_samples *samples, size_t count,
                    uint8_t *rgb);

extern const char *const relief_names[PALETTE_GROUNDS];

/* Writes PALETTE_GROUNDS bytes for each of `count` samples: how much of each ground the relief has
   there. Together they are 255. The palette is a named one. */
void relief_masks(const struct relief *relief, const struct relief_samples *samples, size_t count,
                  uint8_t *masks);

/* The unit vector to a light `azimuth` degrees clockwise from north, `altitude` degrees above the
   horizon. */
void relief_light(double azimuth, double altitude, double light[3]);

#endif
