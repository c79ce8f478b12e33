/* SPDX-License-Identifier: MIT
 *
 * Reads the recipe of a terrain, or writes that of one noise.
 */
#include "ground/source.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/repeat.h"
#include "presets/presets.h"
#include "shared/bounds.h"
#include "shared/error.h"
#include "shared/file.h"
#include "shared/json.h"
#include "shared/number.h"

#define TEXT_MOST 16384

static int tell_no_memory(const struct source *source)
{
    cli_error("%s: no memory", source->option);
    return CLI_FAILURE;
}

/* Adds a number as short as it may be. */
static void add_number(struct text *text, const char *before, double number, bool is_float,
                       const char *after)
{
    char digits[NUMBER_SIZE];
    number_write_shortest(digits, number, is_float);
    text_add(text, "%s%s%s", before, digits, after);
}

/* Writes the recipe of one noise. Sea and plateau are noise values, taken into its interval. */
static void write_noise(struct text *text, const struct ground_options *options,
                        const struct noise_options *noise, const struct scarp_noise *made)
{
    const bool has_plateau = options->plateau != INFINITY;
    float lowest, highest;
    if (scarp_range(made, 2, &lowest, &highest) != SCARP_OK) { /* sampling refuses the noise */
        lowest = -INFINITY;
        highest = INFINITY;
    }
    if (options->sea_level != -INFINITY) {
        const float sea = within(options->sea_level, lowest, highest);
        add_number(text, "param sea = ", (double)(options->height * sea), true, "\n");
    }
    if (noise->phase != NOISE_UNSET) { /* phase 0 is a turn later: noise.c has why */
        add_number(text, "param phase = ", noise->phase == 0.0f ? 1.0 : (double)noise->phase, true,
                   "\n");
    }
    add_number(text, "out height = ", (double)options->height, true,
               has_plateau ? " * min(" : " * ");
    noise_write(noise, text);
    if (has_plateau) {
        add_number(text, ", ", (double)within(options->plateau, lowest, highest), true, ")");
    }
    text_add(text, "\n");
}

static int open_noise(struct source *source, const struct ground_options *options, double step)
{
    struct noise_options noise = options->noise;
    struct scarp_noise made;
    const double tile[2] = {step * (double)options->period.width,
                            step * (double)options->period.height};
    if (options->plateau < options->sea_level) {
        cli_error("--plateau: lies below --sea-level");
        return CLI_USAGE;
    }
    if (options->period.width != 0) {
        if (!repeat_noise(&noise, options->period, step)) {
            return CLI_USAGE;
        }
        source->nearest = noise.frequency;
        source->cells[0] = noise.period[0];
        source->cells[1] = noise.period[1];
    }
    if (!noise_make(&noise, 2, &made)) {
        return CLI_USAGE;
    }
    text_add(&source->text, "recipe 1\n");
    if (tile[0] != 0.0) {
        add_number(&source->text, "tile ", tile[0], false, ", ");
        add_number(&source->text, "", tile[1], false, "\n");
    }
    write_noise(&source->text, options, &noise, &made);
    return source->text.failed ? tell_no_memory(source) : CLI_SUCCESS;
}

static int open_file(struct source *source, const char *path)
{
    char bytes[TEXT_MOST + 1];
    const bool is_input = strcmp(path, "-") == 0;
    errno = 0;
    FILE *const file = is_input ? stdin : fopen(path, "rb");
    const size_t length = file != NULL ? fread(bytes, 1, sizeof bytes, file) : 0;
    const bool has_failed = file == NULL || ferror(file) != 0;
    const int reason = errno;
    if (file != NULL && !is_input) {
        fclose(file);
    }
    if (has_failed) {
        cli_error("--recipe: %s: %s", source->name, file_reason(reason));
        return CLI_USAGE;
    }
    if (length > TEXT_MOST) {
        cli_error("--recipe: %s: is longer than %d bytes", source->name, TEXT_MOST);
        return CLI_USAGE;
    }
    if (memchr(bytes, '\0', length) != NULL) {
        cli_error("--recipe: %s: has a byte that is 0", source->name);
        return CLI_USAGE;
    }
    const size_t mark = length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0; /* of UTF-8 */
    text_add(&source->text, "%.*s", (int)(length - mark), bytes + mark);
    return source->text.failed ? tell_no_memory(source) : CLI_SUCCESS;
}

/* Takes the palette of the line `#: palette NAME`. */
static void find_palette(struct source *source)
{
    static const char key[] = "#: palette ";
    const char *const line = strstr(source->text.bytes, key);
    if (line != NULL) {
        const char *const name = line + strlen(key);
        const size_t length = strcspn(name, " \t\r\n");
        snprintf(source->palette, sizeof source->palette, "%.*s", (int)length, name);
    }
}

