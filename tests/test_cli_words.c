/* SPDX-License-Identifier: MIT
 *
 * The words that the program's help and messages spell out (src/cli) are the library's, all of
 * them, in its order; and its options take each of them for its enumerator.
 */
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

static void append(char *text, size_t size, const char *words)
{
    const size_t length = strlen(text);
    snprintf(text + length, size - length, "%s", words);
}

/* "a, b or c": what `name` gives from `first` on */
static void write_list(char *text, size_t size, const char *(*name)(int), int first)
{
    text[0] = '\0';
    for (int i = first; name(i) != NULL; i++) {
        append(text, size, i == first ? "" : name(i + 1) == NULL ? " or " : ", ");
        append(text, size, name(i));
    }
}

/* A help with spaces where its lines break. */
static void write_line(char *line, size_t size, const char *help)
{
    snprintf(line, size, "%s", help);
    for (char *at = line; (at = strchr(at, '\n')) != NULL;) {
        *at = ' ';
    }
}

static void check_option(const char *option_name, const char *(*name)(int))
{
    char list[256], help[256] = ": ", line[512];
    write_list(list, sizeof list, name, 0);
    append(help, sizeof help, list);
    for (size_t i = 0; i < NOISE_OPTION_COUNT; i++) {
        const struct option *const option = &noise_option_rows[i];
        if (strcmp(option->name, option_name) != 0) {
            continue;
        }
        CHECK(strcmp(option->allowed, list) == 0, "%s is %s, not %s", option_name, option->allowed,
              list);
        write_line(line, sizeof line, option->help);
        CHECK(strlen(line) > strlen(help) && strcmp(line + strlen(line) - strlen(help), help) == 0,
              "the help of %s does not end in%s", option_name, help);
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

int main(void)
{
    char isas[256];
    check_option("--basis", basis_name);
    check_option("--fade", fade_name);
    check_option("--fractal", fractal_name);
    write_list(isas, sizeof isas, isa_name, SCARP_ISA_NONE + 1);
    CHECK(strcmp(OPTION_ISAS, isas) == 0, "instruction sets are %s, not %s", OPTION_ISAS, isas);
    return check_done();
}
