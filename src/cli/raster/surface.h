/* SPDX-License-Identifier: MIT
 *
 * The terrain as a raster: which ground, where, how lit; and windows of its samples.
 *
 * Column c and row r of the raster lie at x = x0 + c step and y = y0 + (height - 1 - r) step: x
 * grows to the right and y upward, as on a map, and (x0, y0) is the bottom left sample.
 */
#ifndef SCARP_CLI_SURFACE_H
#define SCARP_CLI_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

#include "ground/ground.h"
#include "look/look_options.h"
#include "look/relief.h"
#include "scarp.h"

/* A scale of 16-bit integers: 0 at `zero`, 65535 at `full` */
struct surface_scale {
    double zero, steps; /* per unit; 0 if both ends are equal */
};

static inline struct surface_scale surface_scale_of(double zero, double full)
{
    return (struct surface_scale){zero, full > zero ? 65535.0 / (full - zero) : 0.0};
}

/* The integer of a value of the scale, rounded to the nearest */
static inline unsigned surface_quantise(struct surface_scale scale, float value)
{
    /* By way of int, for which processors have a vector instruction */
    return (unsigned)(int)(((double)value - scale.zero) * scale.steps + 0.5);
}

struct surface {
    struct ground ground;
    size_t width, height; /* samples of the whole raster */
    double x0, y0, step;
    unsigned epsg;              /* the system of x and y in EPSG's list; 0: none */
    struct surface_scale scale; /* of heights: from the floor to the highest */
    float z_factor;             /* for the hillshade only: multiplies heights */
    float normal_y;             /* 1 or -1: multiplies the second component of normals */
    double light[3];            /* unit vector to the light: east, north, up */
    size_t zoom;                /* of the comparison: pixels per sample */
    struct relief relief;       /* set where it is asked for */
};

/* The scale of 16-bit heights */
struct surface_scale surface_height_scale(const struct ground *ground);

/* Makes the raster that of level `level`, with steps 2^level times as long, of `width` x `height`
   samples of which each lies in the middle of those that it stands for, or of the last ones, which
   may reach beyond the raster. Octaves that its step cannot show are left out, in level 0 too if
   `is_limited`. */
void surface_set_level(const struct surface *surface, unsigned level, bool is_limited,
                       struct surface *to);

/* Sets the z-factor and the light. */
void surface_set_light(struct surface *surface, const struct look_options *look);

/* Resolves the palette and sets the relief, which points to it; ground and light are set. */
void surface_set_relief(struct surface *surface, struct palette *palette);

/* What a window needs to hold, or'ed */
enum surface_need {
    SURFACE_GRADIENT = 1,
    SURFACE_NORMALS = 2,
    SURFACE_SHADE = 4,       /* normals with the z-factor */
    SURFACE_DIFFERENCES = 8, /* normals from differences of heights */
    SURFACE_BED = 16,        /* values before the sea covers them, if there is a sea */
    SURFACE_CURVATURE = 32,  /* second derivatives */
    SURFACE_FIELDS = 64,     /* the other outputs of the recipe */
};

#define WINDOW_SAMPLES 32768 /* at most: 128 KiB of each array that is needed */

/* Samples of a rectangle, row by row without gaps; what is not needed is NULL. */
struct window {
    size_t column, row; /* of its first sample, in the raster or beyond its edges */
    size_t columns, rows;
    float *value, *dx, *dy;
    float *dxx, *dxy, *dyy;
    float *bed;
    float *fields[GROUND_FIELDS_MOST];
    float *nx, *ny, *nz;
    float *shade_x, *shade_y, *shade_z; /* the normals themselves where the z-factor is 1 */
    float *differences_x, *differences_y, *differences_z;
    float *memory;
};

/* False without memory. Zero-initialise before; close in any case. */
bool window_open(struct window *window, const struct surface *surface, unsigned needs);
void window_close(struct window *window);

/* Samples the window's rectangle: all that it holds but the normals from differences, which
   compare.h adds. */
void surface_sample(const struct surface *surface, struct window *window);

/* Samples only values, of the rectangle `right` columns and `up` rows from the window's. */
void surface_values(const struct surface *surface, const struct window *window, int right, int up,
                    float *value);

#endif
