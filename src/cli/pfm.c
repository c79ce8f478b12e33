/* SPDX-License-Identifier: MIT
 *
 * PFM: floats, low byte first, which the negative scale in its header says. The bottom row comes
 * first, so the file is filled from its end.
 */
#include <stdio.h>
#include <stdlib.h>

#include "writer.h"

/* The bytes before the bottom row are all that is remembered. */
static bool pfm_open(struct writer *writer)
{
    const struct raster *const raster = &writer->raster;
    size_t *const header = malloc(sizeof *header);
    writer->state = header;
    if (header == NULL) {
        return false;
    }
    const int written = fprintf(writer->file.stream, "P%c\n%zu %zu\n-1.0\n",
                                raster->channels == 1 ? 'f' : 'F', raster->width, raster->height);
    *header = written > 0 ? (size_t)written : 0;
    return written > 0;
}

static bool pfm_write(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    const size_t bytes = writer_row_bytes(writer);
    const uint64_t below = writer->raster.height - row - rows;
    if (!file_seek(&writer->file, *(const size_t *)writer->state + below * bytes)) {
        return false;
    }
    for (size_t r = rows; r-- > 0;) {
        if (fwrite(samples + r * bytes, 1, bytes, writer->file.stream) != bytes) {
            return false;
        }
    }
    return true;
}

static bool pfm_close(struct writer *writer, bool complete)
{
    (void)complete;
    free(writer->state);
    writer->state = NULL;
    return true;
}

const struct format format_pfm = {.name = "pfm",
                                  .kinds = {[1] = SAMPLE_F32, [3] = SAMPLE_F32},
                                  .needs_file = true,
                                  .open = pfm_open,
                                  .write = pfm_write,
                                  .close = pfm_close};
