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
/* The pixels of a tile, and those around it that they are compared with */
#define TILE_RAYS ((TILE_WIDTH + 2) * (TILE_HEIGHT + 2))

/* Pixels that one ray scouts for: SCOUT by SCOUT. As many blocks of them as a tile may touch. */
#define SCOUT 4
#define TILE_BLOCKS ((TILE_WIDTH / SCOUT + 2) * (TILE_HEIGHT / SCOUT + 2))

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
    float block_begin[TILE_BLOCKS];
    bool cliff[TILE_RAYS];
    uint32_t hit[TILE_RAYS];
    uint64_t count; /* of rays so far */
};

/* NULL without memory */
struct tile *tile_open(void);
void tile_close(struct tile *tile);

/* A tile of the picture: its first pixel, its size, and where its bytes go: red, green, blue. Rows
   are `stride` bytes apart. */
struct tile_area {
    size_t column, row, columns, rows;
    uint8_t *bytes;
    size_t stride;
};

/* Paints a tile with at most so many rays per pixel. */
void tile_paint(struct tile *tile, const struct scene *scene, size_t samples,
                const struct tile_area *area);

#endif
