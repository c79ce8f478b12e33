/* SPDX-License-Identifier: MIT
 *
 * Signals: a request to stop is remembered, so that the program can tidy up first; a closed pipe
 * and a file over its limit are errors of the write, not signals. What cannot fail stops the
 * program in the same way if it fails nevertheless.
 */
#ifndef SCARP_CLI_INTERRUPT_H
#define SCARP_CLI_INTERRUPT_H

#include <stdbool.h>

void interrupt_install(void);

/* Whether the program is to stop: the user or the system asked for it, or interrupt_unless did. */
bool interrupted(void);

/* Stops the program if a call failed that cannot fail, its arguments having been checked: nothing
   is kept of what was computed. The first failure is reported on stderr. */
void interrupt_unless(bool is_done);

/* Ends the program by the signal that asked for it, as a shell expects; returns where that is
   impossible, or nothing asked for it. */
void interrupt_end(void);

#endif
