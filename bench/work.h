/* SPDX-License-Identifier: MIT
 *
 * A workload: what is computed, for which points. The list is in work.c. Included by everything
 * that runs workloads, C++ peers among them.
 */
#ifndef SCARP_BENCH_WORK_H
#define SCARP_BENCH_WORK_H

#include <stddef.h>

#include "scarp.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The points of workloads whose name says nothing of them */
#define BENCH_STANDARD_POINTS 65536

/* Callers of so few points at a time keep plans, as those of peers keep their objects. */
#define BENCH_FEW_POINTS 64

/* Holds every name of a workload, with the 0 at its end. */
#define BENCH_NAME_SIZE 224

enum bench_layout {
    BENCH_POINTS,
    BENCH_GRID,
    BENCH_NORMALS,
    BENCH_PRODUCT, /* of two samples, by scarp_multiply */
    BENCH_VECTOR,  /* values of all components of vector noise */
    BENCH_CURL,    /* velocities */
    BENCH_GULLIES, /* in a base whose arrays are any that there are */
    BENCH_RECIPE,  /* of the title, at points */
    BENCH_RECIPE_GRID
};

enum bench_output {
    BENCH_VALUE,
    BENCH_PLUS_GRADIENT,       /* value and gradient */
    BENCH_PLUS_HESSIAN,        /* value, gradient and Hessian */
    BENCH_PLUS_PHASE,          /* value and its derivative with respect to the phase */
    BENCH_FORWARD_DIFFERENCES, /* value and gradient, from dimensions + 1 values */
    BENCH_CENTRAL_DIFFERENCES, /* value and gradient, from 2 dimensions + 1 values */
    BENCH_OUTPUTS
};

enum bench_pattern {
    BENCH_RANDOM,     /* uniform in [-1000, 1000) */
    BENCH_SEQUENTIAL, /* along a row, 0.01 cells apart */
    BENCH_SAME_CELL   /* uniform in [0, 1) */
};

enum bench_request {
    BENCH_ALWAYS,
    BENCH_BY_WORK, /* measured only if --work is given: many */
    BENCH_BY_NAME  /* measured only if --work gives the whole name: large */
};

enum { BENCH_WARP_NONE, BENCH_WARP_GRADIENT, BENCH_WARP_VALUE }; /* by which noise */
#define BENCH_WARP_REACH 0.5f

struct bench_work {
    char name[BENCH_NAME_SIZE]; /* made from the rest by names.c */
    enum bench_layout layout;
    enum bench_output output;
    enum bench_pattern pattern;
    enum scarp_basis basis;
    enum scarp_fade fade;
    enum scarp_fractal fractal;
    int dimensions;
    int octaves;
    float lacunarity, gain, erosion; /* as in struct scarp_noise, defaults filled in */
    float amplitude;                 /* 0: 1 */
    const char *title; /* the recipe; or whose work this is: a preset's, or what another library
                          tells the time of; peers do the nearest that they have. Else NULL */
    int turned;        /* the axes turn between octaves */
    unsigned period;   /* cells after which the noise repeats along each axis; 0: never */
    float phase;       /* of flow noise */
    int warp;          /* positions are displaced, by half a cell at most: by BENCH_WARP_... */
    int f64;           /* double coordinates */
    int as_points;     /* the samples of a grid, as arrays of double coordinates */
    enum bench_request request;
    size_t points;
    size_t grid[3];  /* of grids: samples along each axis, x innermost */
    float origin[3]; /* of grids: the first sample, in cells, or units of recipes */
    float step;      /* of grids and BENCH_SEQUENTIAL: cells or units between samples */
};

/* Puts workload number `index`, counted from 0, into *work. Returns 0 when there are no more. */
int bench_work_get(size_t index, struct bench_work *work);

/* The noise of a workload, in cells */
struct scarp_noise bench_work_noise(const struct bench_work *work);

/* Makes the name of a workload from its other members. */
void bench_work_write_name(struct bench_work *work);

/* Whether `pattern` means the workload `name`: `*` is any text and `?` any character of a whole
   name; a pattern without either is a name or, where no workload is called that, a part of one. */
int bench_work_matches(const char *pattern, const char *name);

#ifdef __cplusplus
}
#endif

#endif
