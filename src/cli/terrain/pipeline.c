/* SPDX-License-Identifier: MIT
 *
 * Bands, windows, parts and threads.
 *
 * A band is filled window by window. While the next one is filled, it is written, if its format takes
 * samples as they are; else it is packed part by part, and written while the one after that is
 * filled.
 *
 * Memory: two bands, and what two bands are packed to, whose bytes together are at most BAND_BYTES
 * for one of each unless MIN_ROWS rows take more; one window and one packer per thread.
 */
#include "terrain/pipeline.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "shared/bounds.h"
#include "shared/interrupt.h"
#include "terrain/compare.h"

#define BAND_BYTES ((size_t)16 << 20)
#define MIN_BANDS 4 /* so that small rasters are written while they are sampled, too */
#define MIN_ROWS 16 /* of a band: what is computed once per column of a window pays then */
#define WINDOW_ROWS 64

/* The way of a product: its bands, by turns those with even and those with odd numbers */
struct lane {
    uint8_t *memory[2];
    uint8_t *bytes[2];             /* in there, after the row above the band */
    const struct packing *packing; /* NULL: the bytes go to the file as they are; else: */
    size_t packer;                 /* which of a thread's packers serves */
    struct parts way;              /* how the raster falls into parts */
    size_t parts;                  /* of a band */
    uint8_t *packed[2];
    struct part *part[2];
};

/* What a thread needs */
struct scratch {
    struct window window;
    void *packers[PRODUCTS_MAX]; /* one for each packing, where the first lane is that has it */
};

struct pipeline {
    const struct surface *surface;
    const struct tile *tile;
    struct products *products;
    struct crew *crew;
    struct progress *progress;

    size_t bands, rows;                          /* of a band; the last one may have fewer */
    size_t windows, window_columns, window_rows; /* of a band; the last ones may be smaller */
    size_t parts;                                /* of a band, in all lanes */
    struct lane lanes[PRODUCTS_MAX];             /* by product */
    size_t lag;                                  /* rounds after which a band is in all files */
    size_t threads;                              /* at most */
    struct scratch *scratch;                     /* one per thread */

    size_t round; /* and the band that is filled in it */
    enum pipeline_result result;
};

/* Finds out which products are packed, and in which parts. Returns of how many rows the bands must
   have a multiple, so that a file has the same parts whichever others are made with it. */
static size_t choose_parts(struct pipeline *pipeline)
{
    size_t unit = 1; /* part_rows are powers of two: the largest is a multiple of the others */
    pipeline->lag = 1;
    for (size_t i = 0; i < pipeline->products->count; i++) {
        const struct product *const product = &pipeline->products->list[i];
        struct lane *const lane = &pipeline->lanes[i];
        lane->packing = product->format->packing;
        if (lane->packing == NULL) {
            continue;
        }
        while (pipeline->lanes[lane->packer].packing != lane->packing) {
            lane->packer++;
        }
        lane->way = parts_of(lane->packing, &product->writer.raster);
        unit = unit < lane->way.rows ? lane->way.rows : unit;
        pipeline->lag = 2;
    }
    return unit;
}

/* What a row takes in all lanes, packed and not */
static size_t bytes_of_row(const struct pipeline *pipeline)
{
    size_t bytes = 0;
    for (size_t i = 0; i < pipeline->products->count; i++) {
        const struct lane *const lane = &pipeline->lanes[i];
        bytes += pipeline->products->list[i].row_bytes;
        bytes += lane->packing != NULL ? lane->way.room * lane->way.across / lane->way.rows : 0;
    }
    return bytes;
}

