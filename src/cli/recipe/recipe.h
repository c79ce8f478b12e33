/* SPDX-License-Identifier: MIT
 *
 * The command `scarp recipe`.
 */
#ifndef SCARP_CLI_RECIPE_H
#define SCARP_CLI_RECIPE_H

#include "shared/options.h"

extern const struct option_table recipe_table;

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_recipe(char **argv);

#endif
