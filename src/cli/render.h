/* SPDX-License-Identifier: MIT
 *
 * From a noise to rows of picture samples: heights, normals, hillshade, and normals from the
 * gradient beside those from differences of heights. Included by terrain.c.
 *
 * Column c and row r of the pictures look at x = origin.x + c * step and
 * y = origin.y + (height - 1 - r) * step: x grows to the right and y upward, as on a map, and
 * origin is the bottom left sample.
 */
#ifndef SCARP_CLI_RENDER_H
#define SCARP_CLI_RENDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "options.h"
#include "scarp.h"

struct render {
    struct scarp_noise noise;
    struct option_size size;
    struct option_point origin;
    double step;
    float height_scale;
    float lowest, highest; /* the range of the noise */
    size_t threads;        /* at least 1 */
    size_t compare; /* pixels per sample, across and down, in render_compare; 0: never called */

    /* Buffers for `rows` rows: */
    size_t rows;
    float *value, *dx, *dy, *nx, *ny, *nz;
    float *differences_x, *differences_y, *differences_z; /* if `compare`: normals by differences */
    uint8_t *samples;                                     /* one row of the widest picture */

    double sampling_seconds;
};

/* Allocates the buffers. False without memory. */
bool render_open(struct render *render);
void render_close(struct render *render);

#define RENDER_THREADS_MAX 1024

/* How many threads there are: 1 without OpenMP. */
size_t render_threads(void);

/* Samples `rows` rows from `row` on, at most render->rows, and makes their normals. */
void render_block(struct render *render, size_t row, size_t rows);

/* One row of a picture, `row` counted from the start of the block. They return render->samples. */
typedef const uint8_t *render_row_fn(const struct render *render, size_t row);
render_row_fn render_heights;   /* 16 bits, high byte first */
render_row_fn render_normals;   /* 3 times 8 bits */
render_row_fn render_hillshade; /* 8 bits */
render_row_fn render_compare;   /* 3 times 8 bits, 2 * compare pixels per sample */

double render_seconds(void); /* a clock */

#endif
