/* SPDX-License-Identifier: MIT
 *
 * Which columns of an input are the coordinates: what --columns says, and how the names of a header
 * row are found.
 */
#ifndef SCARP_CLI_COLUMNS_H
#define SCARP_CLI_COLUMNS_H

#include <stdbool.h>
#include <stddef.h>

#include "sample/field.h"
#include "shared/options.h"

#define COLUMNS_AXES 3
#define COLUMNS_NUMBER_MAX 65536 /* as many as a line can have */
#define COLUMNS_ALLOWED                                                                            \
    "2 or 3 different columns with commas between: names of the header row, or numbers from 1 to " \
    "65536"

/* What --columns says: the columns of x, y and z. Zero: it is not given. */
struct columns {
    size_t count;                    /* 2 or 3; 0: not given */
    bool numbered;                   /* by number, not by name */
    struct field name[COLUMNS_AXES]; /* as they are on the command line */
    size_t index[COLUMNS_AXES];      /* if numbered: from 0 on */
};

option_parse_fn option_columns; /* struct columns */

/* A row of names, which ends with a NUL, and the input that it is of, for messages */
struct columns_header {
    const char *input;
    const char *row;
    field_fn *field; /* how it falls into names */
};

/* Finds the coordinates in a header row: those that --columns names, or without it those named x, y
   and, unless dims is 2, z. `dims` is what --dims says, 0 without it. Returns how many coordinates
   there are, with their columns, counted from 0, in `index`; or 0, after a line on stderr. */
int columns_in_header(const struct columns *columns, const struct columns_header *header, int dims,
                      size_t index[COLUMNS_AXES]);

/* Whether a row has fields that hold the names of --columns and nothing else; without
   those, x and y. */
bool columns_are_named(const struct columns *columns, const struct columns_header *header);

/* The columns, counted from 0, where there is no header row: those that --columns numbers, or else
   the first ones. */
void columns_by_number(const struct columns *columns, size_t index[COLUMNS_AXES]);

/* How many columns it takes to have the first `dims` of these */
size_t columns_needed(const size_t index[COLUMNS_AXES], int dims);

/* Whether --columns can choose from `total` columns that have no names. False, after a line on
   stderr, if it has names. */
bool columns_nameless(const struct columns *columns, const char *input, size_t total);

#endif
