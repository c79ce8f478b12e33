/* SPDX-License-Identifier: MIT
 *
 * Finds what a file name becomes for a tile, and refuses equal names.
 */
#include "terrain/products.h"

#include <errno.h>
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
static bool add(struct products *products, const struct product *product)
{
    const char *const path = product->path;
    for (size_t i = 0; i < products->count; i++) {
        const bool standard_output = strcmp(path, "-") == 0;
        if (strcmp(products->list[i].path, path) == 0 &&
            (standard_output || !file_is_special(path))) {
            cli_error("%s: %s is already written by %s", product->option, file_name(path),
                      products->list[i].option);
            return false;
        }
    }
    char *const copy = text_copy(path);
    if (copy == NULL) {
        cli_error("%s: no memory", product->option);
        return false;
    }
    struct product *const added = &products->list[products->count++];
    *added = *product;
    added->type = common_type(product->layer, product->format);
    added->path = copy;
    return true;
}

/* Adds a file, which has all but its format and its path. */
static bool add_text(struct products *products, struct product *product, const char *text)
{
    const struct layer *const layer = product->layer;
    struct wanted wanted = {
        .option = product->option, .content = product->content, .channels = layer->channels};
    const char *path;
    for (size_t i = 0; layer->types[i] != 0; i++) {
        wanted.types |= layer->types[i];
    }
    product->format = format_choose(&wanted, text, &path);
    product->path = (char *)path;
    return product->format != NULL && add(products, product);
}

bool products_add(struct products *products, const struct layer *layer, const char *text)
{
    struct product product = {.layer = layer, .content = layer->content, .option = layer->option};
    return add_text(products, &product, text);
}

bool products_add_field(struct products *products, size_t field, const char *name, const char *text)
{
    struct product product = {.layer = &layers[LAYER_FIELD],
                              .part = field,
                              .content = name,
                              .option = layers[LAYER_FIELD].option};
    return add_text(products, &product, text);
}

/* Adds STEM-NAME.EXT of a stem with an extension, or STEM-NAME and `extension`. */
static bool add_mask(struct products *products, struct product *product, const char *stem,
                     const char *name)
{
    const char *const end = path_extension(stem);
    char *const begin = text_join_part(stem, (size_t)(end - stem), "-");
    char *const path = begin != NULL ? text_join((const char *const[]){
                                           begin, name, *end != '\0' ? end : GREY_EXTENSION, NULL})
                                     : NULL;
    if (path == NULL) {
        cli_error("%s: no memory", product->option);
    }
    const bool added = path != NULL && add_text(products, product, path);
    free(begin);
    free(path);
    return added;
}

bool products_add_masks(struct products *products, const char *stem)
{
    const char *const end = path_extension(stem);
    const bool is_png =
        *end != '\0' && format_find(end + 1, strlen(end + 1)) == format_find("png", 3);
    const struct layer *const layer = &layers[is_png ? LAYER_MASKS : LAYER_MASK];
    static const char *const pairs[] = {"1", "2"};
    bool added = true;
    for (size_t i = 0; i < (is_png ? 2 : PALETTE_GROUNDS) && added; i++) {
        struct product product = {.layer = layer,
                                  .part = i,
                                  .content = is_png ? "masks" : relief_names[i],
                                  .option = layer->option};
        added = add_mask(products, &product, stem, is_png ? pairs[i] : relief_names[i]);
    }
    return added;
}

bool products_add_stem(struct products *products, const char *stem, bool compare)
{
    static const int stem_layers[] = {LAYER_HEIGHTS, LAYER_NORMALS, LAYER_HILLSHADE, LAYER_RELIEF,
                                      LAYER_COMPARE};
    for (size_t i = 0; i < (compare ? 5 : 4); i++) {
        const struct layer *const layer = &layers[stem_layers[i]];
        const char *const extension = layer->channels == 1 ? GREY_EXTENSION : COLOUR_EXTENSION;
        struct product product = {.layer = layer,
                                  .content = layer->content,
                                  .option = "--output",
                                  .format = format_find(extension + 1, 3)};
        product.path = text_join((const char *const[]){stem, "-", layer->name, extension, NULL});
        const bool added = product.path != NULL && add(products, &product);
        free(product.path);
        if (!added) {
            return false;
        }
    }
    return true;
}

static bool to_standard_output(const struct products *products)
{
    for (size_t i = 0; i < products->count; i++) {
        if (strcmp(products->list[i].path, "-") == 0) {
            return true;
        }
    }
    return false;
}

bool products_are_files(const struct products *products)
{
    for (size_t i = 0; i < products->count; i++) {
        const char *const path = products->list[i].path;
        if (strcmp(path, "-") == 0 || file_is_special(path)) {
            return false;
        }
    }
    return true;
}

unsigned products_needs(const struct products *products)
{
    unsigned needs = 0;
    for (size_t i = 0; i < products->count; i++) {
        needs |= products->list[i].layer->needs;
    }
    return needs;
}

bool products_check(const struct products *products, const struct tiling *tiling)
{
    if (tiling->numbered && to_standard_output(products)) {
        cli_error("--tile: tiles cannot go to standard output, only to files");
        return false;
    }
    if (tiling->level_count > 1 && !products_are_files(products)) {
        cli_error(
            "--levels: levels can go to files only, not to standard output, pipes or devices");
        return false;
    }
    for (size_t i = 0; i < products->count; i++) {
        if (!pattern_check(products->list[i].path, tiling, products->list[i].option)) {
            return false;
        }
    }
    return true;
}

