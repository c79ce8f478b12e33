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
#define HELP_WIDTH 84
#define HELP_LENGTH 1024 /* of an option's explanation */

/* Writes words from column `column` on, in lines that begin there, and ends the last line. */
static void print_words(const char *text, int column)
{
    for (int at = column; *text != '\0';) {
        const int length = (int)strcspn(text, " ");
        if (at > column && at + 1 + length > HELP_WIDTH) {
            printf("\n%*s", column, "");
            at = column;
        }
        at += printf("%s%.*s", at > column ? " " : "", length, text);
        text += length;
        text += strspn(text, " ");
    }
    putchar('\n');
}

/* One option of the help: name and value on the left, the explanation on the right. */
static void print_option(const char *name, const char *argument, const char *help)
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
    print_words(help, HELP_COLUMN);
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

static void print_row(const struct option_table *table, const struct option *option)
{
    char help[HELP_LENGTH], bounds[OPTION_WORDS];
    const char *standard = standard_of(table, option);
    standard = standard != NULL ? standard : option->otherwise;
    (void)snprintf(help, sizeof help, "%s%s%s%s%s", option->help, option_bounds(option, bounds),
                   standard != NULL ? " [" : "", standard != NULL ? standard : "",
                   standard != NULL ? "]" : "");
    print_option(option->name, option->argument, help);
}

static void print_help(const struct option_table *table)
{
    printf("usage: scarp %s%s%s [options]\n\n%s\n", table->command,
           table->operand != NULL ? " " : "", table->operand != NULL ? table->operand : "",
           table->purpose);
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        if (group->title != NULL) {
            printf("\n%s:\n", group->title);
        }
        for (size_t i = 0; i < group->count; i++) {
            print_row(table, &group->options[i]);
        }
    }
    print_option("--help", NULL, "print this");
    const size_t most = sizeof table->notes / sizeof table->notes[0];
    for (size_t i = 0; i < most && table->notes[i] != NULL; i++) {
        printf("%s%s", i == 0 ? "\n" : "", table->notes[i]);
    }
    if (table->notes[0] != NULL) {
        printf("\n");
    }
}

/* An option, and the field that its value goes to */
struct target {
    const struct option *option; /* NULL: there is no such option */
    void *field;
    size_t number;   /* in the table, counted through the groups */
    uint32_t *typed; /* NULL: nobody wants to know */
    uint32_t bit;
};

/* Row i of a group */
static struct target target_of(const struct option_group *group, size_t i, void *values)
{
    const struct option *const option = &group->options[i];
    struct target target = {.option = option,
                            .field = (char *)values + group->offset + option->offset};
    if (group->typed != 0) {
        target.typed = (uint32_t *)((char *)values + group->typed);
        target.bit = UINT32_C(1) << i;
    }
    return target;
}

