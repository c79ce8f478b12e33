/* SPDX-License-Identifier: MIT
 *
 * Uses strtod and snprintf in the C locale, which the program never leaves.
 */
#include "shared/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const char *number_read(const char *text, double *value)
{
    const char *const digits = *text == '-' || *text == '+' ? text + 1 : text;
    const int hexadecimal = digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X');
    if (hexadecimal || ((*digits < '0' || *digits > '9') && *digits != '.')) {
        return NULL;
    }
    char *end;
    *value = strtod(text, &end);
    return end != text ? end : NULL;
}

static char *write_number(char *to, int digits, double value)
{
    if (isnan(value)) {
        return to + snprintf(to, NUMBER_SIZE, "nan");
    }
    return to + snprintf(to, NUMBER_SIZE, "%.*g", digits, value);
}

char *number_write_float(char *to, float value)
{
    return write_number(to, 9, (double)value);
}

char *number_write_double(char *to, double value)
{
    return write_number(to, 17, value);
}

char *number_write_shortest(char *to, double value, int is_float)
{
    int length = 0;
    double again = NAN;
    for (int digits = 6; digits <= 17 && again != value; digits++) {
        length = snprintf(to, NUMBER_SIZE, "%.*g", digits, value);
        again = is_float ? (double)strtof(to, NULL) : strtod(to, NULL);
    }
    return to + length;
}
