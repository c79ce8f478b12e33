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
#define HELP_WIDTH 84  /* where names in lines end */

/* One option of the help: name and value on the left, the lines of the explanation on the right. */
static void print_option(const char *name, const char *argument, const char *help,
                         const char *standard)
{
    int column = *name != '\0' ? printf("  %s", name) : 0;
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
static const char *standard_of(const struct option_table *table, const char *name,
                               const struct option *option)
{
    const char *standard = option->standard;
    for (const char *const *word = table->standard; word != NULL && *word != NULL; word++) {
        if (strcmp(*word, name) == 0) {
            standard = word[1];
        }
    }
    return standard;
}

struct option_name option_name_of(const char *prefix, const struct option *option)
{
    struct option_name name;
    snprintf(name.text, sizeof name.text, "--%s%s", prefix != NULL ? prefix : "", option->name + 2);
    return name;
}

/* What a group with a prefix is about, and the names of its options, in lines. */
static void print_names(const struct option_group *group)
{
    print_option("", NULL, group->about, NULL);
    int column = 0;
    for (size_t i = 0; i < group->count; i++) {
        const struct option_name name = option_name_of(group->prefix, &group->options[i]);
        if (column + 1 + (int)strlen(name.text) > HELP_WIDTH) {
            putchar('\n');
            column = 0;
        }
        column += printf("%*s%s", column == 0 ? HELP_COLUMN : 1, "", name.text);
    }
    putchar('\n');
}

static void print_help(const struct option_table *table)
{
    printf("usage: scarp %s [options]\n\n%s\n", table->command, table->purpose);
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        if (group->title != NULL) {
            printf("\n%s:\n", group->title);
        }
        for (size_t i = 0; i < group->count && group->prefix == NULL; i++) {
            const struct option *const option = &group->options[i];
            print_option(option->name, option->argument, option->help,
                         standard_of(table, option->name, option));
        }
        if (group->prefix != NULL) {
            print_names(group);
        }
    }
    print_option("--help", NULL, "print this", NULL);
    if (table->notes != NULL) {
        printf("\n%s\n", table->notes);
    }
}

/* An option, its name, and the field that its value goes to */
struct target {
    const struct option *option; /* NULL: there is no such option */
    struct option_name name;
    void *field;
    struct option_given *given; /* NULL: nobody wants to know */
    uint32_t bit;
};

/* Row i of a group */
static struct target target_of(const struct option_group *group, size_t i, void *values)
{
    const struct option *const option = &group->options[i];
    struct target target = {
        .option = option,
        .name = option_name_of(group->prefix, option),
        .field = (char *)values + group->offset + option->offset,
    };
    if (group->prefix != NULL) {
        target.given = (struct option_given *)((char *)values + group->given);
        target.bit = UINT32_C(1) << i;
    }
    return target;
}

/* The option that `word` names: the whole word, or what stands before '='. */
static struct target find_option(const struct option_table *table, const char *word, void *values)
{
    const size_t length = strcspn(word, "=");
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        for (size_t i = 0; i < group->count; i++) {
            const struct target target = target_of(group, i, values);
            if (strlen(target.name.text) == length &&
                strncmp(target.name.text, word, length) == 0) {
                return target;
            }
        }
    }
    return (struct target){.option = NULL};
}

const struct option *options_find(const struct option_table *table, size_t first, size_t end,
                                  const char *name, void *values, void **field)
{
    struct option_table part = *table;
    part.groups = table->groups + first;
    part.count = end - first;
    const struct target target = find_option(&part, name, values);
    *field = target.field;
    return target.option;
}

static bool set_value(const struct target *target, const char *text)
{
    const struct option *const option = target->option;
    const char *const name = target->name.text;
    switch (option->parse(option, text, target->field)) {
    case OPTION_VALID: return true;
    case OPTION_UNAVAILABLE:
        cli_error("%s: '%.60s' cannot run here; see: scarp info", name, text);
        return false;
    default: cli_error("%s: '%.60s' is not %s", name, text, option->allowed); return false;
    }
}

/* Who the words are of */
enum source { FROM_TABLE, FROM_PRESET, FROM_USER };

static void note_given(const struct target *target, enum source source)
{
    if (target->given != NULL && source != FROM_TABLE) {
        target->given->set |= target->bit;
        target->given->typed |= source == FROM_USER ? target->bit : 0;
    }
}

/* Reads the option at words[0] and its value. Returns how many words that took, 0 after an error.
   The words end with NULL. */
static int read_option(const struct option_table *table, const char *const *words,
                       enum source source, void *values)
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
    note_given(&target, source);
    if (option->parse == NULL) {
        if (joined != NULL) {
            cli_error("%s: takes no value", target.name.text);
            return 0;
        }
        *(int *)target.field = 1;
        return 1;
    }
    if (joined != NULL) {
        return set_value(&target, joined + 1) ? 1 : 0;
    }
    if (words[1] == NULL || strncmp(words[1], "--", 2) == 0) {
        cli_error("%s: has no value; it takes %s", target.name.text, option->allowed);
        return 0;
    }
    return set_value(&target, words[1]) ? 2 : 0;
}

static bool set_words(const struct option_table *table, const char *const *words,
                      enum source source, void *values)
{
    while (words != NULL && *words != NULL) {
        const int count = read_option(table, words, source, values);
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
            const struct target target = target_of(group, i, values);
            const char *const standard = target.option->standard;
            if (standard != NULL && !set_value(&target, standard)) {
                return false;
            }
        }
    }
    return set_words(table, table->standard, FROM_TABLE, values);
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
    if (!set_defaults(table, values) || !set_words(table, words, FROM_USER, values)) {
        return OPTIONS_BAD;
    }
    if (table->presets != NULL) {
        /* Wherever it stands on the command line, what else stands there changes the preset. */
        const int preset = *(const int *)((const char *)values + table->preset_offset);
        if (!set_words(table, table->presets[preset], FROM_PRESET, values) ||
            !set_words(table, words, FROM_USER, values)) {
            return OPTIONS_BAD;
        }
    }
    return OPTIONS_RUN;
}
