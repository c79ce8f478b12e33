/* SPDX-License-Identifier: MIT
 *
 * ENVI's raster: the samples in NAME.img, pixel by pixel, and what they are in NAME.hdr, a text.
 * GDAL opens it, with the raster's place among its neighbours.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/formats.h"
#include "shared/posix.h"
#include "shared/text.h"

/* NAME.hdr for NAME.img, in capitals or not; for any other NAME too. */
static char *header_path(const char *path)
{
    const size_t length = strlen(path);
    const char *const end = length > 4 ? path + length - 4 : "";
    const bool replaces = strcmp(end, ".img") == 0 || strcmp(end, ".IMG") == 0;
    return text_join_part(path, replaces ? length - 4 : length, ".hdr");
}

bool img_knows(unsigned epsg)
{
    const unsigned zone = epsg % 100;
    return (epsg / 100 == 326 || epsg / 100 == 327) && zone >= 1 && zone <= 60;
}

#define HEADER_MAX 512

#define SYSTEM_MAX 48

/* ENVI's name of a system of coordinates, and what follows the place. It knows EPSG's numbers only
   by what they stand for, of which zones of UTM on WGS 84 are known here: 32601 to 32660 in the
   north, 32701 to 32760 in the south. */
static const char *describe_system(unsigned epsg, char more[SYSTEM_MAX])
{
    more[0] = '\0';
    if (!img_knows(epsg)) {
        return "Arbitrary";
    }
    snprintf(more, SYSTEM_MAX, ", %u, %s, WGS-84, units=Meters", epsg % 100,
             epsg < 32700 ? "North" : "South");
    return "UTM";
}

/* The place of the raster is that of the corner of its first pixel. */
static void make_header(const struct raster *raster, char header[HEADER_MAX])
{
    char more[SYSTEM_MAX];
    const char *const system = describe_system(raster->epsg, more);
    snprintf(header, HEADER_MAX,
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
             "map info = { %s, 1, 1, %.17g, %.17g, %.17g, %.17g%s }\n",
             raster->content, raster->width, raster->height, raster->channels,
             raster->type == SAMPLE_U8 ? 1 : 4, system, raster->x - 0.5 * raster->step,
             raster->y + 0.5 * raster->step, raster->step, raster->step, more);
}

static bool img_open(struct writer *writer)
{
    if (file_is_special(writer->path)) {
        errno = ESPIPE; /* a device has no place for a header next to it */
        return false;
    }
    char header[HEADER_MAX];
    make_header(&writer->raster, header);
    char *const path = header_path(writer->path);
    const bool opened = path != NULL && file_open(&writer->header, path) &&
                        fputs(header, writer->header.stream) >= 0;
    free(path);
    return opened;
}

/* Whether the file `path` holds what `text` says and nothing else */
static bool holds(const char *path, const char *text)
{
    char bytes[HEADER_MAX];
    FILE *const file = path != NULL ? fopen(path, "rb") : NULL;
    if (file == NULL) {
        return false;
    }
    const size_t length = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    return length == strlen(text) && memcmp(bytes, text, length) == 0;
}

static bool img_is_whole(const struct raster *raster, const char *path)
{
    char header[HEADER_MAX];
    make_header(raster, header);
    char *const beside = header_path(path);
    const bool whole = holds(beside, header);
    free(beside);
    return whole;
}

#define TYPES (SAMPLE_U8 | SAMPLE_F32)
const struct format format_img = {.name = "img",
                                  .types = {0, TYPES, TYPES, TYPES},
                                  .needs_file = true,
                                  .open = img_open,
                                  .write = writer_write_raw,
                                  .beside = header_path,
                                  .bytes = raster_bytes,
                                  .is_whole = img_is_whole};
