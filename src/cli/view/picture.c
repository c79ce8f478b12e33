/* SPDX-License-Identifier: MIT
 *
 * Bands of buckets. Threads paint the buckets of a band, then pack its rows, if the format packs; the
 * first thread writes them. Most pictures are one band.
 *
 * Memory: a band and what it is packed to, BAND_BYTES each unless one row of buckets is more; one
 * bucket and one packer per thread.
 */
#include "view/picture.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "shared/bounds.h"
#include "shared/interrupt.h"
#include "view/bucket.h"

#define BAND_BYTES ((size_t)24 << 20)

struct picture {
    const struct scene *scene;
    size_t samples;
    struct writer *writer;
    struct crew *crew;
    struct progress *progress;

    size_t rows, stride;           /* of a band, and bytes of a row */
    uint8_t *memory, *bytes;       /* those of the band, after the row above it */
    const struct packing *packing; /* NULL: rows go to the file as they are; else: */
    struct parts way;              /* how the raster falls into parts */
    struct part *part;
    uint8_t *packed;
    size_t wanted, threads; /* threads that there is work for, and memory */
    struct bucket **bucket;
    void **packer;

    size_t row; /* where the band begins */
    enum picture_result result;
    int reason; /* errno of what failed */
};

uint64_t picture_buckets(const struct scene *scene)
{
    return (uint64_t)quotient_up(scene->camera.width, BUCKET_WIDTH) *
           quotient_up(scene->camera.height, BUCKET_HEIGHT);
}

/* A thread without memory is done without, unless it is the only one. */
static bool open_threads(struct picture *picture)
{
    const size_t wanted = picture->wanted;
    picture->bucket = calloc(wanted, sizeof *picture->bucket);
    picture->packer = calloc(wanted, sizeof *picture->packer);
    if (picture->bucket == NULL || picture->packer == NULL) {
        return false;
    }
    for (size_t i = 0; i < wanted; i++) {
        picture->bucket[i] = bucket_open();
        picture->packer[i] = picture->packing != NULL ? picture->packing->open() : NULL;
        if (picture->bucket[i] == NULL ||
            (picture->packing != NULL && picture->packer[i] == NULL)) {
            break;
        }
        picture->threads++;
    }
    return picture->threads > 0;
}

static bool open_picture(struct picture *picture)
{
    const struct raster *const raster = &picture->writer->raster;
    picture->packing = picture->writer->format->packing;
    picture->stride = raster_row_bytes(raster);
    const size_t affordable = BAND_BYTES / picture->stride / BUCKET_HEIGHT * BUCKET_HEIGHT;
    size_t unit = BUCKET_HEIGHT;
    if (picture->packing != NULL) {
        picture->way = parts_of(picture->packing, raster);
        unit = picture->way.rows > unit ? picture->way.rows : unit; /* powers of two */
    }
    picture->rows =
        smaller(affordable / unit > 0 ? affordable / unit * unit : unit, raster->height);
    picture->memory = calloc(1 + picture->rows, picture->stride);
    if (picture->memory == NULL) {
        return false;
    }
    picture->bytes = picture->memory + picture->stride;
    if (picture->packing != NULL) {
        const size_t parts = parts_count(&picture->way, picture->rows);
        const size_t room = picture->way.room;
        picture->packed = room <= SIZE_MAX / parts ? malloc(parts * room) : NULL;
        picture->part = calloc(parts, sizeof *picture->part);
        if (picture->packed == NULL || picture->part == NULL) {
            return false;
        }
    }
    const size_t buckets =
        quotient_up(raster->width, BUCKET_WIDTH) * quotient_up(picture->rows, BUCKET_HEIGHT);
    picture->wanted = smaller(crew_most(picture->crew), buckets);
    return open_threads(picture);
}

static void close_picture(struct picture *picture)
{
    for (size_t i = 0; i < picture->wanted && picture->bucket != NULL && picture->packer != NULL;
         i++) {
        bucket_close(picture->bucket[i]);
        if (picture->packer[i] != NULL) {
            picture->packing->close(picture->packer[i]);
        }
    }
    free(picture->bucket);
    free(picture->packer);
    free(picture->part);
    free(picture->packed);
    free(picture->memory);
}

static size_t rows_of_band(const struct picture *picture)
{
    return smaller(picture->rows, picture->writer->raster.height - picture->row);
}

