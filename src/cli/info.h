/* SPDX-License-Identifier: MIT
 *
 * The command `scarp info`.
 */
#ifndef SCARP_CLI_INFO_H
#define SCARP_CLI_INFO_H

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_info(char **argv);

#endif
