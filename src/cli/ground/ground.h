/* SPDX-License-Identifier: MIT
 *
 * The terrain: a recipe whose first output is the height, in units of x and y. Where the recipe has
 * `param sea`, water stands up to that height, and the ground below it is the bed.
 *
 * All of it is the same on every machine, to the bit. Nothing here needs more than scarp.h and the
 * C library.
 */
#ifndef SCARP_CLI_GROUND_H
#define SCARP_CLI_GROUND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "scarp.h"

/* A parameter of the recipe, and its value */
struct ground_value {
    const char *name;
    double value;
};

#define GROUND_FIELDS_MOST 15 /* a call of the library has 16 outputs, one of them the height */

/* What a terrain is made of. A member that is 0 changes nothing. */
struct ground_source {
    const char *text; /* a recipe */
    size_t length;    /* its bytes */
    const struct ground_value *values;
    size_t count;   /* of values */
    uint64_t seed;  /* of the world */
    double tile[2]; /* the terrain repeats after so many units along x and y */
    double scale;   /* makes it so many times larger, places and heights; 0: it does not */
    bool is_any;    /* any field will do: it may be one of space, and have no bound */
    const char *const *fields; /* names of outputs that are asked for beside the height */
    size_t field_count;
};

/* An output of the recipe. Places grow with the scale, its values do not. */
struct ground_field {
    int32_t statement;
    float lowest, highest; /* it never leaves this interval; infinite without a bound */
};

/* 64 KiB: not for small stacks. It may be copied. */
struct ground {
    struct scarp_recipe recipe;
    int32_t height;        /* the number of the statement that is the height */
    float lowest, highest; /* heights never leave this interval, the sea aside */
    float floor;           /* the sea, taken into that interval; without one, `lowest` */
    double cell;           /* the largest cell of the height; without a noise, the scale */
    bool jumps;            /* heights may jump somewhere */
    bool is_space;         /* of space, and so no terrain: is_any allows that */
    struct ground_field fields[GROUND_FIELDS_MOST]; /* those asked for; the height, if it is one of
                                                       them, is the ground without water */
    size_t field_count;
};

/* What kept a ground from being made */
enum ground_problem {
    GROUND_FINE,
    GROUND_BAD_TEXT,    /* the text has an error; lines and bytes are those of the text */
    GROUND_BAD_TERRAIN, /* it is no terrain */
    GROUND_BAD_NAME,    /* no parameter has the name of a value, which is number error->from */
    GROUND_BAD_VALUE,   /* a parameter cannot have that value, which is number error->from */
    GROUND_BAD_FIELD    /* there is no such output, or none of the plane: number error->from */
};

/* Makes the ground; if it is not GROUND_FINE, *error tells why. */
enum ground_problem ground_open(struct ground *ground, const struct ground_source *source,
                                struct scarp_recipe_error *error);

/* Whether there is water */
static inline bool ground_has_sea(const struct ground *ground)
{
    return ground->floor > ground->lowest;
}

/* Sample heights, and slopes if out->dx and out->dy are there, as scarp_grid2 and
   scarp_sample2_f64 do. The sea is flat. `out` may have second derivatives, too, where the recipe
   has them; false if not. */
bool ground_grid(const struct ground *ground, const struct scarp_grid *grid,
                 const struct scarp_samples *out);
bool ground_points(const struct ground *ground, size_t count, const double *x, const double *y,
                   const struct scarp_samples *out);

/* Sample the ground with the bed of the sea in place of the water. */
bool ground_dry_grid(const struct ground *ground, const struct scarp_grid *grid,
                     const struct scarp_samples *out);
bool ground_dry_points(const struct ground *ground, size_t count, const double *x, const double *y,
                       const struct scarp_samples *out);

/* As ground_dry_grid, with the values of each field in an array of fields; NULL: of none */
bool ground_fields_grid(const struct ground *ground, const struct scarp_grid *grid,
                        const struct scarp_samples *out, float *const *fields);

/* Memory of this thread for calls of recipes */
const struct scarp_scratch *ground_scratch(void);

/* Covers samples of the dry ground with the sea: it is flat there, so derivatives are 0. */
void ground_cover(const struct ground *ground, size_t count, const struct scarp_samples *out);

/* Makes the same ground without the octaves whose cells are smaller than `finest` units; the last
   one that is left fades in. What is left is as it was: amplitudes do not change. */
void ground_limit(const struct ground *ground, double finest, struct ground *limited);

#endif
