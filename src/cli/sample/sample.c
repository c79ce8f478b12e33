/* SPDX-License-Identifier: MIT
 *
 * `scarp sample`: the options, and the way of a batch of points from the input to the output.
 * Reading is in points.c, writing in results.c.
 */
#include "commands.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "ground/source.h"
#include "sample/points.h"
#include "sample/results.h"
#include "scarp.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/options.h"
#include "shared/running.h"

struct sample_options {
    struct ground_options ground; /* of it: the noise, the recipe and its values */
    const char *input, *output;
    int input_format, output_format; /* an enum points_format */
    int delimiter;                   /* an enum points_delimiter */
    struct columns columns;
    size_t dims; /* 0: not given */
    int skip_bad, keep, gradient, hessian, dphase, isa, quiet;
};

/* In the order of enum points_format */
static const char *format_word(int format)
{
    static const char *const words[] = {"csv", "text", "npy", NULL};
    return words[format];
}

/* A word, or the character itself; the tab also as a shell leaves it, with a backslash */
static enum option_result parse_delimiter(const struct option *option, const char *text,
                                          void *field)
{
    for (int d = 0; delimiter_word(d) != NULL; d++) {
        const bool is_tab = d == DELIMITER_TAB && strcmp(text, "\\t") == 0;
        if (is_tab || strcmp(text, delimiter_word(d)) == 0 ||
            (text[0] == delimiter_character(d) && text[1] == '\0')) {
            *(int *)field = d;
            return OPTION_VALID;
        }
    }
    (void)option;
    return OPTION_INVALID;
}

#define FIELD(name) offsetof(struct sample_options, name)

static const struct option point_rows[] = {
    {OPTION_TEXT("--input", input, "FILE", "a file name, or - for standard input",
                 "where the points are; - is standard input"),
     .standard = "-"},
    {OPTION_CHOICE("--input-format", input_format, NULL, format_word, "the format of the points"),
     .otherwise = "what the input looks like"},
    {OPTION_READ(
         parse_delimiter, "NAME", "--delimiter", delimiter,
         "comma, semicolon, tab, space or such a character",
         "what separates columns: comma, semicolon, tab, or space (any number of spaces and "
         "tabs); but for commas, numbers may have decimal commas"),
     .otherwise = "what the first row has"},
    {OPTION_READ(option_columns, "X,Y[,Z]", "--columns", columns, COLUMNS_ALLOWED,
                 "which columns are the coordinates: names of CSV's header row, or numbers from 1 "
                 "to 65536"),
     .otherwise = "with a header row those named x, y and z; else the first ones, which must be "
                  "all there are unless --dims is given"},
    {OPTION_READ(option_count, "N", "--dims", dims, "2 or 3",
                 "coordinates of a point, 2 or 3; 2 leaves z out"),
     .otherwise = "3 if there is a column z, or if there are 3 columns without names", .lowest = 2,
     .highest = 3},
    {OPTION_FLAG(
        "--skip-bad", skip_bad,
        "leave out malformed lines, and rows of .npy, instead of stopping at the first one")},
    {OPTION_FLAG("--keep", keep,
                 "copy the input's columns in front of the results; of .npy and to .npy, which "
                 "then holds doubles, only the coordinates")},
};

static const struct option result_rows[] = {
    {OPTION_TEXT("--output", output, "FILE", "a file name, or - for standard output",
                 "where the results go; - is standard output"),
     .standard = "-"},
    {OPTION_CHOICE("--output-format", output_format, NULL, format_word,
                   "the format of the results"),
     .otherwise = "what FILE ends with: .csv, .txt, .npy; else as the input"},
    {OPTION_FLAG("--gradient", gradient, "after the value, its derivatives along x, y (and z)")},
    {OPTION_FLAG("--hessian", hessian, "after these, its second derivatives")},
    {OPTION_FLAG("--dphase", dphase,
                 "after these, its derivative with respect to the phase, per turn; only with "
                 "--basis gradient")},
};

