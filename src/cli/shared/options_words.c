/* SPDX-License-Identifier: MIT
 *
 * What an option takes, in words, from its kind and its bounds.
 */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "shared/options.h"

/* How messages and the help speak of numbers that lie in an interval */
static const struct kind {
    option_parse_fn *parse;
    const char *what, *help; /* "a number" and "from 0 to 1", after a semicolon in the help */
} kinds[] = {
    {option_float, "a number ", "; "},
    {option_double, "a number ", "; "},
    {option_positive, "a number ", "; "},
    {option_magnitude, "a number whose magnitude is ", "; its magnitude is "},
    {option_count, "an integer ", "; "},
    {option_size, "WIDTHxHEIGHT with both ", "; both "},
    {option_point, "two numbers X,Y ", "; each "},
};

static void add(char text[OPTION_WORDS], const char *format, ...)
{
    const size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text + length, OPTION_WORDS - length, format, arguments);
    va_end(arguments);
}

/* 2^24, 1/16, 1024: as people write it */
static void add_number(char text[OPTION_WORDS], double number)
{
    int exponent;
    const bool is_power = frexp(fabs(number), &exponent) == 0.5;
    if (is_power && (exponent > 15 || exponent < -3)) {
        add(text, "%s2^%d", number < 0 ? "-" : "", exponent - 1);
    } else if (is_power && exponent < 1) {
        add(text, "%s1/%g", number < 0 ? "-" : "", 1 / fabs(number));
    } else {
        add(text, "%.15g", number);
    }
}

static void add_choices(char text[OPTION_WORDS], const struct option *option)
{
    for (int i = 0; option->choice(i) != NULL; i++) {
        add(text, "%s%s",
            i == 0                          ? ""
            : option->choice(i + 1) == NULL ? " or "
                                            : ", ",
            option->choice(i));
    }
}

static void add_interval(char text[OPTION_WORDS], const struct option *option)
{
    if (option->parse == option_positive) {
        add(text, "above 2^-150, at most "); /* what is less is 0 as a float */
    } else {
        add(text, "from ");
        add_number(text, option->lowest);
        add(text, " to ");
    }
    add_number(text, option->highest);
}

/* NULL: the option has no interval, or words of its own */
static const struct kind *kind_of(const struct option *option)
{
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0] && option->allowed == NULL; i++) {
        if (kinds[i].parse == option->parse) {
            return &kinds[i];
        }
    }
    return NULL;
}

static const char *describe(const struct option *option, bool is_help, char text[OPTION_WORDS])
{
    const struct kind *const kind = kind_of(option);
    text[0] = '\0';
    if (kind != NULL) {
        add(text, "%s", is_help ? kind->help : kind->what);
        add_interval(text, option);
    } else if (option->choice != NULL) {
        add(text, "%s", is_help ? ": " : "");
        add_choices(text, option);
    }
    return text;
}

const char *option_allowed(const struct option *option, char text[OPTION_WORDS])
{
    return option->allowed != NULL ? option->allowed : describe(option, false, text);
}

const char *option_bounds(const struct option *option, char text[OPTION_WORDS])
{
    return describe(option, true, text);
}
