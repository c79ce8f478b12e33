/* SPDX-License-Identifier: MIT
 *
 * What the formats share, and the life of a raster's file.
 */
#include "formats/writer.h"

#include <errno.h>
#include <stdlib.h>

size_t sample_bytes(enum sample_kind kind)
{
    switch (kind) {
    case SAMPLE_U8: return 1;
    case SAMPLE_F32: return 4;
    default: return 2;
    }
}

size_t raster_row_bytes(const struct raster *raster)
{
    return raster->width * raster->channels * sample_bytes(raster->kind);
}

bool writer_write_raw(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    (void)row;
    const size_t bytes = rows * raster_row_bytes(&writer->raster);
    return file_write(&writer->file, samples, bytes);
}

uint64_t raster_bytes(const struct raster *raster)
{
    return (uint64_t)raster->width * raster->height * raster->channels * sample_bytes(raster->kind);
}

size_t packing_columns(const struct packing *packing, const struct raster *raster)
{
    return packing->part_columns != NULL ? packing->part_columns(raster) : raster->width;
}

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

void part_fit(struct part *part, const struct raster *raster, const uint8_t *samples, size_t first)
{
    const size_t pixel = raster_row_bytes(raster) / raster->width;
    part->rows = smaller(part->rows, raster->height / raster->times - part->row);
    part->columns = smaller(part->columns, raster->width - part->column);
    part->samples = samples + (part->row - first) * raster_row_bytes(raster) + part->column * pixel;
}

uint64_t writer_bytes(const struct writer *writer, bool *is_exact)
{
    const struct format *const format = writer->format;
    *is_exact = format->bytes != NULL;
    return *is_exact ? format->bytes(&writer->raster) : raster_bytes(&writer->raster);
}

bool writer_open(struct writer *writer)
{
    if (!(writer->makes_directories ? file_open_making_directories(&writer->file, writer->path)
                                    : file_open(&writer->file, writer->path))) {
        return false;
    }
    if (writer->format->needs_file && !file_seek(&writer->file, 0)) {
        return false;
    }
    errno = 0;
    return writer->format->open(writer);
}

bool writer_is_there(const struct writer *writer, struct file_time since)
{
    const struct format *const format = writer->format;
    const struct raster *const raster = &writer->raster;
    uint64_t size;
    struct file_time time;
    return file_look(writer->path, &size, &time) && !file_is_older(time, since) &&
           (format->bytes == NULL || size == format->bytes(raster)) &&
           (format->is_whole == NULL || format->is_whole(raster, writer->path));
}

bool writer_is_same(const struct writer *a, const struct writer *b)
{
    return file_is_same(&a->file, &b->file) || file_is_same(&a->header, &b->header) ||
           file_is_same(&a->file, &b->header) || file_is_same(&a->header, &b->file);
}

bool writer_write(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    return writer->format->write(writer, samples, row, rows);
}

bool writer_write_part(struct writer *writer, const struct part *part)
{
    if (part->size == 0) {
        errno = EIO;
        return false;
    }
    return writer->format->packing->write(writer, part);
}

bool writer_close(struct writer *writer)
{
    const struct format *const format = writer->format;
    return (format->end == NULL || format->end(writer)) && file_close(&writer->header) &&
           file_close(&writer->file);
}

bool writer_publish(struct writer *writer)
{
    /* The header first: whoever sees the file then sees its header too. */
    return file_publish(&writer->header) && file_publish(&writer->file);
}

void writer_retract(struct writer *writer)
{
    file_retract(&writer->file);
    file_retract(&writer->header);
}

bool writer_settle(const struct writer *writer)
{
    return file_settle(&writer->file); /* the header is in the same directory */
}

void writer_discard(struct writer *writer)
{
    const int reason = errno;
    file_discard(&writer->header);
    file_discard(&writer->file);
    free(writer->memory);
    writer->memory = NULL;
    errno = reason;
}