static const struct option period_rows[] = {
    {OPTION_READ(option_periods, "X,Y[,Z]", "--period", ground.noise.period,
                 "two or three integers X,Y[,Z] from 0 to 2^30",
                 "repeat along each axis after so many cells of the first octave, from 0, which is "
                 "never, to 2^30; without --rotate, and with a whole number as lacunarity"),
     .otherwise = "it never does", .lowest = 0, .highest = 0x1p30},
};

static const struct option running_rows[] = {
    {OPTION_ISA(isa)},
    {OPTION_FLAG("--quiet", quiet, "do not print how many points --skip-bad left out")},
};

static const struct option_group groups[] = {
    OPTION_GROUP("points", point_rows, 0),
    OPTION_GROUP("results", result_rows, 0),
    OPTION_GROUP("the noise", ground_recipe_rows, FIELD(ground)),
    OPTION_GROUP_TYPED(NULL, noise_seed_rows, FIELD(ground.noise), FIELD(ground.seed_typed)),
    OPTION_GROUP_TYPED("one noise, without --preset and --recipe", noise_option_rows,
                       FIELD(ground.noise), FIELD(ground.noise_typed)),
    OPTION_GROUP(NULL, period_rows, 0),
    OPTION_GROUP("running", running_rows, 0),
};

const struct option_table sample_table = {
    .command = "sample",
    .purpose = "Reads points and writes the noise at each of them, one row per point.",
    .notes[0] =
        "A row holds what was asked for, in this order:\n"
        "  in 2D  value dx dy dxx dxy dyy dphase\n"
        "  in 3D  value dx dy dz dxx dxy dxz dyy dyz dzz dphase\n"
        "Coordinates are doubles and keep their precision. Results are floats, written with the\n"
        "nine digits that tell them apart, or nan where coordinate times frequency overflows.\n"
        "\n"
        "csv        Fields between commas, semicolons or tabs, in double quotes or not. Which of\n"
        "           them is found from the first row, if it is plain there. Between semicolons\n"
        "           and tabs, numbers may have decimal commas, all or none of them. Results have\n"
        "           the delimiter of the points, and decimal commas if the first point has one.\n"
        "           The first line is a header\n"
        "           row if it has x and y, or if its first two fields are no numbers. With\n"
        "           --columns it is one if --columns has names, or if the fields that it numbers\n"
        "           are no numbers. Results get a header row, too, unless the points are CSV\n"
        "           without one.\n"
        "text       Columns between spaces or tabs, without a header row, also of numbers with\n"
        "           decimal commas. As in CSV, empty lines and lines that begin with # are passed\n"
        "           over.\n"
        "npy        Arrays of NumPy. Points have the shape (n, 2) or (n, 3), or more columns\n"
        "           with --columns or --dims, and are floats of 16, 32 or 64 bits or integers;\n"
        "           those beyond 2^53 are rounded. In Fortran order, as np.array([x, y]).T is,\n"
        "           they are read as a whole first. Results have the shape (n, number of\n"
        "           results) and are floats, with --keep doubles. Points from CSV or text, or\n"
        "           with --skip-bad, need a file for such results, not a pipe.\n"
        "\n"
        "columns    Names are compared without blanks and quotes around them, and without regard\n"
        "           to capitals. In --columns, write a name with a comma in double quotes. A\n"
        "           header row without x and y needs --columns. If two columns have the name,\n"
        "           give their numbers. All lines have as many columns as the first. Without a\n"
        "           header row and without --keep, --dims and --columns ignore what is\n"
        "           behind the coordinates.\n"
        "recipe     With a recipe, the value is its first output, and there is no dphase. The\n"
        "           seed is 1 unless it is given, as of scarp terrain. If it has `param sea`,\n"
        "           lower values become the sea's.\n"
        "malformed  A point is malformed if a coordinate is not a finite number, so with nan or\n"
        "           inf, also in .npy. A line is, if it has too few or too many columns.\n"
        "\n"
        "Rows are written as soon as points are read, in batchs of at most 4096. A malformed one\n"
        "ends the run with one message and exit status 2, as does an input that cannot be read.\n"
        "The output file, which may be the input file, appears only when all went well. Standard\n"
        "output has then got the rows of the points before.",
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .removed = ground_removed,
};

