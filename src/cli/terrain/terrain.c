/* SPDX-License-Identifier: MIT
 *
 * `scarp terrain`: from the options to the run, and the closing line. The options are in
 * terrain_options.c, which files they ask for in asked.c, tiles in job.c, samples in surface.c,
 * their bytes in layers.c, files in products.c, and what fills them in pipeline.c.
 */
#include "commands.h"

#include <stdbool.h>
#include <stdio.h>

#include "shared/amount.h"
#include "shared/error.h"
#include "shared/posix.h"
#include "shared/running.h"
#include "terrain/job.h"
#include "terrain/room.h"
#include "terrain/verify.h"
#include "terrain/world.h"

static bool make_surface(const struct terrain_options *options, const struct source *source,
                         struct surface *surface)
{
    *surface = (struct surface){
        .width = options->size.width,
        .height = options->size.height,
        .x0 = options->origin.x,
        .y0 = options->origin.y,
        .step = options->step,
        .epsg = options->crs,
        .normal_y = options->normal_down ? -1.0f : 1.0f,
        .zoom = options->compare,
    };
    if (!source_ground(source, &surface->ground)) {
        return false;
    }
    surface->scale = surface_height_scale(&surface->ground);
    surface_set_light(surface, &options->look);
    return true;
}

static void print_scale(FILE *stream, const char *name, float zero, float full)
{
    /* No zero is negative. */
    fprintf(stream, "16-bit %s: 0 is %.9g, 65535 is %.9g\n", name, (double)(zero + 0.0f),
            (double)(full + 0.0f));
}

static bool is_integer(const struct product *product)
{
    return product->type == SAMPLE_U16_LOW || product->type == SAMPLE_U16_HIGH;
}

/* Without what 0 and 65535 stand for, 16-bit integers are nothing but greys. */
static void print_scales(const struct job *job, FILE *stream)
{
    const struct products *const products = &job->products[0];
    const struct ground *const ground = &job->surface.ground;
    bool are_heights = false;
    for (size_t i = 0; i < products->count; i++) {
        const struct product *const product = &products->list[i];
        const struct ground_field *const field = &ground->fields[product->part];
        if (!is_integer(product)) {
            continue;
        }
        if (product->layer == &layers[LAYER_FIELD]) {
            print_scale(stream, product->content, field->lowest, field->highest);
        } else if (product->layer == &layers[LAYER_SLOPE]) {
            print_scale(stream, "slope", 0.0f, 90.0f);
        } else if (!are_heights) {
            print_scale(stream, "heights", ground->floor, ground->highest);
            are_heights = true;
        }
    }
}

/* The frequency may be another than was asked for. */
static void print_period(const struct job *job, FILE *stream)
{
    const struct option_size period = job->options->ground.period;
    if (period.width == 0) {
        return;
    }
    fprintf(stream, "repeats after %zux%zu samples", period.width, period.height);
    if (job->source->nearest != 0.0) {
        fprintf(stream, ": frequency %.9g, %u x %u cells", job->source->nearest,
                (unsigned)job->source->cells[0], (unsigned)job->source->cells[1]);
    }
    fputc('\n', stream);
}

static void print_summary(const struct job *job, double duration)
{
    /* A device may be standard output by another name. */
    FILE *const stream = products_are_files(&job->products[0]) ? stdout : stderr;
    print_scales(job, stream);
    print_period(job, stream);
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
        if (job->tiling.level_count > 1) {
            fprintf(stream, " in %u levels, %llu", job->tiling.level_count,
                    (unsigned long long)job->samples);
        }
    }
    /* No clock resolves the smallest rasters. */
    const double rate = (double)job->samples / (duration > 1e-9 ? duration : 1e-9);
    char time[AMOUNT_SIZE], speed[AMOUNT_SIZE];
    fprintf(stream, " samples in %s: %ssamples per second", amount_seconds(time, duration),
            amount_count(speed, rate));
    running_print(stream, job->crew);
}

