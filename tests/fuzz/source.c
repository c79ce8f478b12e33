/* SPDX-License-Identifier: MIT
 *
 * A recipe as the program reads it, with --set, --scale and --period: it is described as JSON, and
 * its ground has heights in the interval that it says.
 *
 * Two bytes, the lines of --set, an empty line, and the recipe.
 */
#include "ground/source.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "draw.h"
#include "fuzz.h"
#include "shared/error.h"
#include "shared/json.h"

static void check_ground(struct ground *ground)
{
    static const double x[4] = {0.0, -17.25, 1e4, 3.0}, y[4] = {0.0, 5.5, -2e5, 1e-3};
    float value[4], dx[4], dy[4];
    ground_points(ground, 4, x, y, &(struct scarp_samples){.value = value, .dx = dx, .dy = dy});
    for (int i = 0; i < 4; i++) {
        MUST(isnan(value[i]) || (value[i] >= ground->lowest && value[i] <= ground->highest),
             "%.9g is not in %.9g..%.9g", (double)value[i], (double)ground->lowest,
             (double)ground->highest);
    }
}

static void describe(const struct source *source)
{
    struct text text = {0};
    struct json_member members[4];
    text_add(&text, "{\n");
    source_describe(source, &text);
    text_add(&text, "  \"end\": 0\n}");
    MUST(json_read(text.bytes, members, 4) == 3, "no JSON: %s", text.bytes);
    free(text.bytes);
}

/* The lines up to an empty one */
static void read_settings(struct draw *bytes, struct option_list *list, char *settings)
{
    size_t at = 0;
    while (bytes->left > 0 && *bytes->at != '\n' && list->count < 8) {
        list->texts[list->count++] = settings + at;
        while (bytes->left > 0 && *bytes->at != '\n') {
            settings[at++] = (char)draw_bits(bytes, 1);
        }
        settings[at++] = '\0';
        (void)draw_bits(bytes, 1);
    }
    (void)draw_bits(bytes, 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    static struct ground ground;
    struct draw bytes = {input, size};
    struct source source = {.name = NULL};
    struct ground_options options = GROUND_OPTIONS_UNSET;
    const unsigned how = (unsigned)draw_bits(&bytes, 1), number = (unsigned)draw_bits(&bytes, 1);
    char *const settings = malloc(size + 16);
    MUST(settings != NULL, "no memory");
    read_settings(&bytes, &options.set, settings);
    options.scale = (how & 1) != 0 ? 0.25 + number : 1.0;
    options.period =
        (struct option_size){(how & 2) != 0 ? 1u + number : 0, (how & 2) != 0 ? 64u : 0};
    options.recipe = fuzz_file("r.recipe", bytes.at, bytes.left);
    options.noise.seed = number;
    fuzz_no_errors();
    const int status = source_open(&source, &options, 1.0);
    fuzz_must_tell(status != CLI_SUCCESS, "a recipe");
    if (status == CLI_SUCCESS) {
        source.ground.is_any = (how & 4) != 0;
        describe(&source);
        const bool has_ground = source_ground(&source, &ground);
        fuzz_must_tell(!has_ground, "a ground");
        if (has_ground && !source.ground.is_any) {
            check_ground(&ground);
        }
        struct palette palette;
        const bool has_palette = source_open_palette(&source, NULL, &palette);
        fuzz_must_tell(!has_palette, "a palette");
        if (has_palette) {
            palette_free(&palette);
        }
    }
    source_close(&source);
    free(settings);
    return 0;
}
