/* SPDX-License-Identifier: MIT
 *
 * What honesty.c measures: the library's samples of something, and the same in double precision.
 */
#ifndef SCARP_TESTS_HONESTY_H
#define SCARP_TESTS_HONESTY_H

#include <stddef.h>

/* Bounds are by class. */
enum honesty_class {
    HONESTY_NOISE,   /* sums of octaves, folded or not, and hybrid noise */
    HONESTY_EROSION, /* slopes damp octaves */
    HONESTY_BENT,    /* slopes bend octaves */
    HONESTY_WARP,
    HONESTY_RECIPE,
    HONESTY_GULLIES,
    HONESTY_SHARP, /* gullies between sharp crests */
    HONESTY_CLASSES
};

struct subject {
    char name[2][64]; /* the columns of a table */
    enum honesty_class kind;
    int dimensions;
    double cell;            /* edge of a cell of the finest octave, about */
    double step;            /* of differences in double precision, a power of two */
    double span;            /* coordinates are in [-span, span), a power of two */
    double lowest, highest; /* the promised range */

    /* What the library computes for `count` points: value, dx, dy, dz. NULL is skipped. */
    void (*sample)(const struct subject *subject, size_t count, const double *const x[3],
                   float *const out[4]);

    /* The value in double precision, without the library. */
    double (*value)(const struct subject *subject, const double x[3]);
};

#define HONESTY_BLOCK 4096 /* most points of a call */

/* How many bases and fractals there are: the first subjects are all of them in pairs of 2D and 3D,
   with the basis counting fastest. */
int honesty_bases(void);
int honesty_fractals(void);

/* Makes subject `number` from 0 on. Returns 0 past the last one. */
int honesty_subject(int number, struct subject *subject);

/* Frees what was made, and prepares for the next. */
void honesty_forget(void);

#endif
