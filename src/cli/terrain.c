/* SPDX-License-Identifier: MIT
 *
 * `scarp terrain`: from the options to tiles, one after the other, and the closing line. The
 * options are in terrain_options.c, samples in surface.c, their bytes in layers.c, files in
 * outputs.c, and what fills them in pipeline.c.
 */
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <time.h>

#include "cli.h"
#include "interrupt.h"
#include "outputs.h"
#include "pipeline.h"
#include "progress.h"
#include "surface.h"
#include "terrain_options.h"

/* The tiles to write; a raster without tiles is one. */
struct tiling {
    struct option_size tile;
    struct option_range range;
    size_t overlap;
    bool numbered;
};

static double seconds(void)
{
    struct timespec now = {0, 0}; /* stays so without a clock */
#ifdef CLOCK_MONOTONIC
    clock_gettime(CLOCK_MONOTONIC, &now);
#else
    timespec_get(&now, TIME_UTC);
#endif
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static float within(float value, const struct surface *surface)
{
    return value < surface->lowest    ? surface->lowest
           : value > surface->highest ? surface->highest
                                      : value;
}

static bool make_surface(const struct terrain_options *options, struct surface *surface)
{
    *surface = (struct surface){
        .width = options->size.width,
        .height = options->size.height,
        .x0 = options->origin.x,
        .y0 = options->origin.y,
        .step = options->step,
        .height_scale = options->height,
        .z_factor = options->z_factor,
        .normal_y = options->normal_down ? -1.0f : 1.0f,
        .zoom = options->compare,
    };
    if (!noise_make(&options->noise, &surface->noise)) {
        return false;
    }
    if (options->plateau < options->sea_level) {
        cli_error("--plateau: lies below --sea-level");
        return false;
    }
    scarp_range(&surface->noise, 2, &surface->lowest, &surface->highest);
    surface->steps_per_value = 65535.0 / ((double)surface->highest - (double)surface->lowest);
    surface->floor = within(options->sea_level, surface);
    surface->ceiling = within(options->plateau, surface);
    surface_light(options->azimuth, options->altitude, surface->light);
    return true;
}

static bool make_outputs(const struct terrain_options *options, struct outputs *outputs)
{
    const char *const files[] = {[LAYER_HEIGHTS] = options->heights,
                                 [LAYER_NORMALS] = options->normals,
                                 [LAYER_HILLSHADE] = options->hillshade,
                                 [LAYER_GRADIENT] = options->gradient};
    for (int i = 0; i < LAYER_COMPARE; i++) {
        if (files[i] != NULL && !outputs_add(outputs, &layers[i], files[i])) {
            return false;
        }
    }
    const char *const stem =
        options->output == NULL && outputs->count == 0 ? "terrain" : options->output;
    if (stem == NULL && options->compare != 0) {
        cli_error("--compare: needs --output");
        return false;
    }
    return stem == NULL || outputs_add_stem(outputs, stem, options->compare != 0);
}

static size_t quotient_up(size_t a, size_t b)
{
    return (a + b - 1) / b;
}

static bool make_tiling(const struct terrain_options *options, const struct outputs *outputs,
                        struct tiling *tiling)
{
    tiling->numbered = options->tile.width != 0;
    tiling->tile = tiling->numbered ? options->tile : options->size;
    tiling->overlap = options->overlap;
    tiling->range = options->tiles;
    if (!tiling->numbered && (options->tiles.x1 != 0 || options->overlap != 0)) {
        cli_error("%s: needs --tile", options->tiles.x1 != 0 ? "--tiles" : "--overlap");
        return false;
    }
    if (tiling->numbered && outputs_to_standard_output(outputs)) {
        cli_error("--tile: tiles cannot go to standard output, only to files");
        return false;
    }
    const size_t across = quotient_up(options->size.width, tiling->tile.width);
    const size_t down = quotient_up(options->size.height, tiling->tile.height);
    if (tiling->range.x1 == 0) {
        tiling->range = (struct option_range){0, across, 0, down};
    }
    if (tiling->range.x1 > across || tiling->range.y1 > down) {
        cli_error("--tiles: there are %zu x %zu tiles, so X1 is at most %zu and Y1 at most %zu",
                  across, down, across, down);
        return false;
    }
    return true;
}

static size_t extent(size_t first, size_t length, size_t size, size_t overlap)
{
    return (first + length < size ? length : size - first) + overlap;
}

static struct tile tile_at(const struct tiling *tiling, const struct surface *surface, size_t x,
                           size_t y)
{
    const size_t column = x * tiling->tile.width, row = y * tiling->tile.height;
    return (struct tile){
        .column = column,
        .row = row,
        .width = extent(column, tiling->tile.width, surface->width, tiling->overlap),
        .height = extent(row, tiling->tile.height, surface->height, tiling->overlap),
        .x = x,
        .y = y,
        .numbered = tiling->numbered,
    };
}

/* What a run of the program is about */
struct job {
    const struct terrain_options *options;
    struct surface surface;
    struct outputs outputs;
    struct tiling tiling;
    size_t threads;
    struct progress progress;
    size_t written;   /* tiles */
    uint64_t samples; /* of those written */
};

/* Tells why a tile was not written, and returns the exit status of that. */
static int tell_failure(const struct job *job, const struct tile *tile, enum pipeline_result result,
                        bool opened)
{
    if (interrupted()) { /* which also ends writes that wait, and the opening of a pipe */
        cli_error("interrupted: unfinished files are removed%s",
                  job->tiling.numbered ? ", finished tiles stay; see --resume" : "");
        return CLI_FAILURE;
    }
    if (result == PIPELINE_NO_MEMORY) {
        cli_error("no memory for rows of %zu samples with %zu threads", tile->width, job->threads);
        return CLI_FAILURE;
    }
    const struct output *output = job->outputs.list;
    while (!output->failed) {
        output++;
    }
    output_error(output);
    /* A file that cannot be had is the command line's fault, a reader that has gone is not. */
    return !opened && output->reason != EPIPE && job->written == 0 ? CLI_USAGE : CLI_FAILURE;
}

static int write_tile(struct job *job, const struct tile *tile)
{
    struct outputs *const outputs = &job->outputs;
    enum pipeline_result result = PIPELINE_FAILED;
    const bool opened = outputs_open(outputs, &job->surface, tile);
    if (opened) {
        result = pipeline_run(&job->surface, tile, outputs, job->threads, &job->progress);
    }
    if (result == PIPELINE_DONE && !outputs_close(outputs)) {
        result = PIPELINE_FAILED;
    }
    int status = CLI_SUCCESS;
    if (result != PIPELINE_DONE) {
        progress_end(&job->progress, false);
        status = tell_failure(job, tile, result, opened);
    } else {
        job->written++;
        job->samples += (uint64_t)tile->width * tile->height;
    }
    outputs_discard(outputs);
    return status;
}

static int write_tiles(struct job *job)
{
    const struct option_range *const range = &job->tiling.range;
    uint64_t rows = 0;
    for (size_t y = range->y0; y < range->y1; y++) {
        rows += tile_at(&job->tiling, &job->surface, 0, y).height * (range->x1 - range->x0);
    }
    progress_start(&job->progress, rows, job->options->quiet != 0);
    for (size_t y = range->y0; y < range->y1; y++) {
        for (size_t x = range->x0; x < range->x1; x++) {
            const struct tile tile = tile_at(&job->tiling, &job->surface, x, y);
            if (!outputs_name(&job->outputs, &tile)) {
                return CLI_FAILURE;
            }
            if (job->options->resume && outputs_exist(&job->outputs) && !interrupted()) {
                progress_add(&job->progress, tile.height);
                continue;
            }
            const int status = write_tile(job, &tile);
            if (status != CLI_SUCCESS) {
                return status;
            }
        }
    }
    return CLI_SUCCESS;
}

static void print_summary(const struct job *job, double duration)
{
    /* A device may be standard output by another name. */
    FILE *const stream = outputs_are_files(&job->outputs) ? stdout : stderr;
    if (job->written == 0) {
        fprintf(stream, "nothing to do: all files are there\n");
        return;
    }
    if (job->tiling.numbered) {
        fprintf(stream, "%zu tile%s, %llu", job->written, job->written == 1 ? "" : "s",
                (unsigned long long)job->samples);
    } else {
        fprintf(stream, "%zux%zu", job->surface.width, job->surface.height);
    }
    /* No clock resolves the smallest rasters. */
    const double rate = (double)job->samples / (duration > 1e-9 ? duration : 1e-9);
    fprintf(stream, " samples in %.3f s: %.1f million samples per second (%s, %zu thread%s)\n",
            duration, rate * 1e-6, scarp_isa_name(scarp_isa_active()), job->threads,
            job->threads == 1 ? "" : "s");
}

static bool prepare(struct job *job)
{
    const struct terrain_options *const options = job->options;
    job->threads = options->threads != 0 ? options->threads : pipeline_threads();
    return make_surface(options, &job->surface) && make_outputs(options, &job->outputs) &&
           make_tiling(options, &job->outputs, &job->tiling);
}

int cli_terrain(char **argv)
{
    struct terrain_options options = {.sea_level = -INFINITY, .plateau = INFINITY};
    switch (options_parse(&terrain_table, argv, &options)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    struct job job = {.options = &options};
    int status = CLI_USAGE;
    if (prepare(&job)) {
        scarp_isa_select((enum scarp_isa)options.isa);
        const double start = seconds();
        status = write_tiles(&job);
        progress_end(&job.progress, status == CLI_SUCCESS);
        if (status == CLI_SUCCESS && !options.quiet) {
            print_summary(&job, seconds() - start);
        }
    }
    outputs_free(&job.outputs);
    pipeline_end();
    return status;
}
