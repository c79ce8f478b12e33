/* SPDX-License-Identifier: MIT
 *
 * Draws a recipe: an example of scarp_recipe_parse and scarp_recipe_grid.
 *
 *     paint [--isa NAME] [--units N] [--seed N] [--tones] [WIDTHxHEIGHT] FILE.recipe [FILE.ppm]
 *
 * The picture is a PPM of 640x360 pixels, on stdout without a second file name, and N units wide
 * (3000). The first output of a recipe of the plane is drawn as land, seen from above: the sea is
 * what lies below 0, and light falls on the exact gradient. With --tones it is drawn in grey, from
 * the lower end of its range to the upper one. That of space is a density, seen from the side,
 * where z points up: the mean over a depth of N units, lit by its exact gradient. The program needs
 * scarp and the C library, no more: cc -O3 paint.c -lscarp -lm.
 */
#include <scarp.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 2,     /* a pixel is the mean of SIDE x SIDE points, of land */
    DEPTH = 32,   /* points along a line of sight, of space */
    PIECE = 4096, /* points of a call, at most */
    TEXT = 16384  /* bytes of a recipe, at most */
};

struct colour {
    float red, green, blue;
};

struct painter {
    struct scarp_recipe recipe;
    struct scarp_scratch scratch;
    long width, height;
    double units;
    int is_space, tones;
    float lowest, highest; /* of the output */
    float value[PIECE], slope[3][PIECE];
};

static void fail(int status, const char *message)
{
    fprintf(stderr, "paint: %s\n", message);
    exit(status);
}

static void must(enum scarp_status status)
{
    if (status != SCARP_OK) {
        fail(EXIT_FAILURE, scarp_status_text(status));
    }
}

static float clamp(float a)
{
    return a < 0 ? 0 : a > 1 ? 1 : a;
}

static struct colour mix(struct colour a, struct colour b, float part)
{
    return (struct colour){a.red + (b.red - a.red) * part, a.green + (b.green - a.green) * part,
                           a.blue + (b.blue - a.blue) * part};
}

/* Reads a recipe, or tells the first error in it. */
static void read_recipe(struct painter *p, const char *path, uint64_t seed)
{
    static char text[TEXT + 1];
    char message[300];
    struct scarp_recipe_error error;
    struct scarp_recipe_entry entry;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        fail(2, "cannot read the recipe");
    }
    const size_t length = fread(text, 1, sizeof text, file);
    fclose(file);
    if (length > TEXT) {
        fail(2, "a recipe has at most 16384 bytes");
    }
    if (scarp_recipe_parse(text, length, &p->recipe, &error, 1, NULL) != SCARP_OK) {
        snprintf(message, sizeof message, "%d:%d: %s", (int)error.line, (int)error.column,
                 error.text);
        fail(2, message);
    }
    must(scarp_recipe_seed(&p->recipe, seed));
    for (size_t i = 0; scarp_recipe_entry_at(&p->recipe, i, &entry) == SCARP_OK; i++) {
        p->is_space = p->is_space || (entry.output == 0 && (entry.axes & 4) != 0);
    }
    must(scarp_recipe_range(&p->recipe, SCARP_RECIPE_OUTPUT, NULL, &p->lowest, &p->highest));
    p->scratch.size = scarp_recipe_scratch_size(&p->recipe, 1, 0);
    p->scratch.memory = malloc(p->scratch.size);
    if (p->scratch.memory == NULL) {
        fail(EXIT_FAILURE, "not enough memory");
    }
}

static void sample(struct painter *p, const struct scarp_grid *grid)
{
    const struct scarp_samples out = {.value = p->value,
                                      .dx = p->slope[0],
                                      .dy = p->slope[1],
                                      .dz = p->is_space ? p->slope[2] : NULL};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    must(scarp_recipe_grid(&p->recipe, grid, &outputs, &p->scratch));
}

/* What lies at a height, which is a part of the highest; the sea's is below 0. */
static struct colour ground_of(float part, float steep)
{
    static const struct colour deep = {0.03f, 0.08f, 0.20f}, shallow = {0.12f, 0.32f, 0.40f};
    static const struct colour sand = {0.58f, 0.52f, 0.36f}, forest = {0.14f, 0.21f, 0.10f};
    static const struct colour meadow = {0.38f, 0.40f, 0.21f}, rock = {0.40f, 0.36f, 0.32f};
    static const struct colour snow = {0.92f, 0.95f, 1.0f};
    if (part < 0) {
        return mix(shallow, deep, clamp(-3 * part));
    }
    const struct colour green = mix(forest, meadow, clamp(part * 3.5f));
    const struct colour low =
        mix(mix(sand, green, clamp(part * 20)), rock, clamp((part - 0.4f) * 5));
    const struct colour bare = mix(low, rock, clamp(2 * steep - 0.9f));
    return mix(bare, snow, clamp((part - 0.62f) * 8) * clamp(2.2f - 1.3f * steep));
}

