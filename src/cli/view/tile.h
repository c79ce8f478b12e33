/* SPDX-License-Identifier: MIT
 *
 * Tiles of the picture: what threads work at. The rays of a tile are marched and lit together.
 */
#ifndef SCARP_CLI_VIEW_TILE_H
#define SCARP_CLI_VIEW_TILE_H

#include "view/light.h"
#include "view/march.h"

#define TILE_WIDTH 128
#define TILE_HEIGHT 64
/* Its pixels, and those around it that they are compared with */
#define TILE_RAYS ((TILE_WIDTH + 2) * (TILE_HEIGHT + 2))

/* What a thread needs */
struct tile {
    struct rays rays;
    struct march march;
    struct light light;
    struct colour colour[TILE_RAYS];          /* of the rays */
    struct colour pixel[TILE_RAYS];           /* as shown, before the curve of the screen */
    uint32_t which[TILE_WIDTH * TILE_HEIGHT]; /* pixels that need more rays */
    float ray_x[TILE_RAYS], ray_y[TILE_RAYS], ray_z[TILE_RAYS], distance[TILE_RAYS];
    float begin[TILE_RAYS], clear[TILE_RAYS]; /* the latter of pixels */
    uint32_t hit[TILE_RAYS];
    uint64_t count; /* of rays so far */
};

/* NULL without memory */
struct tile *tile_open(void);
void tile_close(struct tile *tile);

/* Paints the tile whose first pixel is (column, row). `bytes` is where that goes, red, green, blue;
   rows are `stride` bytes apart. */
void tile_paint(struct tile *tile, const struct scene *scene, size_t samples, size_t column,
                size_t row, uint8_t *bytes, size_t stride);

#endif
