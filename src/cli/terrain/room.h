/* SPDX-License-Identifier: MIT
 *
 * Whether what a run writes fits on its disks.
 */
#ifndef SCARP_CLI_ROOM_H
#define SCARP_CLI_ROOM_H

#include "terrain/job.h"

/* Before a large run, prints its bytes, its tiles and the free space in a line. Returns an exit
   status, after a line on stderr if it is not CLI_SUCCESS: files whose size is known must fit. What
   is there already, and is replaced or left, does not count. */
int room_check(struct job *job);

#endif
