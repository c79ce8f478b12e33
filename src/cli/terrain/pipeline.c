/* SPDX-License-Identifier: MIT
 *
 * Bands, blocks and threads.
 *
 * Memory: two bands, whose bytes are at most BAND_BYTES each unless MIN_ROWS rows take more, and
 * one block per thread.
 */
#include "terrain/pipeline.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>

#include "shared/interrupt.h"
#include "terrain/compare.h"

#define BAND_BYTES ((size_t)16 << 20)
#define MIN_BANDS 4 /* so that small rasters are written while they are sampled, too */
#define MIN_ROWS 16 /* of a band: what is computed once per column of a block pays then */
#define BLOCK_ROWS 64

struct pipeline {
    const struct surface *surface;
    const struct tile *tile;
    struct outputs *outputs;
    struct crew *crew;
    struct progress *progress;

    size_t bands, rows;                       /* of a band; the last one may have fewer */
    size_t blocks, block_columns, block_rows; /* of a band; the last ones may be smaller */
    size_t threads;                           /* at most */
    struct block *scratch;                    /* one per thread */
    uint8_t *bytes[2][OUTPUTS_MAX];           /* of even and odd bands, by output */

    size_t band; /* that is filled, while the one before it is drained */
    enum pipeline_result result;
};

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t quotient_up(size_t a, size_t b)
{
    return (a + b - 1) / b;
}

/* Decides the sizes of bands and blocks. */
static void divide(struct pipeline *pipeline)
{
    const struct tile *const tile = pipeline->tile;
    size_t bytes_per_row = 0;
    for (size_t i = 0; i < pipeline->outputs->count; i++) {
        bytes_per_row += pipeline->outputs->list[i].row_bytes;
    }
    /* Bands are long: the threads wait for each other after each, and for those that the system
       lets wait. */
    const size_t affordable =
        smaller(BAND_BYTES / bytes_per_row, quotient_up(tile->height, MIN_BANDS));
    const size_t rows = affordable < MIN_ROWS ? MIN_ROWS : affordable;
    pipeline->rows = smaller(rows, tile->height);
    pipeline->bands = quotient_up(tile->height, pipeline->rows);
    pipeline->block_rows = smaller(pipeline->rows, BLOCK_ROWS);
    pipeline->block_columns = smaller(BLOCK_SAMPLES / pipeline->block_rows, tile->width);
    pipeline->blocks = quotient_up(tile->width, pipeline->block_columns) *
                       quotient_up(pipeline->rows, pipeline->block_rows);
    /* Waiting for a thread that has nothing to do takes longer than a small raster. */
    pipeline->threads = smaller(crew_most(pipeline->crew), pipeline->blocks);
}

/* Opens a block for each thread. Where memory does not last for all, there are fewer threads. */
static bool open_scratch(struct pipeline *pipeline)
{
    const unsigned needs = outputs_needs(pipeline->outputs);
    const size_t wanted = pipeline->threads;
    pipeline->threads = 0;
    pipeline->scratch = calloc(wanted, sizeof *pipeline->scratch);
    while (pipeline->scratch != NULL && pipeline->threads < wanted &&
           block_open(&pipeline->scratch[pipeline->threads], pipeline->surface, needs)) {
        pipeline->threads++;
    }
    return pipeline->threads != 0;
}

static bool open_pipeline(struct pipeline *pipeline)
{
    divide(pipeline);
    for (size_t i = 0; i < 2 * pipeline->outputs->count; i++) {
        uint8_t **const bytes = &pipeline->bytes[i % 2][i / 2];
        *bytes = malloc(pipeline->rows * pipeline->outputs->list[i / 2].row_bytes);
        if (*bytes == NULL) {
            return false;
        }
    }
    return open_scratch(pipeline);
}

static void close_pipeline(struct pipeline *pipeline)
{
    for (size_t i = 0; i < pipeline->threads && pipeline->scratch != NULL; i++) {
        block_close(&pipeline->scratch[i]);
    }
    free(pipeline->scratch);
    for (size_t i = 0; i < 2 * pipeline->outputs->count; i++) {
        free(pipeline->bytes[i % 2][i / 2]);
    }
}

static size_t rows_of_band(const struct pipeline *pipeline, size_t band)
{
    return smaller(pipeline->rows, pipeline->tile->height - band * pipeline->rows);
}

