/* SPDX-License-Identifier: MIT
 *
 * Reads decimal numbers, correctly rounded, whatever the locale is.
 *
 * Numbers of up to 15 digits and small exponents are one exact product or quotient (Clinger 1990).
 * For all others, the quotient of two large integers is computed bit by bit.
 */
#include <stdbool.h>
#include <string.h>

#include "reader.h"

#define DIGITS 40 /* with one for those that are too many, and one that is never filled */
#define MOST 1e60
#define EXPONENT 60 /* of the first digit, at most in magnitude */
#define WORDS 24    /* of 32 bits: 40 digits times 10^100 times 2^60 */

struct integer {
    uint32_t word[WORDS]; /* the lowest first */
};

static void multiply_add(struct integer *n, uint32_t factor, uint32_t add)
{
    uint64_t carry = add;
    for (int i = 0; i < WORDS; i++) {
        carry += (uint64_t)n->word[i] * factor;
        n->word[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static int count_bits(const struct integer *n)
{
    for (int i = WORDS * 32 - 1; i >= 0; i--) {
        if ((n->word[i / 32] >> i % 32 & 1) != 0) {
            return i + 1;
        }
    }
    return 0;
}

static bool less(const struct integer *a, const struct integer *b)
{
    for (int i = WORDS - 1; i >= 0; i--) {
        if (a->word[i] != b->word[i]) {
            return a->word[i] < b->word[i];
        }
    }
    return false;
}

static void subtract(struct integer *a, const struct integer *b)
{
    uint64_t borrow = 0;
    for (int i = 0; i < WORDS; i++) {
        const uint64_t difference = (uint64_t)a->word[i] - b->word[i] - borrow;
        a->word[i] = (uint32_t)difference;
        borrow = difference >> 63;
    }
}

static double power_of_two(int exponent)
{
    const uint64_t bits = (uint64_t)(1023 + exponent) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

/* digits 10^exponent, rounded to the nearest double, to the even one if two are as near */
static double quotient(const char *digits, int count, int exponent)
{
    struct integer above = {{0}}, below = {{1}}, rest = {{0}};
    for (int i = 0; i < count; i++) {
        multiply_add(&above, 10, (uint32_t)(digits[i] - '0'));
    }
    for (int i = 0; i < (exponent < 0 ? -exponent : exponent); i++) {
        multiply_add(exponent < 0 ? &below : &above, 10, 0);
    }
    /* 2^shift above / below has 59 or 60 bits. */
    const int shift = 60 - count_bits(&above) + count_bits(&below) - 1;
    for (int i = 0; i < (shift < 0 ? -shift : shift); i++) {
        multiply_add(shift < 0 ? &below : &above, 2, 0);
    }
    uint64_t q = 0;
    for (int i = count_bits(&above) - 1; i >= 0; i--) {
        multiply_add(&rest, 2, above.word[i / 32] >> i % 32 & 1);
        q *= 2;
        if (!less(&rest, &below)) {
            subtract(&rest, &below);
            q++;
        }
    }
    int excess = 0;
    while (q >> excess >= UINT64_C(1) << 53) {
        excess++;
    }
    const uint64_t cut = q & ((UINT64_C(1) << excess) - 1), half = (UINT64_C(1) << excess) / 2;
    uint64_t mantissa = q >> excess;
    const bool is_exact = count_bits(&rest) == 0;
    mantissa += cut > half || (cut == half && (!is_exact || (mantissa & 1) != 0));
    return (double)mantissa * power_of_two(excess - shift);
}

static double scaled(const char *digits, int count, int exponent)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (count > 15 || exponent > 22 || exponent < -22) {
        return quotient(digits, count, exponent);
    }
    double mantissa = 0.0;
    for (int i = 0; i < count; i++) {
        mantissa = mantissa * 10.0 + (double)(digits[i] - '0');
    }
    return exponent < 0 ? mantissa / powers[-exponent] : mantissa * powers[exponent];
}

/* The exponent behind e or E, if there is one. */
static int read_exponent(const char *text, size_t length, size_t *at)
{
    size_t i = *at + 1;
    if (*at >= length || (text[*at] != 'e' && text[*at] != 'E')) {
        return 0;
    }
    const bool is_negative = i < length && text[i] == '-';
    i += i < length && (text[i] == '-' || text[i] == '+');
    if (i >= length || !reader_is_digit(text[i])) {
        return 0; /* the letter belongs to what comes next, and is an error there */
    }
    int exponent = 0;
    for (; i < length && reader_is_digit(text[i]); i++) {
        exponent = exponent < 10000 ? exponent * 10 + (text[i] - '0') : exponent;
    }
    *at = i;
    return is_negative ? -exponent : exponent;
}

size_t scarpi_read_number(const char *text, size_t length, double *value)
{
    char digits[DIGITS];
    int count = 0, exponent = 0;
    bool has_point = false, has_digits = false;
    size_t at = 0;
    for (; at < length && (reader_is_digit(text[at]) || (text[at] == '.' && !has_point)); at++) {
        if (text[at] == '.') {
            has_point = true;
            continue;
        }
        has_digits = true;
        exponent -= has_point;
        if (count > 0 || text[at] != '0') {
            digits[count] = text[at];
            count += count < DIGITS - 1;
        }
    }
    if (!has_digits) {
        return 0;
    }
    exponent += read_exponent(text, length, &at);
    const int first = exponent + count; /* 10^first is above the number */
    *value = 0.0;
    if (count > 0) {
        if (count >= DIGITS - 1 || first > EXPONENT + 1 || first < 1 - EXPONENT) {
            return 0;
        }
        *value = scaled(digits, count, exponent);
    }
    return *value <= MOST ? at : 0;
}
