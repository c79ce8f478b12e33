/* SPDX-License-Identifier: MIT
 *
 * Fills the files of a tile in bounded memory: band after band of rows, each sampled and encoded
 * by all threads while the one before is being written.
 */
#ifndef SCARP_CLI_PIPELINE_H
#define SCARP_CLI_PIPELINE_H

#include "raster/surface.h"
#include "shared/crew.h"
#include "shared/progress.h"
#include "terrain/products.h"

enum pipeline_result {
    PIPELINE_DONE,
    PIPELINE_FAILED, /* a file could not be written: its `failed` is set */
    PIPELINE_INTERRUPTED,
    PIPELINE_NO_MEMORY,
    PIPELINE_NOT_OPENED /* not of pipeline_run: a file could not be opened */
};

/* Nothing of the files depends on the crew. */
enum pipeline_result pipeline_run(const struct surface *surface, const struct tile *tile,
                                  struct products *products, struct crew *crew,
                                  struct progress *progress);

#endif
