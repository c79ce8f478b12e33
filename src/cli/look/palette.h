/* SPDX-License-Identifier: MIT
 *
 * Palettes: the colours of ground, rock, snow, sand and water.
 *
 * Colours are sRGB, from 0 to 1. They are mixed and lit as their squares, which are nearly the
 * amounts of light that sRGB stands for.
 */
#ifndef SCARP_CLI_PALETTE_H
#define SCARP_CLI_PALETTE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct colour {
    float r, g, b;
};

/* Where a ramp has a colour. Between two stops it is linear in sRGB. Two stops at one height are a
   step, which has the second colour at that height. */
struct palette_stop {
    float height; /* a fraction, or with `in_units` a height in the unit of x and y */
    struct colour colour;
    bool is_fraction; /* of a file, until palette_resolve: 50% */
};

/* What the ground is, in the order in which masks have it */
enum palette_ground {
    PALETTE_ROCK,
    PALETTE_SNOW,
    PALETTE_SAND,
    PALETTE_VEGETATION,
    PALETTE_WATER,
    PALETTE_GROUNDS
};

/* Fractions of height are 0 at the lower end of usual heights, or at the sea, and 1 at their upper
   end. Pairs are where something begins and where it is complete; between, it is smooth. */
struct palette {
    const char *name; /* NULL: of a file */
    const struct palette_stop *stops;
    size_t count;
    struct colour below, above; /* of heights beyond the stops, */
    bool has_below, has_above;  /* or without them the first and the last colour */
    bool in_units;              /* stops are heights; there is nothing but the ramp */
    enum palette_ground ground; /* what shows the ramp */
    struct colour rock, high_rock, snow, sand, shallow, deep;
    float rock_slope[2];  /* cosines of the angle to level ground */
    float rock_height[2]; /* fractions: high_rock in place of rock */
    float snow_height[2]; /* fractions */
    float snow_slope[2];  /* cosines */
    float snow_sun;       /* how much higher, in fractions, snow begins on walls toward the sun, */
    float snow_steep;     /* and on all walls */
    float sand_height[2]; /* fractions, above the sea */
    uint32_t sum;         /* of a file: of its bytes */
    struct palette_stop *memory; /* of a file: the stops */
};

#define PALETTE_NAMES "alpine, temperate, desert, arctic or grey"

/* The words, ending with NULL */
extern const char *const palette_names[];

/* The palette of that name; NULL if there is none. */
const struct palette *palette_find(const char *name);

/* Reads a palette of that name, or the file `text`. False, with a line on stderr that names
   `option` and the line of the file, if it cannot be. Free it in any case. */
bool palette_open(struct palette *palette, const char *option, const char *text);
void palette_free(struct palette *palette);

/* Reads a file of GDAL's or GMT's form; used by palette_open. */
bool palette_read(struct palette *palette, const char *option, const char *path);

/* Completes a palette: stops of a file that are fractions get heights between `low` and `high`,
   and all are sorted; ends without a colour get that of the stop there. */
void palette_resolve(struct palette *palette, float low, float high);

#endif
