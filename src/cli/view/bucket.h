/* SPDX-License-Identifier: MIT
 *
 * Buckets of the picture: what threads work at. The rays of a bucket are marched and lit together.
 */
#ifndef SCARP_CLI_VIEW_BUCKET_H
#define SCARP_CLI_VIEW_BUCKET_H

#include "view/light.h"
#include "view/march.h"

#define BUCKET_WIDTH 128
#define BUCKET_HEIGHT 64
/* The pixels of a bucket, and those around it that they are compared with */
#define BUCKET_RAYS ((BUCKET_WIDTH + 2) * (BUCKET_HEIGHT + 2))

/* Pixels that one ray scouts for: SCOUT by SCOUT. As many blocks of them as a bucket may touch. */
#define SCOUT 4
#define BUCKET_BLOCKS ((BUCKET_WIDTH / SCOUT + 2) * (BUCKET_HEIGHT / SCOUT + 2))

/* What a thread needs */
struct bucket {
    struct rays rays;
    struct march march;
    struct light light;
    struct colour colour[BUCKET_RAYS];            /* of the rays */
    struct colour pixel[BUCKET_RAYS];             /* as shown, before the curve of the screen */
    uint32_t which[BUCKET_WIDTH * BUCKET_HEIGHT]; /* pixels that need more rays */
    float ray_x[BUCKET_RAYS], ray_y[BUCKET_RAYS], ray_z[BUCKET_RAYS], distance[BUCKET_RAYS];
    float begin[BUCKET_RAYS], clear[BUCKET_RAYS]; /* the latter of pixels */
    float block_begin[BUCKET_BLOCKS];
    bool cliff[BUCKET_RAYS];
    uint32_t hit[BUCKET_RAYS];
    uint64_t count; /* of rays so far */
};

/* NULL without memory */
struct bucket *bucket_open(void);
void bucket_close(struct bucket *bucket);

/* A bucket of the picture: its first pixel, its size, and where its bytes go: red, green, blue. Rows
   are `stride` bytes apart. */
struct bucket_area {
    size_t column, row, columns, rows;
    uint8_t *bytes;
    size_t stride;
};

/* Paints a bucket with at most so many rays per pixel. */
void bucket_paint(struct bucket *bucket, const struct scene *scene, size_t samples,
                  const struct bucket_area *area);

#endif
