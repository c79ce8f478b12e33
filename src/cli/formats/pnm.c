/* SPDX-License-Identifier: MIT
 *
 * PGM and PPM in their binary forms (P5, P6): a header in text, then the samples, 16-bit ones with
 * the high byte first. Every image program reads them, and nothing but libc is needed.
 */
#include <stdio.h>

#include "formats/formats.h"

#define HEADER_MAX 64

static int make_header(const struct raster *raster, char header[HEADER_MAX])
{
    return snprintf(header, HEADER_MAX, "P%c\n%zu %zu\n%d\n", raster->channels == 1 ? '5' : '6',
                    raster->width, raster->height, raster->type == SAMPLE_U8 ? 255 : 65535);
}

static bool pnm_open(struct writer *writer)
{
    char header[HEADER_MAX];
    make_header(&writer->raster, header);
    return fputs(header, writer->file.stream) >= 0;
}

static uint64_t pnm_bytes(const struct raster *raster)
{
    char header[HEADER_MAX];
    return (uint64_t)make_header(raster, header) + raster_bytes(raster);
}

const struct format format_pgm = {.name = "pgm",
                                  .types = {[1] = SAMPLE_U8 | SAMPLE_U16_HIGH},
                                  .open = pnm_open,
                                  .write = writer_write_raw,
                                  .bytes = pnm_bytes};
const struct format format_ppm = {.name = "ppm",
                                  .types = {[3] = SAMPLE_U8},
                                  .open = pnm_open,
                                  .write = writer_write_raw,
                                  .bytes = pnm_bytes};