/* Decides the sizes of bands, parts and windows. */
static void divide(struct pipeline *pipeline)
{
    const struct tile *const tile = pipeline->tile;
    const size_t unit = choose_parts(pipeline);
    /* Bands are long: the threads wait for each other after each, and for those that the system
       lets wait. */
    const size_t affordable = BAND_BYTES / bytes_of_row(pipeline) / unit;
    const size_t wanted = quotient_up(quotient_up(tile->height, MIN_BANDS), unit);
    const size_t least = quotient_up(MIN_ROWS, unit);
    const size_t units = smaller(affordable, wanted);
    pipeline->rows = smaller((units < least ? least : units) * unit, tile->height);
    pipeline->bands = quotient_up(tile->height, pipeline->rows);
    pipeline->window_rows = smaller(pipeline->rows, WINDOW_ROWS);
    pipeline->window_columns = smaller(WINDOW_SAMPLES / pipeline->window_rows, tile->width);
    pipeline->windows = quotient_up(tile->width, pipeline->window_columns) *
                        quotient_up(pipeline->rows, pipeline->window_rows);
    for (size_t i = 0; i < pipeline->products->count; i++) {
        struct lane *const lane = &pipeline->lanes[i];
        lane->parts = lane->packing != NULL ? parts_count(&lane->way, pipeline->rows) : 0;
        pipeline->parts += lane->parts;
    }
    /* Waiting for a thread that has nothing to do takes longer than a small raster. */
    const size_t tasks = pipeline->windows > pipeline->parts ? pipeline->windows : pipeline->parts;
    pipeline->threads = smaller(crew_most(pipeline->crew), tasks);
}

static bool open_lane(struct pipeline *pipeline, size_t i)
{
    struct lane *const lane = &pipeline->lanes[i];
    const size_t row = pipeline->products->list[i].row_bytes;
    for (size_t turn = 0; turn < 2; turn++) {
        lane->memory[turn] = malloc((1 + pipeline->rows) * row);
        if (lane->memory[turn] == NULL) {
            return false;
        }
        memset(lane->memory[turn], 0, row);
        lane->bytes[turn] = lane->memory[turn] + row;
        if (lane->packing == NULL) {
            continue;
        }
        /* With 32-bit addresses, enlarged rasters may need more than there are. */
        lane->packed[turn] =
            lane->way.room <= SIZE_MAX / lane->parts ? malloc(lane->parts * lane->way.room) : NULL;
        lane->part[turn] = calloc(lane->parts, sizeof *lane->part[turn]);
        if (lane->packed[turn] == NULL || lane->part[turn] == NULL) {
            return false;
        }
    }
    return true;
}

static void close_lane(struct lane *lane)
{
    for (size_t turn = 0; turn < 2; turn++) {
        free(lane->memory[turn]);
        free(lane->packed[turn]);
        free(lane->part[turn]);
    }
}

static void close_scratch(const struct pipeline *pipeline, struct scratch *scratch)
{
    for (size_t i = 0; i < pipeline->products->count; i++) {
        if (scratch->packers[i] != NULL) {
            pipeline->lanes[i].packing->close(scratch->packers[i]);
        }
    }
    window_close(&scratch->window);
}

static bool open_scratch(const struct pipeline *pipeline, struct scratch *scratch)
{
    bool is_open =
        window_open(&scratch->window, pipeline->surface, products_needs(pipeline->products));
    for (size_t i = 0; i < pipeline->products->count && is_open; i++) {
        const struct lane *const lane = &pipeline->lanes[i];
        if (lane->packing != NULL && lane->packer == i) {
            scratch->packers[i] = lane->packing->open();
            is_open = scratch->packers[i] != NULL;
        }
    }
    if (!is_open) {
        close_scratch(pipeline, scratch);
    }
    return is_open;
}

/* Where memory does not last for all threads, there are fewer. */
static bool open_threads(struct pipeline *pipeline)
{
    const size_t wanted = pipeline->threads;
    pipeline->threads = 0;
    pipeline->scratch = calloc(wanted, sizeof *pipeline->scratch);
    while (pipeline->scratch != NULL && pipeline->threads < wanted &&
           open_scratch(pipeline, &pipeline->scratch[pipeline->threads])) {
        pipeline->threads++;
    }
    return pipeline->threads != 0;
}

static bool open_pipeline(struct pipeline *pipeline)
{
    divide(pipeline);
    for (size_t i = 0; i < pipeline->products->count; i++) {
        if (!open_lane(pipeline, i)) {
            pipeline->threads = 0;
            return false;
        }
    }
    return open_threads(pipeline);
}

static void close_pipeline(struct pipeline *pipeline)
{
    for (size_t i = 0; i < pipeline->threads; i++) {
        close_scratch(pipeline, &pipeline->scratch[i]);
    }
    free(pipeline->scratch);
    for (size_t i = 0; i < pipeline->products->count; i++) {
        close_lane(&pipeline->lanes[i]);
    }
}

