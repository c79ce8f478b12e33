/* SPDX-License-Identifier: MIT
 *
 * What the program says of many command lines and headers of .npy, without a process for each: the
 * tests cli.errors and cli.sample.description ask it. Standard input has cases: how many words,
 * then for each its length in bytes and a space, then its bytes. The first word is the command
 * whose options the others are, or npy, before a header. A line is printed for each case: what came
 * of it, how many errors were told, and the last of them.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "formats/npy.h"
#include "shared/error.h"
#include "shared/options.h"
#include "terrain/terrain_options.h"

#define WORDS_MOST 64

static struct {
    int count;
    char last[1024];
} errors;

/* Replaces the program's function. */
void cli_error(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(errors.last, sizeof errors.last, format, arguments);
    va_end(arguments);
    errors.count++;
}

static void fail(const char *why)
{
    fprintf(stderr, "%s\n", why);
    exit(EXIT_FAILURE);
}

/* Reads a word, which ends with a NUL behind its bytes. */
static char *read_word(size_t *length)
{
    if (scanf("%zu", length) != 1 || getchar() != ' ') {
        fail("no length of a word");
    }
    char *const word = malloc(*length + 1);
    if (word == NULL || fread(word, 1, *length, stdin) != *length) {
        fail("no word of that length");
    }
    word[*length] = '\0';
    return word;
}

static const char *try_options(const struct option_table *table, char **words)
{
    static union {
        double alignment;
        char bytes[1 << 14]; /* more than any command has */
    } values;
    memset(&values, 0, sizeof values);
    switch (options_parse(table, words, &values)) {
    case OPTIONS_RUN: return "run";
    case OPTIONS_HELP: return "help";
    default: return "bad";
    }
}

static const char *try_npy(const char *header, size_t length)
{
    struct npy_array array;
    const char *const problem = npy_parse_header(header, length, &array);
    if (problem != NULL) {
        cli_error("the .npy header %s", problem);
    }
    return problem != NULL ? "bad" : "run";
}

static void try_case(size_t count)
{
    char *words[WORDS_MOST + 1] = {NULL};
    size_t length = 0;
    if (count < 1 || count > WORDS_MOST) {
        fail("too many words, or none");
    }
    for (size_t i = 0; i < count; i++) {
        words[i] = read_word(&length);
    }
    errors.count = 0;
    errors.last[0] = '\0';
    const char *const came =
        strcmp(words[0], "terrain") == 0  ? try_options(&terrain_table, words + 1)
        : strcmp(words[0], "sample") == 0 ? try_options(&sample_table, words + 1)
                                          : try_npy(words[count - 1], length);
    for (char *c = errors.last; *c != '\0'; c++) {
        *c = (unsigned char)*c < 0x20 || *c == 0x7f ? '?' : *c;
    }
    printf("%s %d %s\n", came, errors.count, errors.last);
    for (size_t i = 0; i < count; i++) {
        free(words[i]);
    }
}

int main(void)
{
    size_t count;
    while (scanf("%zu", &count) == 1) {
        try_case(count);
    }
    return EXIT_SUCCESS;
}
