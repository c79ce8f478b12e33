/* SPDX-License-Identifier: MIT
 *
 * What the formats share: the list of them, and the life of a raster's file.
 */
#include "writer.h"

#include <errno.h>
#include <stdlib.h>

const struct format *const writer_formats[] = {
#ifdef SCARP_CLI_PNG
    &format_png,
#endif
    &format_pgm, &format_ppm, &format_r16, &format_r32, &format_pfm, &format_img, &format_npy, NULL,
};

size_t sample_bytes(enum sample_kind kind)
{
    switch (kind) {
    case SAMPLE_U8: return 1;
    case SAMPLE_F32: return 4;
    default: return 2;
    }
}

size_t writer_row_bytes(const struct writer *writer)
{
    return writer->raster.width * writer->raster.channels * sample_bytes(writer->raster.kind);
}

bool writer_write_raw(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    (void)row;
    const size_t bytes = rows * writer_row_bytes(writer);
    return file_write(&writer->file, samples, bytes);
}

bool writer_open(struct writer *writer)
{
    if (!file_open(&writer->file, writer->path)) {
        return false;
    }
    if (writer->format->needs_file && !file_seek(&writer->file, 0)) {
        return false;
    }
    errno = 0;
    return writer->format->open(writer);
}

bool writer_exists(const struct format *format, const char *path)
{
    char *const header = format->header_path != NULL ? format->header_path(path) : NULL;
    const bool complete = file_exists(path) &&
                          (format->header_path == NULL || (header != NULL && file_exists(header)));
    free(header);
    return complete;
}

bool writer_write(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    return writer->format->write(writer, samples, row, rows);
}

bool writer_close(struct writer *writer)
{
    const struct format *const format = writer->format;
    return (format->close == NULL || format->close(writer, true)) && file_close(&writer->header) &&
           file_close(&writer->file);
}

bool writer_publish(struct writer *writer)
{
    /* The header first: whoever sees the file then sees its header too. */
    return file_publish(&writer->header) && file_publish(&writer->file);
}

void writer_discard(struct writer *writer)
{
    const int reason = errno;
    if (writer->format != NULL && writer->format->close != NULL) {
        writer->format->close(writer, false);
    }
    file_discard(&writer->header);
    file_discard(&writer->file);
    errno = reason;
}
