/* SPDX-License-Identifier: MIT
 *
 * Signals: a request to stop is remembered, so that the program can tidy up first; a closed pipe
 * and a file over its limit are errors of the write, not signals.
 */
#ifndef SCARP_CLI_INTERRUPT_H
#define SCARP_CLI_INTERRUPT_H

#include <stdbool.h>

void interrupt_install(void);

/* Whether the user or the system asked the program to stop. */
bool interrupted(void);

/* Ends the program by the signal that asked for it, as a shell expects; returns where that is
   impossible, or nothing asked for it. */
void interrupt_end(void);

#endif
