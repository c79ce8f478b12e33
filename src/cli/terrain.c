/* SPDX-License-Identifier: MIT
 *
 * `scarp terrain`: the options, the pictures, the progress and the closing line. What a sample
 * becomes in a picture is in render.c, how a file comes to be in image.c.
 */
#include <errno.h>
#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#ifdef _WIN32
#include <io.h>
#define STDERR_IS_TERMINAL() (_isatty(2) != 0)
#else
#include <unistd.h>
#define STDERR_IS_TERMINAL() (isatty(STDERR_FILENO) != 0)
#endif

#include "cli.h"
#include "image.h"
#include "options.h"
#include "render.h"
#include "scarp.h"

struct terrain_options {
    struct option_size size;
    struct option_point origin;
    uint64_t seed;
    double frequency, step;
    float octaves, lacunarity, gain, erosion, height;
    int basis, fade, fractal, rotate, isa, quiet;
    size_t compare, threads;
    const char *output;
};

/* In the order of the enumerators */
static const char *const bases[] = {"gradient", "value", NULL};
static const char *const fades[] = {"quintic", "cubic", NULL};
static const char *const fractals[] = {"fbm", "turbulence", "ridged", "erosion", NULL};

#define FIELD(name) offsetof(struct terrain_options, name)
#define FRACTALS "fbm, turbulence, ridged or erosion"
#define ISAS "scalar, sse4.1, avx2, avx512 or neon"

