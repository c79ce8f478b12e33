/* SPDX-License-Identifier: MIT
 *
 * `scarp terrain --verify`: compares the files of a world with the checksums that its runs kept.
 */
#ifndef SCARP_CLI_VERIFY_H
#define SCARP_CLI_VERIFY_H

#include "terrain/job.h"

/* Looks at the files of all tiles of the job, whose manifest is compared; writes nothing. Returns
   an exit status: CLI_FAILURE, after lines on stderr, if a file is not as it was written. */
int verify_files(struct job *job);

#endif
