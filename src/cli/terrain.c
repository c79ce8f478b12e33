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
#include "crew.h"
#include "interrupt.h"
#include "outputs.h"
#include "pipeline.h"
#include "progress.h"
#include "surface.h"
#include "terrain_options.h"
#include "tiling.h"
#include "world.h"

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

/* What a run of the program is about */
struct job {
    const struct terrain_options *options;
    struct surface surface;
    struct outputs outputs;
    struct tiling tiling;
    struct manifest manifest;
    struct crew *crew;
    struct progress progress;
    size_t written;   /* tiles */
    size_t busy;      /* tiles that other runs are writing */
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
        cli_error("no memory for rows of %zu samples", tile->width);
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
    const bool opened = outputs_open(outputs);
    if (opened) {
        result = pipeline_run(&job->surface, tile, outputs, job->crew, &job->progress);
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

enum tile_state { TILE_MISSING, TILE_THERE, TILE_BUSY };

/* Claims the tile, unless it need not be written. Claims come before the look at the files: what
   another run has just finished is there then. */
static enum tile_state claim(const struct job *job, const struct tile *tile)
{
    const bool claimed = manifest_claim(&job->manifest, tile->number);
    if (!job->options->resume) {
        return TILE_MISSING;
    }
    if (!claimed) {
        return TILE_BUSY;
    }
    return outputs_are_there(&job->outputs, job->manifest.time) ? TILE_THERE : TILE_MISSING;
}

/* Writes tile number `n` of the range, if need be. */
static int visit_tile(struct job *job, size_t n)
{
    const struct tile tile = tiling_at(&job->tiling, n);
    if (!outputs_begin(&job->outputs, &job->surface, &tile)) {
        return CLI_FAILURE;
    }
    int status = CLI_SUCCESS;
    const enum tile_state state = claim(job, &tile);
    if (state == TILE_MISSING || interrupted()) {
        status = write_tile(job, &tile);
    } else {
        job->busy += state == TILE_BUSY ? 1 : 0;
        outputs_sweep(&job->outputs);
        progress_add(&job->progress, tile.height);
    }
    if (state != TILE_BUSY) {
        manifest_release(&job->manifest, tile.number);
    }
    return status;
}

static int visit_tiles(struct job *job)
{
    job->busy = 0;
    for (size_t n = job->tiling.begin; n < job->tiling.end; n++) {
        const int status = visit_tile(job, n);
        if (status != CLI_SUCCESS) {
            return status;
        }
    }
    return CLI_SUCCESS;
}

static int write_tiles(struct job *job)
{
    uint64_t rows = 0;
    for (size_t n = job->tiling.begin; n < job->tiling.end; n++) {
        rows += tiling_at(&job->tiling, n).height;
    }
    progress_start(&job->progress, rows, job->options->quiet != 0);
    int status = visit_tiles(job);
    if (status == CLI_SUCCESS && job->busy > 0) {
        /* The run that had them may have ended without writing them. */
        status = visit_tiles(job);
    }
    return status;
}

static void print_summary(const struct job *job, double duration)
{
    /* A device may be standard output by another name. */
    FILE *const stream = outputs_are_files(&job->outputs) ? stdout : stderr;
    if (job->busy > 0) {
        fprintf(stream, "%zu tile%s left to other runs\n", job->busy, job->busy == 1 ? "" : "s");
    }
    if (job->written == 0) {
        fprintf(stream, "nothing to do: %s\n",
                job->tiling.begin == job->tiling.end ? "there are more shares than tiles"
                : job->busy > 0                      ? "all other files are there"
                                                     : "all files are there");
        return;
    }
    if (job->tiling.numbered) {
        fprintf(stream, "%zu tile%s, %llu", job->written, job->written == 1 ? "" : "s",
                (unsigned long long)job->samples);
    } else {
        fprintf(stream, "%zux%zu", job->surface.width, job->surface.height);
    }
    /* No clock resolves the smallest rasters. */
    const size_t threads = crew_size(job->crew);
    const double rate = (double)job->samples / (duration > 1e-9 ? duration : 1e-9);
    fprintf(stream, " samples in %.3f s: %.1f million samples per second (%s, %zu thread%s)\n",
            duration, rate * 1e-6, scarp_isa_name(scarp_isa_active()), threads,
            threads == 1 ? "" : "s");
}

/* Whether other runs may have to do with the same files: then they must be of one world. */
static bool needs_manifest(const struct job *job)
{
    return job->tiling.numbered || (job->options->resume && outputs_are_files(&job->outputs));
}

static int prepare(struct job *job)
{
    const struct terrain_options *const options = job->options;
    job->crew = crew_open(options->threads != 0 ? options->threads : crew_processors());
    if (job->crew == NULL) {
        cli_error("--threads: no memory");
        return CLI_FAILURE;
    }
    if (!make_surface(options, &job->surface) || !make_outputs(options, &job->outputs) ||
        !tiling_make(options, &job->tiling) || !outputs_check(&job->outputs, &job->tiling)) {
        return CLI_USAGE;
    }
    return needs_manifest(job)
               ? world_open(&job->manifest, options, &job->surface, &job->tiling, &job->outputs)
               : CLI_SUCCESS;
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
    int status = prepare(&job);
    if (status == CLI_SUCCESS) {
        scarp_isa_select((enum scarp_isa)options.isa);
        const double start = seconds();
        status = write_tiles(&job);
        progress_end(&job.progress, status == CLI_SUCCESS);
        if (status == CLI_SUCCESS && !options.quiet) {
            print_summary(&job, seconds() - start);
        }
    }
    manifest_close(&job.manifest, status == CLI_SUCCESS || job.written > 0);
    outputs_free(&job.outputs);
    crew_close(job.crew);
    return status;
}
