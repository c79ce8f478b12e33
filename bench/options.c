/* SPDX-License-Identifier: MIT
 *
 * The command line of scarp-bench: one row per option. Help, parsing and messages are made from the
 * table. A value is read whole or not at all.
 */
#include "options.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "scarp.h"

#define HELP_COLUMN 18 /* where the explanations begin */

struct option {
    const char *name, *argument;
    const char *allowed; /* completes the message "--name: 'text' is not ..." */
    const char *help;
    int (*parse)(const struct option *option, const char *text, void *field); /* NULL: a flag */
    size_t offset; /* of the field in struct bench_options */
    double lowest, highest;
};

static void refuse(const struct option *option, const char *text)
{
    bench_error("%s: '%.60s' is not %s", option->name, text, option->allowed);
}

/* strtod also takes leading space, "inf" and "nan"; the first character rules them out. */
static int parse_double(const struct option *option, const char *text, void *field)
{
    char *end;
    const int begins = (text[0] >= '0' && text[0] <= '9') || text[0] == '.';
    const double value = begins ? strtod(text, &end) : 0;
    if (!begins || *end != '\0' || !(value >= option->lowest && value <= option->highest)) {
        refuse(option, text);
        return 0;
    }
    *(double *)field = value;
    return 1;
}

static int parse_count(const struct option *option, const char *text, void *field)
{
    double value;
    if (text[strspn(text, "0123456789")] != '\0') {
        refuse(option, text);
        return 0;
    }
    if (!parse_double(option, text, &value)) {
        return 0;
    }
    *(int *)field = (int)value;
    return 1;
}

static int parse_text(const struct option *option, const char *text, void *field)
{
    if (*text == '\0') {
        refuse(option, text);
        return 0;
    }
    *(const char **)field = text;
    return 1;
}

/* Takes texts between commas, none of them empty. */
static int parse_list(const struct option *option, const char *text, void *field)
{
    const size_t length = strlen(text);
    if (length == 0 || text[0] == ',' || text[length - 1] == ',' || strstr(text, ",,") != NULL) {
        refuse(option, text);
        return 0;
    }
    *(const char **)field = text;
    return 1;
}

int bench_next_part(const char **list, char *part, size_t size)
{
    if (*list == NULL) {
        return 0;
    }
    const size_t length = strcspn(*list, ",");
    snprintf(part, size, "%.*s", (int)length, *list);
    *list = (*list)[length] == ',' ? *list + length + 1 : NULL;
    return 1;
}

/* "an instruction set: " and the names of all; it is written before anything is parsed. */
static char isas_allowed[160];

static void write_isas_allowed(void)
{
    size_t length = 0;
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        length +=
            (size_t)snprintf(isas_allowed + length, sizeof isas_allowed - length, "%s%s",
                             length == 0 ? "an instruction set: " : ", ", scarp_isa_name(isa));
    }
}

static int parse_isas(const struct option *option, const char *text, void *field)
{
    unsigned *const isas = field;
    char part[64];
    *isas = 0;
    while (bench_next_part(&text, part, sizeof part)) {
        enum scarp_isa isa = SCARP_ISA_NONE + 1;
        while (scarp_isa_name(isa) != NULL && strcmp(part, scarp_isa_name(isa)) != 0) {
            isa++;
        }
        if (scarp_isa_name(isa) == NULL) {
            refuse(option, part);
            return 0;
        }
        if (!scarp_isa_supported(isa)) {
            bench_error("%s: '%s' cannot run here", option->name, part);
            return 0;
        }
        *isas |= 1u << isa;
    }
    return 1;
}

/* Takes bytes between commas. */
static int parse_scratch(const struct option *option, const char *text, void *field)
{
    struct bench_options *const options = field;
    char part[64];
    if (!parse_list(option, text, &(const char *){NULL})) {
        return 0;
    }
    options->scratch_count = 0;
    while (bench_next_part(&text, part, sizeof part)) {
        int bytes;
        if (options->scratch_count == BENCH_MOST_SCRATCH) {
            refuse(option, part);
            return 0;
        }
        if (!parse_count(option, part, &bytes)) {
            return 0;
        }
        options->scratch[options->scratch_count++] = (size_t)bytes;
    }
    return 1;
}

#define FIELD(name) offsetof(struct bench_options, name)

