/* SPDX-License-Identifier: MIT
 *
 * How much stack a thread takes; and the first thread's stack, which the system enlarges only when
 * it is used: if it cannot then, a signal ends the program.
 */
#ifndef SCARP_CLI_STACK_H
#define SCARP_CLI_STACK_H

#include <stdbool.h>
#include <stddef.h>

/* A call of the library takes less than 48 KiB, the rest of the program some 20. Without
   optimisation, one function of the library has 330 KiB with gcc, 700 with clang. */
#ifdef __OPTIMIZE__
#define STACK_NEEDED ((size_t)128 << 10)
#else
#define STACK_NEEDED ((size_t)2 << 20)
#endif

/* Sees to it, before anything is written, that the first thread's stack is large enough. False if
   it may not be, with a line on stderr. */
bool stack_reserve(void);

#endif
