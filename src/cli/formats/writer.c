/* SPDX-License-Identifier: MIT
 *
 * What the formats share, and the life of a raster's file.
 */
#include "formats/writer.h"

#include <errno.h>
#include <stdlib.h>

#include "shared/bounds.h"

size_t sample_bytes(enum sample_type type)
{
    switch (type) {
    case SAMPLE_U8: return 1;
    case SAMPLE_F32: return 4;
    default: return 2;
    }
}

size_t raster_row_bytes(const struct raster *raster)
{
    return raster->width * raster->channels * sample_bytes(raster->type);
}

bool writer_write_raw(struct writer *writer, const uint8_t *samples, size_t row, size_t rows)
{
    (void)row;
    const size_t bytes = rows * raster_row_bytes(&writer->raster);
    return file_write(&writer->file, samples, bytes);
}

uint64_t raster_bytes(const struct raster *raster)
{
    return (uint64_t)raster->width * raster->height * raster->channels * sample_bytes(raster->type);
}

struct parts parts_of(const struct packing *packing, const struct raster *raster)
{
    struct parts parts = {.rows = packing->part_rows(raster), .columns = raster->width};
    if (packing->part_columns != NULL) {
        parts.columns = packing->part_columns(raster);
    }
    parts.across = quotient_up(raster->width, parts.columns);
    parts.room = packing->room(raster, parts.rows);
    return parts;
}

size_t parts_count(const struct parts *parts, size_t rows)
{
    return quotient_up(rows, parts->rows) * parts->across;
}

struct part parts_at(const struct parts *parts, const struct raster *raster, const uint8_t *samples,
                     size_t first, size_t n)
{
    const size_t row = n / parts->across * parts->rows;
    const size_t column = n % parts->across * parts->columns;
    const size_t stride = raster_row_bytes(raster);
    return (struct part){
        .samples = samples + row * stride + column * (stride / raster->width),
        .row = first + row,
        .rows = smaller(parts->rows, raster->height / raster->times - first - row),
        .column = column,
        .columns = smaller(parts->columns, raster->width - column),
    };
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
