/* SPDX-License-Identifier: MIT
 *
 * The command `scarp sample`.
 */
#ifndef SCARP_CLI_SAMPLE_H
#define SCARP_CLI_SAMPLE_H

#include "shared/options.h"

extern const struct option_table sample_table;

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_sample(char **argv);

#endif