/* The light of a point of land. The sun stands in the north-west. */
static struct colour land_at(const struct painter *p, size_t i)
{
    const float dx = p->slope[0][i], dy = p->slope[1][i];
    const float up = 1 / sqrtf(1 + dx * dx + dy * dy), steep = sqrtf(dx * dx + dy * dy);
    const int is_sea = p->value[i] < 0 && p->lowest < 0;
    const float sun = is_sea ? 0.75f : clamp((0.5f * dx - 0.5f * dy + 0.7f) * up);
    const float sky = is_sea ? 0.9f : 0.5f + 0.5f * up;
    const struct colour c = ground_of(p->value[i] / (0.8f * p->highest), steep);
    return (struct colour){c.red * (1.05f * sun + 0.20f * sky),
                           c.green * (0.98f * sun + 0.25f * sky),
                           c.blue * (0.86f * sun + 0.36f * sky)};
}

static struct colour tone_at(const struct painter *p, size_t i)
{
    const float t = (p->value[i] - p->lowest) / (p->highest - p->lowest);
    return (struct colour){0.08f + 0.85f * t * t, 0.08f + 0.84f * t * t, 0.10f + 0.80f * t * t};
}

/* Adds the colours of a row of points to pixels. y of the picture points down. */
static void add_row(struct painter *p, struct colour *pixels, long row)
{
    const double step = p->units / (double)(p->width * SIDE);
    for (long x = 0; x < p->width * SIDE; x += PIECE) {
        const long left = p->width * SIDE - x;
        const struct scarp_grid grid = {.step = {step, step, 1},
                                        .first = {x, p->height * SIDE - 1 - row, 0},
                                        .count = {(size_t)(left < PIECE ? left : PIECE), 1, 1}};
        sample(p, &grid);
        for (size_t i = 0; i < grid.count[0]; i++) {
            struct colour *const pixel = &pixels[((size_t)x + i) / SIDE];
            const struct colour c = p->tones ? tone_at(p, i) : land_at(p, i);
            pixel->red += c.red / (float)(SIDE * SIDE);
            pixel->green += c.green / (float)(SIDE * SIDE);
            pixel->blue += c.blue / (float)(SIDE * SIDE);
        }
    }
}

/* Adds what is seen along the lines of sight of a row of pixels, from the front to the back. */
static void add_sight(struct painter *p, struct colour *pixels, long row)
{
    static const struct colour high = {0.10f, 0.22f, 0.48f}, low = {0.45f, 0.58f, 0.75f};
    const double step = p->units / (double)p->width, far = p->units / (double)DEPTH;
    const float thick = (float)far / 60; /* how much a density of 1 hides over that length */
    const struct colour sky = mix(high, low, (float)row / (float)p->height);
    for (long x = 0; x < p->width; x += PIECE / DEPTH) {
        const long left = p->width - x;
        const size_t count = (size_t)(left < PIECE / DEPTH ? left : PIECE / DEPTH);
        const struct scarp_grid grid = {.step = {step, far, step},
                                        .first = {x, 0, p->height - 1 - row},
                                        .count = {count, DEPTH, 1}};
        sample(p, &grid);
        for (size_t i = 0; i < count; i++) {
            struct colour *const pixel = &pixels[(size_t)x + i];
            float through = 1; /* the light that comes from behind */
            for (size_t k = i; k < count * DEPTH; k += count) {
                const float gx = p->slope[0][k], gz = p->slope[2][k];
                const float length = sqrtf(gx * gx + gz * gz + p->slope[1][k] * p->slope[1][k]);
                const float sun =
                    length > 0 ? 0.5f + 0.5f * (0.5f * gx - 0.86f * gz) / length : 0.5f;
                const float held = through * clamp(p->value[k] * thick);
                pixel->red += held * (0.25f + 0.75f * sun);
                pixel->green += held * (0.29f + 0.69f * sun);
                pixel->blue += held * (0.36f + 0.60f * sun);
                through -= held;
            }
            *pixel =
                (struct colour){pixel->red + through * sky.red, pixel->green + through * sky.green,
                                pixel->blue + through * sky.blue};
        }
    }
}

/* A byte of the picture: the square root stands for the screen's curve. */
static unsigned char byte(float light)
{
    return (unsigned char)(255 * sqrtf(clamp(light)) + 0.5f);
}

