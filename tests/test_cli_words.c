/* SPDX-License-Identifier: MIT
 *
 * The program's options (src/cli) take each of the library's words for its enumerator, messages
 * name them all, and bounds read as people write them.
 */
#include <math.h>
#include <stdarg.h>

#include "check.h"
#include "shared/error.h"
#include "shared/noise.h"

/* Replaces the program's function; no test here leads to a message. */
void cli_error(const char *format, ...)
{
    (void)format;
    CHECK(0, "a message was written");
}

static void check_words(const char *name, const struct option *option, const char *allowed,
                        const char *bounds)
{
    char text[OPTION_WORDS];
    const char *const takes = option_allowed(option, text);
    CHECK(strcmp(takes, allowed) == 0, "%s takes %s, not %s", name, takes, allowed);
    const char *const help = option_bounds(option, text);
    CHECK(strcmp(help, bounds) == 0, "%s: the help ends in '%s', not '%s'", name, help, bounds);
}

/* The words of `name` are all that the option takes, in their order. */
static void check_choice(const char *option_name, const char *(*name)(int))
{
    char list[OPTION_WORDS] = "", bounds[OPTION_WORDS + 2];
    for (int i = 0; name(i) != NULL; i++) {
        const size_t length = strlen(list);
        snprintf(list + length, sizeof list - length, "%s%s",
                 i == 0                ? ""
                 : name(i + 1) == NULL ? " or "
                                       : ", ",
                 name(i));
    }
    snprintf(bounds, sizeof bounds, ": %s", list);
    for (size_t i = 0; i < NOISE_OPTION_COUNT; i++) {
        const struct option *const option = &noise_option_rows[i];
        if (strcmp(option->name, option_name) != 0) {
            continue;
        }
        check_words(option_name, option, list, bounds);
        CHECK(strcmp(option->standard, name(0)) == 0, "%s: the default is not 0", option_name);
        for (int word = 0; name(word) != NULL; word++) {
            int value = -1;
            CHECK(option->parse(option, name(word), &value) == OPTION_VALID && value == word,
                  "%s %s is %d", option_name, name(word), value);
        }
        return;
    }
    CHECK(0, "there is no option %s", option_name);
}

/* In the order of the option's words */
static const char *set_name(int index)
{
    return isa_name(SCARP_ISA_NONE + 1 + index);
}

static void check_sets(void)
{
    for (int i = 0; set_name(i) != NULL || option_isa_word(i) != NULL; i++) {
        const char *const ours = set_name(i), *const word = option_isa_word(i);
        CHECK(ours != NULL && word != NULL && strcmp(ours, word) == 0, "set %d is %s, not %s", i,
              word, ours);
    }
}

static void check_bounds(void)
{
    static const struct {
        option_parse_fn *parse;
        double lowest, highest;
        const char *allowed, *help;
    } cases[] = {
        {option_float, 0, 0x1p24, "a number from 0 to 2^24", "; from 0 to 2^24"},
        {option_double, -0x1p53, 0.0625, "a number from -2^53 to 1/16", "; from -2^53 to 1/16"},
        {option_double, 0x1p-5, 16384, "a number from 2^-5 to 16384", "; from 2^-5 to 16384"},
        {option_float, 0.25, 0.3, "a number from 1/4 to 0.3", "; from 1/4 to 0.3"},
        {option_positive, 0, 32, "a number above 2^-150, at most 32", "; above 2^-150, at most 32"},
        {option_magnitude, 0x1p-24, 0x1p24, "a number whose magnitude is from 2^-24 to 2^24",
         "; its magnitude is from 2^-24 to 2^24"},
        {option_count, 1, 1024, "an integer from 1 to 1024", "; from 1 to 1024"},
        {option_size, 1, 1e6, "WIDTHxHEIGHT with both from 1 to 1000000",
         "; both from 1 to 1000000"},
        {option_point, -32768, 3, "two numbers X,Y from -2^15 to 3", "; each from -2^15 to 3"},
        {option_text, 0, 0, "", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct option option = {
            .parse = cases[i].parse, .lowest = cases[i].lowest, .highest = cases[i].highest};
        check_words(cases[i].allowed, &option, cases[i].allowed, cases[i].help);
    }
    const struct option own = {.parse = option_float, .allowed = "0 or more", .highest = 1};
    check_words("words of its own", &own, "0 or more", "");
}

int main(void)
{
    check_choice("--basis", basis_name);
    check_choice("--fade", fade_name);
    check_choice("--fractal", fractal_name);
    check_sets();
    check_bounds();
    return check_done();
}
