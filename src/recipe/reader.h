/* SPDX-License-Identifier: MIT
 *
 * The reader of a text: parse.c reads statements with it, expressions.c expressions, tokens.c words
 * and signs, and number.c numbers.
 */
#ifndef SCARP_RECIPE_READER_H
#define SCARP_RECIPE_READER_H

#include "text.h"

struct recipe_reader {
    struct recipe *recipe;
    struct recipe_errors *errors;
    size_t at; /* the next byte of the text */
    int parentheses, nesting;
    bool has_failed; /* in this statement */
};

/* The next byte of the text; 0 at its end. */
static inline char reader_next(const struct recipe_reader *r)
{
    return r->at < (size_t)r->recipe->length ? r->recipe->text[r->at] : '\0';
}

static inline bool reader_is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static inline bool reader_is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Adds an error at bytes of the text, if it is the first one of the statement. Returns -1. */
int scarpi_reader_fail_at(struct recipe_reader *r, struct recipe_span span, const char *text);

/* Adds an error at the next word or byte. Returns -1. */
int scarpi_reader_fail(struct recipe_reader *r, const char *text);

/* The word that begins at a byte; empty if there is none. */
struct recipe_span scarpi_reader_word(const struct recipe_reader *r, size_t at);

/* Skips spaces, comments, and newlines inside of parentheses. */
void scarpi_reader_skip(struct recipe_reader *r);

/* Skips a sign, with spaces around it. Returns whether it was there. */
bool scarpi_reader_take(struct recipe_reader *r, char sign);

/* Reads a number, and one that may have a minus in front. Returns false after adding an error. */
bool scarpi_reader_number(struct recipe_reader *r, double *value);
bool scarpi_reader_signed(struct recipe_reader *r, double *value);

/* Reads an expression: its index, or -1 after adding an error. */
int scarpi_reader_expression(struct recipe_reader *r);

/* Reads the number that a text begins with: digits, a point, an exponent; no sign. Returns how many
   bytes it has; 0 if there is none, if it has more than 38 digits, or if it is not 0 and outside
   [10^-60, 10^60]. */
size_t scarpi_read_number(const char *text, size_t length, double *value);

/* Reads the text in recipe->text. Statements with an error have the expression -1. */
void scarpi_recipe_read(struct recipe *recipe, struct recipe_errors *errors);

#endif
