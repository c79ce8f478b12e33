/* SPDX-License-Identifier: MIT
 *
 * GeoTIFF: tiles of 256 x 256 pixels, each packed by itself (tiff_tiles.c), then the list of where
 * they are. A file that may need more than 32-bit offsets is a BigTIFF.
 *
 * It is written here and not by libtiff, since threads pack tiles side by side, bands of rows are
 * all that is in memory, and the program needs no library for it. The tags are those of TIFF 6.0,
 * its supplements on tiles, Deflate and predictors, and of OGC GeoTIFF 1.1.
 */
#include "formats/tiff.h"

#include <stdlib.h>
#include <string.h>

#include "formats/formats.h"
#include "shared/bounds.h"
#include "shared/posix.h"

static uint64_t count_tiles(const struct raster *raster)
{
    return (uint64_t)quotient_up(raster->width, TIFF_SIDE) * quotient_up(raster->height, TIFF_SIDE);
}

enum type { ASCII = 2, SHORT = 3, LONG = 4, DOUBLE = 12, LONG8 = 16 };

#define DIRECTORY_MOST 1024
#define EXTRA_MOST 512

/* What follows the tiles: long values, then the directory, whose entries are sorted by their tags,
   and which ends the file */
struct directory {
    bool is_big;
    uint64_t
        offsets; /* where the list of the tiles' offsets is, and after it that of their sizes */
    uint64_t at; /* where `extra` begins */
    uint8_t entries[DIRECTORY_MOST], extra[EXTRA_MOST];
    size_t count, extra_size;
};

static void put(uint8_t *to, uint64_t number, size_t bytes)
{
    for (size_t i = 0; i < bytes; i++) {
        to[i] = (uint8_t)(number >> 8 * i);
    }
}

static uint64_t get(const uint8_t *from, size_t bytes)
{
    uint64_t number = 0;
    for (size_t i = bytes; i > 0; i--) {
        number = number << 8 | from[i - 1];
    }
    return number;
}

static size_t type_bytes(enum type type)
{
    switch (type) {
    case ASCII: return 1;
    case SHORT: return 2;
    case LONG: return 4;
    default: return 8;
    }
}

/* Whether offsets may not fit into 32 bits. It depends only on the raster. */
static bool is_big(const struct raster *raster)
{
    return count_tiles(raster) * (tiff_room(raster) + 16) + DIRECTORY_MOST + EXTRA_MOST >
           UINT32_MAX;
}

static size_t offset_bytes(bool is_big)
{
    return is_big ? 8 : 4;
}

static size_t header_bytes(bool is_big)
{
    return is_big ? 16 : 8;
}

static size_t entry_bytes(bool is_big)
{
    return is_big ? 20 : 12;
}

/* An entry whose values are `value`, or lie at that offset if they are too long */
static void add(struct directory *directory, unsigned tag, enum type type, uint64_t count,
                uint64_t value)
{
    const size_t size = offset_bytes(directory->is_big);
    uint8_t *const to = directory->entries + directory->count++ * entry_bytes(directory->is_big);
    put(to, tag, 2);
    put(to + 2, (uint64_t)type, 2);
    put(to + 4, count, size);
    put(to + 4 + size, value, size);
}

/* An entry with its values, in bytes as the file has them */
static void add_values(struct directory *directory, unsigned tag, enum type type, size_t count,
                       const uint8_t *bytes)
{
    const size_t size = count * type_bytes(type);
    if (size <= offset_bytes(directory->is_big)) {
        add(directory, tag, type, count, get(bytes, size));
        return;
    }
    add(directory, tag, type, count, directory->at + directory->extra_size);
    memcpy(directory->extra + directory->extra_size, bytes, size);
    directory->extra_size += size + size % 2;
}

static void add_shorts(struct directory *directory, unsigned tag, size_t count,
                       const uint16_t *values)
{
    uint8_t bytes[2 * 16];
    for (size_t i = 0; i < count; i++) {
        put(bytes + 2 * i, values[i], 2);
    }
    add_values(directory, tag, SHORT, count, bytes);
}

