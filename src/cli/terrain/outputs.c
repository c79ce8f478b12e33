/* SPDX-License-Identifier: MIT
 *
 * Finds what a file name becomes for a tile, and refuses equal names.
 */
#include "terrain/outputs.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/choose.h"
#include "shared/error.h"
#include "shared/path.h"
#include "shared/text.h"
#include "shared/unfinished.h"
#include "terrain/pattern.h"

#ifdef SCARP_CLI_ZLIB
#define GREY_EXTENSION ".png"
#define COLOUR_EXTENSION ".png"
#else
#define GREY_EXTENSION ".pgm"
#define COLOUR_EXTENSION ".ppm"
#endif

/* The best type of samples that both know; 0 if there is none. */
static enum sample_type common_type(const struct layer *layer, const struct format *format)
{
    for (size_t i = 0; layer->types[i] != 0; i++) {
        if ((format->types[layer->channels] & layer->types[i]) != 0) {
            return layer->types[i];
        }
    }
    return (enum sample_type)0;
}

/* Adds a file of which all but the type of samples is set, and takes `path` for its own. */
static bool add(struct outputs *outputs, const struct output *output)
{
    const char *const path = output->path;
    for (size_t i = 0; i < outputs->count; i++) {
        const bool standard_output = strcmp(path, "-") == 0;
        if (strcmp(outputs->list[i].path, path) == 0 &&
            (standard_output || !file_is_special(path))) {
            cli_error("%s: %s is already written by %s", output->option, file_name(path),
                      outputs->list[i].option);
            return false;
        }
    }
    char *const copy = text_copy(path);
    if (copy == NULL) {
        cli_error("%s: no memory", output->option);
        return false;
    }
    struct output *const added = &outputs->list[outputs->count++];
    *added = *output;
    added->type = common_type(output->layer, output->format);
    added->path = copy;
    return true;
}

/* Adds a file, which has all but its format and its path. */
static bool add_text(struct outputs *outputs, struct output *output, const char *text)
{
    const struct layer *const layer = output->layer;
    struct wanted wanted = {
        .option = output->option, .content = output->content, .channels = layer->channels};
    const char *path;
    for (size_t i = 0; layer->types[i] != 0; i++) {
        wanted.types |= layer->types[i];
    }
    output->format = format_choose(&wanted, text, &path);
    output->path = (char *)path;
    return output->format != NULL && add(outputs, output);
}

bool outputs_add(struct outputs *outputs, const struct layer *layer, const char *text)
{
    struct output output = {.layer = layer, .content = layer->content, .option = layer->option};
    return add_text(outputs, &output, text);
}

bool outputs_add_field(struct outputs *outputs, size_t field, const char *name, const char *text)
{
    struct output output = {.layer = &layers[LAYER_FIELD],
                            .part = field,
                            .content = name,
                            .option = layers[LAYER_FIELD].option};
    return add_text(outputs, &output, text);
}

/* Adds STEM-NAME.EXT of a stem with an extension, or STEM-NAME and `extension`. */
static bool add_mask(struct outputs *outputs, struct output *output, const char *stem,
                     const char *name)
{
    const char *const end = path_extension(stem);
    char *const begin = text_join_part(stem, (size_t)(end - stem), "-");
    char *const path = begin != NULL ? text_join((const char *const[]){
                                           begin, name, *end != '\0' ? end : GREY_EXTENSION, NULL})
                                     : NULL;
    if (path == NULL) {
        cli_error("%s: no memory", output->option);
    }
    const bool added = path != NULL && add_text(outputs, output, path);
    free(begin);
    free(path);
    return added;
}

