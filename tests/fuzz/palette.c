/* SPDX-License-Identifier: MIT
 *
 * Palettes of GDAL's and GMT's form: stops and colours are within their bounds, sorted once they
 * are resolved, and the same when they are written and read again.
 *
 * The first byte: whether the file's name ends with .cpt
 */
#include <math.h>
#include <string.h>

#include "cli.h"
#include "draw.h"
#include "fuzz.h"
#include "look/palette.h"
#include "shared/text.h"

static void check_colour(struct colour colour)
{
    const float c[] = {colour.r, colour.g, colour.b};
    for (int i = 0; i < 3; i++) {
        MUST(c[i] >= 0.0f && c[i] <= 1.0f, "%g is no part of a colour", (double)c[i]);
    }
}

static void check(const struct palette *palette)
{
    MUST(palette->count > 0 && palette->count <= 4096 && palette->stops == palette->memory,
         "%zu stops", palette->count);
    for (size_t i = 0; i < palette->count; i++) {
        check_colour(palette->stops[i].colour);
        MUST(fabsf(palette->stops[i].height) <= 1e9f, "a stop at %g",
             (double)palette->stops[i].height);
    }
    check_colour(palette->below);
    check_colour(palette->above);
}

static bool is_near(struct colour a, struct colour b)
{
    return fabsf(a.r - b.r) <= 1e-6f && fabsf(a.g - b.g) <= 1e-6f && fabsf(a.b - b.b) <= 1e-6f;
}

static void write_again(const struct palette *palette)
{
    struct text text = {0};
    struct palette again;
    for (size_t i = 0; i < palette->count; i++) {
        const struct palette_stop *const stop = &palette->stops[i];
        text_add(&text, "%.9g %.9g %.9g %.9g\n", (double)stop->height,
                 (double)stop->colour.r * 255.0, (double)stop->colour.g * 255.0,
                 (double)stop->colour.b * 255.0);
    }
    MUST(palette_read(&again, "--palette", fuzz_file("p.txt", (uint8_t *)text.bytes, text.length)),
         "a palette that was written is not read");
    MUST(again.count == palette->count, "%zu stops of %zu", again.count, palette->count);
    for (size_t i = 0; i < again.count; i++) {
        MUST(again.stops[i].height == palette->stops[i].height &&
                 is_near(again.stops[i].colour, palette->stops[i].colour),
             "stop %zu", i);
    }
    palette_free(&again);
    free(text.bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct palette palette;
    struct draw input = {bytes, size};
    const char *const name = draw_bits(&input, 1) % 2 == 0 ? "p.txt" : "p.cpt";
    fuzz_no_errors();
    const bool is_read = palette_read(&palette, "--palette", fuzz_file(name, input.at, input.left));
    fuzz_must_tell(!is_read, "a palette");
    if (is_read) {
        check(&palette);
        palette_resolve(&palette, -100.0f, 900.0f);
        for (size_t i = 1; i < palette.count; i++) {
            MUST(palette.stops[i - 1].height <= palette.stops[i].height &&
                     !palette.stops[i].is_fraction,
                 "stop %zu", i);
        }
        bool is_far = false; /* a fraction of more than the heights that are read */
        for (size_t i = 0; i < palette.count; i++) {
            is_far |= fabsf(palette.stops[i].height) > 1e9f;
        }
        if (!is_far) {
            write_again(&palette);
        }
    }
    palette_free(&palette);
    return 0;
}
