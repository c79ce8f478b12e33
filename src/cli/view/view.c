/* SPDX-License-Identifier: MIT
 *
 * `scarp view`: from the options to the picture, and the closing line. Rays find the ground in
 * march.c and get their colours in light.c; bucket.c makes pixels of them, and picture.c a file.
 */
#include "commands.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "formats/choose.h"
#include "ground/source.h"
#include "shared/amount.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/running.h"
#include "view/picture.h"
#include "view/sky.h"
#include "view/view_options.h"
#include "view/viewpoint.h"

#define HAZE 4.0f /* sides of the view */

static bool choose_format(const struct view_options *options, struct writer *writer)
{
    static const struct wanted wanted = {
        .option = "--output", .content = "pictures", .channels = 3, .types = SAMPLE_U8};
    if (options->output == NULL) {
        cli_error("--output: must be given; see: scarp help view");
        return false;
    }
    writer->format = format_choose(&wanted, options->output, &writer->path);
    writer->raster = (struct raster){.width = options->size.width,
                                     .height = options->size.height,
                                     .channels = 3,
                                     .type = SAMPLE_U8,
                                     .step = 1.0,
                                     .content = "view",
                                     .times = 1};
    return writer->format != NULL;
}

/* Whether the camera is above the ground. False, with a line on stderr, if not. */
static bool check_camera(const struct view_options *options, const struct scene *scene)
{
    float value;
    interrupt_unless(ground_points(&scene->ground, 1, &options->camera.x, &options->camera.y,
                                   &(struct scarp_samples){.value = &value}));
    if ((float)options->camera.height <= value) {
        cli_error("--camera: the height %.9g is not above the ground, which is %.9g high there",
                  options->camera.height, (double)value);
        return false;
    }
    return true;
}

static bool make_scene(struct view_options *options, const struct source *source,
                       struct palette *palette, struct scene *scene)
{
    struct ground ground;
    if (options->haze != 0.0f && options->haze < 1.0f) {
        cli_error("--haze: is not 0 or a number from 1 to 2^24");
        return false;
    }
    if (!source_ground(source, &ground) ||
        !source_open_palette(source, options->palette, palette)) {
        return false;
    }
    scene->sun = direction_of(options->sun.azimuth, options->sun.elevation);
    scene->sunlight = sky_sunlight(scene->sun);
    scene_set_ground(scene, &ground, options->origin.x, options->origin.y);
    scene->haze = options->haze != INFINITY ? options->haze : HAZE * scene->side;
    palette_resolve(palette, scene->survey.low, scene->survey.high);
    colours_make(palette, &scene->colours);
    viewpoint_choose(options, scene);
    if (interrupted()) {
        cli_error("interrupted: nothing was written");
        return false;
    }
    if (!check_camera(options, scene)) {
        return false;
    }
    scene->camera = (struct camera){.x = options->camera.x,
                                    .y = options->camera.y,
                                    .z = (float)options->camera.height,
                                    .width = options->size.width,
                                    .height = options->size.height};
    camera_turn(&scene->camera, options->look.azimuth, options->look.elevation, options->fov);
    scene_set_bands(scene);
    return true;
}

static void print_calls(FILE *stream, const char *what, uint64_t calls, uint64_t points)
{
    char count[AMOUNT_SIZE];
    fprintf(stream, "%s: %spoints in %llu calls, %.0f each\n", what,
            amount_count(count, (double)points), (unsigned long long)calls,
            calls != 0 ? (double)points / (double)calls : 0.0);
}

static void print_summary(const struct view_options *options, const struct writer *writer,
                          const struct crew *crew, const struct picture_counts *counts,
                          double duration)
{
    const bool is_file = strcmp(writer->path, "-") != 0 && !file_is_special(writer->path);
    FILE *const stream = is_file ? stdout : stderr;
    const double time = duration > 1e-9 ? duration : 1e-9;
    print_calls(stream, "marching", counts->march_calls, counts->march_points);
    print_calls(stream, "shadows", counts->shadow_calls, counts->shadow_points);
    print_calls(stream, "light", counts->light_calls, counts->light_points);
    fprintf(stream, "camera: --camera %.9g,%.9g,%.9g --look %.9g,%.9g\n", options->camera.x,
            options->camera.y, options->camera.height, options->look.azimuth,
            options->look.elevation);
    char rays[AMOUNT_SIZE], elapsed[AMOUNT_SIZE], speed[AMOUNT_SIZE];
    fprintf(stream, "%zux%zu pixels, %srays in %s: %srays per second", options->size.width,
            options->size.height, amount_count(rays, (double)counts->rays),
            amount_seconds(elapsed, duration), amount_count(speed, (double)counts->rays / time));
    running_print(stream, crew);
}

static int tell_failure(const struct writer *writer, enum picture_result result)
{
    const int reason = errno;
    if (interrupted()) {
        cli_error("interrupted: the unfinished file is removed");
    } else if (result == PICTURE_NO_MEMORY) {
        cli_error("no memory for rows of %zu pixels", writer->raster.width);
    } else {
        cli_error("--output: %s: %s", file_name(writer->path), file_reason(reason));
    }
    return CLI_FAILURE;
}

/* Writes the picture to a file that appears when it is whole. */
static int write_picture(const struct view_options *options, const struct scene *scene,
                         struct writer *writer, struct crew *crew, struct picture_counts *counts)
{
    errno = 0;
    if (!writer_open(writer)) {
        const bool is_usage = !interrupted() && errno != EPIPE;
        tell_failure(writer, PICTURE_FAILED);
        return is_usage ? CLI_USAGE : CLI_FAILURE;
    }
    struct progress progress;
    progress_start(&progress, picture_buckets(scene), options->running.quiet != 0);
    enum picture_result result =
        picture_write(scene, options->samples, writer, crew, &progress, counts);
    if (result == PICTURE_DONE &&
        !(writer_close(writer) && writer_publish(writer) && writer_settle(writer))) {
        result = PICTURE_FAILED;
    }
    const int reason = errno;
    progress_end(&progress, result == PICTURE_DONE);
    errno = reason;
    return result == PICTURE_DONE ? CLI_SUCCESS : tell_failure(writer, result);
}

static int run(struct view_options *options, const struct source *source)
{
    static struct scene scene; /* too large for a stack */
    struct writer writer = {.path = NULL};
    if (!choose_format(options, &writer)) {
        return CLI_USAGE;
    }
    struct crew *const crew = running_begin(&options->running);
    if (crew == NULL) {
        return CLI_FAILURE;
    }
    const double start = running_seconds();
    struct palette palette = {.name = NULL};
    struct picture_counts counts = {.rays = 0};
    const int status = make_scene(options, source, &palette, &scene)
                           ? write_picture(options, &scene, &writer, crew, &counts)
                           : CLI_USAGE;
    if (status == CLI_SUCCESS && !options->running.quiet) {
        print_summary(options, &writer, crew, &counts, running_seconds() - start);
    }
    writer_discard(&writer);
    palette_free(&palette);
    crew_close(crew);
    return status;
}

int cli_view(char **argv)
{
    static struct view_options options = VIEW_OPTIONS_UNSET;
    switch (options_parse(&view_table, argv, &options)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    struct source source = {.name = NULL};
    int status = source_open(&source, &options.ground, 1.0);
    if (status == CLI_SUCCESS && options.ground.print_recipe) {
        source_print(&source);
    } else if (status == CLI_SUCCESS) {
        status = run(&options, &source);
    }
    source_close(&source);
    return status;
}
