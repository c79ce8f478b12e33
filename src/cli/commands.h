/* SPDX-License-Identifier: MIT
 *
 * The commands of the program. Each has its file: info.c, and COMMAND/COMMAND.c for the others.
 */
#ifndef SCARP_CLI_COMMANDS_H
#define SCARP_CLI_COMMANDS_H

#include "shared/options.h"

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_info(char **argv);
int cli_recipe(char **argv);
int cli_sample(char **argv);
int cli_sheet(char **argv);
int cli_terrain(char **argv);
int cli_view(char **argv);

/* The options of commands that have no COMMAND_options.h */
extern const struct option_table recipe_table, sample_table;

#endif