/* Whether other runs may have to do with the same files: then they must be of one world. */
static bool needs_manifest(const struct job *job)
{
    return job->tiling.numbered || (job->options->resume && products_are_files(&job->products[0]));
}

static bool make_relief(struct job *job)
{
    const struct terrain_options *const options = job->options;
    if (!source_open_palette(job->source, options->look.palette, &job->palette)) {
        return false;
    }
    if (options->masks != NULL && job->palette.in_units) {
        cli_error("--masks: a --palette FILE has only colours, without rock, snow, sand and water");
        return false;
    }
    if ((products_needs(&job->products[0]) & SURFACE_BED) != 0) {
        surface_set_relief(&job->surface, &job->palette);
    }
    return true;
}

/* Opens the world, and the file for the checksums of its files. */
static int open_world(struct job *job)
{
    const int status = world_open(job);
    if (status == CLI_SUCCESS && !sums_open(&job->sums, job->manifest.path, job->options->share)) {
        cli_error("%s: no memory", job->manifest.option);
        return CLI_FAILURE;
    }
    return status;
}

static int prepare(struct job *job)
{
    const struct terrain_options *const options = job->options;
    job->crew = running_begin(&options->running);
    if (job->crew == NULL) {
        return CLI_FAILURE;
    }
    if (!make_surface(options, job->source, &job->surface) ||
        !asked_products(options, &job->asked, &job->products[0]) ||
        !asked_products(options, &job->asked, &job->products[1]) ||
        !asked_check(&job->products[0], &job->surface) || !make_relief(job) ||
        !tiling_make(options, &job->tiling) || !products_check(&job->products[0], &job->tiling)) {
        return CLI_USAGE;
    }
    if (options->verify && !needs_manifest(job)) {
        cli_error("--verify: needs --tile or --resume, whose runs keep checksums");
        return CLI_USAGE;
    }
    const int status = options->verify ? CLI_SUCCESS : room_check(job);
    return status == CLI_SUCCESS && needs_manifest(job) ? open_world(job) : status;
}

/* Writes the files. */
static int write_files(struct job *job)
{
    const double start = running_seconds();
    if (!job->options->running.quiet) {
        tiling_warn(job->options);
    }
    const int status = job_run(job);
    if (status == CLI_SUCCESS && !job->options->running.quiet) {
        print_summary(job, running_seconds() - start);
    }
    return status;
}

static int run(const struct terrain_options *options, struct source *source)
{
    static struct job job; /* large for a stack */
    job.options = options;
    job.source = source;
    int status = asked_read(&job.asked, &options->out, source) ? prepare(&job) : CLI_USAGE;
    if (status == CLI_SUCCESS) {
        status = options->verify ? verify_files(&job) : write_files(&job);
    }
    sums_close(&job.sums, job.written > 0);
    manifest_close(&job.manifest, status == CLI_SUCCESS || job.written > 0);
    products_free(&job.products[0]);
    products_free(&job.products[1]);
    palette_free(&job.palette);
    crew_close(job.crew);
    return status;
}

static bool set_tileable(struct terrain_options *options)
{
    struct option_size *const period = &options->ground.period;
    if (options->tileable && period->width != 0) {
        cli_error("--tileable: means --period %zux%zu; leave one of them out", options->size.width,
                  options->size.height);
        return false;
    }
    *period = options->tileable ? options->size : *period;
    return true;
}

int cli_terrain(char **argv)
{
    static struct terrain_options options = {.ground = GROUND_OPTIONS_UNSET};
    switch (options_parse(&terrain_table, argv, &options)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    if (!set_tileable(&options)) {
        return CLI_USAGE;
    }
    struct source source = {.name = NULL};
    int status = source_open(&source, &options.ground, options.step);
    if (status == CLI_SUCCESS && options.ground.print_recipe) {
        source_print(&source);
    } else if (status == CLI_SUCCESS) {
        status = run(&options, &source);
    }
    source_close(&source);
    return status;
}
