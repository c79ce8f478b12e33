/* SPDX-License-Identifier: MIT
 *
 * The option parser, and how each kind of value is read: the whole text or nothing. Numbers are
 * read in the C locale, which the program never leaves.
 */
#include "options.h"

#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "scarp.h"

#define HELP_COLUMN 18 /* where the help's explanations begin */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* A number of [lowest, highest] at the start of `text`; *end is what follows it. strtod also takes
   leading space, "inf" and "nan"; the first character rules them out. */
static bool read_number(const struct option *option, const char *text, double *value, char **end)
{
    const char first = text[0] == '-' || text[0] == '+' ? text[1] : text[0];
    if (!is_digit(first) && first != '.') {
        return false;
    }
    *value = strtod(text, end);
    return *end != text && *value >= option->lowest && *value <= option->highest;
}

enum option_result option_double(const struct option *option, const char *text, void *field)
{
    char *end;
    double value;
    if (!read_number(option, text, &value, &end) || *end != '\0') {
        return OPTION_INVALID;
    }
    *(double *)field = value;
    return OPTION_VALID;
}

enum option_result option_float(const struct option *option, const char *text, void *field)
{
    double value;
    const enum option_result result = option_double(option, text, &value);
    if (result == OPTION_VALID) {
        *(float *)field = (float)value;
    }
    return result;
}

enum option_result option_point(const struct option *option, const char *text, void *field)
{
    char *end;
    struct option_point point;
    if (!read_number(option, text, &point.x, &end) || *end != ',' ||
        !read_number(option, end + 1, &point.y, &end) || *end != '\0') {
        return OPTION_INVALID;
    }
    *(struct option_point *)field = point;
    return OPTION_VALID;
}

/* Decimal digits whose number lies in [lowest, highest], at the start of `text`. */
static bool read_count(const struct option *option, const char *text, size_t *count, char **end)
{
    if (!is_digit(text[0])) {
        return false;
    }
    errno = 0;
    const unsigned long long value = strtoull(text, end, 10);
    if (errno != 0 || (double)value < option->lowest || (double)value > option->highest) {
        return false;
    }
    *count = (size_t)value;
    return true;
}

enum option_result option_count(const struct option *option, const char *text, void *field)
{
    char *end;
    size_t count;
    if (!read_count(option, text, &count, &end) || *end != '\0') {
        return OPTION_INVALID;
    }
    *(size_t *)field = count;
    return OPTION_VALID;
}

enum option_result option_size(const struct option *option, const char *text, void *field)
{
    char *end;
    struct option_size size;
    if (!read_count(option, text, &size.width, &end) || *end != 'x' ||
        !read_count(option, end + 1, &size.height, &end) || *end != '\0') {
        return OPTION_INVALID;
    }
    *(struct option_size *)field = size;
    return OPTION_VALID;
}

enum option_result option_seed(const struct option *option, const char *text, void *field)
{
    (void)option;
    const bool hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const char *const digits = hexadecimal ? text + 2 : text;
    const char *const alphabet = hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
    if (*digits == '\0' || digits[strspn(digits, alphabet)] != '\0') {
        return OPTION_INVALID;
    }
    errno = 0;
    const unsigned long long seed = strtoull(digits, NULL, hexadecimal ? 16 : 10);
    if (errno != 0 || seed > UINT64_MAX) {
        return OPTION_INVALID;
    }
    *(uint64_t *)field = (uint64_t)seed;
    return OPTION_VALID;
}

enum option_result option_choice(const struct option *option, const char *text, void *field)
{
    for (int i = 0; option->choices[i] != NULL; i++) {
        if (strcmp(text, option->choices[i]) == 0) {
            *(int *)field = i;
            return OPTION_VALID;
        }
    }
    return OPTION_INVALID;
}

enum option_result option_isa(const struct option *option, const char *text, void *field)
{
    (void)option;
    for (int i = SCARP_ISA_SCALAR; i <= SCARP_ISA_NEON; i++) {
        const enum scarp_isa isa = (enum scarp_isa)i;
        if (strcmp(text, scarp_isa_name(isa)) == 0) {
            *(int *)field = i;
            return scarp_isa_supported(isa) ? OPTION_VALID : OPTION_UNAVAILABLE;
        }
    }
    return OPTION_INVALID;
}

