/* SPDX-License-Identifier: MIT
 *
 * `scarp recipe`: prints a recipe, and behind it, as comments, what an artist wants to know of it:
 * so what is printed is a recipe again. Of a text with errors, only the errors are printed.
 */
#include "commands.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ground/source.h"
#include "presets/presets.h"
#include "recipe/measure.h"
#include "recipe/shader.h"
#include "shared/error.h"

struct recipe_options {
    struct ground_options ground;
    int text;
    struct shader_options shader;
};

#define FIELD(name) offsetof(struct recipe_options, name)

static const struct option rows[] = {
    {OPTION_READ(option_seed, "N", "--seed", ground.noise.seed,
                 "an integer from -2^63 to 2^64 - 1, decimal or 0x and hexadecimal",
                 "the seed of the world: an integer of 64 bits, decimal or 0x..."),
     .standard = "1"},
    {OPTION_READ(option_list, "NAME=VALUE", "--set", ground.set,
                 "a parameter of the recipe and its number: NAME=VALUE, at most 64 times",
                 "set a parameter of the recipe; repeat it for others"),
     .highest = OPTION_LIST_MOST},
    {OPTION_FLAG("--text", text, "print only the text")},
};

static const struct option shader_rows[] = {
    {OPTION_CHOICE("--shader", shader.language, NULL, shader_word,
                   "print it as functions of a shading language"),
     .otherwise = "no shader"},
    {OPTION_COUNT("--derivatives", shader.order, "1", 0, 2,
                  "what the shader computes: 0 values, 1 gradients, 2 Hessians")},
    {OPTION_TEXT("--uniforms", shader.uniforms, "FILE", "a file name",
                 "write the uniform buffer of the shader")},
    {OPTION_TEXT("--answers", shader.answers, "FILE", "a file name",
                 "write the right answers of the shader's self-test")},
};

static const struct option_group groups[] = {OPTION_GROUP("a recipe", rows, 0),
                                             OPTION_GROUP("a shader", shader_rows, 0)};

const struct option_table recipe_table = {
    .command = "recipe",
    .operand = "NAME|FILE",
    .purpose = "Prints a recipe of the program, or of a file (- is standard input), checks it, and "
               "shows\nits parameters and outputs, what a sample costs, and which values occur.",
    .notes[0] =
        "errors     All errors of the text are printed on stderr, as FILE:LINE:COLUMN: what is\n"
        "           wrong. The exit status is then 2.\n"
        "outputs    Each has an interval that values never leave, and the lowest, the middle and\n"
        "           the highest value of 4096 places, in a square of 64 of its largest cells.\n"
        "shaders    The text has scarp_recipe(x, y), in space (x, y, z), and what it uses of\n"
        "           scarp.glsl, scarp.hlsl or scarp.wgsl. Its numbers, and the seed, are in a\n"
        "           uniform buffer. The self-test has 4096 numbers of 32 bits. Both files are in\n"
        "           the order of bytes of this processor.\n"
        "cost       It is measured on a grid, with one thread.\n"
        "terrain    It is the first output of a recipe of the plane: a height in the unit of x\n"
        "           and y. `param sea` is the height of water. A line `#: palette NAME` says\n"
        "           which colours suit it.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
};

/* The language, as the library describes it */
static void print_functions(void)
{
    struct scarp_recipe_function f;
    printf(
        "\nfunctions  take a field (f) first; src/recipe/README.md has formulas and pictures:\n");
    for (size_t i = 0; scarp_recipe_function_at(i, &f) == SCARP_OK; i++) {
        printf("  %s(", f.name);
        for (int32_t a = 0; a < f.arguments; a++) {
            printf("%s%s", a > 0 ? ", " : "", f.argument[a].name);
        }
        printf(")\n             %s\n", f.text);
    }
}

static const char *end_of_line(const char *at)
{
    return at + strcspn(at, "\r\n");
}

/* All errors of a text, a line each */
static void print_errors(const struct source *source)
{
    enum { MOST = 20 };
    struct scarp_recipe recipe;
    struct scarp_recipe_error errors[MOST];
    size_t found = 0;
    memset(errors, 0, sizeof errors);
    if (scarp_recipe_parse(source->text.bytes, source->text.length, &recipe, errors, MOST,
                           &found) != SCARP_OK) {
        for (size_t i = 0; i < found && i < MOST; i++) {
            source_refuse(source, &errors[i]);
        }
    }
}

/* What the text says of a parameter: the comment behind it */
static void print_comment(const char *text, const struct scarp_recipe_entry *entry)
{
    const char *const end = end_of_line(text + entry->span[1]);
    const char *const comment =
        memchr(text + entry->span[1], '#', (size_t)(end - (text + entry->span[1])));
    if (comment != NULL) {
        const char *const words = comment + 1 + strspn(comment + 1, " \t");
        printf("  %.*s", (int)(end - words), words);
    }
}

