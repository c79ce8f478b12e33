/* SPDX-License-Identifier: MIT
 *
 * The option parser and the help. How a value is read is in values.c.
 */
#include "shared/options.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "shared/error.h"

#define HELP_COLUMN 18 /* where the help's explanations begin */

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

/* The default of an option: the row's, unless the table has another. */
static const char *standard_of(const struct option_table *table, const struct option *option)
{
    const char *standard = option->standard;
    for (const char *const *word = table->standard; word != NULL && *word != NULL; word++) {
        if (strcmp(*word, option->name) == 0) {
            standard = word[1];
        }
    }
    return standard;
}

static void print_help(const struct option_table *table)
{
    printf("usage: scarp %s [options]\n\n%s\n", table->command, table->purpose);
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        if (group->title != NULL) {
            printf("\n%s:\n", group->title);
        }
        for (size_t i = 0; i < group->count; i++) {
            const struct option *const option = &group->options[i];
            print_option(option->name, option->argument, option->help, standard_of(table, option));
        }
    }
    print_option("--help", NULL, "print this", NULL);
    if (table->notes != NULL) {
        printf("\n%s\n", table->notes);
    }
}

/* An option and the field that its value goes to */
struct target {
    const struct option *option; /* NULL: there is no such option */
    void *field;
};

/* The option that `word` names: the whole word, or what stands before '='. */
static struct target find_option(const struct option_table *table, const char *word, void *values)
{
    const size_t length = strcspn(word, "=");
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        for (size_t i = 0; i < group->count; i++) {
            const struct option *const option = &group->options[i];
            if (strlen(option->name) == length && strncmp(option->name, word, length) == 0) {
                return (struct target){option, (char *)values + group->offset + option->offset};
            }
        }
    }
    return (struct target){NULL, NULL};
}

static bool set_value(const struct target *target, const char *text)
{
    const struct option *const option = target->option;
    switch (option->parse(option, text, target->field)) {
    case OPTION_VALID: return true;
    case OPTION_UNAVAILABLE:
        cli_error("%s: '%.60s' cannot run here; see: scarp info", option->name, text);
        return false;
    default: cli_error("%s: '%.60s' is not %s", option->name, text, option->allowed); return false;
    }
}

/* Reads the option at words[0] and its value. Returns how many words that took, 0 after an error.
   The words end with NULL. */
static int read_option(const struct option_table *table, const char *const *words, void *values)
{
    const char *const word = words[0];
    if (word[0] != '-') {
        cli_error("%.60s: unexpected argument; see: scarp %s --help", word, table->command);
        return 0;
    }
    const struct target target = find_option(table, word, values);
    if (target.option == NULL) {
        cli_error("%.60s: unknown option; see: scarp %s --help", word, table->command);
        return 0;
    }
    const struct option *const option = target.option;
    const char *const joined = strchr(word, '=');
    if (option->parse == NULL) {
        if (joined != NULL) {
            cli_error("%s: takes no value", option->name);
            return 0;
        }
        *(int *)target.field = 1;
        return 1;
    }
    if (joined != NULL) {
        return set_value(&target, joined + 1) ? 1 : 0;
    }
    if (words[1] == NULL || strncmp(words[1], "--", 2) == 0) {
        cli_error("%s: has no value; it takes %s", option->name, option->allowed);
        return 0;
    }
    return set_value(&target, words[1]) ? 2 : 0;
}

static bool set_words(const struct option_table *table, const char *const *words, void *values)
{
    while (words != NULL && *words != NULL) {
        const int count = read_option(table, words, values);
        if (count == 0) {
            return false;
        }
        words += count;
    }
    return true;
}

static bool set_defaults(const struct option_table *table, void *values)
{
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        for (size_t i = 0; i < group->count; i++) {
            const struct option *const option = &group->options[i];
            const struct target target = {option, (char *)values + group->offset + option->offset};
            if (option->standard != NULL && !set_value(&target, option->standard)) {
                return false;
            }
        }
    }
    return set_words(table, table->standard, values);
}

enum options_outcome options_parse(const struct option_table *table, char **argv, void *values)
{
    for (int i = 0; argv[i] != NULL; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help(table);
            return OPTIONS_HELP;
        }
    }
    const char *const *const words = (const char *const *)argv;
    if (!set_defaults(table, values) || !set_words(table, words, values)) {
        return OPTIONS_BAD;
    }
    if (table->presets != NULL) {
        /* Wherever it stands on the command line, what else stands there changes the preset. */
        const int preset = *(const int *)((const char *)values + table->preset_offset);
        if (!set_words(table, table->presets[preset], values) || !set_words(table, words, values)) {
            return OPTIONS_BAD;
        }
    }
    return OPTIONS_RUN;
}
