/* SPDX-License-Identifier: MIT
 *
 * What the commands of the program share: their entry points, exit statuses and the way errors are
 * told. Included by every file that can fail.
 */
#ifndef SCARP_CLI_CLI_H
#define SCARP_CLI_CLI_H

enum cli_exit {
    CLI_SUCCESS = 0,
    CLI_FAILURE = 1, /* something went wrong on the way: a full disk, no memory */
    CLI_USAGE = 2    /* the command line asks for what is not possible; nothing was done */
};

/* Prints "scarp: ", the message and a newline on stderr. It stays one line whatever the arguments
   hold: control characters become '?'. */
#if defined(__GNUC__) || defined(__clang__)
__attribute__((format(printf, 1, 2)))
#endif
void cli_error(const char *format, ...);

/* The commands. `argv` holds what follows the command's name, and ends with NULL; the result is an
   exit status. */
int cli_info(char **argv);
int cli_sample(char **argv);
int cli_terrain(char **argv);

#endif
