/* SPDX-License-Identifier: MIT
 *
 * PGM and PPM in their binary forms (P5, P6): a header in text, then the samples, 16-bit ones with
 * the high byte first. Every image program reads them, and nothing but libc is needed.
 */
#include <stdio.h>

#include "writer.h"

static bool pnm_open(struct writer *writer)
{
    const struct raster *const raster = &writer->raster;
    return fprintf(writer->file.stream, "P%c\n%zu %zu\n%d\n", raster->channels == 1 ? '5' : '6',
                   raster->width, raster->height, raster->kind == SAMPLE_U8 ? 255 : 65535) > 0;
}

const struct format format_pgm = {.name = "pgm",
                                  .kinds = {[1] = SAMPLE_U8 | SAMPLE_U16_HIGH},
                                  .open = pnm_open,
                                  .write = writer_write_raw};
const struct format format_ppm = {
    .name = "ppm", .kinds = {[3] = SAMPLE_U8}, .open = pnm_open, .write = writer_write_raw};