/* The intervals of the noise are those of scarp.h. */
static const struct option terrain_table[] = {
    {.name = "--size",
     .argument = "WxH",
     .standard = "1024x1024",
     .allowed = "WIDTHxHEIGHT with both from 1 to 65536",
     .help = "samples across and down, each from 1 to 65536",
     .parse = option_size,
     .offset = FIELD(size),
     .lowest = 1,
     .highest = 65536},
    {.name = "--origin",
     .argument = "X,Y",
     .standard = "0,0",
     .allowed = "two numbers X,Y from -2^53 to 2^53",
     .help = "position of the bottom left sample, each from -2^53 to 2^53",
     .parse = option_point,
     .offset = FIELD(origin),
     .lowest = -0x1p53,
     .highest = 0x1p53},
    {.name = "--step",
     .argument = "F",
     .standard = "1",
     .allowed = "a number from 2^-48 to 2^48",
     .help = "distance between samples, in the unit of x and y,\nfrom 2^-48 to 2^48",
     .parse = option_double,
     .offset = FIELD(step),
     .lowest = 0x1p-48,
     .highest = 0x1p48},
    {.name = "--height",
     .argument = "F",
     .standard = "120",
     .allowed = "a number from 0 to 2^24",
     .help = "vertical size of noise value 1, in the unit of x and y, for\n"
             "normals and hillshade, from 0 to 2^24",
     .parse = option_float,
     .offset = FIELD(height),
     .lowest = 0,
     .highest = 0x1p24},
    {.name = "--seed",
     .argument = "N",
     .standard = "1",
     .allowed = "an integer from 0 to 2^64 - 1, decimal or 0x and hexadecimal",
     .help = "which terrain: an integer of 64 bits, decimal or 0x...",
     .parse = option_seed,
     .offset = FIELD(seed)},
    {.name = "--basis",
     .argument = "NAME",
     .standard = "gradient",
     .allowed = "gradient or value",
     .help = "noise of an octave: gradient or value",
     .parse = option_choice,
     .offset = FIELD(basis),
     .choices = bases},
    {.name = "--fade",
     .argument = "NAME",
     .standard = "quintic",
     .allowed = "quintic or cubic",
     .help = "blend between lattice points: quintic or cubic",
     .parse = option_choice,
     .offset = FIELD(fade),
     .choices = fades},
    {.name = "--fractal",
     .argument = "NAME",
     .standard = "fbm",
     .allowed = FRACTALS,
     .help = "how octaves are summed: " FRACTALS,
     .parse = option_choice,
     .offset = FIELD(fractal),
     .choices = fractals},
    {.name = "--erosion",
     .argument = "F",
     .standard = "1",
     .allowed = "a number from 2^-24 to 2^24",
     .help = "with --fractal erosion, how strongly slopes damp octaves,\nfrom 2^-24 to 2^24",
     .parse = option_float,
     .offset = FIELD(erosion),
     .lowest = 0x1p-24,
     .highest = 0x1p24},
    {.name = "--frequency",
     .argument = "F",
     .standard = "0.0025",
     .allowed = "a number from 2^-32 to 2^48",
     .help = "lattice cells of the first octave per unit of x and y,\nfrom 2^-32 to 2^48",
     .parse = option_double,
     .offset = FIELD(frequency),
     .lowest = 0x1p-32,
     .highest = 0x1p48},
    {.name = "--octaves",
     .argument = "F",
     .standard = "9",
     .allowed = "a number above 0, at most 32",
     .help = "octaves that are summed, above 0, at most 32; a fraction fades\nthe last one in",
     .parse = option_float,
     .offset = FIELD(octaves),
     .lowest = (double)FLT_MIN,
     .highest = 32},
    {.name = "--lacunarity",
     .argument = "F",
     .standard = "2",
     .allowed = "a number from 1/16 to 16",
     .help = "frequency ratio from octave to octave, from 1/16 to 16",
     .parse = option_float,
     .offset = FIELD(lacunarity),
     .lowest = 0.0625,
     .highest = 16},
    {.name = "--gain",
     .argument = "F",
     .standard = "0.4",
     .allowed = "a number from 1/16 to 16",
     .help = "amplitude ratio from octave to octave, from 1/16 to 16",
     .parse = option_float,
     .offset = FIELD(gain),
     .lowest = 0.0625,
     .highest = 16},
    {.name = "--rotate",
     .help = "turn the axes between octaves: hides the lattice's directions",
     .offset = FIELD(rotate)},
    {.name = "--compare",
     .argument = "N",
     .allowed = "an integer from 1 to 7",
     .help = "also write STEM-compare, with N by N pixels per sample,\nfrom 1 to 7 [not written]",
     .parse = option_count,
     .offset = FIELD(compare),
     .lowest = 1,
     .highest = 7}, /* 2 * 7 * 65536 pixels across; libpng's limit is 1,000,000 */
    {.name = "--threads",
     .argument = "N",
#ifdef _OPENMP
     .allowed = "an integer from 1 to 1024",
     .help = "how many threads sample, from 1 to 1024; the pictures do not\ndepend on it [as many "
             "as there are]",
     .highest = RENDER_THREADS_MAX,
#else
     .allowed = "1: this program was built without OpenMP",
     .help = "how many threads sample: 1, since this program was built\nwithout OpenMP",
     .highest = 1,
#endif
     .parse = option_count,
     .offset = FIELD(threads),
     .lowest = 1},
    {.name = "--isa",
     .argument = "NAME",
     .allowed = ISAS,
     .help = "instruction set: " ISAS ";\nthe pictures do not depend on it [the best one]",
     .parse = option_isa,
     .offset = FIELD(isa)},
    {.name = "--output",
     .argument = "STEM",
     .standard = "terrain",
     .allowed = "the beginning of file names: not empty, no separator at its end",
     .help = "the beginning of the file names, directory included",
     .parse = option_stem,
     .offset = FIELD(output)},
    {.name = "--quiet", .help = "print nothing but errors", .offset = FIELD(quiet)},
};

