/* SPDX-License-Identifier: MIT
 *
 * The picture as a file: its buckets are painted by all threads, then packed and written.
 */
#ifndef SCARP_CLI_VIEW_PICTURE_H
#define SCARP_CLI_VIEW_PICTURE_H

#include "formats/writer.h"
#include "shared/crew.h"
#include "shared/progress.h"
#include "view/scene.h"

enum picture_result { PICTURE_DONE, PICTURE_NO_MEMORY, PICTURE_INTERRUPTED, PICTURE_FAILED };

/* What was done, for the closing line */
struct picture_counts {
    uint64_t rays;
    uint64_t march_calls, march_points;
    uint64_t shadow_calls, shadow_points;
    uint64_t light_calls, light_points;
};

/* How many buckets it has: what the progress counts */
uint64_t picture_buckets(const struct scene *scene);

/* Writes the picture to an open writer. After PICTURE_FAILED, errno tells why. */
enum picture_result picture_write(const struct scene *scene, size_t samples, struct writer *writer,
                                  struct crew *crew, struct progress *progress,
                                  struct picture_counts *counts);

#endif
