/* SPDX-License-Identifier: MIT
 *
 * The command `scarp sample`.
 */
#ifndef SCARP_CLI_SAMPLE_H
#define SCARP_CLI_SAMPLE_H

/* `argv` holds what follows the command's name, and ends with NULL; the result is one of
   enum cli_exit. */
int cli_sample(char **argv);

#endif
