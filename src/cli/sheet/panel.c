/* SPDX-License-Identifier: MIT
 *
 * Panels are made of command lines: that of the sheet, and after it the options that differ. Samples
 * become bytes as those of `scarp terrain` do, and pixels are means of them.
 */
#include "sheet/panel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ground/source.h"
#include "raster/layers.h"
#include "shared/bounds.h"
#include "shared/error.h"
#include "shared/text.h"

/* The option of an axis, if a sheet can vary it. All other names are those of parameters, and with
   a recipe those of one noise, too. */
static const struct option *find(const struct axis *axis, bool has_recipe,
                                 struct sheet_options *options, void **field)
{
    char name[AXIS_NAME_SIZE + 2] = "--";
    strcat(name, axis->name);
    const size_t end =
        has_recipe ? sheet_table.count - 1 - GROUND_NOISE_GROUPS : sheet_table.count - 1;
    return options_find(&sheet_table, SHEET_VARIED_FIRST, end, name, options, field);
}

static bool set_flag(const struct axis *axis, const char *value, int *flag)
{
    *flag = strcmp(value, "on") == 0;
    if (!*flag && strcmp(value, "off") != 0) {
        cli_error("--sheet: '%.60s' of %s is not off or on", value, axis->name);
        return false;
    }
    return true;
}

/* Reads the command line and the values behind it. Options without a value are set afterwards. */
static bool read_options(struct panel *panel, char **argv, bool has_recipe, const struct axes *axes,
                         const size_t *at)
{
    struct sheet_options *const options = &panel->options;
    size_t count = 0;
    while (argv[count] != NULL) {
        count++;
    }
    char **const words = calloc(count + AXES_MAX + 1, sizeof *words);
    bool is_valid = words != NULL;
    for (size_t i = 0; i < count && is_valid; i++) {
        words[i] = argv[i];
    }
    for (size_t i = 0; i < axes->count && is_valid; i++) {
        const struct axis *const axis = &axes->list[i];
        void *field;
        const struct option *const option = find(axis, has_recipe, options, &field);
        if (option == NULL || option->parse != NULL) {
            panel->typed[i] = text_join((const char *const[]){
                option == NULL ? "--set=" : "--", axis->name, "=", axis->values[at[i]], NULL});
            is_valid = panel->typed[i] != NULL;
            words[count++] = panel->typed[i];
        }
    }
    if (!is_valid) {
        cli_error("--sheet: no memory");
    }
    is_valid = is_valid && options_parse(&sheet_table, words, options) == OPTIONS_RUN;
    for (size_t i = 0; i < axes->count && is_valid; i++) {
        void *field;
        const struct option *const option = find(&axes->list[i], has_recipe, options, &field);
        if (option != NULL && option->parse == NULL) {
            is_valid = set_flag(&axes->list[i], axes->list[i].values[at[i]], field);
        }
    }
    free(words);
    return is_valid;
}

bool panel_make(struct panel *panel, char **argv, bool has_recipe, const struct axes *axes,
                const size_t *at)
{
    struct sheet_options *const options = &panel->options;
    *panel = (struct panel){.options = SHEET_OPTIONS_UNSET};
    if (!read_options(panel, argv, has_recipe, axes, at)) {
        return false;
    }
    const size_t samples = options->samples;
    const double step = options->step / (double)samples;
    const double aside = 0.5 * (double)(samples - 1) * step; /* pixels are around their place */
    panel->surface = (struct surface){
        .width = options->panel.width * samples,
        .height = options->panel.height * samples,
        .x0 = options->origin.x - aside,
        .y0 = options->origin.y - aside,
        .step = step,
        .normal_y = 1.0f,
    };
    struct source source = {.name = NULL};
    const bool is_made = source_open(&source, &options->ground, options->step) == CLI_SUCCESS &&
                         source_ground(&source, &panel->surface.ground) &&
                         source_open_palette(&source, options->look.palette, &panel->palette);
    source_close(&source);
    if (!is_made) {
        return false;
    }
    panel->surface.scale = surface_height_scale(&panel->surface.ground);
    surface_set_light(&panel->surface, &options->look);
    surface_set_relief(&panel->surface, &panel->palette);
    return true;
}

void panel_free(struct panel *panel)
{
    palette_free(&panel->palette);
    for (size_t i = 0; i < AXES_MAX; i++) {
        free(panel->typed[i]);
    }
}

static uint8_t mean(const uint8_t *bytes, size_t samples, size_t channels, size_t stride)
{
    uint32_t sum = 0;
    for (size_t row = 0; row < samples; row++) {
        for (size_t i = 0; i < samples; i++) {
            const uint32_t byte = bytes[row * stride + i * channels];
            sum += byte * byte;
        }
    }
    return (uint8_t)(sqrt((double)sum / (double)(samples * samples)) + 0.5);
}

/* Means of samples * samples bytes each, for `width` pixels side by side; grey becomes three bytes.
 */
static void put_means(const uint8_t *bytes, size_t samples, size_t width, size_t channels,
                      uint8_t *to)
{
    const size_t stride = width * samples * channels;
    for (size_t i = 0; i < width; i++) {
        const uint8_t *const pixel = bytes + i * samples * channels;
        for (size_t c = 0; c < 3; c++) {
            to[3 * i + c] = c < channels ? mean(pixel + c, samples, channels, stride) : to[3 * i];
        }
    }
}

/* Draws the window, whose samples were taken, from the pixel `to` on. */
static void draw_window(const struct panel *panel, const struct layer *layer,
                        const struct window *window, uint8_t *bytes, uint8_t *to, size_t stride)
{
    const size_t samples = panel->options.samples;
    for (size_t row = 0; row < window->rows; row++) {
        const struct span span = {.window = window,
                                  .first = row * window->columns,
                                  .count = window->columns,
                                  .width = window->columns};
        layer->encode(&panel->surface, &span, SAMPLE_U8,
                      bytes + row * window->columns * layer->channels);
    }
    for (size_t row = 0; row < window->rows; row += samples) {
        put_means(bytes + row * window->columns * layer->channels, samples,
                  window->columns / samples, layer->channels, to + row / samples * stride);
    }
}

bool panel_draw(const struct panel *panel, size_t row, uint8_t *to, size_t stride)
{
    const struct sheet_options *const options = &panel->options;
    const size_t samples = options->samples;
    const size_t rows = smaller(PANEL_BAND, options->panel.height - row);
    const size_t across =
        WINDOW_SAMPLES / (PANEL_BAND * samples * samples); /* pixels of a window */
    const struct layer *const layer =
        &layers[options->layer == SHEET_RELIEF ? LAYER_RELIEF : LAYER_HILLSHADE];
    struct window window = {.memory = NULL};
    uint8_t *const bytes = malloc(3 * WINDOW_SAMPLES);
    const bool is_open = bytes != NULL && window_open(&window, &panel->surface, layer->needs);
    for (size_t column = 0; column < options->panel.width && is_open; column += across) {
        window.column = column * samples;
        window.row = row * samples;
        window.columns = smaller(across, options->panel.width - column) * samples;
        window.rows = rows * samples;
        surface_sample(&panel->surface, &window);
        draw_window(panel, layer, &window, bytes, to + row * stride + 3 * column, stride);
    }
    free(bytes);
    window_close(&window);
    return is_open;
}