#define BY_PHASE 3

/* The results there are: order 0 is the value, 1 the gradient, 2 the Hessian, BY_PHASE the
   derivative with respect to the phase. */
static const struct result {
    const char *name;
    int order, dims; /* dims: from how many dimensions on */
    size_t offset;   /* of the array in struct scarp_samples */
} all_results[RESULTS_COLUMNS_MAX] = {
    {"value", 0, 2, offsetof(struct scarp_samples, value)},
    {"dx", 1, 2, offsetof(struct scarp_samples, dx)},
    {"dy", 1, 2, offsetof(struct scarp_samples, dy)},
    {"dz", 1, 3, offsetof(struct scarp_samples, dz)},
    {"dxx", 2, 2, offsetof(struct scarp_samples, dxx)},
    {"dxy", 2, 2, offsetof(struct scarp_samples, dxy)},
    {"dxz", 2, 3, offsetof(struct scarp_samples, dxz)},
    {"dyy", 2, 2, offsetof(struct scarp_samples, dyy)},
    {"dyz", 2, 3, offsetof(struct scarp_samples, dyz)},
    {"dzz", 2, 3, offsetof(struct scarp_samples, dzz)},
    {"dphase", BY_PHASE, 2, offsetof(struct scarp_samples, dphase)},
};

/* What a run needs, too large for the stack */
struct sample {
    struct scarp_noise noise; /* one noise, or else: */
    bool has_recipe, is_space;
    struct ground ground;
    struct scarp_samples samples;
    struct points points;
    struct results results;
    struct points_batch batch;
    float values[RESULTS_COLUMNS_MAX][POINTS_BATCH];
};

/* Chooses the results for points of so many dimensions. */
static void choose_results(struct sample *sample, const struct sample_options *options, int dims)
{
    struct results *const results = &sample->results;
    const bool wanted[] = {true, options->gradient != 0, options->hessian != 0,
                           options->dphase != 0};
    for (size_t i = 0; i < RESULTS_COLUMNS_MAX; i++) {
        const struct result *const result = &all_results[i];
        if (wanted[result->order] && dims >= result->dims) {
            float *const values = sample->values[results->columns];
            memcpy((char *)&sample->samples + result->offset, &values, sizeof values);
            results->names[results->columns] = result->name;
            results->values[results->columns] = values;
            results->columns++;
        }
    }
}

static enum scarp_status sample_recipe(const struct ground *ground, size_t count, const double *x,
                                       const double *y, const double *z,
                                       const struct scarp_samples *out)
{
    const struct scarp_recipe_outputs outputs = {.out = out, .which = &ground->height, .count = 1};
    return scarp_recipe_sample_f64(&ground->recipe, count, x, y, z, &outputs, ground_scratch());
}

static enum scarp_status sample_batch(struct sample *sample)
{
    const struct points_batch *const batch = &sample->batch;
    const double *const x = batch->position[0], *const y = batch->position[1],
                        *const z = batch->position[2];
    if (sample->has_recipe) {
        const enum scarp_status status =
            sample_recipe(&sample->ground, batch->count, x, y, z, &sample->samples);
        ground_cover(&sample->ground, batch->count, &sample->samples);
        return status;
    }
    return sample->points.dims == 3
               ? scarp_sample3_f64(&sample->noise, batch->count, x, y, z, &sample->samples)
               : scarp_sample2_f64(&sample->noise, batch->count, x, y, &sample->samples);
}

/* Whether a noise that was checked has what an option asks for. `advice` says what helps. */
static bool has(const char *option, const struct scarp_noise *noise, int order, int dphase,
                const char *advice)
{
    const char *const reason = scarp_noise_fault(noise, 3, order, dphase, NULL);
    if (reason != NULL) {
        cli_error("%s: %s%s", option, reason, advice);
    }
    return reason == NULL;
}