static const struct option_table table = {
    .command = "terrain",
    .purpose = "Samples a terrain (a sum of octaves of noise) with its exact gradient and writes\n"
#ifdef SCARP_CLI_PNG
               "  STEM-height.png     16-bit grey\n"
               "  STEM-normal.png     8-bit red, green, blue\n"
               "  STEM-hillshade.png  8-bit grey\n"
               "and, with --compare,\n"
               "  STEM-compare.png    8-bit red, green, blue",
#else
               "  STEM-height.pgm     16-bit grey, high byte first\n"
               "  STEM-normal.ppm     8-bit red, green, blue\n"
               "  STEM-hillshade.pgm  8-bit grey\n"
               "and, with --compare,\n"
               "  STEM-compare.ppm    8-bit red, green, blue",
#endif
    .notes =
        "Column c and row r of the pictures lie at x = X + c step and y = Y + (H - 1 - r) step:\n"
        "x grows to the right (east) and y upward (north). The next tile to the right has the\n"
        "origin X + W step,Y, the next one above X,Y + H step.\n"
        "\n"
        "height     round(65535 (value - lowest) / (highest - lowest)), with the interval that\n"
        "           values of this noise never leave, and not those that occur: tiles of one\n"
        "           terrain fit together. It is [-1, 1], so value = 2 grey / 65535 - 1; with\n"
        "           turbulence and ridged [0, 1], so value = grey / 65535.\n"
        "normal     floor(127.5 n + 128) of n = (-dx, -dy, 1) / length, with dx and dy the\n"
        "           slopes of height * value: red is east, green north, blue up (OpenGL).\n"
        "hillshade  round(255 n.light), light from azimuth 315 (north-west), altitude 45.\n"
        "compare    on the left the normals again, on the right normals of the same places with\n"
        "           dx and dy by central differences of the 16-bit heights, two steps apart.",
    .options = terrain_table,
    .count = sizeof terrain_table / sizeof terrain_table[0],
};

/* The pictures, each with the function that makes its rows; the last one only if asked for */
#define PICTURES 4
static const struct picture {
    const char *name;
    int channels, depth;
    render_row_fn *row;
} pictures[PICTURES] = {
    {"height", 1, 16, render_heights},
    {"normal", 3, 8, render_normals},
    {"hillshade", 1, 8, render_hillshade},
    {"compare", 3, 8, render_compare},
};

static int picture_count(size_t compare)
{
    return compare == 0 ? PICTURES - 1 : PICTURES;
}

static int file_error(const struct image *image, int status)
{
    const char *const reason = errno != 0 ? strerror(errno) : "cannot be written";
    cli_error("--output: %s: %s", image->path != NULL ? image->path : image->name, reason);
    return status;
}

static int open_pictures(struct image images[PICTURES], const struct terrain_options *options)
{
    for (int i = 0; i < picture_count(options->compare); i++) {
        const bool enlarged = pictures[i].row == render_compare;
        images[i] =
            (struct image){.name = pictures[i].name,
                           .width = options->size.width * (enlarged ? 2 * options->compare : 1),
                           .height = options->size.height * (enlarged ? options->compare : 1),
                           .channels = pictures[i].channels,
                           .depth = pictures[i].depth};
        errno = 0;
        if (!image_open(&images[i], options->output)) {
            return file_error(&images[i], CLI_USAGE);
        }
    }
    return CLI_SUCCESS;
}

/* All files are completed before the first one takes its name: the disk may fill up until then. */
static int close_pictures(struct image images[PICTURES], int count)
{
    errno = 0;
    for (int i = 0; i < count; i++) {
        if (!image_close(&images[i])) {
            return file_error(&images[i], CLI_FAILURE);
        }
    }
    for (int i = 0; i < count; i++) {
        if (!image_publish(&images[i])) {
            return file_error(&images[i], CLI_FAILURE);
        }
    }
    return CLI_SUCCESS;
}

/* One line on the terminal that rewrites itself, and goes before anything else is printed. */
#define PROGRESS "sampling %3d %%"
#define PROGRESS_WIDTH 14

static void show_progress(size_t done, size_t total, int *shown)
{
    const int percent = (int)(done * 100 / total);
    if (percent != *shown) {
        fprintf(stderr, "\r" PROGRESS, percent);
        fflush(stderr);
        *shown = percent;
    }
}

static void clear_progress(void)
{
    fprintf(stderr, "\r%*s\r", PROGRESS_WIDTH, "");
}

