/* SPDX-License-Identifier: MIT
 *
 * Whether what a run writes fits on its disks.
 */
#ifndef SCARP_CLI_ROOM_H
#define SCARP_CLI_ROOM_H

#include <stdbool.h>

#include "terrain/job.h"

/* Before a large run, tells its bytes, its tiles and the free space in a line. False, with a line
   on stderr, if files whose size is known do not fit. What is there already, and is replaced or
   left, does not count. */
bool room_check(struct job *job);

#endif