bool outputs_add_masks(struct outputs *outputs, const char *stem)
{
    const char *const end = path_extension(stem);
    const bool is_png =
        *end != '\0' && format_find(end + 1, strlen(end + 1)) == format_find("png", 3);
    const struct layer *const layer = &layers[is_png ? LAYER_MASKS : LAYER_MASK];
    static const char *const pairs[] = {"1", "2"};
    bool added = true;
    for (size_t i = 0; i < (is_png ? 2 : PALETTE_GROUNDS) && added; i++) {
        struct output output = {.layer = layer,
                                .part = i,
                                .content = is_png ? "masks" : relief_names[i],
                                .option = layer->option};
        added = add_mask(outputs, &output, stem, is_png ? pairs[i] : relief_names[i]);
    }
    return added;
}

bool outputs_add_stem(struct outputs *outputs, const char *stem, bool compare)
{
    static const int stem_layers[] = {LAYER_HEIGHTS, LAYER_NORMALS, LAYER_HILLSHADE, LAYER_RELIEF,
                                      LAYER_COMPARE};
    for (size_t i = 0; i < (compare ? 5 : 4); i++) {
        const struct layer *const layer = &layers[stem_layers[i]];
        const char *const extension = layer->channels == 1 ? GREY_EXTENSION : COLOUR_EXTENSION;
        struct output output = {.layer = layer,
                                .content = layer->content,
                                .option = "--output",
                                .format = format_find(extension + 1, 3)};
        output.path = text_join((const char *const[]){stem, "-", layer->name, extension, NULL});
        const bool added = output.path != NULL && add(outputs, &output);
        free(output.path);
        if (!added) {
            return false;
        }
    }
    return true;
}

bool outputs_to_standard_output(const struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++) {
        if (strcmp(outputs->list[i].path, "-") == 0) {
            return true;
        }
    }
    return false;
}

bool outputs_are_files(const struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++) {
        const char *const path = outputs->list[i].path;
        if (strcmp(path, "-") == 0 || file_is_special(path)) {
            return false;
        }
    }
    return true;
}

unsigned outputs_needs(const struct outputs *outputs)
{
    unsigned needs = 0;
    for (size_t i = 0; i < outputs->count; i++) {
        needs |= outputs->list[i].layer->needs;
    }
    return needs;
}

bool outputs_check(const struct outputs *outputs, const struct tiling *tiling)
{
    if (tiling->numbered && outputs_to_standard_output(outputs)) {
        cli_error("--tile: tiles cannot go to standard output, only to files");
        return false;
    }
    if (tiling->level_count > 1 && !outputs_are_files(outputs)) {
        cli_error(
            "--levels: levels can go to files only, not to standard output, pipes or devices");
        return false;
    }
    for (size_t i = 0; i < outputs->count; i++) {
        if (!pattern_check(outputs->list[i].path, tiling, outputs->list[i].option)) {
            return false;
        }
    }
    return true;
}

/* What the layer is of this tile */
static struct raster make_raster(const struct output *output, const struct surface *surface,
                                 const struct tile *tile)
{
    const size_t zoom = output->layer == &layers[LAYER_COMPARE] ? surface->zoom : 0;
    const double up = (double)(surface->height - 1) - (double)tile->row;
    return (struct raster){
        .width = tile->width * (zoom == 0 ? 1 : 2 * zoom),
        .height = tile->height * (zoom == 0 ? 1 : zoom),
        .channels = output->layer->channels,
        .type = output->type,
        .x = surface->x0 + (double)tile->column * surface->step,
        .y = surface->y0 + up * surface->step,
        .step = surface->step,
        .content = output->content,
        .times = zoom == 0 ? 1 : zoom,
        .epsg = surface->epsg,
    };
}

/* The name of a tile; GDAL's own of a level of one file, if it has one */
static char *path_of(const struct output *output, const struct tile *tile)
{
    const char *const overview = output->format->overview;
    if (tile->level == 0 || tile->numbered || overview == NULL || pattern_has_level(output->path)) {
        return pattern_expand(output->path, tile);
    }
    struct text name = {0};
    text_add(&name, "%s", output->path);
    for (unsigned i = 0; i < tile->level; i++) {
        text_add(&name, "%s", overview);
    }
    return name.bytes;
}

