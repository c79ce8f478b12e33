/* SPDX-License-Identifier: MIT
 *
 * Reads palettes from files of two forms, line by line.
 *
 * GDAL's, of gdaldem color-relief: `height red green blue [alpha]` or `height name`, with the
 * fields apart by spaces, tabs, commas or colons. The height may be a percentage. Lines of `nv`,
 * for what has no value, are left out, and so is alpha.
 *
 * GMT's, if the name ends with .cpt or a comment has a COLOR_MODEL: slices `z0 colour z1 colour`,
 * each beginning where the one before ends, with the colour `red green blue`, `red/green/blue` or a
 * name. B and F are the colours below and above; N, for what has no value, is left out, and so are
 * labels and annotations.
 */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "look/palette.h"
#include "shared/error.h"
#include "shared/file.h"
#include "shared/interrupt.h"
#include "shared/number.h"
#include "shared/path.h"

#define LINE_MAX_LENGTH 1024
#define STOPS_MAX 4096
#define FIELDS_MAX 10 /* of a line; more are too many in both forms */
#define HEIGHT_MAX 1e9

struct reader {
    struct palette *palette;
    const char *option, *path;
    size_t line; /* from 1 */
    size_t size; /* stops that there is room for */
    bool is_gmt;
    char *fields[FIELDS_MAX];
    size_t count; /* of fields */
};

#if defined(__GNUC__) || defined(__clang__)
__attribute__((format(printf, 2, 3)))
#endif
static bool
refuse(const struct reader *reader, const char *format, ...)
{
    char why[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    cli_error("%s: %.300s, line %zu: %s", reader->option, reader->path, reader->line, why);
    return false;
}

/* The names of gdaldem, and dark and light greys */
static const struct {
    const char *name;
    uint8_t rgb[3];
} names[] = {
    {"white", {255, 255, 255}},     {"black", {0, 0, 0}},           {"red", {255, 0, 0}},
    {"green", {0, 255, 0}},         {"blue", {0, 0, 255}},          {"yellow", {255, 255, 0}},
    {"magenta", {255, 0, 255}},     {"cyan", {0, 255, 255}},        {"aqua", {0, 255, 255}},
    {"grey", {128, 128, 128}},      {"gray", {128, 128, 128}},      {"orange", {255, 165, 0}},
    {"brown", {165, 42, 42}},       {"purple", {128, 0, 128}},      {"violet", {238, 130, 238}},
    {"indigo", {75, 0, 130}},       {"darkgrey", {169, 169, 169}},  {"darkgray", {169, 169, 169}},
    {"lightgrey", {211, 211, 211}}, {"lightgray", {211, 211, 211}},
};

static bool is_word(const char *text, const char *word)
{
    size_t i = 0;
    for (; text[i] != '\0' && word[i] != '\0'; i++) {
        const char c = text[i] >= 'A' && text[i] <= 'Z' ? (char)(text[i] - 'A' + 'a') : text[i];
        if (c != word[i]) {
            return false;
        }
    }
    return text[i] == word[i];
}

static bool find_name(const char *text, float rgb[3])
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (is_word(text, names[i].name)) {
            for (size_t c = 0; c < 3; c++) {
                rgb[c] = (float)names[i].rgb[c] / 255.0f;
            }
            return true;
        }
    }
    return false;
}

/* A number from 0 to 255, and nothing else up to `end` */
static bool read_part(const char *text, char end, float *part, const char **next)
{
    double value;
    *next = number_read(text, &value);
    if (*next == NULL || **next != end || !(value >= 0.0 && value <= 255.0)) {
        return false;
    }
    *part = (float)value / 255.0f;
    return true;
}

/* The colour at field `at`, which takes `count` fields: three numbers, or a name, or with slashes.
 */
