/* SPDX-License-Identifier: MIT
 *
 * Which parameters a sheet varies, and their values: seed=1..4,gain=0.3..0.6/4 for instance.
 */
#ifndef SCARP_CLI_AXES_H
#define SCARP_CLI_AXES_H

#include <stdbool.h>
#include <stddef.h>

#define CELLS_MAX 100
#define AXES_MAX 2
#define AXIS_VALUE_SIZE 64
#define AXIS_NAME_SIZE 32

/* A parameter and its values, as they would be typed */
struct axis {
    char name[AXIS_NAME_SIZE]; /* of the option, without its dashes */
    char values[CELLS_MAX][AXIS_VALUE_SIZE];
    size_t count;
};

struct axes {
    struct axis list[AXES_MAX];
    size_t count;
};

/* Reads the text of --sheet. False, with a line on stderr, if it is not one. Whether there are such
   options, and whether they take these values, is not looked at. */
bool axes_parse(const char *text, struct axes *axes);

#endif