/* Returns the picture that could not be written, NULL if all could. */
static const struct image *write_block(struct image images[PICTURES], const struct render *render,
                                       size_t rows)
{
    for (int i = 0; i < picture_count(render->compare); i++) {
        const size_t times = images[i].height / render->size.height;
        for (size_t r = 0; r < rows; r++) {
            const uint8_t *const samples = pictures[i].row(render, r);
            for (size_t n = 0; n < times; n++) {
                errno = 0;
                if (!image_row(&images[i], samples)) {
                    return &images[i];
                }
            }
        }
    }
    return NULL;
}

static int write_rows(struct image images[PICTURES], struct render *render, bool progress)
{
    const size_t height = render->size.height;
    const struct image *failed = NULL;
    int shown = -1;
    for (size_t row = 0; row < height && failed == NULL; row += render->rows) {
        const size_t rows = height - row < render->rows ? height - row : render->rows;
        render_block(render, row, rows);
        failed = write_block(images, render, rows);
        if (progress && failed == NULL) {
            show_progress(row + rows, height, &shown);
        }
    }
    const int reason = errno;
    if (shown >= 0) {
        clear_progress();
    }
    errno = reason;
    return failed == NULL ? CLI_SUCCESS : file_error(failed, CLI_FAILURE);
}

static int write_pictures(struct render *render, const struct terrain_options *options)
{
    struct image images[PICTURES] = {{0}};
    int status = open_pictures(images, options);
    if (status == CLI_SUCCESS) {
        status = write_rows(images, render, !options->quiet && STDERR_IS_TERMINAL());
    }
    if (status == CLI_SUCCESS) {
        status = close_pictures(images, picture_count(options->compare));
    }
    for (int i = 0; i < PICTURES; i++) {
        image_discard(&images[i], status == CLI_SUCCESS);
    }
    return status;
}

/* Fills the part of `render` that the options decide. */
static bool prepare(struct render *render, const struct terrain_options *options)
{
    *render = (struct render){
        .noise = {.basis = (enum scarp_basis)options->basis,
                  .fade = (enum scarp_fade)options->fade,
                  .fractal = (enum scarp_fractal)options->fractal,
                  .rotate = (uint32_t)options->rotate,
                  .seed = options->seed,
                  .frequency = options->frequency,
                  .octaves = options->octaves,
                  .lacunarity = options->lacunarity,
                  .gain = options->gain,
                  .erosion = options->erosion},
        .size = options->size,
        .origin = options->origin,
        .step = options->step,
        .height_scale = options->height,
        .compare = options->compare,
        .threads = options->threads != 0 ? options->threads : render_threads(),
    };
    /* Each number was checked by itself; what is left is the frequency of the last octave. */
    const enum scarp_status status =
        scarp_range(&render->noise, 2, &render->lowest, &render->highest);
    if (status != SCARP_OK) {
        cli_error("--frequency, --lacunarity, --octaves: the frequency of the last octave is not "
                  "from 2^-32 to 2^48");
    }
    return status == SCARP_OK;
}

static void print_summary(const struct render *render, double seconds)
{
    const double samples = (double)render->size.width * (double)render->size.height;
    /* No clock resolves the smallest pictures. */
    const double sampling = render->sampling_seconds > 1e-9 ? render->sampling_seconds : 1e-9;
    printf("%zux%zu samples in %.3f s, of which %.3f s sampled values, gradients and normals: %.1f "
           "million "
           "samples per second (%s)\n",
           render->size.width, render->size.height, seconds, render->sampling_seconds,
           samples / sampling * 1e-6, scarp_isa_name(scarp_isa_active()));
}

int cli_terrain(int argc, char **argv)
{
    struct terrain_options options = {0};
    switch (options_parse(&table, argc, argv, &options)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    struct render render;
    if (!prepare(&render, &options)) {
        return CLI_USAGE;
    }
    scarp_isa_select((enum scarp_isa)options.isa);
    const double start = render_seconds();
    int status = CLI_FAILURE;
    if (render_open(&render)) {
        status = write_pictures(&render, &options);
    } else {
        cli_error("no memory for rows of %zu samples", options.size.width);
    }
    if (status == CLI_SUCCESS && !options.quiet) {
        print_summary(&render, render_seconds() - start);
    }
    render_close(&render);
    return status;
}
