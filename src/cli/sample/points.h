/* SPDX-License-Identifier: MIT
 *
 * Points from CSV, text or .npy, in batchs: what `scarp sample` reads. The two readers are in
 * points_text.c and points_npy.c; what they share is here and in points.c.
 */
#ifndef SCARP_CLI_POINTS_H
#define SCARP_CLI_POINTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "formats/npy.h"
#include "sample/columns.h"
#include "sample/field.h"
#include "sample/input.h"

#define POINTS_BATCH 4096
#define POINTS_LINE_MAX 65535 /* bytes, without the line's end */

enum points_format { POINTS_CSV, POINTS_TEXT, POINTS_NPY, POINTS_UNKNOWN };

/* What separates the columns of lines: blanks those of text, the others those of CSV */
enum points_delimiter {
    DELIMITER_COMMA,
    DELIMITER_SEMICOLON,
    DELIMITER_TAB,
    DELIMITER_SPACE, /* or tabs, any number of them */
    DELIMITER_UNKNOWN
};

struct points_batch {
    size_t count;
    double position[3][POINTS_BATCH];
    /* Unless they come from .npy: the line of each point, up to the next read */
    const char *line[POINTS_BATCH];
};

/* What only one of the readers needs */
struct points_text {
    uint64_t number; /* of the line at hand, from 1 */
    char *line;      /* ends with a NUL; inside the input's bytes */
    size_t length;
    size_t searched;   /* unused bytes that are known to hold no line's end */
    char problem[256]; /* what is wrong with it; empty: nothing */
    bool pending;      /* the line was looked at, but is yet to be read */
    bool overlong;     /* it is too long, and may be lost but for its first byte */
    bool cut;          /* the start of the line that is being looked for was lost */
};

struct points_npy {
    size_t left; /* points yet to be read */
    size_t row;  /* bytes from point to point */
    struct npy_type type;
    /* Fortran order: all of the columns, of which the bytes are kept; else NULL */
    unsigned char *whole;
    bool is_fortran;
};

struct points {
    /* What is wanted: set before opening, the rest zero */
    int format;            /* an enum points_format; POINTS_UNKNOWN: the reader finds out */
    int delimiter;         /* an enum points_delimiter; DELIMITER_UNKNOWN: the reader finds out */
    int dims;              /* coordinates of a point, 2 or 3; 0: the reader finds out */
    struct columns chosen; /* what --columns says */
    bool skip_bad;
    bool keep; /* lines must have equally many columns, since results will follow them */
    /* Set after points_begin: fields must be such that blanks can separate them. */
    bool plain;

    /* What is known after points_begin */
    char *header;                /* the header row of CSV, NULL without */
    size_t column[COLUMNS_AXES]; /* where x, y and z are, counted from 0 */
    size_t columns;              /* of the first line; 0: there is none */
    size_t total;                /* .npy: how many points there are */
    bool single;                 /* .npy: the coordinates are floats */
    field_fn *field;             /* how lines fall into fields */
    char decimal;                /* the mark of those numbers that have one: '.', ',' or 0 */
    uint64_t malformed;          /* lines, or rows of .npy, left out so far */

    /* Private to the readers: */
    bool dims_given;
    bool told; /* the columns of the coordinates do not follow from how many there are */
    struct input input;
    struct points_text text;
    struct points_npy npy;
};

/* All return an exit status, after a line on stderr if it is not CLI_SUCCESS. */

int points_open(struct points *points, const char *path);

/* Reads as far as it takes to know the format and the dimensions: to the first point. */
int points_begin(struct points *points);

/* Reads the next points: those that are there, at most POINTS_BATCH, at least one unless the input
   has ended. */
int points_read(struct points *points, struct points_batch *batch);

/* May be called at any time after zero-initialisation. */
void points_close(struct points *points);

/* What separates the columns of a first row, so far as that is plain; else DELIMITER_UNKNOWN.
   `format` is POINTS_CSV or POINTS_UNKNOWN. */
enum points_delimiter delimiter_of(const char *row, const struct columns *chosen, int format);

/* How lines fall into fields, and what is between them */
field_fn *delimiter_field(int delimiter);
char delimiter_character(int delimiter);

/* "comma" and so on; NULL past the last */
const char *delimiter_word(int delimiter);

/* Whether a field is a number, if only one that a point cannot have, such as "nan" */
bool delimiter_is_number(const struct field *field, int delimiter);

/* The readers, for points.c */
int points_text_begin(struct points *points);
int points_text_read(struct points *points, struct points_batch *batch);
int points_npy_begin(struct points *points);
int points_npy_read(struct points *points, struct points_batch *batch);

#endif
