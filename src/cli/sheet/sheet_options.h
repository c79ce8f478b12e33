/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp sheet`, parsed.
 */
#ifndef SCARP_CLI_SHEET_OPTIONS_H
#define SCARP_CLI_SHEET_OPTIONS_H

#include "ground/ground_options.h"
#include "look/look_options.h"
#include "shared/options.h"
#include "shared/running_options.h"

struct sheet_options {
    struct ground_options ground;
    struct look_options look;
    struct option_size panel; /* pixels */
    struct option_point origin;
    double step; /* between pixels */
    struct running_options running;
    size_t samples; /* across a pixel */
    int layer;      /* SHEET_RELIEF or SHEET_HILLSHADE */
    const char *sheet, *output;
};

enum { SHEET_RELIEF, SHEET_HILLSHADE };

#define SHEET_OPTIONS_UNSET                                                                        \
    {                                                                                              \
        .ground = GROUND_OPTIONS_UNSET                                                             \
    }

extern const struct option_table sheet_table;

/* The groups whose options a sheet can vary: from the first one to the one before the last */
enum { SHEET_VARIED_FIRST = 1 };

#endif