static void draw(struct painter *p, struct colour *pixels, long y, unsigned char *rgb)
{
    memset(pixels, 0, (size_t)p->width * sizeof *pixels);
    for (long row = y * SIDE; row < (y + 1) * SIDE && !p->is_space; row++) {
        add_row(p, pixels, row);
    }
    if (p->is_space) {
        add_sight(p, pixels, y);
    }
    for (long x = 0; x < p->width; x++) {
        rgb[3 * x] = byte(pixels[x].red);
        rgb[3 * x + 1] = byte(pixels[x].green);
        rgb[3 * x + 2] = byte(pixels[x].blue);
    }
}

static void choose_isa(const char *name)
{
    enum scarp_isa isa = SCARP_ISA_SCALAR;
    while (scarp_isa_name(isa) != NULL && strcmp(scarp_isa_name(isa), name) != 0) {
        isa++;
    }
    if (scarp_isa_select(isa) != SCARP_OK) {
        fail(2, "--isa: this instruction set cannot run here");
    }
}

/* Reads WIDTHxHEIGHT, each from 1 to 16384. Returns 0 if that is not what the text says. */
static int read_size(const char *text, long *width, long *height)
{
    char *end;
    *width = strtol(text, &end, 10);
    *height = *end == 'x' ? strtol(end + 1, &end, 10) : 0;
    return *end == '\0' && *width >= 1 && *width <= 16384 && *height >= 1 && *height <= 16384;
}

static double read_number(const char *text, const char *message)
{
    char *end;
    const double number = strtod(text, &end);
    if (*end != '\0' || end == text || !(number >= 0 && number <= 1e9)) {
        fail(2, message);
    }
    return number;
}

/* Reads the options. Returns the path of the recipe, and of the picture, or NULL for stdout. */
static const char *read_options(struct painter *p, int argc, char **argv, const char **picture,
                                uint64_t *seed)
{
    const char *path[2] = {NULL, NULL};
    int paths = 0;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--isa") == 0 && i + 1 < argc) {
            choose_isa(argv[++i]);
        } else if (strcmp(argv[i], "--units") == 0 && i + 1 < argc) {
            p->units = read_number(argv[++i], "--units: a number from 0 to 1e9");
        } else if (strcmp(argv[i], "--seed") == 0 && i + 1 < argc) {
            *seed = (uint64_t)read_number(argv[++i], "--seed: a number from 0 to 1e9");
        } else if (strcmp(argv[i], "--tones") == 0) {
            p->tones = 1;
        } else if (argv[i][0] >= '0' && argv[i][0] <= '9') {
            if (!read_size(argv[i], &p->width, &p->height)) {
                fail(2, "the size must be WIDTHxHEIGHT, each from 1 to 16384");
            }
        } else if (argv[i][0] != '-' && paths < 2) {
            path[paths++] = argv[i];
        } else {
            paths = 3;
        }
    }
    if (paths < 1 || paths > 2) {
        fail(2, "usage: paint [--isa NAME] [--units N] [--seed N] [--tones] [WIDTHxHEIGHT] "
                "FILE.recipe [FILE.ppm]");
    }
    *picture = path[1];
    return path[0];
}

int main(int argc, char **argv)
{
    struct painter *const p = calloc(1, sizeof *p);
    const char *picture;
    uint64_t seed = 0;
    if (p == NULL) {
        fail(EXIT_FAILURE, "not enough memory");
    }
    p->width = 640;
    p->height = 360;
    p->units = 3000;
    const char *const recipe = read_options(p, argc, argv, &picture, &seed);
    read_recipe(p, recipe, seed);
    struct colour *pixels = malloc((size_t)p->width * sizeof *pixels);
    unsigned char *rgb = malloc(3 * (size_t)p->width * (size_t)p->height);
    if (pixels == NULL || rgb == NULL) {
        fail(EXIT_FAILURE, "not enough memory");
    }
    for (long y = 0; y < p->height; y++) {
        draw(p, pixels, y, rgb + 3 * (size_t)(y * p->width));
    }
    FILE *file = picture != NULL ? fopen(picture, "wb") : stdout;
    if (file == NULL || fprintf(file, "P6\n%ld %ld\n255\n", p->width, p->height) < 0 ||
        fwrite(rgb, 3, (size_t)(p->width * p->height), file) != (size_t)(p->width * p->height) ||
        fclose(file) != 0) {
        fail(EXIT_FAILURE, "cannot write the picture");
    }
    free(rgb);
    free(pixels);
    free(p->scratch.memory);
    free(p);
    return EXIT_SUCCESS;
}