static void add_doubles(struct directory *directory, unsigned tag, size_t count,
                        const double *values)
{
    uint8_t bytes[8 * 6];
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        put(bytes + 8 * i, bits, 8);
    }
    add_values(directory, tag, DOUBLE, count, bytes);
}

static void add_short(struct directory *directory, unsigned tag, uint16_t value)
{
    add(directory, tag, SHORT, 1, value);
}

/* As many of the same short as there are channels */
static void add_per_channel(struct directory *directory, unsigned tag, size_t count, unsigned value)
{
    uint16_t values[MAX_CHANNELS];
    for (size_t i = 0; i < count; i++) {
        values[i] = (uint16_t)value;
    }
    add_shorts(directory, tag, count, values);
}

/* A place in the file that lists of `bytes` fill: in the entry itself if there is one tile */
static void add_list(struct directory *directory, unsigned tag, enum type type, uint64_t count,
                     uint64_t at, uint64_t only)
{
    add(directory, tag, type, count, count == 1 ? only : at);
}

/* The corner of the first pixel, and the system of coordinates */
static void add_place(struct directory *directory, const struct raster *raster)
{
    const double scale[3] = {raster->step, raster->step, 0.0};
    const double corner[6] = {
        0.0, 0.0, 0.0, raster->x - 0.5 * raster->step, raster->y + 0.5 * raster->step, 0.0};
    /* The version and the number of keys, then: projected; pixels are areas; the system */
    const uint16_t keys[16] = {1,    1, 0, 3, 1024, 0, 1, 1,
                               1025, 0, 1, 1, 3072, 0, 1, (uint16_t)raster->epsg};
    add_doubles(directory, 33550, 3, scale);
    add_doubles(directory, 33922, 6, corner);
    if (raster->epsg != 0) {
        add_shorts(directory, 34735, 16, keys);
    }
}

static void fill_directory(struct directory *directory, const struct raster *raster,
                           const struct tiff_tiles *tiles)
{
    const bool is_colour = raster->channels >= 3 && raster->type == SAMPLE_U8;
    const size_t extra = raster->channels - (is_colour ? 3 : 1);
    const size_t size = offset_bytes(directory->is_big);
    add(directory, 256, LONG, 1, raster->width);
    add(directory, 257, LONG, 1, raster->height);
    add_per_channel(directory, 258, raster->channels, 8 * (unsigned)sample_bytes(raster->type));
    add_short(directory, 259, TIFF_DEFLATES ? 8 : 1);
    add_short(directory, 262, is_colour ? 2 : 1);
    add_values(directory, 270, ASCII, strlen(raster->content) + 1,
               (const uint8_t *)raster->content);
    add_short(directory, 277, (uint16_t)raster->channels);
    add_short(directory, 284, 1);
    if (TIFF_DEFLATES) {
        add_short(directory, 317, raster->type == SAMPLE_F32 ? 3 : 2);
    }
    add_short(directory, 322, TIFF_SIDE);
    add_short(directory, 323, TIFF_SIDE);
    add_list(directory, 324, directory->is_big ? LONG8 : LONG, tiles->count, directory->offsets,
             header_bytes(directory->is_big));
    add_list(directory, 325, LONG, tiles->count, directory->offsets + tiles->count * size,
             tiles->sizes[0]);
    if (extra > 0) {
        add_per_channel(directory, 338, extra, 0);
    }
    add_per_channel(directory, 339, raster->channels, raster->type == SAMPLE_F32 ? 3 : 1);
    add_place(directory, raster);
}

static bool write_number(struct writer *writer, uint64_t number, size_t bytes)
{
    uint8_t to[8];
    put(to, number, bytes);
    return file_write(&writer->file, to, bytes);
}

/* The offsets of all tiles, then their sizes */
static bool write_lists(struct writer *writer, const struct tiff_tiles *tiles, bool big)
{
    uint64_t offset = header_bytes(big);
    for (uint64_t i = 0; i < tiles->count; i++) {
        if (!write_number(writer, offset, offset_bytes(big))) {
            return false;
        }
        offset += tiles->sizes[i];
    }
    for (uint64_t i = 0; i < tiles->count; i++) {
        if (!write_number(writer, tiles->sizes[i], 4)) {
            return false;
        }
    }
    return true;
}

