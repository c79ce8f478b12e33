/* SPDX-License-Identifier: MIT
 *
 * The recipe that options ask for: that of a preset, of a file, or of one noise, with the values of
 * its parameters.
 */
#ifndef SCARP_CLI_SOURCE_H
#define SCARP_CLI_SOURCE_H

#include <stdbool.h>

#include "ground/ground.h"
#include "ground/ground_options.h"
#include "look/palette.h"
#include "shared/text.h"

#define SOURCE_PALETTE_SIZE 32

/* Zero-initialise; close it. */
struct source {
    const char *option, *name; /* what messages begin with: "--recipe", and the file */
    bool is_noise;             /* the text was written for options of one noise */
    struct text text;
    struct text names; /* those of `values`, each ended by a NUL */
    struct ground_value values[OPTION_LIST_MOST];
    struct ground_source ground;            /* of these */
    const char *fields[GROUND_FIELDS_MOST]; /* names of outputs, which the source does not own */
    char palette[SOURCE_PALETTE_SIZE]; /* that of the text's line `#: palette NAME`; "": none */
    double nearest;                    /* the frequency of one noise that repeats; else 0 */
    uint32_t cells[2];                 /* and its cells along the sides of the period */
};

/* Reads or writes the recipe of options. `step` is the distance between samples, of which a period
   has a number. Returns an exit status, after a line on stderr if it is not CLI_SUCCESS. */
int source_open(struct source *source, const struct ground_options *options, double step);
void source_close(struct source *source);

/* Prints the text. */
void source_print(const struct source *source);

/* Asks for the output `name` of the recipe beside the height, and tells which of the fields it is:
   one name is one field. */
size_t source_field(struct source *source, const char *name);

/* Makes the ground. False, with a line on stderr, if it cannot be. */
bool source_ground(const struct source *source, struct ground *ground);

/* Opens a palette: the one of that name or file, or if it is NULL that of the recipe, or alpine.
   False, with a line on stderr, if it cannot be. Free it in any case. */
bool source_open_palette(const struct source *source, const char *name, struct palette *palette);

/* Tells on stderr what is wrong in the text. */
void source_refuse(const struct source *source, const struct scarp_recipe_error *error);

/* Adds the recipe, which is null for one noise, and the values as members of an object of JSON, a
   line each. */
void source_describe(const struct source *source, struct text *text);

#endif
