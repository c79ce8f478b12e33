/* SPDX-License-Identifier: MIT
 *
 * Reads parameters and their values: NAME=VALUES,NAME=VALUES. A comma begins the next parameter
 * only where a name and an equals sign follow, since values may have commas.
 */
#include "sheet/axes.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shared/error.h"
#include "shared/number.h"

#define STANDARD_COUNT 4 /* values of a range of numbers that are not whole */

static const char name_letters[] =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

/* How long the name of a parameter at `text` is; 0 if no equals sign follows. */
static size_t name_length(const char *text)
{
    const size_t length = strspn(text, name_letters);
    return text[length] == '=' ? length : 0;
}

/* Where the values at `text` end: at the next parameter, or at the end */
static size_t values_length(const char *text)
{
    size_t at = 0;
    while (text[at] != '\0' && !(text[at] == ',' && name_length(text + at + 1) > 0)) {
        at++;
    }
    return at;
}

static bool too_many(const struct axis *axis)
{
    cli_error("--sheet: %s has more than %d values", axis->name, CELLS_MAX);
    return false;
}

static bool add_value(struct axis *axis, const char *text, size_t length)
{
    if (axis->count == CELLS_MAX) {
        return too_many(axis);
    }
    if (length == 0 || length >= AXIS_VALUE_SIZE) {
        cli_error("--sheet: a value of %s has not 1 to %d characters", axis->name,
                  AXIS_VALUE_SIZE - 1);
        return false;
    }
    char *const value = axis->values[axis->count++];
    memcpy(value, text, length);
    value[length] = '\0';
    return true;
}

/* Whole numbers from `a` to `b`, up or down, both below 2^64 */
static bool add_integers(struct axis *axis, uint64_t a, uint64_t b)
{
    const uint64_t steps = a < b ? b - a : a - b;
    for (uint64_t i = 0; i <= steps; i++) {
        char text[AXIS_VALUE_SIZE];
        const int length =
            snprintf(text, sizeof text, "%llu", (unsigned long long)(a < b ? a + i : a - i));
        if (!add_value(axis, text, (size_t)length)) {
            return false;
        }
    }
    return true;
}

/* The same for numbers that may be negative, below 2^53 in magnitude */
static bool add_wholes(struct axis *axis, double a, double b)
{
    for (double i = 0.0; i <= fabs(b - a); i++) {
        char text[AXIS_VALUE_SIZE];
        const int length = snprintf(text, sizeof text, "%.0f", (a < b ? a + i : a - i) + 0.0);
        if (!add_value(axis, text, (size_t)length)) {
            return false;
        }
    }
    return true;
}

/* `count` numbers from `a` to `b`, equally far from each other, with six digits: what the label
   tells is what is used. */
static bool add_numbers(struct axis *axis, double a, double b, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char text[AXIS_VALUE_SIZE];
        const double t = count > 1 ? (double)i / (double)(count - 1) : 0.0;
        const int length = snprintf(text, sizeof text, "%.6g", a + (b - a) * t + 0.0);
        if (!add_value(axis, text, (size_t)length)) {
            return false;
        }
    }
    return true;
}

/* Digits only, of a number below 2^64. *end is what follows. */
static bool read_integer(const char *text, uint64_t *number, const char **end)
{
    const size_t length = strspn(text, "0123456789");
    *end = text + length;
    errno = 0;
    *number = length > 0 ? strtoull(text, NULL, 10) : 0;
    return length > 0 && errno == 0;
}

/* The number from `text` to `stop`, and nothing else */
static bool read_end(const char *text, const char *stop, double *number)
{
    char copy[AXIS_VALUE_SIZE];
    const size_t length = (size_t)(stop - text);
    if (length == 0 || length >= sizeof copy) {
        return false;
    }
    memcpy(copy, text, length);
    copy[length] = '\0';
    const char *const end = number_read(copy, number);
    return end != NULL && *end == '\0' && isfinite(*number);
}