/* Samples block number `n` of the band, and encodes it for all files. */
static void fill(const struct pipeline *pipeline, size_t band, size_t n, struct block *block)
{
    const struct tile *const tile = pipeline->tile;
    const size_t across = quotient_up(tile->width, pipeline->block_columns);
    const size_t column = n % across * pipeline->block_columns;
    const size_t row = n / across * pipeline->block_rows;
    const size_t rows = rows_of_band(pipeline, band);
    if (row >= rows || interrupted()) {
        return; /* the last band is lower; of an interrupted run nothing is kept */
    }
    block->column = tile->column + column;
    block->row = tile->row + band * pipeline->rows + row;
    block->columns = smaller(pipeline->block_columns, tile->width - column);
    block->rows = smaller(pipeline->block_rows, rows - row);
    surface_sample(pipeline->surface, block);
    if (block->differences_x != NULL) {
        compare_sample(pipeline->surface, block);
    }
    for (size_t i = 0; i < pipeline->outputs->count; i++) {
        const struct output *const output = &pipeline->outputs->list[i];
        const size_t pixel = output->layer->channels * sample_bytes(output->kind) * output->times;
        for (size_t r = 0; r < block->rows; r++) {
            uint8_t *const to = pipeline->bytes[band % 2][i] + (row + r) * output->row_bytes;
            const struct strip strip = {block, r * block->columns, block->columns, tile->width};
            output->layer->encode(pipeline->surface, &strip, output->kind, to + column * pixel);
        }
    }
}

/* Writes a band of one file. */
static void drain(const struct pipeline *pipeline, size_t band, size_t i)
{
    struct output *const output = &pipeline->outputs->list[i];
    const uint8_t *bytes = pipeline->bytes[band % 2][i];
    const size_t first = band * pipeline->rows;
    const size_t rows = rows_of_band(pipeline, band);
    errno = 0;
    if (output->times == 1) {
        output->failed = !writer_write(&output->writer, bytes, first, rows);
    }
    for (size_t n = 0; output->times > 1 && n < rows * output->times && !output->failed; n++) {
        output->failed =
            !writer_write(&output->writer, bytes + n / output->times * output->row_bytes,
                          first * output->times + n, 1);
    }
    output->reason = errno;
}

/* What happened while a band was filled and the one before it drained */
static enum pipeline_result look(const struct pipeline *pipeline)
{
    if (interrupted()) {
        return PIPELINE_INTERRUPTED;
    }
    for (size_t i = 0; i < pipeline->outputs->count; i++) {
        if (pipeline->outputs->list[i].failed) {
            return PIPELINE_FAILED;
        }
    }
    return PIPELINE_DONE;
}

/* Ends a band, while all threads wait. */
static void end_band(void *context)
{
    struct pipeline *const pipeline = context;
    pipeline->result = look(pipeline);
    if (pipeline->band > 0 && pipeline->result == PIPELINE_DONE) {
        progress_add(pipeline->progress, rows_of_band(pipeline, pipeline->band - 1));
    }
    pipeline->band++;
}

static bool waits(const struct pipeline *pipeline, size_t i)
{
    return pipeline->outputs->list[i].writer.file.waits;
}

/* What each thread does. All go through the bands together. In each, those that find a file to be
   written write it, and then help the others with the blocks. Pipes are the first thread's: signals
   go to it, and end a write that waits. */
static void work(void *context, size_t number)
{
    struct pipeline *const pipeline = context;
    while (pipeline->band <= pipeline->bands && pipeline->result == PIPELINE_DONE) {
        const size_t band = pipeline->band;
        const size_t to_drain = band > 0 ? pipeline->outputs->count : 0;
        const size_t to_fill = band < pipeline->bands ? pipeline->blocks : 0;
        for (size_t i = 0; number == 0 && i < to_drain; i++) {
            if (waits(pipeline, i)) {
                drain(pipeline, band - 1, i);
            }
        }
        for (size_t n; (n = crew_next(pipeline->crew)) < to_drain + to_fill;) {
            if (n >= to_drain) {
                fill(pipeline, band, n - to_drain, &pipeline->scratch[number]);
            } else if (!waits(pipeline, n)) {
                drain(pipeline, band - 1, n);
            }
        }
        crew_meet(pipeline->crew, end_band);
    }
}

enum pipeline_result pipeline_run(const struct surface *surface, const struct tile *tile,
                                  struct outputs *outputs, struct crew *crew,
                                  struct progress *progress)
{
    struct pipeline pipeline = {.surface = surface,
                                .tile = tile,
                                .outputs = outputs,
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
