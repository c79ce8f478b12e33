/* SPDX-License-Identifier: MIT
 *
 * R16 and R32: the samples and nothing else, low byte first, as terrain programs import them.
 * Whoever reads them has to know width and height.
 */
#include "formats/formats.h"

static bool raw_open(struct writer *writer)
{
    (void)writer;
    return true;
}

const struct format format_r16 = {.name = "r16",
                                  .types = {[1] = SAMPLE_U16_LOW},
                                  .open = raw_open,
                                  .write = writer_write_raw,
                                  .bytes = raster_bytes};
const struct format format_r32 = {.name = "r32",
                                  .types = {[1] = SAMPLE_F32},
                                  .open = raw_open,
                                  .write = writer_write_raw,
                                  .bytes = raster_bytes};
