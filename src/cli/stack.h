/* SPDX-License-Identifier: MIT
 *
 * The stack of the first thread, which the system enlarges only when it is used, and by a signal
 * tells then that it cannot.
 */
#ifndef SCARP_CLI_STACK_H
#define SCARP_CLI_STACK_H

#include <stdbool.h>

/* Sees to it, before anything is written, that the first thread's stack is large enough. False if
   it may not be, with a line on stderr. */
bool stack_reserve(void);

#endif
