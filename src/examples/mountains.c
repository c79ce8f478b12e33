/* SPDX-License-Identifier: MIT
 *
 * Draws a mountain range from above: an example of gullies on a base that is made for them.
 *
 *     mountains [--isa NAME] [WIDTHxHEIGHT] [FILE.ppm]
 *
 * The picture is a PPM of 640x360 pixels, on stdout without a file name. The program needs scarp
 * and the C library, no more: cc -O3 mountains.c -lscarp -lm.
 *
 * What is worth copying:
 * - Valleys are where a smooth noise is 0 (scarp_smooth_abs), so they hang together, and drain.
 * - A slow noise says where mountains are, and a smooth maximum with another one makes plains.
 * - scarp_gullies_grid2 erodes that base. A mask fades gullies out on plains, where rivers would
 *   fill them up.
 * - Light falls on the exact gradient of the result. Its displacement says where crests are, which
 *   lose their snow to the wind, and where gullies are, which keep it.
 * - All is + - * / and square roots, so every machine draws the same bytes, unless the compiler
 *   fuses operations, which -ffp-contract=off forbids.
 *
 * A unit is a cell of the noise that valleys are made of: some ten kilometres. Heights are in the
 * same unit; light takes them as a third lower.
 */
#include <scarp.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 2,    /* a pixel is the mean of SIDE x SIDE points */
    STRIP = 4096 /* points of a call: as many as the caches hold */
};

/* A function of the place, at the points of a call. */
struct field {
    float value[STRIP], dx[STRIP], dy[STRIP], dxx[STRIP], dxy[STRIP], dyy[STRIP];
};

/* What a strip of the picture is made of. */
struct strip {
    struct field base, plain, mask;
    float height[STRIP], dx[STRIP], dy[STRIP], ridge[STRIP];
};

struct colour {
    float red, green, blue;
};

static const double left = 1.0, top = 0.5; /* of the picture */
static const double across = 5;            /* units from the left edge to the right one */
static const float relief = 0.66f;         /* of the heights, to the light */

static struct scarp_samples all_of(struct field *f)
{
    return (struct scarp_samples){
        .value = f->value, .dx = f->dx, .dy = f->dy, .dxx = f->dxx, .dxy = f->dxy, .dyy = f->dyy};
}

static struct scarp_samples slopes_of(struct field *f)
{
    return (struct scarp_samples){.value = f->value, .dx = f->dx, .dy = f->dy};
}

static void fail(int status, const char *message)
{
    fprintf(stderr, "mountains: %s\n", message);
    exit(status);
}

static void must(enum scarp_status status)
{
    if (status != SCARP_OK) {
        fail(EXIT_FAILURE, scarp_status_text(status));
    }
}

/* The base: valleys and mountains, by how high these may be, above a plain. */
static void make_base(const struct scarp_grid *grid, struct strip *s)
{
    static const struct scarp_noise bend = {
        .seed = 10, .octaves = 2, .frequency = 0.7, .gain = 0.4f, .amplitude = 0.35f};
    static const struct scarp_noise valleys = {
        .seed = 9, .octaves = 3, .gain = 0.4f, .rotate = 1, .warp = &bend};
    static const struct scarp_noise ranges = {.seed = 209, .octaves = 2, .frequency = 0.25};
    static const struct scarp_noise slow = {
        .seed = 109, .octaves = 2, .frequency = 0.25, .amplitude = 0.05f};
    const size_t count = grid->count[0] * grid->count[1];
    const struct scarp_samples base = all_of(&s->base), plain = all_of(&s->plain);
    const struct scarp_samples mask = all_of(&s->mask);
    must(scarp_grid2(&valleys, grid, &base));
    must(scarp_smooth_abs(count, &base, 0.12f, &base));
    must(scarp_grid2(&ranges, grid, &mask));
    must(scarp_smoothstep(count, &mask, -0.35f, 0.35f, &mask));
    must(scarp_affine(count, &mask, 0.8f, 0.2f, &mask));
    must(scarp_multiply(count, &base, &mask, &base));
    must(scarp_grid2(&slow, grid, &plain));
    must(scarp_affine(count, &plain, 1, 0.05f, &plain));
    must(scarp_affine(count, &plain, -1, 0, &mask)); /* how far the base is above the plain */
    must(scarp_add(count, &base, &mask, &mask));
    must(scarp_smooth_max(count, &base, &plain, 0.08f, &base));
}

