/* SPDX-License-Identifier: MIT
 *
 * How the program fails: its exit statuses and its messages.
 */
#ifndef SCARP_CLI_ERROR_H
#define SCARP_CLI_ERROR_H

enum cli_exit {
    CLI_SUCCESS = 0,
    CLI_FAILURE = 1, /* something went wrong on the way: a full disk, no memory */
    CLI_USAGE = 2    /* the command line asks for what is not possible; nothing was done */
};

/* Prints "scarp: ", the message and a newline on stderr. It stays one line whatever the arguments
   hold: control characters become '?'. */
#if defined(__clang__) || (defined(__GNUC__) && !defined(_WIN32))
__attribute__((format(printf, 1, 2)))
#endif
void cli_error(const char *format, ...);

#endif
