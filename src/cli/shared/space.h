/* SPDX-License-Identifier: MIT
 *
 * How much a disk still takes.
 */
#ifndef SCARP_CLI_SPACE_H
#define SCARP_CLI_SPACE_H

#include <stdbool.h>
#include <stdint.h>

struct space {
    uint64_t device; /* the same number for the same disk */
    uint64_t bytes;  /* that this user may still write */
};

/* Looks at the disk where the file `path` would be, whose directory need not be there yet. False if
   the system does not say. */
bool space_look(const char *path, struct space *space);

#endif
