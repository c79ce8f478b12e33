/* SPDX-License-Identifier: MIT
 *
 * The commands of the program. Included by main.c and by each file that holds one.
 */
#ifndef SCARP_CLI_COMMANDS_H
#define SCARP_CLI_COMMANDS_H

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_info(char **argv);
int cli_sample(char **argv);
int cli_terrain(char **argv);

#endif