/* What the layer is of this tile */
static struct raster make_raster(const struct product *product, const struct surface *surface,
                                 const struct tile *tile)
{
    const size_t zoom = product->layer == &layers[LAYER_COMPARE] ? surface->zoom : 0;
    const double up = (double)(surface->height - 1) - (double)tile->row;
    return (struct raster){
        .width = tile->width * (zoom == 0 ? 1 : 2 * zoom),
        .height = tile->height * (zoom == 0 ? 1 : zoom),
        .channels = product->layer->channels,
        .type = product->type,
        .x = surface->x0 + (double)tile->column * surface->step,
        .y = surface->y0 + up * surface->step,
        .step = surface->step,
        .content = product->content,
        .times = zoom == 0 ? 1 : zoom,
        .epsg = surface->epsg,
    };
}

/* The name of a tile; GDAL's own of a level of one file, if it has one */
static char *path_of(const struct product *product, const struct tile *tile)
{
    const char *const overview = product->format->overview;
    if (tile->level == 0 || tile->numbered || overview == NULL ||
        pattern_has_level(product->path)) {
        return pattern_expand(product->path, tile);
    }
    struct text name = {0};
    text_add(&name, "%s", product->path);
    for (unsigned i = 0; i < tile->level; i++) {
        text_add(&name, "%s", overview);
    }
    return name.bytes;
}

void products_measure(const struct products *products, const struct surface *surface,
                      const struct tile *tile, uint64_t *exact, uint64_t *most)
{
    for (size_t i = 0; i < products->count; i++) {
        const struct product *const product = &products->list[i];
        const struct writer writer = {.raster = make_raster(product, surface, tile),
                                      .format = product->format};
        bool is_exact;
        const uint64_t bytes = writer_bytes(&writer, &is_exact);
        *(is_exact ? &exact[i] : &most[i]) += bytes;
    }
}

bool products_begin(struct products *products, const struct surface *surface,
                    const struct tile *tile)
{
    for (size_t i = 0; i < products->count; i++) {
        struct product *const product = &products->list[i];
        free(product->tile_path);
        product->tile_path = path_of(product, tile);
        if (product->tile_path == NULL) {
            cli_error("%s: no memory", product->option);
            return false;
        }
        product->writer = (struct writer){.raster = make_raster(product, surface, tile),
                                          .format = product->format,
                                          .path = product->tile_path,
                                          .makes_directories = pattern_is(product->path)};
        product->row_bytes = raster_row_bytes(&product->writer.raster);
        product->failed = false;
    }
    return true;
}

bool products_are_there(const struct products *products, struct file_time since)
{
    for (size_t i = 0; i < products->count; i++) {
        if (!writer_is_there(&products->list[i].writer, since)) {
            return false;
        }
    }
    return true;
}

bool products_wait(const struct products *products)
{
    for (size_t i = 0; i < products->count; i++) {
        if (products->list[i].writer.file.waits) {
            return true;
        }
    }
    return false;
}

void products_sweep(const struct products *products)
{
    for (size_t i = 0; i < products->count; i++) {
        unfinished_sweep(products->list[i].tile_path);
    }
}

void product_error(const struct product *product)
{
    cli_error("%s: %s: %s", product->option, file_name(product->tile_path),
              file_reason(product->reason));
}

static bool check(struct product *product, bool succeeded)
{
    if (!succeeded) {
        product->reason = errno;
        product->failed = true;
    }
    return succeeded;
}

bool products_open(struct products *products, const char *manifest)
{
    for (size_t i = 0; i < products->count; i++) {
        struct product *const product = &products->list[i];
        errno = 0;
        if (!check(product, writer_open(&product->writer))) {
            return false;
        }
        const char *const path = product->writer.file.path;
        if (manifest != NULL && path != NULL && strcmp(path, manifest) == 0) {
            errno = EBUSY;
            return check(product, false);
        }
        for (size_t j = 0; j < i; j++) {
            if (writer_is_same(&product->writer, &products->list[j].writer)) {
                errno = EBUSY;
                return check(product, false);
            }
        }
    }
    return true;
}

bool products_complete(struct products *products)
{
    errno = 0;
    for (size_t i = 0; i < products->count; i++) {
        if (!check(&products->list[i], writer_close(&products->list[i].writer))) {
            return false;
        }
    }
    return true;
}

bool products_publish(struct products *products)
{
    errno = 0;
    for (size_t i = 0; i < products->count; i++) {
        if (!check(&products->list[i], writer_publish(&products->list[i].writer))) {
            for (size_t j = 0; j <= i; j++) {
                writer_retract(&products->list[j].writer);
            }
            return false;
        }
    }
    for (size_t i = 0; i < products->count; i++) {
        if (!check(&products->list[i], writer_settle(&products->list[i].writer))) {
            return false;
        }
    }
    return true;
}

/* From the last one on: the files before it may be the reason why it found its directory. */
void products_discard(struct products *products)
{
    for (size_t i = products->count; i > 0; i--) {
        struct writer *const writer = &products->list[i - 1].writer;
        writer_discard(writer);
        *writer = (struct writer){0};
    }
}

void products_free(struct products *products)
{
    for (size_t i = 0; i < products->count; i++) {
        free(products->list[i].path);
        free(products->list[i].tile_path);
    }
    *products = (struct products){.count = 0};
}
