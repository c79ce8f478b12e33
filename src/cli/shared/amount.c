/* SPDX-License-Identifier: MIT
 *
 * A unit is taken as soon as the number, as it is rounded, reaches 1 there.
 */
#include "shared/amount.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *amount_count(char text[AMOUNT_SIZE], double count)
{
    static const char *const units[] = {"thousand", "million", "billion", "trillion"};
    if (count < 999.5) {
        snprintf(text, AMOUNT_SIZE, floor(count) == count ? "%.0f " : "%.3g ", count);
        return text;
    }
    size_t unit = 0;
    for (count *= 1e-3; count >= 999.95 && unit < 3; unit++) {
        count *= 1e-3;
    }
    snprintf(text, AMOUNT_SIZE, "%.1f %s ", count, units[unit]);
    return text;
}

static void write_bytes(char text[AMOUNT_SIZE], uint64_t bytes)
{
    snprintf(text, AMOUNT_SIZE, "%llu byte%s", (unsigned long long)bytes, bytes == 1 ? "" : "s");
}

const char *amount_bytes(char text[AMOUNT_SIZE], uint64_t bytes)
{
    static const char *const units[] = {"kB", "MB", "GB", "TB", "PB", "EB"};
    if (bytes < 1000) {
        write_bytes(text, bytes);
        return text;
    }
    double amount = (double)bytes * 1e-3;
    size_t unit = 0;
    for (; amount >= 999.995 && unit < 5; unit++) {
        amount *= 1e-3;
    }
    snprintf(text, AMOUNT_SIZE, "%.2f %s", amount, units[unit]);
    return text;
}

void amount_bytes_two(char one[AMOUNT_SIZE], uint64_t bytes, char other[AMOUNT_SIZE],
                      uint64_t other_bytes)
{
    if (strcmp(amount_bytes(one, bytes), amount_bytes(other, other_bytes)) == 0) {
        write_bytes(one, bytes);
        write_bytes(other, other_bytes);
    }
}

const char *amount_seconds(char text[AMOUNT_SIZE], double seconds)
{
    if (seconds >= 0.99995) {
        snprintf(text, AMOUNT_SIZE, "%.3f s", seconds);
    } else if (seconds >= 0.99995e-3) {
        snprintf(text, AMOUNT_SIZE, "%.1f ms", seconds * 1e3);
    } else {
        snprintf(text, AMOUNT_SIZE, "%.1f us", seconds * 1e6);
    }
    return text;
}
