/* SPDX-License-Identifier: MIT
 *
 * Makes the list of products.
 */
#include "terrain/asked.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/formats.h"
#include "shared/error.h"

static bool read_field(struct asked_field *field, const char *text)
{
    const size_t length = strcspn(text, "=");
    if (length == 0 || length > ASKED_NAME_MOST || text[length] == '\0' ||
        text[length + 1] == '\0') {
        cli_error("--out: '%.60s' is not an output of the recipe and a file: NAME=FILE", text);
        return false;
    }
    memcpy(field->name, text, length);
    field->name[length] = '\0';
    field->file = text + length + 1;
    return true;
}

static int compare_fields(const void *a, const void *b)
{
    const struct asked_field *const one = a, *const other = b;
    const int order = strcmp(one->name, other->name);
    return order != 0 ? order : strcmp(one->file, other->file);
}

bool asked_read(struct asked *asked, const struct option_list *list, struct source *source)
{
    asked->count = list->count;
    for (size_t i = 0; i < list->count; i++) {
        if (!read_field(&asked->fields[i], list->texts[i])) {
            return false;
        }
    }
    qsort(asked->fields, asked->count, sizeof asked->fields[0], compare_fields);
    for (size_t i = 0; i < asked->count; i++) {
        asked->fields[i].number = source_field(source, asked->fields[i].name);
    }
    return true;
}

bool asked_products(const struct terrain_options *options, const struct asked *asked,
                    struct products *products)
{
    const char *const files[] = {
        [LAYER_HEIGHTS] = options->heights,     [LAYER_NORMALS] = options->normals,
        [LAYER_HILLSHADE] = options->hillshade, [LAYER_RELIEF] = options->relief,
        [LAYER_GRADIENT] = options->gradient,   [LAYER_SLOPE] = options->slope,
        [LAYER_CURVATURE] = options->curvature};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        if (files[i] != NULL && !products_add(products, &layers[i], files[i])) {
            return false;
        }
    }
    for (size_t i = 0; i < asked->count; i++) {
        const struct asked_field *const field = &asked->fields[i];
        if (!products_add_field(products, field->number, field->name, field->file)) {
            return false;
        }
    }
    if (options->masks != NULL && !products_add_masks(products, options->masks)) {
        return false;
    }
    const char *const stem =
        options->output == NULL && products->count == 0 ? "terrain" : options->output;
    if (stem == NULL && options->compare != 0) {
        cli_error("--compare: needs --output");
        return false;
    }
    return stem == NULL || products_add_stem(products, stem, options->compare != 0);
}

/* Integers need an interval that they can divide. */
static bool check_field(const struct product *product, const struct ground *ground)
{
    const struct ground_field *const field = &ground->fields[product->part];
    if (product->type == SAMPLE_F32 || (isfinite(field->lowest) && isfinite(field->highest))) {
        return true;
    }
    cli_error("--out: %s grows with x or y, so there is no scale for 16-bit integers; .r32, .pfm, "
              ".img, .tif and .npy hold floats",
              product->content);
    return false;
}

static bool has_curvature(const struct ground *ground)
{
    const double origin = 0.0;
    float values[6];
    const struct scarp_samples out = {.value = &values[0],
                                      .dx = &values[1],
                                      .dy = &values[2],
                                      .dxx = &values[3],
                                      .dxy = &values[4],
                                      .dyy = &values[5]};
    return ground_dry_points(ground, 1, &origin, &origin, &out);
}

static bool check_product(const struct product *product, const struct ground *ground)
{
    if (product->layer == &layers[LAYER_FIELD]) {
        return check_field(product, ground);
    }
    if (product->layer == &layers[LAYER_CURVATURE] && !has_curvature(ground)) {
        cli_error("--curvature: the heights have no second derivatives; some fractals, gullies, "
                  "slopes and distances in cells have none");
        return false;
    }
    return true;
}

static bool check_system(const struct products *products, unsigned epsg)
{
    bool has_place = false;
    for (size_t i = 0; i < products->count && epsg != 0; i++) {
        const struct format *const format = products->list[i].format;
        has_place |= format == &format_tif || format == &format_img;
        if (format == &format_img && !img_knows(epsg)) {
            cli_error("--crs: headers of .img can name UTM zones only, EPSG:32601 to 32660 and "
                      "32701 to 32760; .tif knows EPSG:%u",
                      epsg);
            return false;
        }
    }
    if (epsg != 0 && !has_place) {
        cli_error("--crs: is for .tif and .img, and no such file is asked for");
        return false;
    }
    return true;
}

bool asked_check(const struct products *products, const struct surface *surface)
{
    for (size_t i = 0; i < products->count; i++) {
        if (!check_product(&products->list[i], &surface->ground)) {
            return false;
        }
    }
    return check_system(products, surface->epsg);
}