/* Whether the library can give what is asked for of one noise; all else was checked before. */
static bool check_results(const struct scarp_noise *noise, const struct sample_options *options)
{
    const char *const take =
        noise->basis == SCARP_GRADIENT ? "" : "; leave it out or take --basis gradient";
    return (!options->hessian || has("--hessian", noise, 2, 0, "")) &&
           (!options->dphase || has("--dphase", noise, 0, 1, take));
}

/* The same of a recipe */
static bool check_recipe(struct sample *sample, const struct source *source,
                         const struct sample_options *options)
{
    float result;
    const double origin = 0;
    const struct scarp_samples second = {.dxx = &result};
    struct ground *const ground = &sample->ground;
    if (options->dphase) {
        cli_error("--dphase: is for one noise; leave it out with %s", source->option);
        return false;
    }
    if (!source_ground(source, ground)) {
        return false;
    }
    sample->is_space = ground->is_space;
    if (options->hessian &&
        sample_recipe(ground, 1, &origin, &origin, &origin, &second) != SCARP_OK) {
        cli_error("--hessian: %s has no second derivatives", source->name);
        return false;
    }
    return true;
}

/* A recipe is of the plane, or of space. */
static bool check_dimensions(const struct sample *sample, const struct source *source)
{
    if (sample->is_space && sample->points.dims == 2) {
        cli_error("%s: %s is a recipe of space, but the points have no z", source->option,
                  source->name);
        return false;
    }
    if (!sample->is_space && sample->points.dims == 3) {
        cli_error("%s: %s is of the plane; --dims 2 leaves z out", source->option, source->name);
        return false;
    }
    return true;
}

static bool check_columns(const struct sample_options *options)
{
    const size_t count = options->columns.count;
    const bool agree = count == 0 || options->dims == 0 || count == options->dims;
    if (!agree) {
        cli_error("--columns: names %zu columns, but --dims is %zu", count, options->dims);
    }
    return agree;
}

/* Space is the delimiter of text, the others are those of CSV. */
static bool check_delimiter(const struct sample_options *options)
{
    const bool is_space = options->delimiter == DELIMITER_SPACE;
    const bool agree = options->delimiter == DELIMITER_UNKNOWN ||
                       options->input_format == POINTS_UNKNOWN ||
                       options->input_format == (is_space ? POINTS_TEXT : POINTS_CSV);
    if (!agree) {
        cli_error("--delimiter: %s is the delimiter of --input-format %s, not of %s",
                  delimiter_word(options->delimiter), is_space ? "text" : "csv",
                  format_word(options->input_format));
    }
    return agree;
}

/* What the name of the output says, if nothing else does */
static int format_by_name(const char *path, int otherwise)
{
    static const char *const ends[] = {".csv", ".txt", ".npy"};
    const size_t length = strlen(path);
    for (int i = 0; i < 3; i++) {
        if (length > 4 && strcmp(path + length - 4, ends[i]) == 0) {
            return i;
        }
    }
    return otherwise;
}

static int open_both(struct sample *sample, const struct source *source,
                     const struct sample_options *options)
{
    struct points *const points = &sample->points;
    struct results *const results = &sample->results;
    *points = (struct points){.format = options->input_format,
                              .delimiter = options->delimiter,
                              .dims = (int)options->dims,
                              .chosen = options->columns,
                              .skip_bad = options->skip_bad != 0,
                              .keep = options->keep != 0};
    results->format = options->output_format;
    results->keep = options->keep != 0;
    int status = points_open(points, options->input);
    if (status == CLI_SUCCESS) {
        status = results_open(results, options->output);
    }
    if (status == CLI_SUCCESS) {
        status = points_begin(points);
    }
    if (status != CLI_SUCCESS) {
        return status;
    }
    /* Some noise is there only in space. */
    if (sample->has_recipe
            ? !check_dimensions(sample, source)
            : points->dims == 2 && !noise_make(&options->ground.noise, 2, &sample->noise)) {
        return CLI_USAGE;
    }
    if (results->format == POINTS_UNKNOWN) {
        results->format = format_by_name(options->output, points->format);
    }
    points->plain = points->keep && results->format == POINTS_TEXT;
    choose_results(sample, options, points->dims);
    return results_begin(results, points);
}