static bool is_whole(double number)
{
    return floor(number) == number && fabs(number) < 0x1p53;
}

static bool range_error(const struct axis *axis, const char *text)
{
    cli_error("--sheet: '%.60s' of %s is not A..B or A..B/N, with numbers A and B and N from 2 to "
              "%d values",
              text, axis->name, CELLS_MAX);
    return false;
}

/* A..B or A..B/N; `dots` are the two dots. */
static bool add_range(struct axis *axis, const char *text, const char *dots)
{
    const char *const slash = dots + strcspn(dots, "/");
    const char *rest;
    uint64_t first, last, count = STANDARD_COUNT;
    double a, b;
    if (!read_end(text, dots, &a) || !read_end(dots + 2, slash, &b)) {
        return range_error(axis, text);
    }
    if (*slash == '/') {
        if (!read_integer(slash + 1, &count, &rest) || *rest != '\0' || count < 2 ||
            count > CELLS_MAX) {
            return range_error(axis, text);
        }
        return add_numbers(axis, a, b, (size_t)count);
    }
    /* Seeds have more digits than doubles. */
    if (read_integer(text, &first, &rest) && rest == dots && read_integer(dots + 2, &last, &rest) &&
        rest == slash) {
        return add_integers(axis, first, last);
    }
    if (is_whole(a) && is_whole(b)) {
        return add_wholes(axis, a, b);
    }
    return add_numbers(axis, a, b, STANDARD_COUNT);
}

/* V|V|V, or a range */
static bool add_values(struct axis *axis, const char *text)
{
    const char *const dots = strstr(text, "..");
    const bool starts_as_number = strchr("+-.0123456789", text[0]) != NULL;
    if (dots != NULL && starts_as_number && strchr(text, '|') == NULL &&
        strchr(text, ',') == NULL && strncmp(text, "../", 3) != 0) {
        return add_range(axis, text, dots);
    }
    for (;;) {
        const size_t length = strcspn(text, "|");
        if (!add_value(axis, text, length)) {
            return false;
        }
        if (text[length] == '\0') {
            return true;
        }
        text += length + 1;
    }
}

static bool add_axis(struct axes *axes, const char *text, size_t name, size_t length)
{
    struct axis *const axis = &axes->list[axes->count++];
    char values[CELLS_MAX * AXIS_VALUE_SIZE];
    axis->count = 0;
    memcpy(axis->name, text, name);
    axis->name[name] = '\0';
    for (size_t i = 0; i + 1 < axes->count; i++) {
        if (strcmp(axes->list[i].name, axis->name) == 0) {
            cli_error("--sheet: %s is there twice", axis->name);
            return false;
        }
    }
    if (length >= sizeof values) {
        return too_many(axis);
    }
    memcpy(values, text + name + 1, length);
    values[length] = '\0';
    return add_values(axis, values);
}

bool axes_parse(const char *text, struct axes *axes)
{
    axes->count = 0;
    for (;;) {
        const size_t name = name_length(text);
        if (name == 0 || name >= AXIS_NAME_SIZE - 2) {
            cli_error("--sheet: '%.60s' is not NAME=VALUES or NAME=VALUES,NAME=VALUES", text);
            return false;
        }
        if (axes->count == AXES_MAX) {
            cli_error("--sheet: has more than %d parameters", AXES_MAX);
            return false;
        }
        const size_t length = values_length(text + name + 1);
        if (!add_axis(axes, text, name, length)) {
            return false;
        }
        text += name + 1 + length;
        if (*text == '\0') {
            break;
        }
        text++; /* the comma */
    }
    const size_t rows = axes->count > 1 ? axes->list[1].count : 1;
    if (axes->list[0].count * rows > CELLS_MAX) {
        cli_error("--sheet: %zu times %zu panels are more than %d", axes->list[0].count, rows,
                  CELLS_MAX);
        return false;
    }
    return true;
}