static size_t rows_of_band(const struct pipeline *pipeline, size_t band)
{
    return smaller(pipeline->rows, pipeline->tile->height - band * pipeline->rows);
}

/* Samples window number `n` of the band, and encodes it for all files. */
static void fill(const struct pipeline *pipeline, size_t band, size_t n, struct window *window)
{
    const struct tile *const tile = pipeline->tile;
    const size_t across = quotient_up(tile->width, pipeline->window_columns);
    const size_t column = n % across * pipeline->window_columns;
    const size_t row = n / across * pipeline->window_rows;
    const size_t rows = rows_of_band(pipeline, band);
    if (row >= rows) {
        return; /* the last band is lower */
    }
    window->column = tile->column + column;
    window->row = tile->row + band * pipeline->rows + row;
    window->columns = smaller(pipeline->window_columns, tile->width - column);
    window->rows = smaller(pipeline->window_rows, rows - row);
    surface_sample(pipeline->surface, window);
    if (window->differences_x != NULL) {
        compare_sample(pipeline->surface, window);
    }
    for (size_t i = 0; i < pipeline->products->count; i++) {
        const struct product *const product = &pipeline->products->list[i];
        const size_t pixel =
            product->layer->channels * sample_bytes(product->type) * product->writer.raster.times;
        for (size_t r = 0; r < window->rows; r++) {
            uint8_t *const to = pipeline->lanes[i].bytes[band % 2] + (row + r) * product->row_bytes;
            const struct span span = {.window = window,
                                      .first = r * window->columns,
                                      .count = window->columns,
                                      .width = tile->width,
                                      .part = product->part};
            product->layer->encode(pipeline->surface, &span, product->type, to + column * pixel);
        }
    }
}

/* Packs part number `n` of the band, counted through the lanes. */
static void pack(const struct pipeline *pipeline, size_t band, size_t n,
                 const struct scratch *scratch)
{
    size_t i = 0;
    for (; n >= pipeline->lanes[i].parts; i++) {
        n -= pipeline->lanes[i].parts;
    }
    const struct lane *const lane = &pipeline->lanes[i];
    const struct product *const product = &pipeline->products->list[i];
    if (n >= parts_count(&lane->way, rows_of_band(pipeline, band))) {
        return; /* the last band is lower */
    }
    struct part *const part = &lane->part[band % 2][n];
    *part = parts_at(&lane->way, &product->writer.raster, lane->bytes[band % 2],
                     band * pipeline->rows, n);
    part->bytes = lane->packed[band % 2] + n * lane->way.room;
    lane->packing->pack(scratch->packers[lane->packer], &product->writer.raster, part);
}

/* Writes a band of one file, of samples. */
static bool write_samples(const struct pipeline *pipeline, size_t band, size_t i)
{
    struct product *const product = &pipeline->products->list[i];
    const uint8_t *const bytes = pipeline->lanes[i].bytes[band % 2];
    const size_t first = band * pipeline->rows, rows = rows_of_band(pipeline, band);
    const size_t times = product->writer.raster.times;
    bool written = true;
    if (times == 1) {
        return writer_write(&product->writer, bytes, first, rows);
    }
    for (size_t n = 0; n < rows * times && written; n++) {
        written = writer_write(&product->writer, bytes + n / times * product->row_bytes,
                               first * times + n, 1);
    }
    return written;
}

static bool write_parts(const struct pipeline *pipeline, size_t band, size_t i)
{
    struct product *const product = &pipeline->products->list[i];
    const struct lane *const lane = &pipeline->lanes[i];
    const size_t parts = parts_count(&lane->way, rows_of_band(pipeline, band));
    bool written = true;
    for (size_t n = 0; n < parts && written; n++) {
        written = writer_write_part(&product->writer, &lane->part[band % 2][n]);
    }
    return written;
}