static const struct option options_known[] = {
    {"--work", "PATTERN", "a list of workloads",
     "only these workloads: a name, a part of one, or a pattern with\n"
     "* and ?; several between commas",
     parse_list, FIELD(work), 0, 0},
    {"--isa", "LIST", isas_allowed,
     "only these instruction sets, between commas; libraries that do not\n"
     "choose among them count as scalar",
     parse_isas, FIELD(isas), 0, 0},
    {"--peers", NULL, NULL, "measure other libraries, too", NULL, FIELD(peers), 0, 0},
    {"--min-time", "S", "a time of at most 3600 seconds",
     "seconds for which each row is timed, over all repeats [0.2]", parse_double, FIELD(min_time),
     1e-6, 3600},
    {"--repeat", "N", "a count from 1 to 1000", "interleaved repeats of all rows [11]", parse_count,
     FIELD(repeat), 1, 1000},
    {"--scratch", "LIST", "a list of at most 8 counts up to 1073741824",
     "also measure recipes with so many bytes of scratch memory, between\n"
     "commas, besides the size that is best",
     parse_scratch, 0, 0, 1 << 30},
    {"--json", "FILE", "the name of a file", "write the results as JSON; - is standard output",
     parse_text, FIELD(json), 0, 0},
    {"--svg", "FILE", "the name of a file", "write the results as a chart", parse_text, FIELD(svg),
     0, 0},
    {"--markdown", NULL, NULL, "print the results as Markdown tables", NULL, FIELD(markdown), 0, 0},
    {"--from", "FILES", "a list of files",
     "measure nothing: show the results that --json wrote to these files;\n"
     "of rows that several have, the first counts",
     parse_list, FIELD(from), 0, 0},
    {"--list", NULL, NULL, "print the names of the workloads, and measure nothing", NULL,
     FIELD(list), 0, 0},
    {"--quiet", NULL, NULL, "no progress on stderr: what is done, and the time left", NULL,
     FIELD(quiet), 0, 0},
};

#define OPTION_COUNT (sizeof options_known / sizeof options_known[0])

static void print_help(void)
{
    printf("usage: scarp-bench [options]\n\n"
           "How fast scarp is, with each instruction set, and other libraries next to it.\n\n");
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        const struct option *const option = &options_known[i];
        const char *const argument = option->argument != NULL ? option->argument : "";
        int column = printf("  %s %s", option->name, argument);
        if (column >= HELP_COLUMN) {
            putchar('\n');
            column = 0;
        }
        printf("%*s", HELP_COLUMN - column, "");
        for (const char *c = option->help; *c != '\0'; c++) {
            putchar(*c);
            if (*c == '\n') {
                printf("%*s", HELP_COLUMN, "");
            }
        }
        putchar('\n');
    }
    printf("  %-*sprint this\n", HELP_COLUMN - 2, "--help");
    printf(
        "\nExit status: 0 done, 1 failed on the way, 2 bad command line (nothing was written).\n");
}

static const struct option *find_option(const char *word)
{
    const size_t length = strcspn(word, "=");
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        const char *const name = options_known[i].name;
        if (strlen(name) == length && strncmp(name, word, length) == 0) {
            return &options_known[i];
        }
    }
    return NULL;
}

/* Reads the option at argv[0] and its value. Returns how many words that took, 0 after an error. */
static int read_option(struct bench_options *options, int argc, char **argv)
{
    const struct option *const option = find_option(argv[0]);
    if (option == NULL) {
        bench_error("%.60s: unknown option; see: scarp-bench --help", argv[0]);
        return 0;
    }
    void *const field = (char *)options + option->offset;
    const char *const joined = strchr(argv[0], '=');
    if (option->parse == NULL) {
        if (joined != NULL) {
            bench_error("%s: takes no value", option->name);
            return 0;
        }
        *(int *)field = 1;
        return 1;
    }
    if (joined != NULL) {
        return option->parse(option, joined + 1, field) ? 1 : 0;
    }
    if (argc < 2 || strncmp(argv[1], "--", 2) == 0) {
        bench_error("%s: has no value; it takes %s", option->name, option->allowed);
        return 0;
    }
    return option->parse(option, argv[1], field) ? 2 : 0;
}

enum bench_outcome bench_options_parse(struct bench_options *options, int argc, char **argv)
{
    *options = (struct bench_options){.isas = ~0u, .min_time = 0.2, .repeat = 11};
    write_isas_allowed();
    for (int i = 1; i < argc;) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help();
            return BENCH_HELP;
        }
        const int words = read_option(options, argc - i, argv + i);
        if (words == 0) {
            return BENCH_BAD;
        }
        i += words;
    }
    if (options->markdown && options->json != NULL && strcmp(options->json, "-") == 0) {
        bench_error("--json: standard output cannot take both JSON and --markdown");
        return BENCH_BAD;
    }
    if (options->from != NULL && (options->list || options->peers)) {
        bench_error("--from: measures nothing, so %s makes no sense with it",
                    options->list ? "--list" : "--peers");
        return BENCH_BAD;
    }
    return BENCH_RUN;
}
