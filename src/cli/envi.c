/* SPDX-License-Identifier: MIT
 *
 * ENVI's raster: the samples in NAME.img, pixel by pixel, and what they are in NAME.hdr, a text.
 * GDAL opens it, with the raster's place among its neighbours.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "writer.h"

/* NAME.hdr for NAME.img, in capitals or not; for any other NAME too. */
static char *header_path(const char *path)
{
    char *const header = file_join((const char *const[]){path, ".hdr", NULL});
    const size_t length = strlen(path);
    const char *const end = length > 4 ? path + length - 4 : "";
    if (header != NULL && (strcmp(end, ".img") == 0 || strcmp(end, ".IMG") == 0)) {
        strcpy(header + length - 4, ".hdr");
    }
    return header;
}

/* The place of the raster is that of the corner of its first pixel. */
static bool write_header(FILE *stream, const struct raster *raster)
{
    return fprintf(stream,
                   "ENVI\n"
                   "description = { %s, by scarp terrain }\n"
                   "samples = %zu\n"
                   "lines = %zu\n"
                   "bands = %zu\n"
                   "header offset = 0\n"
                   "file type = ENVI Standard\n"
                   "data type = %d\n"
                   "interleave = bip\n"
                   "byte order = 0\n"
                   "map info = { Arbitrary, 1, 1, %.17g, %.17g, %.17g, %.17g }\n",
                   raster->content, raster->width, raster->height, raster->channels,
                   raster->kind == SAMPLE_U8 ? 1 : 4, raster->x - 0.5 * raster->step,
                   raster->y + 0.5 * raster->step, raster->step, raster->step) > 0;
}

static bool img_open(struct writer *writer)
{
    if (file_is_special(writer->path)) {
        errno = ESPIPE; /* a device has no place for a header beside it */
        return false;
    }
    char *const path = header_path(writer->path);
    const bool opened = path != NULL && file_open(&writer->header, path) &&
                        write_header(writer->header.stream, &writer->raster);
    free(path);
    return opened;
}

#define KINDS (SAMPLE_U8 | SAMPLE_F32)
const struct format format_img = {.name = "img",
                                  .kinds = {0, KINDS, KINDS, KINDS},
                                  .needs_file = true,
                                  .header_path = header_path,
                                  .open = img_open,
                                  .write = writer_write_raw};
