/* SPDX-License-Identifier: MIT
 *
 * The fields of a line, one after the other: between commas, semicolons or tabs, perhaps in double
 * quotes, or between blanks. And the numbers in them.
 */
#ifndef SCARP_CLI_FIELD_H
#define SCARP_CLI_FIELD_H

#include <stdbool.h>

struct field {
    const char *begin, *end; /* without blanks around it and without its quotes */
    const char *next;        /* where the next field begins; NULL: this is the last one */
    const char *problem;     /* what is wrong with it; NULL: nothing */
    bool quoted;             /* each quote inside is doubled */
};

/* Finds the field that begins at `at`, in a line that ends with a NUL and is not blank. */
typedef struct field field_fn(const char *at);
field_fn field_csv; /* between commas */
field_fn field_semicolon;
field_fn field_tab;
field_fn field_text; /* between blanks */

/* What follows the byte at `at`, which lies in the field: the second of two quotes is left out. */
const char *field_after(const struct field *field, const char *at);

/* Whether two fields hold the same, but for capital letters of ASCII */
bool field_same(const struct field *a, const struct field *b);

#define FIELD_SHOWN 61

/* Writes what the field holds for a message, or the beginning of it. Returns `shown`. */
const char *field_show(const struct field *field, char shown[FIELD_SHOWN]);

/* Reads a number that is all of the field. With `commas` it may have a decimal comma between
 *digits. mark is '.' or ',' if it has one of them, else 0. */
bool field_number(const struct field *field, bool commas, double *value, char *mark);

/* Past spaces and tabs */
const char *field_skip_blanks(const char *at);

#endif
