/* SPDX-License-Identifier: MIT
 *
 * Writing a raster that is whole in memory.
 */
#ifndef SCARP_CLI_WHOLE_H
#define SCARP_CLI_WHOLE_H

#include "formats/writer.h"
#include "shared/crew.h"

/* Writes all rows of an open writer's raster, packed by the crew. Before `samples` there is a row
   of zeros. False if that failed, and then errno may tell why, or without memory: then errno is
   ENOMEM. */
bool writer_write_whole(struct writer *writer, struct crew *crew, const uint8_t *samples);

#endif