static int sample_all(struct sample *sample)
{
    for (;;) {
        if (interrupted()) { /* reads and writes notice it too */
            cli_error("interrupted: not all points were read");
            return CLI_FAILURE;
        }
        int status = points_read(&sample->points, &sample->batch);
        if (status != CLI_SUCCESS || sample->batch.count == 0) {
            return status;
        }
        if (sample_batch(sample) != SCARP_OK) { /* nothing is known that leads here */
            cli_error("the library refuses this noise");
            return CLI_FAILURE;
        }
        status = results_write(&sample->results, &sample->points, &sample->batch);
        if (status != CLI_SUCCESS) {
            return status;
        }
    }
}

static int run(struct sample *sample, const struct source *source,
               const struct sample_options *options)
{
    int status = open_both(sample, source, options);
    if (status == CLI_SUCCESS) {
        status = sample_all(sample);
    }
    points_close(&sample->points); /* Windows replaces no file that is open */
    if (status == CLI_SUCCESS) {
        status = results_end(&sample->results, &sample->points);
    }
    results_close(&sample->results);
    return status;
}

static void tell_malformed(const struct points *points)
{
    const unsigned long long count = points->malformed;
    if (count > 0) {
        cli_error("--skip-bad: %llu malformed %s%s of %s %s left out", count,
                  points->format == POINTS_NPY ? "point" : "line", count == 1 ? "" : "s",
                  points->input.name, count == 1 ? "was" : "were");
    }
}

/* One noise has no text here: it has dphase, and a period in cells. */
static bool prepare(struct sample *sample, struct source *source, struct sample_options *options)
{
    struct ground_options *const ground = &options->ground;
    sample->has_recipe = ground->preset != 0 || ground->recipe != NULL;
    if (sample->has_recipe) {
        if (ground->seed_typed == 0) { /* all terrain has 1 then */
            ground->noise.seed = 1;
        }
        if (ground->noise.period[0] != 0 || ground->noise.period[1] != 0 ||
            ground->noise.period[2] != 0) {
            cli_error("--period: is for one noise; a recipe has a line: tile X, Y");
            return false;
        }
        if (source_open(source, ground, 1.0) != CLI_SUCCESS) {
            return false;
        }
        source->ground.is_any = true;
        return ground->print_recipe || check_recipe(sample, source, options);
    }
    if (ground->set.count > 0 || ground->scale != 1.0 || ground->print_recipe) {
        cli_error("%s: needs --preset or --recipe", ground->set.count > 0  ? "--set"
                                                    : ground->print_recipe ? "--print-recipe"
                                                                           : "--scale");
        return false;
    }
    return noise_make(&ground->noise, 3, &sample->noise) && check_results(&sample->noise, options);
}

int cli_sample(char **argv)
{
    static struct sample_options options = {.ground = GROUND_OPTIONS_UNSET,
                                            .input_format = POINTS_UNKNOWN,
                                            .delimiter = DELIMITER_UNKNOWN,
                                            .output_format = POINTS_UNKNOWN};
    switch (options_parse(&sample_table, argv, &options)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    struct sample *const sample = calloc(1, sizeof *sample);
    if (sample == NULL) {
        cli_error("no memory for a batch of points");
        return CLI_FAILURE;
    }
    struct source source = {.name = NULL};
    int status = CLI_USAGE;
    if (check_columns(&options) && check_delimiter(&options) &&
        prepare(sample, &source, &options)) {
        status = CLI_FAILURE;
        if (options.ground.print_recipe) {
            source_print(&source);
            status = CLI_SUCCESS;
        } else if (running_select(options.isa)) {
            status = run(sample, &source, &options);
        }
    }
    if (status == CLI_SUCCESS && !options.quiet) {
        tell_malformed(&sample->points);
    }
    source_close(&source);
    free(sample);
    return status;
}
