/* SPDX-License-Identifier: MIT
 *
 * The text of the manifest. What is "derived" follows from the rest; it is there for readers.
 */
#include "terrain/world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shared/error.h"
#include "shared/json.h"
#include "shared/path.h"
#include "shared/text.h"
#include "terrain/pattern.h"

/* The files of a product: their pattern as seen from the manifest, after the format and a colon
   where the extension does not say it. False without memory. */
static bool add_files(const struct product *product, bool numbered, const char *manifest,
                      struct text *text)
{
    const char *const extension = path_extension(product->path);
    const bool told = *extension == '.' && strcmp(extension + 1, product->format->name) == 0;
    const bool named = product->layer == &layers[LAYER_FIELD];
    char *const pattern = pattern_of(product->path, numbered);
    char *const relative = pattern != NULL ? path_relative(pattern, manifest) : NULL;
    char *const whole =
        relative != NULL
            ? text_join((const char *const[]){named ? product->content : "", named ? "=" : "",
                                              told ? "" : product->format->name, told ? "" : ":",
                                              relative, NULL})
            : NULL;
    if (whole != NULL) {
        json_add_string(text, whole);
    }
    free(pattern);
    free(relative);
    free(whole);
    return whole != NULL;
}

/* The files of --out, sorted by the names of the outputs; an output may have several. */
static bool add_fields(const struct products *products, bool numbered, const char *manifest,
                       struct text *text)
{
    bool is_first = true;
    text_add(text, "  \"out\": [");
    for (size_t i = 0; i < products->count; i++) {
        const struct product *const product = &products->list[i];
        if (product->layer != &layers[LAYER_FIELD]) {
            continue;
        }
        text_add(text, "%s", is_first ? "" : ", ");
        if (!add_files(product, numbered, manifest, text)) {
            return false;
        }
        is_first = false;
    }
    text_add(text, "],\n");
    return true;
}

/* Of the files of --output and --masks the first one says what the others are called. */
static bool add_all_files(const struct products *products, bool numbered, const char *manifest,
                          struct text *text)
{
    static const char *const options[] = {"--heights",  "--normals", "--hillshade", "--relief",
                                          "--gradient", "--slope",   "--curvature", "--masks",
                                          "--output",   NULL};
    for (const char *const *option = options; *option != NULL; option++) {
        size_t i = 0;
        while (i < products->count && strcmp(products->list[i].option, *option) != 0) {
            i++;
        }
        text_add(text, "  \"%s\": ", *option + 2);
        if (i == products->count) {
            text_add(text, "null");
        } else if (!add_files(&products->list[i], numbered, manifest, text)) {
            return false;
        }
        text_add(text, ",\n");
    }
    return add_fields(products, numbered, manifest, text);
}

/* What the relief depends on besides the ground and the light */
static void add_palette(const struct relief *relief, struct text *text)
{
    const struct palette *const palette = relief->palette;
    if (palette == NULL) {
        text_add(text, "  \"palette\": null,\n");
    } else if (palette->name != NULL) {
        text_add(text, "  \"palette\": \"%s\",\n", palette->name);
    } else {
        text_add(text, "  \"palette\": \"a file with the FNV-1a hash %08lx\",\n",
                 (unsigned long)palette->sum);
    }
}

static void add_derived(const struct job *job, struct text *text)
{
    const struct ground *const ground = &job->surface.ground;
    const struct level *const raster = &job->tiling.levels[0];
    text_add(text, "  \"derived\": {\n    \"tiles\": [%zu, %zu],\n", raster->across, raster->down);
    text_add(text, "    \"range\": [%.9g, %.9g],\n", (double)ground->lowest,
             (double)ground->highest);
    text_add(text, "    \"16-bit heights\": [%.9g, %.9g]", (double)(ground->floor + 0.0f),
             (double)(ground->highest + 0.0f));
    for (size_t i = 0; i < ground->field_count; i++) {
        const struct ground_field *const field = &ground->fields[i];
        if (isfinite(field->lowest) && isfinite(field->highest)) {
            text_add(text, ",\n    \"16-bit %s\": [%.9g, %.9g]", job->source->fields[i],
                     (double)(field->lowest + 0.0f), (double)(field->highest + 0.0f));
        }
    }
    text_add(text, "\n  }\n");
}

int world_open(struct job *job)
{
    const struct products *const products = &job->products[0];
    const struct product *const first = &products->list[0];
    struct manifest *const manifest = &job->manifest;
    struct text text = {0};
    char *const path = pattern_manifest(first->path);
    manifest->option = first->option;
    manifest->makes_directories = pattern_is(first->path);
    text_add(&text, "{\n  \"manifest\": 1,\n  \"scarp\": \"%s\",\n", scarp_version());
    options_describe(&terrain_table, job->options, &text);
    source_describe(job->source, &text);
    int status = CLI_FAILURE;
    if (path != NULL && add_all_files(products, job->tiling.numbered, path, &text)) {
        add_palette(&job->surface.relief, &text);
        add_derived(job, &text);
        text_add(&text, "}\n");
    } else {
        text.failed = true;
    }
    if (text.failed) {
        cli_error("%s: no memory", first->option);
    } else {
        status = job->options->verify ? manifest_compare(manifest, path, text.bytes)
                                      : manifest_open(manifest, path, text.bytes);
    }
    free(text.bytes);
    free(path);
    return status;
}
