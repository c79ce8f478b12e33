/* SPDX-License-Identifier: MIT
 *
 * The tiles of a run: which of them it writes, one after the other. A tile is brought to the disk
 * while the next one is made.
 */
#ifndef SCARP_CLI_JOB_H
#define SCARP_CLI_JOB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "ground/source.h"
#include "raster/surface.h"
#include "shared/crew.h"
#include "shared/progress.h"
#include "terrain/asked.h"
#include "terrain/manifest.h"
#include "terrain/products.h"
#include "terrain/sums.h"
#include "terrain/terrain_options.h"
#include "terrain/tiling.h"

struct job {
    /* Set before: */
    const struct terrain_options *options;
    const struct source *source;
    struct surface surface;      /* level 0, with all octaves */
    struct palette palette;      /* of the relief */
    struct asked asked;          /* outputs of the recipe */
    struct products products[2]; /* the same ones: of the tile at hand, and of the one before */
    struct tiling tiling;
    struct manifest manifest;
    struct sums sums; /* next to the manifest */
    struct crew *crew;

    /* What became of it: */
    size_t written;   /* tiles */
    size_t busy;      /* tiles that other runs are writing */
    uint64_t samples; /* of those written */

    /* Private to job.c: */
    struct progress progress;
    struct surface level; /* the one of the tile at hand */
    unsigned level_number;
    bool has_level;
    size_t turn; /* which products are those of the tile at hand */
    struct tile last;
    bool is_finishing; /* the tile `last` */
    bool is_finished;  /* whether that succeeded; known when it no longer goes on */
    bool is_orphan;    /* it is on the disk, but the manifest has gone */
    int sums_reason;   /* errno, if its checksums could not be kept; else 0 */
};

/* The surface that tiles of a level are of */
const struct surface *job_level(struct job *job, unsigned level);

/* Writes the tiles of this run. Returns an exit status, after a line on stderr if it is not
   CLI_SUCCESS. */
int job_run(struct job *job);

#endif