static bool read_colour(const struct reader *reader, size_t at, size_t count, struct colour *colour)
{
    float rgb[3];
    const char *next;
    if (count == 3) {
        for (size_t c = 0; c < 3; c++) {
            if (!read_part(reader->fields[at + c], '\0', &rgb[c], &next)) {
                return refuse(reader, "'%.60s' is not a number from 0 to 255",
                              reader->fields[at + c]);
            }
        }
    } else if (!find_name(reader->fields[at], rgb) &&
               !(reader->is_gmt && read_part(reader->fields[at], '/', &rgb[0], &next) &&
                 read_part(next + 1, '/', &rgb[1], &next) &&
                 read_part(next + 1, '\0', &rgb[2], &next))) {
        return refuse(reader, "'%.60s' is not a colour", reader->fields[at]);
    }
    *colour = (struct colour){rgb[0], rgb[1], rgb[2]};
    return true;
}

static bool read_height(const struct reader *reader, const char *text, struct palette_stop *stop)
{
    double value;
    const char *const end = number_read(text, &value);
    const bool percent = end != NULL && !reader->is_gmt && strcmp(end, "%") == 0;
    if (end == NULL || (*end != '\0' && !percent)) {
        return refuse(reader, "'%.60s' is not a height", text);
    }
    if (!(value >= -HEIGHT_MAX && value <= HEIGHT_MAX)) {
        return refuse(reader, "'%.60s' is not from -1e9 to 1e9", text);
    }
    stop->is_fraction = percent;
    stop->height = (float)(percent ? value / 100.0 : value);
    return true;
}

static bool add(struct reader *reader, struct palette_stop stop)
{
    struct palette *const palette = reader->palette;
    if (palette->count == STOPS_MAX) {
        return refuse(reader, "there are more than %d colours", STOPS_MAX);
    }
    if (palette->count == reader->size) {
        const size_t size = reader->size == 0 ? 64 : 2 * reader->size;
        struct palette_stop *const more = realloc(palette->memory, size * sizeof *more);
        if (more == NULL) {
            return refuse(reader, "no memory");
        }
        palette->memory = more;
        reader->size = size;
    }
    palette->memory[palette->count++] = stop;
    return true;
}

static bool read_gdal(struct reader *reader)
{
    struct palette_stop stop = {.height = 0.0f};
    const bool no_value = is_word(reader->fields[0], "nv");
    if (reader->count != 2 && reader->count != 4 && reader->count != 5) {
        return refuse(reader, "is not: height red green blue, or: height name");
    }
    if (!no_value && !read_height(reader, reader->fields[0], &stop)) {
        return false;
    }
    if (!read_colour(reader, 1, reader->count == 2 ? 1 : 3, &stop.colour)) {
        return false;
    }
    float alpha;
    const char *next;
    if (reader->count == 5 && !read_part(reader->fields[4], '\0', &alpha, &next)) {
        return refuse(reader, "'%.60s' is not a number from 0 to 255", reader->fields[4]);
    }
    return no_value || add(reader, stop);
}

/* B or F and a colour */
static bool read_end(struct reader *reader)
{
    struct palette *const palette = reader->palette;
    struct colour colour;
    if (reader->count != 2 && reader->count != 4) {
        return refuse(reader, "is not: %s red green blue", reader->fields[0]);
    }
    if (!read_colour(reader, 1, reader->count - 1, &colour)) {
        return false;
    }
    if (*reader->fields[0] == 'B') {
        palette->below = colour;
        palette->has_below = true;
    } else {
        palette->above = colour;
        palette->has_above = true;
    }
    return true;
}

/* Drops what may follow the colours: which ends are to be annotated. */
static void drop_annotation(struct reader *reader)
{
    const char *const last = reader->count > 1 ? reader->fields[reader->count - 1] : "";
    if (strcmp(last, "L") == 0 || strcmp(last, "U") == 0 || strcmp(last, "B") == 0) {
        reader->count--;
    }
}

static bool read_gmt(struct reader *reader)
{
    const char *const first = reader->fields[0];
    if (strcmp(first, "N") == 0) {
        return true;
    }
    if (strcmp(first, "B") == 0 || strcmp(first, "F") == 0) {
        return read_end(reader);
    }
    drop_annotation(reader);
    if (reader->count != 4 && reader->count != 8) {
        return refuse(reader, "is not: z0 red green blue z1 red green blue");
    }
    const size_t half = reader->count / 2;
    struct palette_stop a, b;
    if (!read_height(reader, reader->fields[0], &a) ||
        !read_colour(reader, 1, half - 1, &a.colour) ||
        !read_height(reader, reader->fields[half], &b) ||
        !read_colour(reader, half + 1, half - 1, &b.colour)) {
        return false;
    }
    const struct palette *const palette = reader->palette;
    if (!(a.height < b.height)) {
        return refuse(reader, "the slice ends no higher than it begins");
    }
    if (palette->count > 0 && palette->memory[palette->count - 1].height != a.height) {
        return refuse(reader, "the slice does not begin where the one before ends");
    }
    return add(reader, a) && add(reader, b);
}

