/* SPDX-License-Identifier: MIT
 *
 *     fuzz_words recipe | options | files FILE
 *
 * Writes a dictionary for libFuzzer: the words that inputs are made of. Those of recipes and of
 * options are taken from the library and the program, so that they are complete.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "scarp.h"
#include "sheet/sheet_options.h"
#include "terrain/terrain_options.h"
#include "view/view_options.h"

/* Prints a word, and what is behind it. */
static void print(const char *word, const char *behind)
{
    const char *const parts[] = {word, behind};
    putchar('"');
    for (size_t i = 0; i < 2; i++) {
        for (const char *c = parts[i]; *c != '\0'; c++) {
            if (*c == '"' || *c == '\\') {
                printf("\\%c", *c);
            } else if (*c >= ' ' && *c <= '~') {
                putchar(*c);
            } else {
                printf("\\x%02x", (unsigned)(unsigned char)*c);
            }
        }
    }
    printf("\"\n");
}

static void print_all(const char *const *words)
{
    for (; *words != NULL; words++) {
        print(*words, "");
    }
}

static const char *const recipe_words[] = {
    "recipe 1\n", "space 3\n", "tile 8, 4\n", "param ", "out ", " = ", "#: palette ",
    "\n",         "1e30",      "0x",          ": ",     "^3",   NULL};

static void print_recipe(void)
{
    struct scarp_recipe_function f;
    print_all(recipe_words);
    for (size_t i = 0; scarp_recipe_function_at(i, &f) == SCARP_OK; i++) {
        print(f.name, "(");
        for (int32_t a = 0; a < f.arguments; a++) {
            if (f.argument[a].words != NULL) {
                print_all(f.argument[a].words);
            } else {
                print(f.argument[a].name, "=");
            }
        }
    }
}

/* Values of every kind of option, and what is around them in patterns */
static const char *const value_words[] = {
    "16x16",  "0,0",   "1e6",  "-1",   "0x",   "0.5", "nan",         "EPSG:", "32632",   "0:1,0:1",
    "0/1",    "NAME=", "..",   "|",    "/4",   "{x}", "{y}",         "{-y}",  "{level}", "{-level}",
    "{x:04}", "png:",  "r16:", ".png", ".tif", "-",   "height=1..4", "seed=", NULL};

static void print_options(void)
{
    const struct option_table *const tables[] = {&terrain_table, &view_table, &sheet_table,
                                                 &sample_table, &recipe_table};
    print_all(value_words);
    for (size_t t = 0; t < sizeof tables / sizeof tables[0]; t++) {
        for (size_t g = 0; g < tables[t]->count; g++) {
            const struct option_group *const group = &tables[t]->groups[g];
            for (size_t i = 0; i < group->count; i++) {
                const struct option *const option = &group->options[i];
                print(option->name, option->parse != NULL ? "\n" : "");
                for (int n = 0; option->choice != NULL && option->choice(n) != NULL; n++) {
                    print(option->choice(n), "");
                }
            }
        }
    }
}

/* Of .npy, CSV, palettes, manifests and checksums */
static const char *const file_words[] = {"\x93NUMPY",
                                         "\x01",
                                         "\x02",
                                         "{'descr': ",
                                         "'<f8'",
                                         "'>f4'",
                                         "'fortran_order': ",
                                         "False",
                                         "True",
                                         "'shape': ",
                                         "(2, 3), }",
                                         "(3,)",
                                         "[('x', '<f4')]",
                                         "L",
                                         "x,y",
                                         "x,y,z",
                                         "\"\"",
                                         "\xef\xbb\xbf",
                                         "\r\n",
                                         "nan",
                                         "1e999",
                                         "COLOR_MODEL",
                                         "RGB",
                                         "HSV",
                                         "# ",
                                         "nv ",
                                         "50% ",
                                         "0 255 0 ",
                                         "0/255/0",
                                         "grey",
                                         "B ",
                                         "F ",
                                         "N ",
                                         " L",
                                         " U",
                                         "; ",
                                         ",",
                                         ":",
                                         "\"manifest\": 1",
                                         "\"derived\": ",
                                         "\"seed\": ",
                                         "\"recipe\": ",
                                         "{}",
                                         "[]",
                                         "null",
                                         "true",
                                         "false",
                                         "\\u0041",
                                         "\\\"",
                                         "1e5",
                                         ".5",
                                         "  tile_0_0.png\n",
                                         "0123456789abcdef",
                                         NULL};

int main(int argc, char **argv)
{
    const char *const topic = argc == 3 ? argv[1] : "";
    if (argc == 3 && freopen(argv[2], "w", stdout) == NULL) {
        perror(argv[2]);
        return EXIT_FAILURE;
    }
    if (strcmp(topic, "recipe") == 0) {
        print_recipe();
    } else if (strcmp(topic, "options") == 0) {
        print_options();
    } else if (strcmp(topic, "files") == 0) {
        print_all(file_words);
    } else {
        fprintf(stderr, "usage: fuzz_words recipe | options | files FILE\n");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