void outputs_measure(const struct outputs *outputs, const struct surface *surface,
                     const struct tile *tile, uint64_t *exact, uint64_t *most)
{
    for (size_t i = 0; i < outputs->count; i++) {
        const struct output *const output = &outputs->list[i];
        const struct writer writer = {.raster = make_raster(output, surface, tile),
                                      .format = output->format};
        bool is_exact;
        const uint64_t bytes = writer_bytes(&writer, &is_exact);
        *(is_exact ? &exact[i] : &most[i]) += bytes;
    }
}

bool outputs_begin(struct outputs *outputs, const struct surface *surface, const struct tile *tile)
{
    for (size_t i = 0; i < outputs->count; i++) {
        struct output *const output = &outputs->list[i];
        free(output->tile_path);
        output->tile_path = path_of(output, tile);
        if (output->tile_path == NULL) {
            cli_error("%s: no memory", output->option);
            return false;
        }
        output->writer = (struct writer){.raster = make_raster(output, surface, tile),
                                         .format = output->format,
                                         .path = output->tile_path,
                                         .makes_directories = pattern_is(output->path)};
        output->row_bytes = raster_row_bytes(&output->writer.raster);
        output->failed = false;
    }
    return true;
}

bool outputs_are_there(const struct outputs *outputs, struct file_time since)
{
    for (size_t i = 0; i < outputs->count; i++) {
        if (!writer_is_there(&outputs->list[i].writer, since)) {
            return false;
        }
    }
    return true;
}

bool outputs_wait(const struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++) {
        if (outputs->list[i].writer.file.waits) {
            return true;
        }
    }
    return false;
}

void outputs_sweep(const struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++) {
        unfinished_sweep(outputs->list[i].tile_path);
    }
}

void output_error(const struct output *output)
{
    cli_error("%s: %s: %s", output->option, file_name(output->tile_path),
              file_reason(output->reason));
}

static bool check(struct output *output, bool succeeded)
{
    if (!succeeded) {
        output->reason = errno;
        output->failed = true;
    }
    return succeeded;
}

bool outputs_open(struct outputs *outputs, const char *manifest)
{
    for (size_t i = 0; i < outputs->count; i++) {
        struct output *const output = &outputs->list[i];
        errno = 0;
        if (!check(output, writer_open(&output->writer))) {
            return false;
        }
        const char *const path = output->writer.file.path;
        if (manifest != NULL && path != NULL && strcmp(path, manifest) == 0) {
            errno = EBUSY;
            return check(output, false);
        }
        for (size_t j = 0; j < i; j++) {
            if (writer_is_same(&output->writer, &outputs->list[j].writer)) {
                errno = EBUSY;
                return check(output, false);
            }
        }
    }
    return true;
}

bool outputs_complete(struct outputs *outputs)
{
    errno = 0;
    for (size_t i = 0; i < outputs->count; i++) {
        if (!check(&outputs->list[i], writer_close(&outputs->list[i].writer))) {
            return false;
        }
    }
    return true;
}

bool outputs_publish(struct outputs *outputs)
{
    errno = 0;
    for (size_t i = 0; i < outputs->count; i++) {
        if (!check(&outputs->list[i], writer_publish(&outputs->list[i].writer))) {
            for (size_t j = 0; j <= i; j++) {
                writer_retract(&outputs->list[j].writer);
            }
            return false;
        }
    }
    for (size_t i = 0; i < outputs->count; i++) {
        if (!check(&outputs->list[i], writer_settle(&outputs->list[i].writer))) {
            return false;
        }
    }
    return true;
}

/* From the last one on: the files before it may be the reason why it found its directory. */
void outputs_discard(struct outputs *outputs)
{
    for (size_t i = outputs->count; i > 0; i--) {
        struct writer *const writer = &outputs->list[i - 1].writer;
        writer_discard(writer);
        *writer = (struct writer){0};
    }
}

void outputs_free(struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++) {
        free(outputs->list[i].path);
        free(outputs->list[i].tile_path);
    }
    *outputs = (struct outputs){.count = 0};
}