/* Cuts a line into its fields, as far as there is room for one too many. */
static void cut(struct reader *reader, char *line)
{
    const char *const separators = reader->is_gmt ? " \t\r\n" : " \t\r\n,:";
    reader->count = 0;
    if (reader->is_gmt) {
        line[strcspn(line, ";")] = '\0'; /* what follows is a label */
    }
    for (char *at = line + strspn(line, separators); *at != '\0'; at += strspn(at, separators)) {
        if (reader->count == FIELDS_MAX) {
            break;
        }
        reader->fields[reader->count++] = at;
        at += strcspn(at, separators);
        if (*at != '\0') {
            *at++ = '\0';
        }
    }
}

/* GMT says in a comment what its numbers are. */
static bool read_comment(struct reader *reader, const char *line)
{
    const char *const model = strstr(line, "COLOR_MODEL");
    if (model == NULL) {
        return true;
    }
    reader->is_gmt = true;
    if (strstr(model, "HSV") != NULL || strstr(model, "hsv") != NULL ||
        strstr(model, "CMYK") != NULL || strstr(model, "cmyk") != NULL) {
        return refuse(reader, "only the COLOR_MODEL RGB is read");
    }
    return true;
}

static void add_sum(struct palette *palette, const char *line)
{
    for (const char *c = line; *c != '\0'; c++) { /* FNV-1a */
        palette->sum = (palette->sum ^ (unsigned char)*c) * UINT32_C(16777619);
    }
}

static bool read_line(struct reader *reader, char *line)
{
    reader->line++;
    add_sum(reader->palette, line);
    if (strlen(line) == LINE_MAX_LENGTH - 1) {
        return refuse(reader, "is longer than %d characters", LINE_MAX_LENGTH - 2);
    }
    const char *const text = line + strspn(line, " \t");
    if (*text == '#') {
        return read_comment(reader, text);
    }
    cut(reader, line);
    return reader->count == 0 || (reader->is_gmt ? read_gmt(reader) : read_gdal(reader));
}

static bool read_lines(struct reader *reader, FILE *stream)
{
    char line[LINE_MAX_LENGTH];
    bool is_first = true;
    while (!interrupted() && fgets(line, sizeof line, stream) != NULL) {
        const bool is_marked = is_first && strncmp(line, "\xef\xbb\xbf", 3) == 0; /* as UTF-8 */
        if (!read_line(reader, line + (is_marked ? 3 : 0))) {
            return false;
        }
        is_first = false;
    }
    if (interrupted()) {
        cli_error("interrupted: nothing was written");
        return false;
    }
    if (ferror(stream)) {
        cli_error("%s: %.300s: %s", reader->option, reader->path, strerror(errno));
        return false;
    }
    if (reader->palette->count == 0) {
        return refuse(reader, "the file ends without a colour");
    }
    return true;
}

bool palette_read(struct palette *palette, const char *option, const char *path)
{
    *palette = (struct palette){.in_units = true, .sum = UINT32_C(2166136261)};
    struct reader reader = {.palette = palette, .option = option, .path = path};
    reader.is_gmt = is_word(path_extension(path), ".cpt");
    errno = 0;
    FILE *const stream = file_is_special(path) ? NULL : fopen(path, "r");
    if (stream == NULL) {
        cli_error("%s: '%.300s' is not " PALETTE_NAMES ", and no file that can be read%s%s", option,
                  path, errno != 0 ? ": " : "", errno != 0 ? strerror(errno) : "");
        return false;
    }
    const bool is_read = read_lines(&reader, stream);
    fclose(stream);
    if (!is_read) {
        return false;
    }
    palette->stops = palette->memory;
    return true;
}
