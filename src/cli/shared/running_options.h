/* SPDX-License-Identifier: MIT
 *
 * The options that say how a command runs, which change no byte of what it makes.
 */
#ifndef SCARP_CLI_RUNNING_OPTIONS_H
#define SCARP_CLI_RUNNING_OPTIONS_H

#include "shared/options.h"

struct running_options {
    size_t threads; /* all: 0 */
    int isa, quiet;
};

#define RUNNING_ROWS 3
extern const struct option running_option_rows[RUNNING_ROWS];

/* The group, for a table; the struct is at an offset in the values. */
#define RUNNING_GROUP(at) OPTION_GROUP("running", running_option_rows, at)

#endif