/* The option that `word` names: the whole word, or what is before '='. */
static struct target find_option(const struct option_table *table, const char *word, void *values)
{
    const size_t length = strcspn(word, "=");
    size_t number = 0;
    for (size_t g = 0; g < table->count; g++) {
        const struct option_group *const group = &table->groups[g];
        for (size_t i = 0; i < group->count; i++) {
            struct target target = target_of(group, i, values);
            target.number = number++;
            if (strlen(target.option->name) == length &&
                strncmp(target.option->name, word, length) == 0) {
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
    const char *const name = option->name;
    char words[OPTION_WORDS];
    switch (option->parse(option, text, target->field)) {
    case OPTION_VALID: return true;
    case OPTION_UNAVAILABLE:
        cli_error("%s: '%.60s' cannot run here; see: scarp info", name, text);
        return false;
    default:
        cli_error("%s: '%.60s' is not %s", name, text, option_allowed(option, words));
        return false;
    }
}

#define NAME_MOST 32 /* of names that are compared */

/* How many letters must be changed, added or left out to make `b` of `a`, as V. I. Levenshtein
   counts them (1965). More than NAME_MOST for long names */
static size_t distance(const char *a, size_t length, const char *b)
{
    size_t row[NAME_MOST + 1];
    const size_t width = strlen(b);
    if (length > NAME_MOST || width > NAME_MOST) {
        return NAME_MOST + 1;
    }
    for (size_t i = 0; i <= width; i++) {
        row[i] = i;
    }
    for (size_t n = 0; n < length; n++) {
        size_t corner = row[0]++;
        for (size_t i = 0; i < width; i++) {
            const size_t change = corner + (a[n] != b[i] ? 1 : 0);
            const size_t other = (row[i] < row[i + 1] ? row[i] : row[i + 1]) + 1;
            corner = row[i + 1];
            row[i + 1] = change < other ? change : other;
        }
    }
    return row[width];
}

/* The option that was meant: two letters away at most, or the only one that goes on as the word
   ends. NULL: there is none. */
static const char *nearest_option(const struct option_table *table, const char *word)
{
    const size_t length = strcspn(word, "=");
    const char *nearest = NULL, *longer = NULL;
    size_t least = length > 5 ? 3 : 2, longer_count = 0;
    for (size_t g = 0; g < table->count; g++) {
        for (size_t i = 0; i < table->groups[g].count; i++) {
            const char *const name = table->groups[g].options[i].name;
            const size_t changes = distance(word, length, name);
            if (changes < least) {
                least = changes;
                nearest = name;
            }
            if (length > 3 && strncmp(name, word, length) == 0) {
                longer = name;
                longer_count++;
            }
        }
    }
    return nearest != NULL ? nearest : longer_count == 1 ? longer : NULL;
}

/* Tells that there is no such option, and what does its work. */
static void refuse_name(const struct option_table *table, const char *word)
{
    for (const struct option_removed *r = table->removed; r != NULL && r->name != NULL; r++) {
        if (strncmp(word, r->name, strlen(r->name)) == 0) {
            cli_error("%.60s: is not an option any more: %s", word, r->advice);
            return;
        }
    }
    const char *const nearest = nearest_option(table, word);
    if (nearest != NULL) {
        cli_error("%.60s: unknown option; did you mean %s? See: scarp %s --help", word, nearest,
                  table->command);
    } else {
        cli_error("%.60s: unknown option; see: scarp %s --help", word, table->command);
    }
}

#define OPTIONS_MOST 256 /* of a table */

/* Options that the user typed; NULL where defaults are set */
struct given {
    bool texts[OPTIONS_MOST];
};

/* Notes that an option is typed. False, with a line on stderr, if it may not be typed again: of two
   files of one option the first would be forgotten. */
static bool give(struct given *given, const struct target *target)
{
    option_parse_fn *const parse = target->option->parse;
    const bool is_text = parse == option_text || parse == option_stem;
    if (is_text && target->number < OPTIONS_MOST && given->texts[target->number]) {
        cli_error("%s: is given twice; leave one of them out", target->option->name);
        return false;
    }
    if (target->number < OPTIONS_MOST) {
        given->texts[target->number] = true;
    }
    if (target->typed != NULL) {
        *target->typed |= target->bit;
    }
    return true;
}

/* Reads the option at words[0] and its value. Returns how many words that took, 0 after an error.
   The words end with NULL. */
static int read_option(const struct option_table *table, const char *const *words,
                       struct given *given, void *values)
{
    const char *const word = words[0];
    if (word[0] != '-') {
        cli_error("%.60s: unexpected argument; see: scarp %s --help", word, table->command);
        return 0;
    }
    const struct target target = find_option(table, word, values);
    if (target.option == NULL) {
        refuse_name(table, word);
        return 0;
    }
    const struct option *const option = target.option;
    const char *const joined = strchr(word, '=');
    if (given != NULL && !give(given, &target)) {
        return 0;
    }
    if (option->parse == NULL) {
        if (joined != NULL) {
            cli_error("%s: takes no value", target.option->name);
            return 0;
        }
        *(int *)target.field = 1;
        return 1;
    }
    if (joined != NULL) {
        return set_value(&target, joined + 1) ? 1 : 0;
    }
    if (words[1] == NULL || strncmp(words[1], "--", 2) == 0) {
        char allowed[OPTION_WORDS];
        cli_error("%s: has no value; it takes %s", option->name, option_allowed(option, allowed));
        return 0;
    }
    return set_value(&target, words[1]) ? 2 : 0;
}

static bool set_words(const struct option_table *table, const char *const *words,
                      struct given *given, void *values)
{
    while (words != NULL && *words != NULL) {
        const int count = read_option(table, words, given, values);
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
    return set_words(table, table->standard, NULL, values);
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
    struct given given = {.texts = {false}};
    return set_defaults(table, values) && set_words(table, words, &given, values) ? OPTIONS_RUN
                                                                                  : OPTIONS_BAD;
}