static void paint(const struct picture *picture, size_t n, struct bucket *bucket)
{
    const size_t width = picture->writer->raster.width;
    const size_t across = quotient_up(width, BUCKET_WIDTH);
    const size_t column = n % across * BUCKET_WIDTH, row = n / across * BUCKET_HEIGHT;
    const struct bucket_area area = {
        .column = column,
        .row = picture->row + row,
        .columns = smaller(width - column, BUCKET_WIDTH),
        .rows = smaller(rows_of_band(picture) - row, BUCKET_HEIGHT),
        .bytes = picture->bytes + row * picture->stride + 3 * column,
        .stride = picture->stride,
    };
    bucket_paint(bucket, picture->scene, picture->samples, &area);
}

static void pack(const struct picture *picture, size_t n, void *packer)
{
    struct part *const part = &picture->part[n];
    *part = parts_at(&picture->way, &picture->writer->raster, picture->bytes, picture->row, n);
    part->bytes = picture->packed + n * picture->way.room;
    picture->packing->pack(packer, &picture->writer->raster, part);
}

static size_t parts_of_band(const struct picture *picture)
{
    return picture->packing != NULL ? parts_count(&picture->way, rows_of_band(picture)) : 0;
}

/* Writes the band, and begins the next one. */
static void write_band(struct picture *picture)
{
    const size_t rows = rows_of_band(picture), parts = parts_of_band(picture);
    bool written = true;
    errno = 0;
    if (interrupted()) {
        picture->result = PICTURE_INTERRUPTED;
        return;
    }
    if (picture->packing == NULL) {
        written = writer_write(picture->writer, picture->bytes, picture->row, rows);
    }
    for (size_t n = 0; n < parts && written; n++) {
        written = writer_write_part(picture->writer, &picture->part[n]);
    }
    if (!written) {
        picture->reason = errno;
        picture->result = interrupted() ? PICTURE_INTERRUPTED : PICTURE_FAILED;
        return;
    }
    memcpy(picture->memory, picture->bytes + (rows - 1) * picture->stride, picture->stride);
    picture->row += rows;
}

/* What each thread does. The first one writes: signals go to it, and end a write that waits. It
   also shows the progress, of the buckets that it finds done. */
static void work(void *context, size_t number)
{
    struct picture *const picture = context;
    while (picture->row < picture->writer->raster.height && picture->result == PICTURE_DONE) {
        const size_t across = quotient_up(picture->writer->raster.width, BUCKET_WIDTH);
        const size_t buckets = across * quotient_up(rows_of_band(picture), BUCKET_HEIGHT);
        const size_t parts = parts_of_band(picture);
        size_t shown = 0;
        for (size_t n; (n = crew_next(picture->crew)) < buckets && !interrupted();) {
            paint(picture, n, picture->bucket[number]);
            if (number == 0) {
                progress_add(picture->progress, n - shown);
                shown = n;
            }
        }
        if (number == 0) {
            progress_add(picture->progress, buckets - shown);
        }
        crew_meet(picture->crew, NULL);
        for (size_t n; (n = crew_next(picture->crew)) < parts && !interrupted();) {
            pack(picture, n, picture->packer[number]);
        }
        crew_meet(picture->crew, NULL);
        if (number == 0) {
            write_band(picture);
        }
        crew_meet(picture->crew, NULL);
    }
}

static void add_counts(const struct picture *picture, struct picture_counts *counts)
{
    for (size_t i = 0; i < picture->threads; i++) {
        const struct bucket *const bucket = picture->bucket[i];
        counts->rays += bucket->count;
        counts->march_calls += bucket->march.calls;
        counts->march_points += bucket->march.points;
        counts->shadow_calls += bucket->light.shadow.calls;
        counts->shadow_points += bucket->light.shadow.points;
        counts->light_calls += bucket->light.calls;
        counts->light_points += bucket->light.points;
    }
}

enum picture_result picture_write(const struct scene *scene, size_t samples, struct writer *writer,
                                  struct crew *crew, struct progress *progress,
                                  struct picture_counts *counts)
{
    struct picture picture = {.scene = scene,
                              .samples = samples,
                              .writer = writer,
                              .crew = crew,
                              .progress = progress,
                              .result = PICTURE_NO_MEMORY};
    if (open_picture(&picture)) {
        picture.result = PICTURE_DONE;
        crew_run(crew, picture.threads, work, &picture);
        add_counts(&picture, counts);
    }
    close_picture(&picture);
    errno = picture.reason;
    return picture.result;
}