/* Reads NAME=VALUE. */
static bool read_value(struct source *source, const char *text)
{
    const size_t length = strcspn(text, "=");
    double number;
    const char *const end = text[length] == '=' ? number_read(text + length + 1, &number) : NULL;
    if (length == 0 || end == NULL || *end != '\0' || !isfinite(number)) {
        cli_error("--set: '%.60s' is not a parameter and its number: NAME=VALUE", text);
        return false;
    }
    text_add(&source->names, "%.*s%c", (int)length, text, '\0');
    source->values[source->ground.count++].value = number;
    return true;
}

/* Reads the values; of two of one name the later one counts, since it is set later. */
static int read_values(struct source *source, const struct option_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        if (!read_value(source, list->texts[i])) {
            return CLI_USAGE;
        }
    }
    if (source->names.failed) {
        return tell_no_memory(source);
    }
    const char *name = source->names.bytes;
    for (size_t i = 0; i < source->ground.count; i++) {
        source->values[i].name = name;
        name += strlen(name) + 1;
    }
    return CLI_SUCCESS;
}

/* One noise, a preset or a file */
static int open_text(struct source *source, const struct ground_options *options, double step)
{
    const bool has_preset = options->preset != 0;
    const char *const typed = ground_noise_option(options);
    if (has_preset && options->recipe != NULL) {
        cli_error("--recipe: there is a --preset, too; leave one of them out");
        return CLI_USAGE;
    }
    if (!has_preset && options->recipe == NULL) {
        source->is_noise = true;
        source->option = "--fractal";
        source->name = "one noise";
        return open_noise(source, options, step);
    }
    if (typed != NULL) {
        cli_error("%s: is for one noise; with %s use --set, as far as it has such a parameter",
                  typed, has_preset ? "--preset" : "--recipe");
        return CLI_USAGE;
    }
    source->option = has_preset ? "--preset" : "--recipe";
    if (!has_preset) {
        source->name = strcmp(options->recipe, "-") == 0 ? "standard input" : options->recipe;
        return open_file(source, options->recipe);
    }
    source->name = preset_name(options->preset);
    text_add(&source->text, "%.*s", (int)preset_list[options->preset].length,
             preset_list[options->preset].text);
    return source->text.failed ? tell_no_memory(source) : CLI_SUCCESS;
}

int source_open(struct source *source, const struct ground_options *options, double step)
{
    int status = open_text(source, options, step);
    if (status == CLI_SUCCESS) {
        status = read_values(source, &options->set);
    }
    if (status != CLI_SUCCESS) {
        return status;
    }
    find_palette(source);
    source->ground.text = source->text.bytes;
    source->ground.length = source->text.length;
    source->ground.values = source->values;
    source->ground.seed = options->noise.seed;
    source->ground.scale = options->scale != 1.0 ? options->scale : 0.0;
    if (!source->is_noise) { /* one noise has its tile in its text */
        source->ground.tile[0] = step * (double)options->period.width;
        source->ground.tile[1] = step * (double)options->period.height;
    }
    return CLI_SUCCESS;
}

void source_close(struct source *source)
{
    free(source->text.bytes);
    free(source->names.bytes);
}

void source_print(const struct source *source)
{
    fputs(source->text.bytes, stdout);
}

/* Whether the text is at fault only because the terrain is to repeat. */
static bool is_fault_of_tile(const struct source *source)
{
    struct scarp_recipe recipe;
    return source->ground.tile[0] != 0.0 &&
           scarp_recipe_parse(source->text.bytes, source->text.length, &recipe, NULL, 0, NULL) ==
               SCARP_OK;
}

void source_refuse(const struct source *source, const struct scarp_recipe_error *error)
{
    const char *const option = is_fault_of_tile(source) ? "--period" : source->option;
    char size[NUMBER_SIZE], nearest[2 * NUMBER_SIZE] = "";
    if (error->nearest != 0.0) {
        number_write_shortest(size, error->nearest, 0);
        snprintf(nearest, sizeof nearest, ": size=%s", size);
    }
    cli_error("%s: %s, line %d, column %d: %s%s%s%s", option, source->name, (int)error->line,
              (int)error->column, error->member != NULL ? error->member : "",
              error->member != NULL ? ": " : "", error->text, nearest);
}

/* Lists the parameters of the text, with their intervals. */
static void list_parameters(const struct source *source, struct text *list)
{
    struct scarp_recipe recipe;
    struct scarp_recipe_entry entry;
    const char *const text = source->text.bytes;
    (void)scarp_recipe_parse(text, source->text.length, &recipe, NULL, 0, NULL);
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.is_param) {
            text_add(list, "%s%.*s [%g, %g]", list->length > 0 ? ", " : "",
                     (int)(entry.name[1] - entry.name[0]), text + entry.name[0], entry.slider[0],
                     entry.slider[1]);
        }
    }
}

