/* SPDX-License-Identifier: MIT
 *
 * What commands with threads do at their beginning and at their end.
 */
#ifndef SCARP_CLI_RUNNING_H
#define SCARP_CLI_RUNNING_H

#include <stdbool.h>
#include <stdio.h>

#include "shared/crew.h"
#include "shared/running_options.h"

/* Selects an instruction set, or the best one for 0. False, with a line on stderr, if it cannot run. */
bool running_select(int isa);

/* Selects the instruction set and opens a crew. NULL with a line on stderr if it
   cannot. */
struct crew *running_begin(const struct running_options *options);

/* Seconds of a clock that only goes on */
double running_seconds(void);

/* Ends a closing line: " (avx2, 2 threads)". */
void running_print(FILE *stream, const struct crew *crew);

#endif