/* Writes the band of one file that is ready for it in this round. */
static void drain(const struct pipeline *pipeline, size_t i)
{
    struct product *const product = &pipeline->products->list[i];
    const bool packs = pipeline->lanes[i].packing != NULL;
    const size_t lag = packs ? 2 : 1;
    const size_t band = pipeline->round - lag;
    if (pipeline->round < lag || band >= pipeline->bands) {
        return;
    }
    errno = 0;
    product->failed = packs ? !write_parts(pipeline, band, i) : !write_samples(pipeline, band, i);
    product->reason = errno;
}

/* What happened in a round */
static enum pipeline_result look(const struct pipeline *pipeline)
{
    if (interrupted()) {
        return PIPELINE_INTERRUPTED;
    }
    for (size_t i = 0; i < pipeline->products->count; i++) {
        if (pipeline->products->list[i].failed) {
            return PIPELINE_FAILED;
        }
    }
    return PIPELINE_DONE;
}

/* Copies the last row of the band that was filled above the one that follows: the memory of the
   first is filled again while the other is packed. */
static void keep_last_rows(const struct pipeline *pipeline)
{
    for (size_t i = 0; i < pipeline->products->count; i++) {
        const struct lane *const lane = &pipeline->lanes[i];
        const size_t row = pipeline->products->list[i].row_bytes;
        const uint8_t *const last = lane->bytes[pipeline->round % 2] + (pipeline->rows - 1) * row;
        if (lane->packing != NULL) {
            memcpy(lane->memory[1 - pipeline->round % 2], last, row);
        }
    }
}

/* Ends a round, while all threads wait. */
static void end_round(void *context)
{
    struct pipeline *const pipeline = context;
    pipeline->result = look(pipeline);
    if (pipeline->round >= pipeline->lag && pipeline->result == PIPELINE_DONE) {
        progress_add(pipeline->progress, rows_of_band(pipeline, pipeline->round - pipeline->lag));
    }
    if (pipeline->round + 1 < pipeline->bands) {
        keep_last_rows(pipeline);
    }
    pipeline->round++;
}

static bool waits(const struct pipeline *pipeline, size_t i)
{
    return pipeline->products->list[i].writer.file.waits;
}

/* Runs a task of the round. The first ones write, which keeps others waiting if it comes last. */
static void do_task(const struct pipeline *pipeline, size_t n, struct scratch *scratch)
{
    const size_t count = pipeline->products->count, round = pipeline->round;
    if (n < count) {
        if (!waits(pipeline, n)) {
            drain(pipeline, n);
        }
    } else if (interrupted()) {
        return; /* nothing is kept */
    } else if (n < count + pipeline->parts) {
        if (round > 0 && round <= pipeline->bands) {
            pack(pipeline, round - 1, n - count, scratch);
        }
    } else if (round < pipeline->bands) {
        fill(pipeline, round, n - count - pipeline->parts, &scratch->window);
    }
}

/* What each thread does. All go through the rounds together. In each, those that find a file to be
   written write it, and then help the others with parts and windows. Pipes are the first thread's:
   signals go to it, and end a write that waits. */
static void work(void *context, size_t number)
{
    struct pipeline *const pipeline = context;
    const size_t tasks = pipeline->products->count + pipeline->parts + pipeline->windows;
    const size_t rounds = pipeline->bands + pipeline->lag;
    while (pipeline->round < rounds && pipeline->result == PIPELINE_DONE) {
        for (size_t i = 0; number == 0 && i < pipeline->products->count; i++) {
            if (waits(pipeline, i)) {
                drain(pipeline, i);
            }
        }
        for (size_t n; (n = crew_next(pipeline->crew)) < tasks;) {
            do_task(pipeline, n, &pipeline->scratch[number]);
        }
        crew_meet(pipeline->crew, end_round);
    }
}

enum pipeline_result pipeline_run(const struct surface *surface, const struct tile *tile,
                                  struct products *products, struct crew *crew,
                                  struct progress *progress)
{
    struct pipeline pipeline = {.surface = surface,
                                .tile = tile,
                                .products = products,
                                .crew = crew,
                                .progress = progress,
                                .result = PIPELINE_NO_MEMORY};
    if (open_pipeline(&pipeline)) {
        pipeline.result = PIPELINE_DONE;
        crew_run(crew, pipeline.threads, work, &pipeline);
    }
    close_pipeline(&pipeline);
    return pipeline.result;
}
