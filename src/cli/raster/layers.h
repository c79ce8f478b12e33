/* SPDX-License-Identifier: MIT
 *
 * The layers of a terrain, each of which can go to a file: what a layer is made of, and how samples
 * become its bytes. The formulas are in the help of `scarp terrain`.
 */
#ifndef SCARP_CLI_LAYERS_H
#define SCARP_CLI_LAYERS_H

#include <stddef.h>
#include <stdint.h>

#include "formats/writer.h"
#include "raster/surface.h"

/* Samples of a window that lie in one row of the raster */
struct span {
    const struct window *window;
    size_t first, count; /* of the window: its index, and how many there are */
    size_t width;        /* samples in the whole row */
    size_t part;         /* which one of a layer that has several: a field, a mask */
};

struct layer {
    const char *option;  /* that asks for it */
    const char *name;    /* STEM-NAME.png */
    const char *content; /* what it holds; of a layer that has several, each says it itself */
    size_t channels;
    /* The types of samples it can be stored as, the best first; 0 at the end */
    enum sample_type types[4];
    unsigned needs; /* of enum surface_need */
    /* Writes the samples of a span. `to` is where the pixel of the first of them goes. */
    void (*encode)(const struct surface *surface, const struct span *span, enum sample_type type,
                   uint8_t *to);
};

enum {
    LAYER_HEIGHTS,
    LAYER_NORMALS,
    LAYER_HILLSHADE,
    LAYER_RELIEF,
    LAYER_GRADIENT,
    LAYER_SLOPE,
    LAYER_CURVATURE,
    LAYER_FIELD, /* part n: field n of the ground */
    LAYER_MASK,  /* part n: ground n of enum palette_ground */
    LAYER_MASKS, /* part 0: grounds 0 to 3, part 1: ground 4 and three times 0 */
    LAYER_COMPARE,
    LAYER_COUNT
};

extern const struct layer layers[LAYER_COUNT];

#endif
