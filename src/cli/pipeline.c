/* SPDX-License-Identifier: MIT
 *
 * Bands, blocks and threads. Without OpenMP the same loops run one after the other.
 *
 * Memory: two bands, whose bytes are at most BAND_BYTES each unless MIN_ROWS rows take more, and
 * one block per thread.
 */
#include "pipeline.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>

#include "interrupt.h"

#ifdef _OPENMP
#include <omp.h>
#define PARALLEL(directive) _Pragma(#directive)
#else
#define PARALLEL(directive)
#endif

#define BAND_BYTES ((size_t)16 << 20)
#define MIN_BANDS 4 /* so that small rasters are written while they are sampled, too */
#define MIN_ROWS 16 /* of a band: what is computed once per column of a block pays then */
#define BLOCK_ROWS 64

struct pipeline {
    const struct surface *surface;
    const struct tile *tile;
    struct outputs *outputs;
    size_t threads;

    size_t bands, rows;                       /* of a band; the last one may have fewer */
    size_t blocks, block_columns, block_rows; /* of a band; the last ones may be smaller */
    struct block *scratch;                    /* one per thread */
    uint8_t *bytes[2][OUTPUTS_MAX];           /* of even and odd bands, by output */
};

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t quotient_up(size_t a, size_t b)
{
    return (a + b - 1) / b;
}

size_t pipeline_threads(void)
{
#ifdef _OPENMP
    const int most = omp_get_max_threads();
    return most < 1 ? 1 : smaller((size_t)most, THREADS_MAX);
#else
    return 1;
#endif
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
    pipeline->threads = smaller(pipeline->threads, pipeline->blocks);
}

static bool open_pipeline(struct pipeline *pipeline)
{
    divide(pipeline);
    pipeline->scratch = calloc(pipeline->threads, sizeof *pipeline->scratch);
    if (pipeline->scratch == NULL) {
        return false;
    }
    const unsigned needs = outputs_needs(pipeline->outputs);
    for (size_t i = 0; i < pipeline->threads; i++) {
        if (!block_open(&pipeline->scratch[i], pipeline->surface, needs)) {
            return false;
        }
    }
    for (size_t i = 0; i < 2 * pipeline->outputs->count; i++) {
        uint8_t **const bytes = &pipeline->bytes[i % 2][i / 2];
        *bytes = malloc(pipeline->rows * pipeline->outputs->list[i / 2].row_bytes);
        if (*bytes == NULL) {
            return false;
        }
    }
    return true;
}

static void close_pipeline(struct pipeline *pipeline)
{
    for (size_t i = 0; pipeline->scratch != NULL && i < pipeline->threads; i++) {
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
    block->columns = smaller(pipeline->block_columns, tile->width - column);
    block->rows = smaller(pipeline->block_rows, rows - row);
    surface_sample(pipeline->surface, block, tile->column + column,
                   tile->row + band * pipeline->rows + row);
    for (size_t i = 0; i < pipeline->outputs->count; i++) {
        const struct output *const output = &pipeline->outputs->list[i];
        const size_t pixel = output->layer->channels * sample_bytes(output->kind) * output->times;
        for (size_t r = 0; r < block->rows; r++) {
            uint8_t *const to = pipeline->bytes[band % 2][i] + (row + r) * output->row_bytes;
            output->layer->encode(pipeline->surface, block, r * block->columns, block->columns,
                                  tile->width, output->kind, to + column * pixel);
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

/* All threads go through the bands together. In each, those that find a file to be written write
   it, and then help the others with the blocks. Pipes are the first thread's: signals go to it, and
   end a write that waits. */
static enum pipeline_result run(struct pipeline *pipeline, struct progress *progress)
{
    enum pipeline_result result = PIPELINE_DONE;
    PARALLEL(omp parallel num_threads((int)pipeline->threads))
    {
#ifdef _OPENMP
        const bool first = omp_get_thread_num() == 0;
        struct block *const block = &pipeline->scratch[omp_get_thread_num()];
#else
        const bool first = true;
        struct block *const block = pipeline->scratch;
#endif
        const int files = (int)pipeline->outputs->count;
        const int blocks = (int)pipeline->blocks;
        for (size_t band = 0; band <= pipeline->bands && result == PIPELINE_DONE; band++) {
            const int to_drain = band > 0 ? files : 0;
            const int to_fill = band < pipeline->bands ? blocks : 0;
            for (int i = 0; first && i < to_drain; i++) {
                if (pipeline->outputs->list[i].writer.file.waits) {
                    drain(pipeline, band - 1, (size_t)i);
                }
            }
            PARALLEL(omp for schedule(dynamic, 1) nowait)
            for (int i = 0; i < to_drain; i++) {
                if (!pipeline->outputs->list[i].writer.file.waits) {
                    drain(pipeline, band - 1, (size_t)i);
                }
            }
            PARALLEL(omp for schedule(dynamic, 1))
            for (int n = 0; n < to_fill; n++) {
                fill(pipeline, band, (size_t)n, block);
            }
            PARALLEL(omp single)
            {
                result = look(pipeline);
                if (to_drain != 0 && result == PIPELINE_DONE) {
                    progress_add(progress, rows_of_band(pipeline, band - 1));
                }
            }
        }
    }
    return result;
}

enum pipeline_result pipeline_run(const struct surface *surface, const struct tile *tile,
                                  struct outputs *outputs, size_t threads,
                                  struct progress *progress)
{
    struct pipeline pipeline = {
        .surface = surface, .tile = tile, .outputs = outputs, .threads = threads};
    const enum pipeline_result result =
        open_pipeline(&pipeline) ? run(&pipeline, progress) : PIPELINE_NO_MEMORY;
    close_pipeline(&pipeline);
    return result;
}

/* LLVM's OpenMP has a file in /dev/shm for each process that uses it, which it removes at exit. */
void pipeline_end(void)
{
#if defined(_OPENMP) && _OPENMP >= 201811
    omp_pause_resource_all(omp_pause_hard);
#endif
}
