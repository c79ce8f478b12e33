/* SPDX-License-Identifier: MIT
 *
 * The command `scarp view`.
 */
#ifndef SCARP_CLI_VIEW_H
#define SCARP_CLI_VIEW_H

/* Runs it. `argv` holds what follows the name of the command and ends with NULL. Returns an exit
   status. */
int cli_view(char **argv);

#endif
