/* SPDX-License-Identifier: MIT
 *
 * The manifest of a terrain: everything that its files depend on.
 */
#ifndef SCARP_CLI_WORLD_H
#define SCARP_CLI_WORLD_H

#include "terrain/job.h"

/* Makes the manifest of a job next to the first of its products, or compares this run with it.
   Returns an exit status, after a line on stderr if it is not CLI_SUCCESS. */
int world_open(struct job *job);

#endif
