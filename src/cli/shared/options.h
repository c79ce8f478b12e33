/* SPDX-License-Identifier: MIT
 *
 * Command-line options from a table: a row for each option states its name, its default, its
 * bounds and where the value goes. Parsing, messages and the help are made from it, so they cannot
 * disagree.
 */
#ifndef SCARP_CLI_OPTIONS_H
#define SCARP_CLI_OPTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "shared/text.h"

struct option;

enum option_result {
    OPTION_VALID,
    OPTION_INVALID,    /* the text "is not <allowed>" */
    OPTION_UNAVAILABLE /* a valid value, but "cannot run here" */
};

/* Reads `text` into the field at `field`, as the option's row says. */
typedef enum option_result option_parse_fn(const struct option *option, const char *text,
                                           void *field);

struct option {
    const char *name;       /* with its dashes */
    const char *argument;   /* what the help calls the value; NULL: a flag without value */
    const char *standard;   /* the default, as it would be typed; NULL: leave the field as it is */
    const char *otherwise;  /* in the help in place of a default, where `standard` is NULL */
    const char *allowed;    /* completes the message "--name: 'text' is not ..."; NULL: the words
                               of options_words.c, which the help then has, too */
    const char *help;       /* meaning and unit, in one line */
    option_parse_fn *parse; /* NULL for a flag, which sets an int to 1 */
    size_t offset;          /* of the field in the structure that receives the values */
    double lowest, highest; /* the interval of numbers, bounds included */
    const char *(*choice)(int); /* the words for 0, 1, ..., NULL past the last */
    int of_run; /* it concerns this run or the names of files, not what files hold */
};

/* Rows, for braces: {OPTION_FLOAT("--gain", gain, "0.5", 0.0625, 16, "..."), .of_run = 1}. The
   file defines FIELD(member), the offset of a member. */
#define OPTION_ROW(kind, value, title, member, default_, explanation)                              \
    .name = title, .argument = value, .standard = default_, .help = explanation, .parse = kind,    \
    .offset = FIELD(member)
#define OPTION_BETWEEN(kind, value, title, member, default_, least, most, explanation)             \
    OPTION_ROW(kind, value, title, member, default_, explanation), .lowest = least, .highest = most
#define OPTION_FLOAT(...) OPTION_BETWEEN(option_float, "F", __VA_ARGS__)
#define OPTION_DOUBLE(...) OPTION_BETWEEN(option_double, "F", __VA_ARGS__)
#define OPTION_MAGNITUDE(...) OPTION_BETWEEN(option_magnitude, "F", __VA_ARGS__)
#define OPTION_COUNT(...) OPTION_BETWEEN(option_count, "N", __VA_ARGS__)
#define OPTION_SIZE(...) OPTION_BETWEEN(option_size, "WxH", __VA_ARGS__)
#define OPTION_POINT(...) OPTION_BETWEEN(option_point, "X,Y", __VA_ARGS__)
#define OPTION_POSITIVE(...) OPTION_BETWEEN(option_positive, "F", __VA_ARGS__)
#define OPTION_CHOICE(title, member, default_, words, explanation)                                 \
    OPTION_ROW(option_choice, "NAME", title, member, default_, explanation), .choice = words
#define OPTION_ISA(member)                                                                         \
    OPTION_ROW(option_isa, "NAME", "--isa", member, NULL,                                          \
               "instruction set, which changes no result"),                                        \
        .otherwise = "the best one", .choice = option_isa_word
#define OPTION_FLAG(title, member, explanation)                                                    \
    .name = title, .help = explanation, .offset = FIELD(member)
#define OPTION_READ(kind, value, title, member, takes, explanation)                                \
    .name = title, .argument = value, .allowed = takes, .help = explanation, .parse = kind,        \
    .offset = FIELD(member)
#define OPTION_TEXT(title, member, value, takes, explanation)                                      \
    OPTION_READ(option_text, value, title, member, takes, explanation)
#define OPTION_FILE(title, member, explanation)                                                    \
    OPTION_TEXT(title, member, "FILE", "a file name, whose extension says which format",           \
                explanation)

/* Options that a structure holds, itself part of what receives the values */
struct option_group {
    const char *title; /* in the help; NULL: that of the group before */
    const struct option *options;
    size_t count;
    size_t offset; /* of the structure */
    size_t typed; /* offset of a uint32_t in the values, of which bit i is set if row i is typed; 0:
                     nobody wants to know */
};

