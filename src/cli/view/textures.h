/* SPDX-License-Identifier: MIT
 *
 * Noise that makes the surface look like something: where one material ends and another begins,
 * what is rough, where trees stand, how rock is layered, how clouds and waves are.
 */
#ifndef SCARP_CLI_VIEW_TEXTURES_H
#define SCARP_CLI_VIEW_TEXTURES_H

#include "scarp.h"

enum texture {
    TEXTURE_PATCHES, /* borders of materials, and their shades */
    TEXTURE_ROUGH,   /* what is too small to be ground */
    TEXTURE_TREES,   /* -1 in the middle of a tree, more towards its neighbours */
    TEXTURE_LAYERS,  /* of rock; the second coordinate is the height */
    TEXTURE_WAVES,
    TEXTURE_CLOUDS,
    TEXTURE_COUNT
};

/* Samples a texture without cells that are smaller than `finest` units; if none is left, all of it
   is 0. `out` has a value, or also dx and dy. */
void texture_sample(enum texture texture, float finest, size_t count, const double *x,
                    const double *y, const struct scarp_samples *out);

#endif
