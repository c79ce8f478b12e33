/* SPDX-License-Identifier: MIT
 *
 * What commands with threads do at their beginning and at their end.
 */
#ifndef SCARP_CLI_RUNNING_H
#define SCARP_CLI_RUNNING_H

#include <stdio.h>

#include "shared/crew.h"
#include "shared/running_options.h"

/* Selects the instruction set and opens a crew. NULL without memory, with a line on stderr. */
struct crew *running_begin(const struct running_options *options);

/* Seconds of a clock that only goes on */
double running_seconds(void);

/* Ends a closing line: " (avx2, 2 threads)". */
void running_print(FILE *stream, const struct crew *crew);

#endif