/* Gullies where the mask, which becomes 0 on plains and 1 on mountains, has them. */
static void erode(const struct scarp_grid *grid, struct strip *s)
{
    static const struct scarp_gullies gullies = {.seed = 7,
                                                 .amplitude = 0.4f,
                                                 .octaves = 6,
                                                 .depth = 0.22f,
                                                 .low = -0.125f,
                                                 .high = 1.875f,
                                                 .rotate = 1};
    const size_t count = grid->count[0] * grid->count[1];
    const struct scarp_samples all = all_of(&s->base), base = slopes_of(&s->base);
    const struct scarp_samples mask = slopes_of(&s->mask);
    const struct scarp_samples result = {.value = s->height, .dx = s->dx, .dy = s->dy};
    const struct scarp_eroded eroded = {
        .value = s->height, .dx = s->dx, .dy = s->dy, .displacement = s->ridge};
    must(scarp_gullies_grid2(&gullies, grid, &all, &eroded));
    must(scarp_smoothstep(count, &mask, -0.05f, 0.15f, &mask));
    must(scarp_mix(count, &base, &result, &mask, &result));
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

/* What grows or lies at a place. */
static struct colour ground_of(float height, float steep, float ridge)
{
    static const struct colour rock = {0.40f, 0.36f, 0.32f}, scree = {0.52f, 0.47f, 0.40f};
    static const struct colour forest = {0.13f, 0.20f, 0.10f}, meadow = {0.36f, 0.40f, 0.20f};
    static const struct colour plain = {0.58f, 0.55f, 0.38f}, snow = {0.92f, 0.95f, 1.0f};
    const float level = clamp(1.7f - 1.6f * steep); /* 1 where plants hold on */
    struct colour c = mix(rock, scree, clamp(0.5f - ridge));
    const struct colour green = mix(forest, meadow, clamp((height - 0.22f) * 6));
    c = mix(c, mix(plain, green, clamp((height - 0.06f) * 14)), level * clamp((0.5f - height) * 5));
    return mix(c, snow, clamp((height - 0.44f - 0.08f * ridge) * 12) * clamp(2.4f - 1.8f * steep));
}

/* The light of a point. The sun stands in the north-west; the sky lights what looks up. */
static struct colour light_of(const struct strip *s, size_t i)
{
    const float dx = relief * s->dx[i], dy = relief * s->dy[i];
    const float up = 1 / sqrtf(1 + dx * dx + dy * dy), steep = sqrtf(dx * dx + dy * dy);
    const float sun = clamp((0.5f * dx + 0.5f * dy + 0.7f) * up);
    const float ridge = s->ridge[i] / (0.4f * 0.22f); /* in [-1, 1] */
    const float sky = (0.5f + 0.5f * up) * (0.75f + 0.25f * clamp(0.5f + ridge));
    const struct colour c = ground_of(s->height[i], steep, ridge);
    return (struct colour){c.red * (1.05f * sun + 0.20f * sky),
                           c.green * (0.98f * sun + 0.25f * sky),
                           c.blue * (0.86f * sun + 0.36f * sky)};
}

/* A byte of the picture: the square root stands for the screen's curve. */
static unsigned char byte(float light)
{
    return (unsigned char)(255 * sqrtf(clamp(light)) + 0.5f);
}

/* Adds the light of a row of points to the pixels of a row. The points are those of one grid,
   whatever is computed together. */
static void add_row(struct colour *pixels, struct strip *s, long width, long row)
{
    const double step = across / (double)(width * SIDE);
    for (long x = 0; x < width * SIDE; x += STRIP) {
        const size_t count = (size_t)(width * SIDE - x < STRIP ? width * SIDE - x : STRIP);
        const struct scarp_grid grid = {
            .origin = {left, top}, .step = {step, step}, .first = {x, row}, .count = {count, 1}};
        make_base(&grid, s);
        erode(&grid, s);
        for (size_t i = 0; i < count; i++) {
            struct colour *const pixel = &pixels[((size_t)x + i) / SIDE];
            const struct colour light = light_of(s, i);
            pixel->red += light.red;
            pixel->green += light.green;
            pixel->blue += light.blue;
        }
    }
}

/* Draws a row of the picture. */
static void draw(unsigned char *rgb, struct colour *pixels, struct strip *s, long width, long y)
{
    const float part = 1.0f / (float)(SIDE * SIDE);
    memset(pixels, 0, (size_t)width * sizeof *pixels);
    for (long row = y * SIDE; row < (y + 1) * SIDE; row++) {
        add_row(pixels, s, width, row);
    }
    for (long x = 0; x < width; x++) {
        rgb[3 * x] = byte(pixels[x].red * part);
        rgb[3 * x + 1] = byte(pixels[x].green * part);
        rgb[3 * x + 2] = byte(pixels[x].blue * part);
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

int main(int argc, char **argv)
{
    long width = 640, height = 360;
    const char *path = NULL;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--isa") == 0 && i + 1 < argc) {
            choose_isa(argv[++i]);
        } else if (argv[i][0] >= '0' && argv[i][0] <= '9') {
            if (!read_size(argv[i], &width, &height)) {
                fail(2, "the size must be WIDTHxHEIGHT, each from 1 to 16384");
            }
        } else if (argv[i][0] != '-' && path == NULL) {
            path = argv[i];
        } else {
            fail(2, "usage: mountains [--isa NAME] [WIDTHxHEIGHT] [FILE.ppm]");
        }
    }
    struct strip *strip = malloc(sizeof *strip);
    struct colour *pixels = malloc((size_t)width * sizeof *pixels);
    unsigned char *rgb = malloc(3 * (size_t)width * (size_t)height);
    if (strip == NULL || pixels == NULL || rgb == NULL) {
        fail(EXIT_FAILURE, "not enough memory");
    }
    for (long y = 0; y < height; y++) {
        draw(rgb + 3 * (size_t)(y * width), pixels, strip, width, y);
    }
    FILE *file = path != NULL ? fopen(path, "wb") : stdout;
    if (file == NULL || fprintf(file, "P6\n%ld %ld\n255\n", width, height) < 0 ||
        fwrite(rgb, 3, (size_t)(width * height), file) != (size_t)(width * height) ||
        fclose(file) != 0) {
        fail(EXIT_FAILURE, "cannot write the picture");
    }
    free(rgb);
    free(pixels);
    free(strip);
    return EXIT_SUCCESS;
}