static void print_parameter(const char *text, const struct scarp_recipe_entry *entry)
{
    char interval[64] = "";
    if (fabs(entry->slider[0]) < 1e30 && fabs(entry->slider[1]) < 1e30) {
        snprintf(interval, sizeof interval, "[%.9g, %.9g]", entry->slider[0], entry->slider[1]);
    }
    printf("#   %-12.*s = %-10.9g %s", (int)(entry->name[1] - entry->name[0]),
           text + entry->name[0], entry->value, interval);
    print_comment(text, entry);
    putchar('\n');
}

static void print_output(const char *text, const struct scarp_recipe_entry *entry,
                         const struct measure *measure)
{
    printf("#   %-12.*s never leaves [%.6g, %.6g]; lowest %.6g, middle %.6g, highest %.6g\n",
           (int)(entry->name[1] - entry->name[0]), text + entry->name[0], (double)entry->range[0],
           (double)entry->range[1], (double)measure->lowest, (double)measure->middle,
           (double)measure->highest);
}

static void print_entries(const struct source *source, const struct ground *ground)
{
    struct scarp_recipe_entry entry;
    const char *const text = source->text.bytes;
    bool has_parameters = false;
    for (size_t i = 0; scarp_recipe_entry_at(&ground->recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.is_param) {
            printf("%s", has_parameters ? "" : "# parameters\n");
            print_parameter(text, &entry);
            has_parameters = true;
        }
    }
    printf("# outputs\n");
    for (size_t i = 0; scarp_recipe_entry_at(&ground->recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.output >= 0 && !entry.is_param) {
            struct measure measure;
            measure_values(ground, (int32_t)i, entry.cell[0] > 0.0 ? entry.cell[0] : 1.0, &measure);
            print_output(text, &entry, &measure);
        }
    }
}

static int explain(const struct source *source)
{
    struct ground ground;
    struct scarp_recipe_error error;
    const enum ground_problem problem = ground_open(&ground, &source->ground, &error);
    if (problem == GROUND_BAD_TEXT) {
        print_errors(source);
        return CLI_USAGE;
    }
    if (!source_ground(source, &ground)) { /* tells why */
        return CLI_USAGE;
    }
    source_print(source);
    printf("\n");
    print_entries(source, &ground);
    printf("# cost\n#   %.1f ns per sample, with the gradient %.1f (%s)\n",
           measure_cost(&ground, false), measure_cost(&ground, true),
           scarp_isa_name(scarp_isa_active()));
    return CLI_SUCCESS;
}

static bool asks_for_shader(const struct shader_options *options)
{
    return options->language >= 0 || options->uniforms != NULL || options->answers != NULL;
}

/* Writes what is asked for of the recipe as a shader. */
static int write_shader(const struct source *source, const struct shader_options *options)
{
    struct ground ground;
    struct scarp_recipe_error error;
    if (ground_open(&ground, &source->ground, &error) == GROUND_BAD_TEXT) {
        print_errors(source);
        return CLI_USAGE;
    }
    return source_ground(source, &ground) ? shader_write(&ground.recipe, options) : CLI_USAGE;
}

/* Takes the operand for a preset, or else for a file. */
static void take_operand(const char *name, struct ground_options *options)
{
    for (int i = 1; preset_name(i) != NULL; i++) {
        if (strcmp(preset_name(i), name) == 0) {
            options->preset = i;
            return;
        }
    }
    options->recipe = name;
}

int cli_recipe(char **argv)
{
    static struct recipe_options options = {.ground = GROUND_OPTIONS_UNSET,
                                            .shader = {.language = -1}};
    const bool has_operand = argv[0] != NULL && (argv[0][0] != '-' || argv[0][1] == '\0');
    switch (options_parse(&recipe_table, argv + (has_operand ? 1 : 0), &options)) {
    case OPTIONS_HELP: print_functions(); return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    if (!has_operand) {
        cli_error("recipe: takes the name of a preset or of a file first; see: scarp help recipe");
        return CLI_USAGE;
    }
    take_operand(argv[0], &options.ground);
    struct source source = {.name = NULL};
    int status = source_open(&source, &options.ground, 1.0);
    source.ground.is_any = true;
    if (status == CLI_SUCCESS && options.text && asks_for_shader(&options.shader)) {
        cli_error("recipe: --text and a shader exclude each other");
        status = CLI_USAGE;
    } else if (status == CLI_SUCCESS && options.text) {
        source_print(&source);
    } else if (status == CLI_SUCCESS && asks_for_shader(&options.shader)) {
        status = write_shader(&source, &options.shader);
    } else if (status == CLI_SUCCESS) {
        status = explain(&source);
    }
    source_close(&source);
    return status;
}
