/* SPDX-License-Identifier: MIT
 *
 * PFM: floats, low byte first, which the negative scale in its header says. The bottom row comes
 * first, so the file is filled from its end.
 */
#include <stdio.h>

#include "formats/formats.h"

#define HEADER_MAX 64

static size_t make_header(const struct raster *raster, char header[HEADER_MAX])
{
    const int length = snprintf(header, HEADER_MAX, "P%c\n%zu %zu\n-1.0\n",
                                raster->channels == 1 ? 'f' : 'F', raster->width, raster->height);
    return (size_t)length;
}

static bool pfm_open(struct writer *writer)
{
    char header[HEADER_MAX];
    make_header(&writer->raster, header);
    return fputs(header, writer->file.stream) >= 0;
}

static bool pfm_write(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    char header[HEADER_MAX];
    const size_t bytes = raster_row_bytes(&writer->raster);
    const uint64_t below = writer->raster.height - row - rows;
    if (!file_seek(&writer->file, make_header(&writer->raster, header) + below * bytes)) {
        return false;
    }
    for (size_t r = rows; r-- > 0;) {
        if (fwrite(samples + r * bytes, 1, bytes, writer->file.stream) != bytes) {
            return false;
        }
    }
    return true;
}

static uint64_t pfm_bytes(const struct raster *raster)
{
    char header[HEADER_MAX];
    return make_header(raster, header) + raster_bytes(raster);
}

const struct format format_pfm = {.name = "pfm",
                                  .types = {[1] = SAMPLE_F32, [3] = SAMPLE_F32},
                                  .needs_file = true,
                                  .open = pfm_open,
                                  .write = pfm_write,
                                  .bytes = pfm_bytes};
