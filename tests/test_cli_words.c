/* SPDX-License-Identifier: MIT
 *
 * The program's options (src/cli) take each of the library's words for its enumerator, messages
 * name them all, bounds read as people write them, and so do amounts.
 */
#include <math.h>
#include <stdarg.h>

#include "check.h"
#include "shared/amount.h"
#include "shared/error.h"
#include "shared/noise_options.h"

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

static void check_text(const char *text, const char *expected)
{
    CHECK(strcmp(text, expected) == 0, "'%s' instead of '%s'", text, expected);
}

/* On both sides of each change of the unit */
static void check_amounts(void)
{
    static const struct {
        double count;
        const char *text;
    } counts[] = {{0, "0 "},
                  {0.25, "0.25 "},
                  {999, "999 "},
                  {999.4, "999 "},
                  {999.5, "1.0 thousand "},
                  {999949, "999.9 thousand "},
                  {999951, "1.0 million "},
                  {12345678, "12.3 million "},
                  {999.96e6, "1.0 billion "},
                  {4e15, "4000.0 trillion "}};
    static const struct {
        uint64_t bytes;
        const char *text;
    } bytes[] = {{0, "0 bytes"},
                 {1, "1 byte"},
                 {999, "999 bytes"},
                 {1000, "1.00 kB"},
                 {999994, "999.99 kB"},
                 {999996, "1.00 MB"},
                 {17180000000, "17.18 GB"},
                 {UINT64_MAX, "18.45 EB"}};
    static const struct {
        double seconds;
        const char *text;
    } times[] = {{0, "0.0 us"},          {41e-6, "41.0 us"},    {0.99994e-3, "999.9 us"},
                 {0.99996e-3, "1.0 ms"}, {0.99994, "999.9 ms"}, {0.99996, "1.000 s"},
                 {5400, "5400.000 s"}};
    char text[AMOUNT_SIZE], other[AMOUNT_SIZE];
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        check_text(amount_count(text, counts[i].count), counts[i].text);
    }
    for (size_t i = 0; i < sizeof bytes / sizeof bytes[0]; i++) {
        check_text(amount_bytes(text, bytes[i].bytes), bytes[i].text);
    }
    for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
        check_text(amount_seconds(text, times[i].seconds), times[i].text);
    }
    amount_bytes_two(text, 4000000, other, 3000000);
    check_text(text, "4.00 MB");
    check_text(other, "3.00 MB");
    amount_bytes_two(text, 4000001, other, 4000000);
    check_text(text, "4000001 bytes");
    check_text(other, "4000000 bytes");
}

int main(void)
{
    check_choice("--basis", basis_name);
    check_choice("--fade", fade_name);
    check_choice("--fractal", fractal_name);
    check_sets();
    check_bounds();
    check_amounts();
    return check_done();
}
