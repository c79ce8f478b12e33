/* SPDX-License-Identifier: MIT
 *
 * How each kind of option value is read: the whole text or nothing. Numbers are read in the C
 * locale, which the program never leaves.
 */
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "scarp.h"
#include "shared/bounds.h"
#include "shared/number.h"
#include "shared/options.h"

/* A number of [lowest, highest] at the start of `text`; *end is what follows it. */
static bool read_number(const struct option *option, const char *text, double *value,
                        const char **end)
{
    *end = number_read(text, value);
    return *end != NULL && *value >= option->lowest && *value <= option->highest;
}

enum option_result option_double(const struct option *option, const char *text, void *field)
{
    const char *end;
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

enum option_result option_magnitude(const struct option *option, const char *text, void *field)
{
    struct option either_sign = *option;
    either_sign.lowest = -option->highest;
    double value;
    if (option_double(&either_sign, text, &value) != OPTION_VALID || fabs(value) < option->lowest) {
        return OPTION_INVALID;
    }
    *(float *)field = (float)value;
    return OPTION_VALID;
}

enum option_result option_positive(const struct option *option, const char *text, void *field)
{
    float value;
    if (option_float(option, text, &value) != OPTION_VALID || value == 0.0f) {
        return OPTION_INVALID;
    }
    *(float *)field = value;
    return OPTION_VALID;
}

enum option_result option_point(const struct option *option, const char *text, void *field)
{
    const char *end;
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

enum option_result option_periods(const struct option *option, const char *text, void *field)
{
    char *end;
    uint32_t periods[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        size_t count;
        if (!read_count(option, text, &count, &end)) {
            return OPTION_INVALID;
        }
        periods[i] = (uint32_t)count;
        if (*end == '\0' && i > 0) {
            memcpy(field, periods, sizeof periods);
            return OPTION_VALID;
        }
        if (*end != ',') {
            return OPTION_INVALID;
        }
        text = end + 1;
    }
    return OPTION_INVALID;
}

enum option_result option_range(const struct option *option, const char *text, void *field)
{
    char *end;
    struct option_range range;
    if (!read_count(option, text, &range.x0, &end) || *end != ':' ||
        !read_count(option, end + 1, &range.x1, &end) || *end != ',' ||
        !read_count(option, end + 1, &range.y0, &end) || *end != ':' ||
        !read_count(option, end + 1, &range.y1, &end) || *end != '\0' || range.x0 >= range.x1 ||
        range.y0 >= range.y1) {
        return OPTION_INVALID;
    }
    *(struct option_range *)field = range;
    return OPTION_VALID;
}

enum option_result option_share(const struct option *option, const char *text, void *field)
{
    char *end;
    struct option_share share;
    if (!read_count(option, text, &share.index, &end) || *end != '/' ||
        !read_count(option, end + 1, &share.count, &end) || *end != '\0' ||
        share.index >= share.count) {
        return OPTION_INVALID;
    }
    *(struct option_share *)field = share;
    return OPTION_VALID;
}

enum option_result option_seed(const struct option *option, const char *text, void *field)
{
    (void)option;
    const bool hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const bool negative = text[0] == '-';
    const char *const digits = hexadecimal ? text + 2 : text + negative;
    const char *const alphabet = hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
    if (*digits == '\0' || digits[strspn(digits, alphabet)] != '\0') {
        return OPTION_INVALID;
    }
    errno = 0;
    const unsigned long long seed = strtoull(digits, NULL, hexadecimal ? 16 : 10);
    if (errno != 0 || seed > UINT64_MAX || (negative && seed > UINT64_C(1) << 63)) {
        return OPTION_INVALID;
    }
    *(uint64_t *)field = negative ? 0 - (uint64_t)seed : (uint64_t)seed;
    return OPTION_VALID;
}

/* Systems whose coordinates are degrees, as far as people ask for them by mistake */
static bool is_of_degrees(size_t number)
{
    static const size_t known[] = {4230, 4258, 4267, 4269, 4277, 4283, 4289, 4312, 4313,
                                   4314, 4322, 4326, 4490, 4612, 4617, 4674, 4937, 4978,
                                   4979, 6318, 6668, 6706, 7789, 7844, 9057, 9754};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (known[i] == number) {
            return true;
        }
    }
    return false;
}

enum option_result option_epsg(const struct option *option, const char *text, void *field)
{
    char *end;
    size_t number;
    const bool is_prefixed = strncmp(text, "EPSG:", 5) == 0 || strncmp(text, "epsg:", 5) == 0;
    if (!is_prefixed || !read_count(option, text + 5, &number, &end) || *end != '\0' ||
        is_of_degrees(number)) {
        return OPTION_INVALID;
    }
    *(unsigned *)field = (unsigned)number;
    return OPTION_VALID;
}

enum option_result option_choice(const struct option *option, const char *text, void *field)
{
    for (int i = 0; option->choice(i) != NULL; i++) {
        if (strcmp(text, option->choice(i)) == 0) {
            *(int *)field = i;
            return OPTION_VALID;
        }
    }
    return OPTION_INVALID;
}

const char *option_isa_word(int index)
{
    return scarp_isa_name((enum scarp_isa)(SCARP_ISA_NONE + 1 + index));
}

enum option_result option_isa(const struct option *option, const char *text, void *field)
{
    (void)option;
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        if (strcmp(text, scarp_isa_name(isa)) == 0) {
            *(int *)field = (int)isa;
            return scarp_isa_supported(isa) ? OPTION_VALID : OPTION_UNAVAILABLE;
        }
    }
    return OPTION_INVALID;
}

enum option_result option_stem(const struct option *option, const char *text, void *field)
{
    (void)option;
    const size_t length = strlen(text);
    if (length == 0 || strcmp(text, "-") == 0 || text[length - 1] == '/' ||
        text[length - 1] == '\\') {
        return OPTION_INVALID;
    }
    *(const char **)field = text;
    return OPTION_VALID;
}

enum option_result option_text(const struct option *option, const char *text, void *field)
{
    (void)option;
    if (*text == '\0') {
        return OPTION_INVALID;
    }
    *(const char **)field = text;
    return OPTION_VALID;
}

enum option_result option_list(const struct option *option, const char *text, void *field)
{
    struct option_list *const list = field;
    if ((double)list->count >= option->highest) {
        return OPTION_INVALID;
    }
    const enum option_result result = option_text(option, text, &list->texts[list->count]);
    list->count += result == OPTION_VALID ? 1 : 0;
    return result;
}
