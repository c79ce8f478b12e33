/* SPDX-License-Identifier: MIT
 *
 * The command `scarp sheet`.
 */
#ifndef SCARP_CLI_SHEET_H
#define SCARP_CLI_SHEET_H

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_sheet(char **argv);

#endif