enum option_result option_stem(const struct option *option, const char *text, void *field)
{
    (void)option;
    const size_t length = strlen(text);
    if (length == 0 || text[length - 1] == '/' || text[length - 1] == '\\') {
        return OPTION_INVALID;
    }
    *(const char **)field = text;
    return OPTION_VALID;
}

/* One option of the help: name and value on the left, the lines of the explanation on the right. */
static void print_option(const char *name, const char *argument, const char *help,
                         const char *standard)
{
    int column = printf("  %s", name);
    if (argument != NULL) {
        column += printf(" %s", argument);
    }
    if (column >= HELP_COLUMN) {
        putchar('\n');
        column = 0;
    }
    printf("%*s", HELP_COLUMN - column, "");
    for (const char *c = help; *c != '\0'; c++) {
        putchar(*c);
        if (*c == '\n') {
            printf("%*s", HELP_COLUMN, "");
        }
    }
    if (standard != NULL) {
        printf(" [%s]", standard);
    }
    putchar('\n');
}

static void print_help(const struct option_table *table)
{
    printf("usage: scarp %s [options]\n\n%s\n\n", table->command, table->purpose);
    for (size_t i = 0; i < table->count; i++) {
        const struct option *const option = &table->options[i];
        print_option(option->name, option->argument, option->help, option->standard);
    }
    print_option("--help", NULL, "print this", NULL);
    if (table->notes != NULL) {
        printf("\n%s\n", table->notes);
    }
}

/* The option that `word` names: the whole word, or what stands before '='. */
static const struct option *find_option(const struct option_table *table, const char *word)
{
    const size_t length = strcspn(word, "=");
    for (size_t i = 0; i < table->count; i++) {
        const char *const name = table->options[i].name;
        if (strlen(name) == length && strncmp(name, word, length) == 0) {
            return &table->options[i];
        }
    }
    return NULL;
}

static bool set_value(const struct option *option, const char *text, void *values)
{
    void *const field = (char *)values + option->offset;
    switch (option->parse(option, text, field)) {
    case OPTION_VALID: return true;
    case OPTION_UNAVAILABLE:
        cli_error("%s: '%.60s' cannot run here; see: scarp info", option->name, text);
        return false;
    default: cli_error("%s: '%.60s' is not %s", option->name, text, option->allowed); return false;
    }
}

/* Reads the option at argv[0] and its value. Returns how many words that took, 0 after an error. */
static int read_option(const struct option_table *table, int argc, char **argv, void *values)
{
    const char *const word = argv[0];
    if (word[0] != '-') {
        cli_error("%.60s: unexpected argument; see: scarp %s --help", word, table->command);
        return 0;
    }
    const struct option *const option = find_option(table, word);
    if (option == NULL) {
        cli_error("%.60s: unknown option; see: scarp %s --help", word, table->command);
        return 0;
    }
    const char *const joined = strchr(word, '=');
    if (option->parse == NULL) {
        if (joined != NULL) {
            cli_error("%s: takes no value", option->name);
            return 0;
        }
        *(int *)((char *)values + option->offset) = 1;
        return 1;
    }
    if (joined != NULL) {
        return set_value(option, joined + 1, values) ? 1 : 0;
    }
    if (argc < 2 || strncmp(argv[1], "--", 2) == 0) {
        cli_error("%s: has no value; it takes %s", option->name, option->allowed);
        return 0;
    }
    return set_value(option, argv[1], values) ? 2 : 0;
}

enum options_outcome options_parse(const struct option_table *table, int argc, char **argv,
                                   void *values)
{
    for (size_t i = 0; i < table->count; i++) {
        const struct option *const option = &table->options[i];
        if (option->standard != NULL && !set_value(option, option->standard, values)) {
            return OPTIONS_BAD;
        }
    }
    for (int i = 0; i < argc;) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help(table);
            return OPTIONS_HELP;
        }
        const int words = read_option(table, argc - i, argv + i, values);
        if (words == 0) {
            return OPTIONS_BAD;
        }
        i += words;
    }
    return OPTIONS_RUN;
}