#define OPTION_GROUP(name, rows, at) OPTION_GROUP_TYPED(name, rows, at, 0)
#define OPTION_GROUP_TYPED(name, rows, at, bits)                                                   \
    {                                                                                              \
        .title = name, .options = rows, .count = sizeof(rows) / sizeof(rows)[0], .offset = at,     \
        .typed = bits                                                                              \
    }

/* Options as they would be typed, one word each and NULL at the end: names, each followed by its
   value unless it is a flag */
typedef const char *const option_words[];

/* Options that earlier versions had */
struct option_removed {
    const char *name;   /* with its dashes; those that begin like it are meant, too */
    const char *advice; /* what to write in its place */
};

struct option_table {
    const char *command;
    const char *operand;  /* what comes before the options; NULL: nothing */
    const char *purpose;  /* the help: before the options */
    const char *notes[3]; /* the help: after the options. C compilers need not take more than 4,095
                             characters in one text. NULL: nothing */
    const struct option_group *groups;
    size_t count;
    const char *const *standard;          /* defaults in place of those of the rows; NULL: none */
    const struct option_removed *removed; /* ends with a NULL name; NULL: none */
};

struct option_size {
    size_t width, height;
};

#define OPTION_LIST_MOST 64
struct option_list {
    const char *texts[OPTION_LIST_MOST];
    size_t count;
};

struct option_point {
    double x, y;
};

struct option_share {
    size_t index, count; /* index < count; all of it: count 0 */
};

struct option_range {
    size_t x0, x1, y0, y1; /* x0 <= x < x1, y0 <= y < y1 */
};

option_parse_fn option_choice;    /* int: the number of the word of `choice` */
option_parse_fn option_count;     /* size_t in [lowest, highest] */
option_parse_fn option_double;    /* double in [lowest, highest] */
option_parse_fn option_epsg;      /* unsigned: N of "EPSG:N" in [lowest, highest], of no degrees */
option_parse_fn option_float;     /* float in [lowest, highest]; the bounds are floats */
option_parse_fn option_isa;       /* int: an enum scarp_isa that can run here */
option_parse_fn option_list;      /* struct option_list: texts, one each time the option is typed,
                                     `highest` times at most */
option_parse_fn option_magnitude; /* float, its magnitude in [lowest, highest], which are floats */
option_parse_fn option_periods;   /* uint32_t[3], "X,Y" or "X,Y,Z", all in [lowest, highest] */
option_parse_fn option_point;     /* struct option_point, "X,Y", both in [lowest, highest] */
option_parse_fn option_positive;  /* float in ]0, highest], as a float */
option_parse_fn option_range;     /* struct option_range, "X0:X1,Y0:Y1", all in [lowest, highest] */
option_parse_fn option_seed;      /* uint64_t */
option_parse_fn option_share;     /* struct option_share, "I/N", both in [lowest, highest] */
option_parse_fn option_size;      /* struct option_size, "WxH", both in [lowest, highest] */
option_parse_fn option_stem;      /* const char *: the beginning of file names */
option_parse_fn option_text;      /* const char *: anything but nothing */

enum options_outcome {
    OPTIONS_RUN,
    OPTIONS_HELP, /* the help was asked for and printed */
    OPTIONS_BAD   /* one line on stderr says why */
};

/* The words of option_isa */
const char *option_isa_word(int index);

#define OPTION_WORDS 256 /* room for what these write */

/* Writes what the option takes: "a number from 0 to 1", "up or down". Returns `text`, or the row's
   own words. */
const char *option_allowed(const struct option *option, char text[OPTION_WORDS]);

/* Writes what follows the option's help: "; from 0 to 1", ": up or down", or nothing. */
const char *option_bounds(const struct option *option, char text[OPTION_WORDS]);

/* The option `name`, with its dashes, of the groups from number `first` to the one before `end`.
   Sets *field to where its value goes in `values`. NULL if there is none. */
const struct option *options_find(const struct option_table *table, size_t first, size_t end,
                                  const char *name, void *values, void **field);

/* Fills `values` with the defaults, then with what `argv` holds, which ends with NULL. Of options
   that come again the last one counts, but texts, such as files, may be given once only. */
enum options_outcome options_parse(const struct option_table *table, char **argv, void *values);

/* Adds "name": value, a line each, as members of an object of JSON: all options but those of the
   run, in the order of the table. Numbers are the shortest that read back the same; what is
   infinite is null. */
void options_describe(const struct option_table *table, const void *values, struct text *text);

#endif
