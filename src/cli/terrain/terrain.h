/* SPDX-License-Identifier: MIT
 *
 * The command `scarp terrain`.
 */
#ifndef SCARP_CLI_TERRAIN_H
#define SCARP_CLI_TERRAIN_H

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_terrain(char **argv);

#endif
