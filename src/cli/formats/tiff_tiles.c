/* SPDX-License-Identifier: MIT
 *
 * Packs the tiles of a TIFF, and writes them: with zlib, what a pixel differs from its neighbour by, deflated;
 * without, the samples as they are.
 */
#include <stdlib.h>
#include <string.h>
#ifdef SCARP_CLI_ZLIB
#include <zlib.h>
#endif

#include "formats/tiff.h"

#define PIXEL_MOST (MAX_CHANNELS * sizeof(float))
#define ROW_MOST (TIFF_SIDE * PIXEL_MOST)

#ifdef SCARP_CLI_ZLIB
#define COMPRESSION_LEVEL 4 /* of 1 to 9 */
#endif

struct tiff_packer {
    uint8_t row[ROW_MOST], filtered[ROW_MOST];
#ifdef SCARP_CLI_ZLIB
    z_stream stream;
#endif
};

static size_t pixel_bytes(const struct raster *raster)
{
    return raster->channels * sample_bytes(raster->type);
}

size_t tiff_room(const struct raster *raster)
{
    const size_t bytes = (size_t)TIFF_SIDE * TIFF_SIDE * pixel_bytes(raster);
    return TIFF_DEFLATES ? bytes + bytes / 8 + 64 : bytes;
}

static size_t room(const struct raster *raster, size_t rows)
{
    (void)rows;
    return tiff_room(raster);
}

static size_t side(const struct raster *raster)
{
    (void)raster;
    return TIFF_SIDE;
}

static void *open_packer(void)
{
    struct tiff_packer *const packer = calloc(1, sizeof *packer);
#ifdef SCARP_CLI_ZLIB
    if (packer != NULL && deflateInit(&packer->stream, COMPRESSION_LEVEL) != Z_OK) {
        free(packer);
        return NULL;
    }
#endif
    return packer;
}

static void close_packer(void *opaque)
{
    struct tiff_packer *const packer = opaque;
#ifdef SCARP_CLI_ZLIB
    deflateEnd(&packer->stream);
#endif
    free(packer);
}

/* Row `row` of a tile, whole: beyond the raster it goes on with the last pixel and the last row. */
static void take_row(struct tiff_packer *packer, const struct raster *raster,
                     const struct part *part, size_t row)
{
    const size_t pixel = pixel_bytes(raster);
    const size_t last = part->rows - 1;
    const uint8_t *const from =
        part->samples + (row < last ? row : last) * raster_row_bytes(raster);
    memcpy(packer->row, from, part->columns * pixel);
    for (size_t i = part->columns; i < TIFF_SIDE; i++) {
        memcpy(packer->row + i * pixel, packer->row + (i - 1) * pixel, pixel);
    }
}

#ifdef SCARP_CLI_ZLIB

/* Predictor 2 of bytes: what each differs by from that of the pixel before */
static void subtract_bytes(const uint8_t *from, size_t count, size_t stride, uint8_t *to)
{
    memcpy(to, from, stride);
    for (size_t i = stride; i < count; i++) {
        to[i] = (uint8_t)(from[i] - from[i - stride]);
    }
}

/* Predictor 2 of 16-bit integers, low byte first */
static void subtract_integers(const uint8_t *from, size_t count, size_t stride, uint8_t *to)
{
    memcpy(to, from, 2 * stride);
    for (size_t i = stride; i < count; i++) {
        const unsigned one = from[2 * i] | (unsigned)from[2 * i + 1] << 8;
        const unsigned before = from[2 * (i - stride)] | (unsigned)from[2 * (i - stride) + 1] << 8;
        to[2 * i] = (uint8_t)(one - before);
        to[2 * i + 1] = (uint8_t)((one - before) >> 8);
    }
}

/* Predictor 3 of floats: all highest bytes of the row, then all that follow these, and so on; then
   as predictor 2. The row is taken for the order. */
static void subtract_floats(uint8_t *row, size_t count, size_t stride, uint8_t *to)
{
    for (size_t byte = 0; byte < 4; byte++) {
        for (size_t i = 0; i < count; i++) {
            to[(3 - byte) * count + i] = row[4 * i + byte];
        }
    }
    memcpy(row, to, 4 * count);
    subtract_bytes(row, 4 * count, stride, to);
}

static void filter(struct tiff_packer *packer, const struct raster *raster)
{
    const size_t count = TIFF_SIDE * raster->channels;
    switch (raster->type) {
    case SAMPLE_U8: subtract_bytes(packer->row, count, raster->channels, packer->filtered); break;
    case SAMPLE_F32: subtract_floats(packer->row, count, raster->channels, packer->filtered); break;
    default: subtract_integers(packer->row, count, raster->channels, packer->filtered); break;
    }
}

/* Sets part->size; it stays 0 if the tile does not fit, which tiff_room rules out. */
static void pack(void *opaque, const struct raster *raster, struct part *part)
{
    struct tiff_packer *const packer = opaque;
    z_stream *const stream = &packer->stream;
    const size_t most = tiff_room(raster);
    part->size = 0;
    deflateReset(stream);
    stream->next_out = part->bytes;
    stream->avail_out = (uInt)most;
    for (size_t row = 0; row < TIFF_SIDE; row++) {
        const bool is_last = row == TIFF_SIDE - 1;
        take_row(packer, raster, part, row);
        filter(packer, raster);
        stream->next_in = packer->filtered;
        stream->avail_in = (uInt)(TIFF_SIDE * pixel_bytes(raster));
        const int status = deflate(stream, is_last ? Z_FINISH : Z_NO_FLUSH);
        if (status != (is_last ? Z_STREAM_END : Z_OK) || stream->avail_in != 0) {
            return;
        }
    }
    part->size = most - stream->avail_out;
}

#else

static void pack(void *opaque, const struct raster *raster, struct part *part)
{
    struct tiff_packer *const packer = opaque;
    const size_t bytes = TIFF_SIDE * pixel_bytes(raster);
    for (size_t row = 0; row < TIFF_SIDE; row++) {
        take_row(packer, raster, part, row);
        memcpy(part->bytes + row * bytes, packer->row, bytes);
    }
    part->size = TIFF_SIDE * bytes;
}

#endif

static bool write_tile(struct writer *writer, const struct part *part)
{
    struct tiff_tiles *const tiles = writer->memory;
    tiles->sizes[tiles->count++] = (uint32_t)part->size;
    tiles->end += part->size;
    return file_write(&writer->file, part->bytes, part->size);
}

const struct packing tiff_packing = {
    .part_rows = side,
    .part_columns = side,
    .room = room,
    .open = open_packer,
    .close = close_packer,
    .pack = pack,
    .write = write_tile,
};