static void refuse_value(const struct source *source, enum ground_problem problem,
                         const struct scarp_recipe_error *error)
{
    const struct ground_value *const value = &source->values[error->from];
    struct text list = {.bytes = NULL};
    list_parameters(source, &list);
    const char *const parameters = list.length > 0 ? list.bytes : "none";
    if (problem == GROUND_BAD_NAME) {
        cli_error("--set: %s has no parameter '%.60s'; it has %.700s", source->name, value->name,
                  parameters);
    } else if (error->text != NULL) {
        cli_error("--set: %s=%.9g: line %d: %s", value->name, value->value, (int)error->line,
                  error->text);
    } else {
        cli_error("--set: %s=%.9g is outside its interval; parameters are %.700s", value->name,
                  value->value, parameters);
    }
    free(list.bytes);
}

/* Tells the outputs that there are. */
static void refuse_field(const struct source *source, const struct scarp_recipe_error *error)
{
    struct scarp_recipe recipe;
    struct scarp_recipe_entry entry;
    struct text list = {.bytes = NULL};
    const char *const name = source->fields[error->from], *const text = source->text.bytes;
    if (error->text != NULL) {
        cli_error("--out: '%.60s' of %s %s", name, source->name, error->text);
        return;
    }
    (void)scarp_recipe_parse(text, source->text.length, &recipe, NULL, 0, NULL);
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.output >= 0) {
            text_add(&list, "%s%.*s", list.length > 0 ? ", " : "",
                     (int)(entry.name[1] - entry.name[0]), text + entry.name[0]);
        }
    }
    cli_error("--out: %s has no output '%.60s'; it has %.700s", source->name, name,
              list.length > 0 ? list.bytes : "none");
    free(list.bytes);
}

bool source_ground(const struct source *source, struct ground *ground)
{
    struct scarp_recipe_error error;
    const enum ground_problem problem = ground_open(ground, &source->ground, &error);
    switch (problem) {
    case GROUND_FINE: return true;
    case GROUND_BAD_TEXT: source_refuse(source, &error); return false;
    case GROUND_BAD_TERRAIN:
        cli_error("%s: %s: %s", source->option, source->name, error.text);
        return false;
    case GROUND_BAD_FIELD: refuse_field(source, &error); return false;
    default: refuse_value(source, problem, &error); return false;
    }
}

bool source_open_palette(const struct source *source, const char *name, struct palette *palette)
{
    if (name != NULL) {
        return palette_open(palette, "--palette", name);
    }
    if (source->palette[0] != '\0' && palette_find(source->palette) == NULL) {
        cli_error("%s: %s: '%s' is no palette: %s", source->option, source->name, source->palette,
                  PALETTE_NAMES);
        return false;
    }
    return palette_open(palette, "--palette",
                        source->palette[0] != '\0' ? source->palette : "alpine");
}

size_t source_field(struct source *source, const char *name)
{
    size_t i = 0;
    while (i < source->ground.field_count && strcmp(source->fields[i], name) != 0) {
        i++;
    }
    source->fields[i] = name;
    source->ground.fields = source->fields;
    source->ground.field_count += i == source->ground.field_count ? 1 : 0;
    return i;
}

/* Whether a later value has the same name */
static bool is_replaced(const struct source *source, size_t i)
{
    for (size_t later = i + 1; later < source->ground.count; later++) {
        if (strcmp(source->values[i].name, source->values[later].name) == 0) {
            return true;
        }
    }
    return false;
}

/* Values in the order of their names, so that the order in which they were typed does not count */
void source_describe(const struct source *source, struct text *text)
{
    const char *before = "";
    bool is_first = true;
    text_add(text, "  \"recipe\": ");
    json_add_string(text, source->is_noise ? NULL : source->text.bytes);
    text_add(text, ",\n  \"set\": {");
    for (;;) {
        const struct ground_value *next = NULL;
        for (size_t i = 0; i < source->ground.count; i++) {
            const struct ground_value *const value = &source->values[i];
            if (!is_replaced(source, i) && strcmp(value->name, before) > 0 &&
                (next == NULL || strcmp(value->name, next->name) < 0)) {
                next = value;
            }
        }
        if (next == NULL) {
            break;
        }
        text_add(text, "%s", is_first ? "" : ", ");
        json_add_string(text, next->name);
        add_number(text, ": ", next->value, false, "");
        before = next->name;
        is_first = false;
    }
    text_add(text, "},\n");
}
