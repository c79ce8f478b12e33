/* SPDX-License-Identifier: MIT
 *
 * The text of the manifest. What is "derived" follows from the rest; it is there for readers.
 */
#include "terrain/world.h"

#include <stdlib.h>
#include <string.h>

#include "shared/error.h"
#include "shared/json.h"
#include "shared/path.h"
#include "shared/text.h"
#include "terrain/pattern.h"

/* The files of one option: their pattern as seen from the manifest, after the format and a colon
   where the extension does not tell it. False without memory. */
static bool add_files(const struct output *output, bool numbered, const char *manifest,
                      struct text *text)
{
    const char *const extension = path_extension(output->path);
    const bool told = *extension == '.' && strcmp(extension + 1, output->format->name) == 0;
    char *const pattern = pattern_of(output->path, numbered);
    char *const relative = pattern != NULL ? path_relative(pattern, manifest) : NULL;
    char *const whole = relative != NULL
                            ? text_join((const char *const[]){told ? "" : output->format->name,
                                                              told ? "" : ":", relative, NULL})
                            : NULL;
    if (whole != NULL) {
        text_add(text, "  \"%s\": ", output->option + 2);
        json_add_string(text, whole);
        text_add(text, ",\n");
    }
    free(pattern);
    free(relative);
    free(whole);
    return whole != NULL;
}

/* Of the files of --output the first one says what the others are called. */
static bool add_all_files(const struct outputs *outputs, bool numbered, const char *manifest,
                          struct text *text)
{
    static const char *const options[] = {"--heights",  "--normals", "--hillshade", "--relief",
                                          "--gradient", "--output",  NULL};
    for (const char *const *option = options; *option != NULL; option++) {
        size_t i = 0;
        while (i < outputs->count && strcmp(outputs->list[i].option, *option) != 0) {
            i++;
        }
        if (i == outputs->count) {
            text_add(text, "  \"%s\": null,\n", *option + 2);
        } else if (!add_files(&outputs->list[i], numbered, manifest, text)) {
            return false;
        }
    }
    return true;
}

/* What the relief depends on beside the ground and the light */
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

static void add_derived(const struct surface *surface, const struct tiling *tiling,
                        struct text *text)
{
    text_add(text, "  \"derived\": {\n    \"tiles\": [%zu, %zu],\n", tiling->across, tiling->down);
    text_add(text, "    \"range\": [%.9g, %.9g],\n", (double)surface->ground.lowest,
             (double)surface->ground.highest);
    text_add(text, "    \"16-bit heights\": [%.9g, %.9g]\n  }\n",
             (double)(surface->ground.floor + 0.0f), (double)(surface->ground.highest + 0.0f));
}

int world_open(struct job *job)
{
    const struct outputs *const outputs = &job->outputs[0];
    const struct output *const first = &outputs->list[0];
    struct manifest *const manifest = &job->manifest;
    struct text text = {0};
    char *const path = pattern_manifest(first->path);
    manifest->option = first->option;
    manifest->makes_directories = pattern_is(first->path);
    text_add(&text, "{\n  \"manifest\": 1,\n  \"scarp\": \"%s\",\n", scarp_version());
    options_describe(&terrain_table, job->options, &text);
    source_describe(job->source, &text);
    int status = CLI_FAILURE;
    if (path != NULL && add_all_files(outputs, job->tiling.numbered, path, &text)) {
        add_palette(&job->surface.relief, &text);
        add_derived(&job->surface, &job->tiling, &text);
        text_add(&text, "}\n");
    } else {
        text.failed = true;
    }
    if (text.failed) {
        cli_error("%s: no memory", first->option);
    } else {
        status = manifest_open(manifest, path, text.bytes);
    }
    free(text.bytes);
    free(path);
    return status;
}