static bool write_directory(struct writer *writer, const struct directory *directory)
{
    const size_t size = offset_bytes(directory->is_big);
    return file_write(&writer->file, directory->extra, directory->extra_size) &&
           write_number(writer, directory->count, directory->is_big ? 8 : 2) &&
           file_write(&writer->file, directory->entries,
                      directory->count * entry_bytes(directory->is_big)) &&
           write_number(writer, 0, size); /* no other directory follows */
}

/* The place of the directory is written at the end. */
static bool write_header(struct writer *writer, uint64_t directory)
{
    const bool big = is_big(&writer->raster);
    uint8_t header[16] = {'I', 'I', big ? 43 : 42};
    if (big) {
        header[4] = 8; /* bytes of an offset */
    }
    put(header + (big ? 8 : 4), directory, offset_bytes(big));
    return file_write(&writer->file, header, header_bytes(big));
}

static bool tiff_open(struct writer *writer)
{
    const uint64_t tiles = count_tiles(&writer->raster);
    if (tiles > (SIZE_MAX - sizeof(struct tiff_tiles)) / sizeof(uint32_t)) {
        return false;
    }
    struct tiff_tiles *const list = malloc(sizeof *list + (size_t)tiles * sizeof list->sizes[0]);
    writer->memory = list;
    if (list == NULL) {
        return false;
    }
    list->count = 0;
    list->end = header_bytes(is_big(&writer->raster));
    return write_header(writer, 0);
}

static bool tiff_end(struct writer *writer)
{
    const struct tiff_tiles *const tiles = writer->memory;
    const bool big = is_big(&writer->raster);
    const size_t padding = (size_t)(tiles->end % 2); /* lists begin at even bytes */
    struct directory directory = {.is_big = big, .offsets = tiles->end + padding};
    directory.at = directory.offsets + tiles->count * (offset_bytes(big) + 4);
    fill_directory(&directory, &writer->raster, tiles);
    return file_write(&writer->file, "", padding) && write_lists(writer, tiles, big) &&
           write_directory(writer, &directory) && file_seek(&writer->file, 0) &&
           write_header(writer, directory.at + directory.extra_size);
}

/* Whether the directory ends the file, and is of a raster of this size. */
static bool directory_is_whole(const struct raster *raster, FILE *file, uint64_t size)
{
    uint8_t header[16], count[8], entries[2 * 20];
    const bool big = is_big(raster);
    const size_t counts = big ? 8 : 2, entry = entry_bytes(big), offset = offset_bytes(big);
    if (fread(header, 1, sizeof header, file) != sizeof header || header[0] != 'I' ||
        header[2] != (big ? 43 : 42)) {
        return false;
    }
    const uint64_t at = get(header + (big ? 8 : 4), offset);
    if (at > size || fseeko(file, (off_t)at, SEEK_SET) != 0 ||
        fread(count, 1, counts, file) != counts || fread(entries, entry, 2, file) != 2) {
        return false;
    }
    return at + counts + get(count, counts) * entry + offset == size &&
           get(entries + entry - offset, offset) == raster->width &&
           get(entries + 2 * entry - offset, offset) == raster->height;
}

static bool tiff_is_whole(const struct raster *raster, const char *path)
{
    uint64_t size;
    struct file_time time;
    FILE *const file = file_look(path, &size, &time) ? fopen(path, "rb") : NULL;
    const bool is_whole = file != NULL && directory_is_whole(raster, file, size);
    if (file != NULL) {
        fclose(file);
    }
    return is_whole;
}

#define TYPES (SAMPLE_U8 | SAMPLE_U16_LOW | SAMPLE_F32)
const struct format format_tif = {
    .name = "tif",
    .types = {0, TYPES, TYPES, TYPES},
    .needs_file = true,
    .overview = ".ovr",
    .open = tiff_open,
    .packing = &tiff_packing,
    .end = tiff_end,
    .is_whole = tiff_is_whole,
};
